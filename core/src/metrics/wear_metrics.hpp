// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/heat_course.hpp"
#include "wear/worn_design.hpp"

#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>

#include <list>
#include <optional>
#include <utility>
#include <vector>

namespace twum::core {

/// True for what WearMetrics answers.
inline bool is_wear(const MetricRequest& request) {
  return request.worn_at || info(request.metric).needs_wear;
}

/// The life of a motor whose track wears evenly (V2), and metrics of the worn motor.
class WearMetrics {
 public:
  explicit WearMetrics(const MotorDesign& design) : design_(design) {}

  MetricValue evaluate(const MetricRequest& request);
  /// With exact derivatives in all parameters; none of an operation with temperatures.
  MetricDerivative differentiate(const MetricRequest& request, bool fixed_static_friction);

  /// Found once for each load. @param load  none: the operation
  const Life& life(const std::optional<LoadPoint>& load);
  std::vector<WearPoint> course(const std::optional<LoadPoint>& load,
                                const std::vector<double>& depths);

 private:
  /// How fast the track wears at a depth (V2.1).
  struct Rate {
    double depth_rate{0};  ///< nu [m/s]
    double turn_rate{0};   ///< revolutions per second [1/s]
    double contact_temperature{kNoValue};
    Gradient slope{};       ///< of nu by the parameters at a depth that stays, if asked
    Gradient turn_slope{};  ///< and of the turns
  };
  using Loads = std::vector<LoadPhase>;  // their times are shares

  Loads loads(const std::optional<LoadPoint>& load) const;
  bool is_warm() const;
  double ratio(double contact_temperature) const;
  Gradient by_ratio(const std::optional<MetricDerivative>& contact) const;
  Rate rate_of(const MotorDesign& worn, const LoadPhase& load, bool gradient, bool fixed) const;
  std::vector<NodeTemperatures> mission_temperatures(const MotorDesign& worn) const;
  Rate mission_rate(const Loads& loads, const MotorDesign& worn) const;
  /// With its slopes by the new motor's parameters.
  Rate rate(const Loads& loads, double depth, bool gradient, bool fixed) const;

  bool carries(const Loads& loads, double depth) const;
  double last_carried(const Loads& loads, double depth) const;
  double margin(std::size_t limit, double depth) const;
  double root_of(std::size_t limit, double good, double bad) const;
  std::optional<Life> first_limit(double depth) const;
  Life end_of() const;
  void spend(const Loads& loads, Life& life) const;
  Life found_life(const Loads& loads) const;

  double value(const MetricRequest& request);
  Gradient end_slope(const Life& end, bool fixed) const;
  MetricDerivative of_life(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_worn(const MetricRequest& request, const MetricValue& value, bool fixed);

  const MotorDesign& design_;
  std::list<std::pair<std::optional<LoadPoint>, Life>> known_;  // references stay valid
};

}  // namespace twum::core
