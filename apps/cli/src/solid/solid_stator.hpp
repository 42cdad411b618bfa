// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/solid/section.hpp>
#include <twum/solid/stiffness_share.hpp>
#include <twum/solid/wave.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::cli {

/// What a motor takes from its stator, by whatever model.
struct StatorNumbers {
  double resonance_frequency;  ///< [Hz]
  double modal_mass;           ///< [kg]
  double force_factor;         ///< [N/V]
  double blocked_capacitance;  ///< [F]
  double tangential_ratio;     ///< tangential over axial amplitude at the contact radius [1]
  double radial_ratio;         ///< radial over tangential amplitude there [1]
  double mode_separation;      ///< [Hz]; NaN where it was not asked for
};

/// One of these numbers.
struct StatorRow {
  const char* name;
  const char* unit;
  double StatorNumbers::*value;
};

/// All of them.
inline constexpr std::array kStatorRows{
    StatorRow{"resonance_frequency", "Hz", &StatorNumbers::resonance_frequency},
    StatorRow{"modal_mass", "kg", &StatorNumbers::modal_mass},
    StatorRow{"force_factor", "N/V", &StatorNumbers::force_factor},
    StatorRow{"blocked_capacitance", "F", &StatorNumbers::blocked_capacitance},
    StatorRow{"tangential_ratio", "1", &StatorNumbers::tangential_ratio},
    StatorRow{"radial_ratio", "1", &StatorNumbers::radial_ratio},
    StatorRow{"mode_separation", "Hz", &StatorNumbers::mode_separation}};

/// Size of a mesh.
struct MeshSize {
  int elements;  ///< through the plate
  int sectors;
  std::size_t bricks, nodes;  ///< of a sector
};

/// The stator as a solid, on two meshes.
struct SolidStator {
  MeshSize mesh{}, coarser_mesh{};
  StatorNumbers numbers{}, coarser{};
  std::vector<std::pair<double, double>> shape{};  ///< radius [m] and R
  std::vector<solid::BentFace> section{};          ///< through a tooth, at the crest of the wave
  std::vector<solid::SolidMode> modes{};           ///< of n - 2 to n + 2, lowest frequency first
  std::size_t wave{};                              ///< which of these carries the wave
  std::vector<int> untold{};  ///< numbers of nodal diameters that this division cannot tell
};

/// Solves a stator as a solid with CalculiX, in a folder where its files stay.
/// @param elements  through the plate, 2 or more; the coarser mesh has half of them
/// @throws as run_calculix(), solid::make_sector(), solid::solid_wave()
SolidStator solve_solid(const MotorDesign& design, int elements, const std::string& folder);

/// The numbers of the plate model.
/// @throws as plate_model()
StatorNumbers numbers_of_plate(const MotorDesign& design);

}  // namespace twum::inline v0_1::cli
