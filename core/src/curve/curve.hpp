// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "point/point.hpp"
#include "point/point_derivatives.hpp"

#include <twum/core/metric_value.hpp>

#include <cstddef>
#include <cstdint>

namespace twum::inline v0_1::core {

/// Thrown inside a search when a point has no answer; the metric takes the status.
struct SearchFailure {
  MetricStatus status;
};

/// A number with its slope in speed.
struct Sloped {
  double value{0}, slope{0};
};

/// A point of a torque-speed curve: what a search compares.
struct CurvePoint {
  static constexpr std::uint64_t kNoSignature = ~std::uint64_t{0};

  double speed{0}, torque{0};  ///< [rad/s], [N m]
  double input{0};             ///< stator power and stator loss (T7.7) [W]
  double electrical_input{0};  ///< the power at the terminals (D4.3), NaN if it is not known [W]
  MetricStatus status{MetricStatus::ok};
  bool plateau{false};                    ///< the whole contact slips and drives
  bool special{false};                    ///< in closed form: tells its neighbours nothing
  std::uint64_t signature{kNoSignature};  ///< of the sequence of zones, if there is an answer
  WarmStart start{};                      ///< for neighbouring points
  long lost{0};                           ///< zones followed in vain, without an answer

  bool ok() const { return status == MetricStatus::ok; }
};

/// The same with slopes.
struct CurveSlope {
  double speed{0};
  Sloped torque, input, electrical_input;  ///< as of CurvePoint
  WarmStart start{};
};

/// A torque-speed curve that can be searched: says what the motor does at a speed. The wave may be the same at every
/// speed (PrescribedCurve) or follow from the speed, as that of a motor under a voltage does.
class Curve : public InWorkspace {
 public:
  virtual ~Curve() = default;
  Curve(const Curve&) = delete;
  Curve& operator=(const Curve&) = delete;

  /// The point at a speed; its status says why it has no answer, as below the beginning or beyond the end of the curve.
  /// @param guess     what a neighbouring point says of the layer; null: nothing
  /// @param accuracy  of the periodic state, as find_periodic_state()
  virtual CurvePoint point(double speed, const WarmStart* guess, double accuracy) const = 0;

  /// Number of slices of the contact, if each can be solved by itself at a speed; 0 if the wave depends on all of them.
  virtual std::size_t own_slices() const { return 0; }
  /// One of these slices at a speed.
  virtual SliceAnswer slice(double /*speed*/, std::size_t /*index*/) const { return {}; }

  /// Points of a curve that had to be followed to know it, by rising speed, as exact as CurveScan wants them.
  virtual Vector<CurvePoint> known_points() const { return {}; }

  /// Slopes along the curve, the wave moving with the speed.
  /// @throws SearchFailure if the point has no answer
  virtual CurveSlope slope(double speed, const WarmStart* guess) const = 0;

  /// The motor under the wave that the curve begins with. It gives the scales of a search and the end of the plateau: as
  /// long as the whole contact slips, the wave does not feel the speed.
  const DrivenMotor<double>& motor() const { return motor_; }
  /// Smallest speed that has a point [rad/s]; 0 is the limit of rest.
  double begin() const { return begin_; }

  double crest() const { return motor_.mean.crest_velocity / motor_.r; }  ///< V0 / r [rad/s]
  double holding() const { return holding_torque(motor_); }               ///< mu_0 F_N r [N m]
  /// The input is more than what the contact takes, so that an efficiency means something at no-load (T7.18).
  bool has_input() const { return motor_.stator_damping > 0; }
  bool may_jump() const { return core::may_jump(motor_); }
  bool has_static_excess() const { return core::has_static_excess(motor_); }
  /// The torque never rises with the speed, but for what the speed takes from the wave's turn (E6.7).
  bool falls() const { return one_wave_ && !has_static_excess(); }

 protected:
  enum class Waves { one, each_its_own };

  /// @param motor  has to outlive the curve
  Curve(const DrivenMotor<double>& motor, Waves waves, double begin = 0)
      : motor_(motor), one_wave_(waves == Waves::one), begin_(begin) {}

 private:
  const DrivenMotor<double>& motor_;
  bool one_wave_;
  double begin_;
};

}  // namespace twum::inline v0_1::core
