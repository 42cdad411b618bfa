// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/operating_point.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <memory>

namespace twum::inline v0_1 {

/// Torque of the contact and its force on a wave of a prescribed amplitude (D1.1), with exact derivatives in the parameters of a
/// design. SI units.
struct ContactGradients {
  /// A number and its derivatives at a wave of the same amplitude and a rotor of the same speed.
  struct Number {
    double value{0};          ///< the number itself
    double per_amplitude{0};  ///< in A [1/m]
    double per_speed{0};      ///< in Omega [s/rad]
    std::array<double, kParameterCount>
        gradient{};  ///< in each parameter in use, as that of MetricDerivative
  };
  Number torque{};          ///< T [N m]
  Number reactive_force{};  ///< Re F [N]
  Number active_force{};    ///< Im F [N]
  double normal_per_amplitude{
      0};  ///< of the contact's normal force, in A at a rotor whose height stays [N/m]
  double normal_per_height{0};  ///< of that force, in the height of the rotor [N/m]
  PointStatus status{
      PointStatus::ok};  ///< ok, or why there is no answer; the numbers are then zero
};

/// A design's contact at its frequency under waves of any amplitude. What all of them share is found once. Copies share it.
class ContactDifferentiator {
 public:
  /// @param design  with a given number of slices; its own amplitude or voltage does not count
  /// @param fixed_static_friction  mu_0 stays where it is when mu moves
  /// @throws InputError for an impossible motor, and for `auto` slices
  explicit ContactDifferentiator(const MotorDesign& design, bool fixed_static_friction = false);

  /// Costs some ten operating points. One-sided where a zone appears or vanishes.
  /// @param amplitude  A, more than 0 [m]
  /// @param speed      Omega, faster than the wave backward [rad/s]
  ContactGradients at(double amplitude, double speed) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace twum::inline v0_1
