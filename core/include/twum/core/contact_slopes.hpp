// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

namespace twum::inline v0_1 {

/// Torque of the contact and its force on the wave (D1.1), with exact derivatives in what is prescribed. SI units.
struct ContactSlopes {
  /// A number and its derivatives, each with the other conditions held fixed.
  struct Number {
    double value{0};          ///< the number itself
    double per_amplitude{0};  ///< in A [1/m]
    double per_speed{0};      ///< in Omega [s/rad]
    double per_frequency{0};  ///< in f [1/Hz]
  };
  Number torque{};          ///< T [N m]
  Number reactive_force{};  ///< Re F [N]
  Number active_force{};    ///< Im F [N]
  PointStatus status{
      PointStatus::ok};  ///< ok, or why there is no answer; the numbers are then zero
};

/// The contact of a wave with another amplitude and frequency than the design's, as Motor::operating_point(at). The layer's viscosity
/// stays that of the design. Costs some ten operating points. One-sided where a zone appears or vanishes, as are the derivatives of
/// an operating point.
/// @throws InputError as Motor::operating_point(at)
ContactSlopes contact_slopes(const Motor& motor, const OperatingConditions& at);

}  // namespace twum::inline v0_1
