// SPDX-License-Identifier: Apache-2.0
#include "performance/evaluator.hpp"

#include <cmath>
#include <limits>

namespace twum::performance {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

MetricValue Evaluator::evaluate(const MetricRequest& request) {
  try {
    const double found = metric_row(*this, request);
    return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                : MetricValue{kNaN, MetricStatus::inaccurate};
  } catch (const SearchFailure& failure) {
    return {kNaN, failure.status};
  }
}

MetricValue Evaluator::evaluate_at_share(Metric metric, double share) {
  const MetricValue largest = evaluate({Metric::max_torque});
  if (largest.status != MetricStatus::ok || !(largest.value > 0))
    return {kNaN, MetricStatus::unreachable};
  return evaluate({metric, Argument::torque, share * largest.value});
}

double Evaluator::at(Metric metric, double speed) {
  if (!wave_meets_rotor(m_, speed)) throw SearchFailure{MetricStatus::out_of_range};
  require_input(metric, speed);
  return point_metric(metric, point(speed).numbers, speed, m_);
}

double Evaluator::at_peak(Metric metric, const Peak& peak) {
  require_input(metric, peak.speed);
  return peak.value;
}

double Evaluator::speed_of_peak(Metric metric, const Peak& peak) {
  require_input(metric, peak.speed);
  return peak.speed;
}

const SolvedPoint& Evaluator::point(double speed) {
  for (const auto& [at, kept] : points_) {
    if (at == speed) return kept;
  }
  const SolvedPoint solved = solve_point(m_, speed);
  if (solved.status != PointStatus::ok) throw SearchFailure{metric_status(solved.status)};
  return points_.emplace_back(speed, solved).second;
}

// An efficiency needs an input power that is more than rounding.
void Evaluator::require_input(Metric metric, double speed) {
  const bool contact_alone = metric == Metric::contact_efficiency_at;
  if (!contact_alone && metric != Metric::efficiency_at) return;
  const PointNumbers<double>& n = point(speed).numbers;
  const double input = n.stator_power + (contact_alone ? 0 : stator_loss(m_));
  if (!(input > 0)) throw SearchFailure{MetricStatus::undefined};
  if (!is_known(input, excess(n, speed))) throw SearchFailure{MetricStatus::inaccurate};
}

}  // namespace twum::performance
