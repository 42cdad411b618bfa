// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <string>

namespace twum::inline v0_1::motion {

/// What the contact does to wave and rotor at one instant.
struct ContactForces {
  Complex stiffness{0, 0};  ///< F / A [N/m]
  double torque{0};         ///< T [N m]
  double stator_power{0}, friction_power{0};
  bool known{true};  ///< false where the contact has no answer
};

/// The contact of a motor under any wave, counted.
class Contact {
 public:
  explicit Contact(const MotionModel& model)
      : model_(&model), floor_(1e-7 * model.full_contact_amplitude) {}

  static constexpr double kOfDesign = -1;

  /// @param amplitude  A [m]; below floor(), where F is linear in A (C20.2, C20.3), F / A and T are those there
  /// @param speed      of the rotor in the direction of the wave [rad/s]
  /// @param frequency  of the wave [Hz]
  /// @param preload    the normal force at this instant [N]; that of the design if it is negative
  ContactForces at(double amplitude, double speed, double frequency, double preload = kOfDesign);

  /// 1e-7 A_1 [m].
  double floor() const { return floor_; }
  /// How many contacts were solved.
  long count() const { return count_; }
  /// Why the last contact without an answer has none; "ok" if all have one.
  const std::string& failure() const { return failure_; }

 private:
  // With radial motion a layer that hardly slips needs more laps than are followed. So below this share of the crest's speed forces
  // are interpolated between that speed and rest, where they have a closed form (R4.1); the error is the square of the share.
  static constexpr double kCreep = 1e-3;
  // Of A_1: smallest amplitude of a contact with a rotor that moves. Below it sliding alone decides, and F is linear in A.
  static constexpr double kLeastRadial = 1e-2;
  // Of the speed above: below it the rotor counts as at rest.
  static constexpr double kNoShare = 1e-8;

  ContactForces solved(double amplitude, double speed, double frequency, double preload);
  ContactForces solved_at(double amplitude, double speed, double frequency, double preload,
                          double least);
  OperatingPoint point(const OperatingConditions& at, double preload) const;

  const MotionModel* model_;
  double floor_;
  long count_{0};
  std::string failure_{"ok"};
  double last_amplitude_{-1}, last_speed_{0}, last_frequency_{0}, last_preload_{0};
  ContactForces last_{};
};

}  // namespace twum::inline v0_1::motion
