// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/wear_course.hpp"

#include <twum/core/metrics.hpp>

#include <list>
#include <optional>

namespace twum::inline v0_1::core {

/// True for what WearMetrics answers.
inline bool is_wear(const MetricRequest& request) {
  return request.worn_at || info(request.metric).needs_wear;
}

/// The life of a motor whose track wears evenly (V2), and metrics of the worn motor.
class WearMetrics {
 public:
  explicit WearMetrics(const MotorDesign& design) : design_(design) {}

  MetricValue evaluate(const MetricRequest& request);
  /// With exact derivatives in all parameters.
  MetricDerivative differentiate(const MetricRequest& request, bool fixed_static_friction);

 private:
  /// Found once for each load; none: the operation.
  WearCourse& course(const std::optional<LoadPoint>& load);
  /// Of a motor that has a life. @throws SearchFailure
  WearCourse& lived(const std::optional<LoadPoint>& load);
  double value(const MetricRequest& request);
  Gradient end_slope(WearCourse& course, bool fixed) const;
  MetricDerivative of_life(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_worn(const MetricRequest& request, const MetricValue& value, bool fixed);

  const MotorDesign& design_;
  std::list<WearCourse> courses_;  // references stay valid
};

}  // namespace twum::inline v0_1::core
