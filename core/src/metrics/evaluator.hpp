// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/thresholds.hpp"
#include "metrics/followed_wave.hpp"
#include "metrics/metric_rows.hpp"
#include "metrics/motor_curve.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace twum::inline v0_1::core {

/// Values of metrics. What several of them need is found once. The members between the first and search() are what
/// metric_row() is made of.
class Evaluator {
 public:
  using Number = double;

  explicit Evaluator(const Motor& motor);
  /// Of a motor under a voltage at the one point that is known.
  Evaluator(const Motor& motor, std::unique_ptr<const FollowedCurve> known);
  /// Of a motor under a voltage that stands still, for its thresholds.
  Evaluator(const Motor& motor, std::unique_ptr<const RestCurve> at_rest);

  MetricValue evaluate(const MetricRequest& request);
  /// A point metric at a speed.
  MetricValue evaluate_at(Metric metric, double speed);
  /// At a load of a share of the largest torque; `unreachable` if the motor has no torque.
  MetricValue evaluate_at_share(Metric metric, double share);

  double fixed(double x) const { return x; }
  /// A point metric at a speed.
  double at(Metric metric, double speed);
  double at_peak(Metric metric, const Peak& peak);
  double along_peak(Metric metric, const Peak& peak) { return at(metric, peak.speed); }
  double speed_of_peak(Metric metric, const Peak& peak);
  double crossing(const Crossing& crossing, double /*load*/) const { return crossing.speed; }
  double plateau_of_track() {
    const double end = track_plateau_end(m_, search_.plateau_end());
    return end < begin() ? 0 : end;
  }
  /// A point metric where the running wave ends.
  double at_pull_out(Metric metric);
  double threshold(Metric metric) { return thresholds().at(metric).value; }
  template <typename F>
  double of_modes(F f) const {
    const double found = f(modes());
    if (!std::isfinite(found)) throw SearchFailure{MetricStatus::undefined};
    return found;
  }
  template <typename F>
  double of_motor(F f) const {
    return f(m_);
  }
  template <typename F>
  double of_contact(F f) const {
    return f(m_);
  }
  /// @throws SearchFailure without a geometry
  double of_plate(PlateNumber number) const;
  /// Amplitude of the wave without rotor. @throws SearchFailure without a voltage
  double free_wave() const {
    const StatorModes<double>& m = modes();
    return free_amplitude(m, m_.omega,
                          std::numbers::sqrt2 * voltage() * m.force_factor * m.unequal.share());
  }
  /// Of a phase, rms [V]. @throws SearchFailure without one
  double voltage() const {
    if (!motor_.design().stator.voltage) throw SearchFailure{MetricStatus::undefined};
    return *motor_.design().stator.voltage;
  }
  double product(double a, double b) const { return a * b; }
  CurveSearch& search() { return search_; }

  const Motor& motor() const { return motor_; }
  bool has_drive() const { return motor_.design().stator.voltage.has_value(); }
  const DrivenMotor<double>& first_motor() const { return m_; }
  /// The point at a speed. @throws SearchFailure if it has no answer
  const SolvedPoint& point(double speed) { return known(speed).solved; }
  /// The motor under the wave at a speed.
  const DrivenMotor<double>& motor_at(double speed) { return *known(speed).motor; }
  /// The contact there as a backward wave feels it. @throws SearchFailure if that is not known
  DisturbedContact<double> disturbed_contact_at(double speed);
  /// Smallest speed of the curve [rad/s].
  double begin() const { return curve_->begin(); }
  /// @throws SearchFailure without modal data
  const StatorModes<double>& modes() const;
  /// @throws SearchFailure without modal data
  Thresholds& thresholds();
  /// Where the running wave ends. @throws SearchFailure if it does not
  const CurveNode& pull_out() const;
  MotorPoint pull_out_point() const;

 private:
  struct Known {
    const DrivenMotor<double>* motor;
    SolvedPoint solved;
  };

  bool has_meaning(Metric metric) const;
  template <typename Find>
  MetricValue found(Metric metric, Find find);
  void require_input(Metric metric, double speed);
  const Known& known(double speed);

  const Motor& motor_;
  std::unique_ptr<const Curve> curve_;
  const DrivenMotor<double>& m_;  // under the wave that the curve begins with
  CurveSearch search_;
  std::optional<Thresholds> thresholds_;
  // References stay valid.
  Deque<Known> points_;
  Map<double, std::size_t> places_;  // of a speed among them
  Deque<DrivenMotor<double>> motors_;
};

}  // namespace twum::inline v0_1::core
