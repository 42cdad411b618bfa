// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1 {

/// Losses of a motor by the place where they become heat [W].
struct HeatLosses {
  double friction{0};    ///< P_fric of (T7.3), at the sliding contact
  double layer{0};       ///< P_layer of (T7.4), evenly in the thickness of the lining
  double stator{0};      ///< P_stator of (T7.5), in the stator
  double dielectric{0};  ///< P_diel of (D4.2), in the stator

  /// All of them [W].
  double sum() const noexcept { return friction + layer + stator + dielectric; }
};

/// Temperatures of the motor's parts, absolute or above ambient [K].
struct PartTemperatures {
  double stator{0};   ///< T_s
  double rotor{0};    ///< T_r
  double housing{0};  ///< T_h
  double contact{0};  ///< T_c, where lining and stator slide
  double lining{0};   ///< T_l, mean over the thickness of the lining
};

/// A part of the motor with a temperature, in the order of PartTemperatures.
enum class Part : unsigned char { stator, rotor, housing, contact, lining };
/// Its name; static lifetime.
const char* to_string(Part value) noexcept;
/// How many parts there are.
inline constexpr std::size_t kParts = 5;

/// The temperature of a part.
double at(const PartTemperatures& temperatures, Part part);

/// Three masses, a sliding contact without mass between two of them, and the ways of the heat (H1.4); or one mass.
struct HeatNetwork {
  double stator_capacity{0};   ///< C_s [J/K]; of one node all of it
  double rotor_capacity{0};    ///< C_r [J/K]
  double housing_capacity{0};  ///< C_h [J/K]
  double stator_contact{0};    ///< G_sc [W/K]
  double lining{0};            ///< G_l [W/K]
  double stator_housing{0};    ///< G_sh [W/K]
  double rotor_housing{0};     ///< G_rh [W/K]
  double housing_ambient{0};   ///< G_ha [W/K]
  double stator_ambient{0};    ///< G_sa [W/K]; of one node its conductance
  double rotor_ambient{0};     ///< G_ra [W/K]
  bool one_node{false};        ///< the whole motor has one temperature

  /// True if all members are equal.
  bool operator==(const HeatNetwork&) const = default;
};

/// The network of a design. One node has G = sum of losses / rise and C = G tau (H1.10).
/// @param at_reference  of one node: the losses at one_node_torque and the reference temperature; else not used
/// @throws InputError without a thermal block
HeatNetwork heat_network(const MotorDesign& design, const HeatLosses& at_reference = {});

/// Steady temperatures above ambient under constant losses (H1.2, H1.3, H1.4) [K].
PartTemperatures steady_rises(const HeatNetwork& network, const HeatLosses& losses);

/// Time constants of the masses, in rising order (H4.1) [s].
std::vector<double> time_constants(const HeatNetwork& network);

/// Temperatures above ambient after a time under constant losses (H4.1) [K].
/// @param start  of the masses above ambient; contact and lining are not read [K]
/// @param time   at least 0 [s]
PartTemperatures rises_after(const HeatNetwork& network, const PartTemperatures& start,
                             const HeatLosses& losses, double time);

/// Time from cold, all at ambient, until a part reaches a rise under constant losses (H4.2) [s]; infinite if it never does, 0
/// for a rise of 0 or less.
double time_to_rise(const HeatNetwork& network, const HeatLosses& losses, Part part, double rise);

/// A part of a cycle with constant losses.
struct HeatPhase {
  HeatLosses losses{};  ///< while it lasts
  double time{0};       ///< how long, more than 0 [s]
};

/// Rises above ambient in a cycle that is repeated for ever [K].
struct HeatCycle {
  PartTemperatures start{};  ///< as its first phase begins
  PartTemperatures peak{};   ///< the highest of each part
  PartTemperatures low{};    ///< the lowest of each part
  PartTemperatures mean{};   ///< over the cycle (H5.2)
};

/// The periodic state of a cycle (H5.1), with its extrema, which may stand within a phase.
/// @throws InputError without a phase, and for a phase whose time is not more than 0
HeatCycle heat_cycle(const HeatNetwork& network, std::span<const HeatPhase> phases);

/// Largest share of a period with losses `on`, the rest with losses `off`, at which no part exceeds its rise in the periodic
/// state; 1 if the steady state under `on` does not, 0 if the one under `off` does.
/// @param period  of the cycle, more than 0 [s]
/// @param limits  of each part above ambient [K]; without a value no limit
double duty_limit(const HeatNetwork& network, const HeatLosses& on, const HeatLosses& off,
                  double period, std::span<const std::optional<double>, kParts> limits);

}  // namespace twum::inline v0_1
