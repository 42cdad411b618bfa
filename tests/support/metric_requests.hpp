// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace twum::test {

/// The envelope of a drive that follows takes a search of a hundred points; it has tests of its own.
inline bool is_of_envelope(Metric metric) {
  return metric == Metric::held_speed_limit_at || metric == Metric::held_torque_limit_at;
}

/// Every metric but the envelope once, those at a speed or a torque [SI] there; those at either at both.
inline std::vector<MetricRequest> every_metric(double speed, double torque) {
  std::vector<MetricRequest> list;
  for (const MetricInfo& row : metric_table()) {
    if (is_of_envelope(row.metric)) continue;
    const bool both = row.argument == Argument::speed_or_torque || row.argument == Argument::either;
    if (row.argument == Argument::none) list.push_back({row.metric});
    if (both || row.argument == Argument::speed)
      list.push_back({row.metric, Argument::speed, speed});
    if (both || row.argument == Argument::torque)
      list.push_back({row.metric, Argument::torque, torque});
  }
  return list;
}

/// Their values at a design; NaN where there is none.
inline std::vector<double> values_of(const MotorDesign& design,
                                     const std::vector<MetricRequest>& asked) {
  std::vector<double> list;
  for (const MetricValue& v : evaluate(Motor(design), asked)) list.push_back(v.value);
  return list;
}

/// How far exact gradients are from differences of the values.
struct GradientCheck {
  int compared{0};
  double worst{
      0};  ///< deviation in parts of |value| + |derivative|, both derivatives times the parameter
  std::string where;  ///< metric and parameter of the worst
};

/// Compares all derivatives that are defined, but for those of whole numbers, of zeros, and of mu_0, which has none from below
/// where it is mu.
/// @param step  of Richardson's extrapolation, in parts of the parameter
inline GradientCheck against_differences(const MotorDesign& design,
                                         const std::vector<MetricRequest>& asked, double step) {
  GradientCheck check;
  const std::vector<MetricDerivative> found = differentiate(Motor(design), asked);
  for (const ParameterInfo& row : parameter_table()) {
    const bool left_out = row.integer || row.parameter == Parameter::static_friction;
    if (left_out || !in_use(design, row.parameter) || get(design, row.parameter) == 0) continue;
    const double x = get(design, row.parameter), d = step * x;
    const auto at = [&](double by) {
      return values_of(with(design, row.parameter, x + by), asked);
    };
    const auto p1 = at(d), m1 = at(-d), p2 = at(2 * d), m2 = at(-2 * d);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (found[i].value.status != MetricStatus::ok || found[i].smoothness == Smoothness::undefined)
        continue;
      const double one = (p1[i] - m1[i]) / (2 * d), two = (p2[i] - m2[i]) / (4 * d);
      const double slope = (4 * one - two) / 3;
      const double scale = std::fabs(found[i].value.value) + std::fabs(slope * x) + 1e-12;
      const double off =
          std::fabs((found[i].gradient[index_of(row.parameter)] - slope) * x) / scale;
      ++check.compared;
      if (off <= check.worst) continue;
      check.worst = std::isnan(off) ? HUGE_VAL : off;
      check.where = std::string(info(asked[i].metric).name) + " by " + std::string(row.name);
    }
  }
  return check;
}

}  // namespace twum::test
