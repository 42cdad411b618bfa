// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/heat_course.hpp"
#include "metrics/worn_motors.hpp"

#include <twum/core/load.hpp>
#include <twum/core/metrics.hpp>

#include <list>
#include <optional>
#include <vector>

namespace twum::inline v0_1::core {

/// How fast a track wears at a depth (V2.1).
struct WearRate {
  double depth{0};                       ///< nu [m/s]
  double turns{0};                       ///< revolutions per second [1/s]
  double contact_temperature{kNoValue};  ///< of the hottest load [K]
  Gradient depth_slope{};                ///< of nu by the new motor's parameters, if asked
  Gradient turn_slope{};                 ///< and of the turns
};

/// Rates of wear of a motor at depths, under a load or in its operation, at the steady temperatures if it has some that matter.
class WearRates {
 public:
  /// @param design  with a wear block; has to outlive this
  /// @param load    none: the operation of the design
  /// @throws SearchFailure without an operation
  WearRates(const MotorDesign& design, const std::optional<LoadPoint>& load);

  /// @throws SearchFailure where the worn motor has no such point; likewise below
  WearRate at(double depth);
  WearRate with_slopes(double depth, bool fixed_static_friction);
  bool carries(double depth);
  /// As WornMotors::confirm_or_stop_following().
  bool confirm_or_stop_following(double depth);
  /// Under the design's own voltage.
  WornMotors& motors() { return motors({}); }

 private:
  WornMotors& motors(const std::optional<double>& voltage);
  bool is_warm() const;
  bool is_mission() const;
  double ratio(double contact_temperature) const;
  Gradient by_ratio(const std::optional<MetricDerivative>& contact) const;
  std::vector<MetricRequest> asked(const LoadPoint& load) const;
  WearRate of_load(const LoadPhase& phase, double depth);
  WearRate of_load_with_slopes(const LoadPhase& phase, double depth, bool fixed);
  WearRate rate_with_slopes(const LoadPoint& load, const MetricDerivative& intensity,
                            const std::optional<MetricDerivative>& speed,
                            const std::optional<MetricDerivative>& contact) const;
  WearRate of_warm_operation(double depth) const;
  WearRate of_warm_operation_with_slopes(double depth, bool fixed) const;
  template <typename RateOf>
  WearRate sum(RateOf rate_of) const;

  const MotorDesign& design_;
  std::vector<LoadPhase> loads_;  // their times are shares
  std::list<WornMotors> motors_;  // references stay valid
};

}  // namespace twum::inline v0_1::core
