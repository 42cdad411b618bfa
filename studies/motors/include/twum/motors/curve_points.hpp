// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/motor.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::motors {

/// One quantity of a torque-speed curve.
struct CurveColumn {
  const char* name;  ///< as in files
  const char* unit;  ///< SI
  /// Its value at an operating point, SI.
  double (*value)(const OperatingPoint&);
};

/// speed, torque, powers, efficiency, wear and stick, in the order of tables and files; static lifetime.
std::span<const CurveColumn> contact_columns();

/// Quantities at the terminals of a motor with modal data: the wave, powers and current, and the losses. Together
/// with friction_power, layer_loss and output_power the losses add up to the electrical power (D4.2). Static
/// lifetime.
std::span<const CurveColumn> terminal_columns();

/// All columns that a design has: those of the contact, and those of the terminals if it has modal data.
std::vector<CurveColumn> curve_columns(const MotorDesign& design);

/// The default last speed of a curve [rad/s]: 1.05 times the no-load speed, or 1.2 times the crest speed if there is
/// none. Costs the computation of one no-load speed; never throws.
double last_curve_speed(const Motor& motor);

/// The speed of point `index` = 0, 1, ... of `points` (at least 2), equally spaced from rest to `last`
/// [rad/s].
double curve_speed(double last, std::uint64_t index, std::uint64_t points);

/// Equally spaced speeds from rest to last_curve_speed() [rad/s].
/// @param points  at least 2
std::vector<double> curve_speeds(const Motor& motor, std::size_t points);

/// Whether a backward wave grows beside the wave of a motor, so that the motor squeals (D6.8): friction gives it more
/// than modal_damping takes, which is 0 if it is not given. Nothing where that is unknown.
std::optional<bool> squeals(const MotorDesign& design, const BackwardWave& wave);

/// Speeds between which a motor squeals [rad/s].
struct SquealRange {
  double first;  ///< the lower one
  double last;   ///< the upper one
};

/// Where a motor squeals, as far as these speeds tell; they are in ascending order [rad/s]. Costs about a point of the
/// curve for each speed.
std::vector<SquealRange> squeal_ranges(const Motor& motor, std::span<const double> speeds);

}  // namespace twum::inline v0_1::motors
