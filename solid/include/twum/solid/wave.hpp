// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/eigenmodes.hpp>

#include <utility>
#include <vector>

namespace twum::inline v0_1::solid {

/// A mode of the solid.
struct SolidMode {
  int nodal_diameters;  ///< n
  int nodal_circles;    ///< sign changes of the axial motion of the top, from edge to edge
  double frequency;     ///< [Hz]
  double modal_mass;    ///< for the axial motion at the contact radius [kg]
  double axial_share;   ///< of the squares of the nodes' motion, that along the axis [1]
};

/// What a mode of the solid is.
SolidMode described(const Sector& sector, int nodal_diameters, double contact_radius,
                    const Eigenmode& mode);

/// The mode that carries the travelling wave, and what a motor takes from it. Amplitudes are those of the mean motion of the
/// top at the contact radius, which is that of the tips of the teeth.
struct SolidWave {
  std::size_t mode;   ///< its place in the list of modes
  double frequency;   ///< f_r, free and short-circuited [Hz]
  double modal_mass;  ///< m_s at the contact radius (F2.2) [kg]
  double
      tangential_ratio;  ///< tangential over axial amplitude at the contact radius, a n / r of a plate (F2.3) [1]
  double radial_ratio;  ///< radial over tangential amplitude there, q (F2.3) [1]
  double force_factor;  ///< Theta of a phase (F2.4) [N/V]
  std::vector<std::pair<double, double>> shape;  ///< radius [m] and R [1] at each line of the mesh
};

/// The wave among the modes with n nodal diameters: as of the plate, the mode of the smallest modal mass whose axial motion keeps its
/// sign on the ring.
/// @throws EvaluationError "no-ring-mode" if there is none among them
SolidWave solid_wave(const Sector& sector, const stator::StatorGeometry& geometry, int wavelengths,
                     double contact_radius, const std::vector<Eigenmode>& modes);

}  // namespace twum::inline v0_1::solid
