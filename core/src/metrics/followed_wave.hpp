// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/curve.hpp"
#include "drive/drive.hpp"
#include "heat/heat_state.hpp"

#include <twum/core/load.hpp>
#include <twum/core/motor_design.hpp>

#include <memory>

namespace twum::inline v0_1::core {

/// True for a load whose wave can be followed from motor to motor: a voltage holds it on the running branch.
bool follows_wave(const MotorDesign& design, const LoadPoint& load);

/// The one point of a torque-speed curve that a load takes, found from that of nearly the same motor: a few operating points in
/// place of the whole branch.
class FollowedCurve final : public Curve {
 public:
  /// H = Theta u_0 (D2.4), and at a torque T = T_L with it, by Newton's method over amplitude and speed. Null where this does not
  /// lead straight to a wave that is stable, and at a torque to a speed that is.
  static std::unique_ptr<const FollowedCurve> from(const MotorDesign& design, const LoadPoint& load,
                                                   const LoadWave& near);

  /// The running wave at a speed where running_point() finds it, else null.
  static std::unique_ptr<const FollowedCurve> at_speed(const DrivenWaves& waves, double speed);

  double speed() const { return begin(); }
  const MotorPoint& found() const { return found_; }
  /// Not searched: both throw. @{
  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;
  /// @}

 private:
  FollowedCurve(MotorPoint found, double speed)
      : Curve(found_.motor, Waves::each_its_own, speed), found_(std::move(found)) {}

  MotorPoint found_;
};

}  // namespace twum::inline v0_1::core
