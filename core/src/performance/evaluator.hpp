// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/curve/prescribed_curve.hpp"
#include "performance/metric_rows.hpp"

#include <deque>
#include <utility>

namespace twum::performance {

/// Values of metrics. What several of them need is found once. The members between the first and search() are what
/// metric_row() is made of.
class Evaluator {
 public:
  using Number = double;

  explicit Evaluator(const DrivenMotor<double>& motor)
      : m_(motor), curve_(motor), search_(curve_) {}

  MetricValue evaluate(const MetricRequest& request);
  /// At a load of a share of the largest torque; `unreachable` if the motor has no torque.
  MetricValue evaluate_at_share(Metric metric, double share);

  double fixed(double x) const { return x; }
  /// A point metric at a speed.
  double at(Metric metric, double speed);
  double at_peak(Metric metric, const Peak& peak);
  double along_peak(Metric metric, const Peak& peak) { return at(metric, peak.speed); }
  double speed_of_peak(Metric metric, const Peak& peak);
  double crossing(const Crossing& crossing, double /*load*/) const { return crossing.speed; }
  double plateau_of_track() { return track_plateau_end(m_, search_.plateau_end()); }
  template <typename F>
  double of_motor(F f) const {
    return f(m_);
  }
  template <typename F>
  double of_contact(F f) const {
    return f(m_);
  }
  CurveSearch& search() { return search_; }

  const DrivenMotor<double>& motor() const { return m_; }
  /// The point at a speed. @throws SearchFailure if it has no answer
  const SolvedPoint& point(double speed);

 private:
  void require_input(Metric metric, double speed);

  const DrivenMotor<double>& m_;
  PrescribedCurve curve_;
  CurveSearch search_;
  std::deque<std::pair<double, SolvedPoint>> points_;  // references stay valid
};

}  // namespace twum::performance
