// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/heat_course.hpp"
#include "metrics/heat_sensitivity.hpp"

#include <cmath>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <utility>

namespace twum::inline v0_1::core {

/// Parts with a limit, which are the first, and their limits.
inline constexpr std::array kTemperatureLimits{
    Parameter::stator_temperature_limit, Parameter::rotor_temperature_limit,
    Parameter::housing_temperature_limit, Parameter::contact_temperature_limit};

/// True for what HeatMetrics answers: metrics of the motor's temperatures, and any metric of the warm motor.
inline bool is_heat(const MetricRequest& request) {
  return request.warm_at || info(request.metric).needs_thermal;
}

/// The load of a metric at one.
inline LoadPoint load_of(const MetricRequest& request) {
  return {request.argument, request.at, request.torque};
}

/// Whether a temperature is asked for after a time, and not for ever.
inline bool is_timed(const MetricRequest& request) {
  return request.after && info(request.metric).timed && std::isfinite(*request.after);
}

/// The part whose temperature a metric is.
std::optional<std::size_t> part_of(Metric metric);

/// Metrics of the motor's temperatures, and those of the motor at its steady temperatures (H6.1). A steady state that several need
/// is found once.
class HeatMetrics {
 public:
  /// @param motor  has to outlive this
  explicit HeatMetrics(const Motor& motor) : motor_(motor), design_(motor.design()) {}

  MetricValue evaluate(const MetricRequest& request);
  /// With exact derivatives in all parameters; thermal_gain_at has none.
  MetricDerivative differentiate(const MetricRequest& request, bool fixed_static_friction);

 private:
  /// A load, and the steady state that the cold motor reaches under it.
  struct Known {
    LoadPoint load;
    SteadyState steady;
    PartValues<double> parts;  // absolute
  };
  /// The derivatives of a steady state (H6.1).
  struct Moves {
    std::array<Gradient, kParts> parts;  // of the temperatures
    std::array<Gradient, 3> nodes;       // of those that parameters follow
  };
  const HeatNetwork& network();
  const std::shared_ptr<WarmMotors>& motors();
  HeatProblem problem(const LoadPoint& load);
  const Known& known(const LoadPoint& load);
  /// Without a status beside ok. @throws SearchFailure
  const Known& steady(const LoadPoint& load);
  double value(const MetricRequest& request);
  double margin(const Known& known) const;
  std::size_t hottest(const Known& known) const;

  /// Phi_q: derivatives of the parts' temperatures with the nodes', which parameters follow, held; and p_x.
  struct Rows {
    std::array<Gradient, kParts> parts;
    std::array<Vector3, kSources> slope;
  };
  std::optional<Rows> at_fixed_nodes(const Known& known, bool fixed);
  std::optional<Moves> moves(const Known& known, bool fixed);
  std::array<Gradient, kParts> by_network(const Known& known, bool fixed);
  MetricDerivative of_margin(const Known& known, const MetricValue& value, bool fixed);
  MetricDerivative of_parts(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_warm(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_time_constant(const MetricValue& value, bool fixed);

  /// What ends the torques up to which the motor runs for ever.
  enum class Limiting : unsigned char {
    temperature,
    fold,  ///< of steady states
    lost,  ///< the warm motor does not carry more
    load   ///< the cold motor does not carry more
  };
  struct Continuous {
    Known state;
    double torque;
    Limiting limiting;
  };
  LoadPoint load_with(const MetricRequest& request, double torque) const;
  double most_torque(const MetricRequest& request);
  Known followed(const LoadPoint& load, const NodeTemperatures& from);
  bool keeps_limits(const Known& known) const;
  Continuous continuous(const MetricRequest& request);
  MetricDerivative of_continuous(const MetricRequest& request, const MetricValue& value,
                                 bool fixed);
  MetricDerivative of_limit(const MetricRequest& request, const Continuous& found,
                            const MetricValue& value, bool fixed);
  MetricDerivative of_fold(const MetricRequest& request, const Continuous& found,
                           const MetricValue& value, bool fixed);
  /// Temperatures of the nodes: steady at a load, or the mean over the operation.
  NodeTemperatures nodes(const LoadPoint& load);
  std::optional<std::array<Gradient, 3>> node_moves(const LoadPoint& load, bool fixed);

  /// The operation, which returns.
  struct Operation {
    HeatCourse course;
    HeatCourse::Lap lap;
  };
  const Operation& operation();
  CourseSensitivity& sensitivity(bool fixed);
  NodeTemperatures mean_nodes();
  std::array<Gradient, 3> mean_moves(bool fixed);
  double peak(std::size_t part);
  MetricDerivative of_peak(std::size_t part, const MetricValue& value, bool fixed);
  /// The part that reaches its limit, and when.
  struct OnTime {
    HeatCourse course;
    HeatCourse::Lap lap;
    HeatCourse::Moment moment;
    std::size_t part;
  };
  OnTime on_time(const LoadPoint& load) const;
  MetricDerivative of_on_time(const LoadPoint& load, const MetricValue& value, bool fixed) const;
  /// The part that just keeps its limit in a cycle with a load for a share of the operation's period.
  struct Shared {
    HeatCourse course;
    HeatCourse::Lap lap;
    HeatCourse::Moment moment;
    std::size_t part;
    double margin;
  };
  Shared shared(const LoadPoint& load, double share) const;
  struct DutyLimit {
    double share;
    std::optional<Shared> at;  ///< where a temperature limits it
    Limiting limiting;         ///< load: it may stay for ever, or not at all
  };
  DutyLimit duty_limit(const LoadPoint& load);
  MetricDerivative of_duty_limit(const LoadPoint& load, const MetricValue& value, bool fixed);
  /// A load from ambient temperature on, for as long as was asked. No state depends on what else is asked.
  struct WarmUp {
    LoadPoint load;
    bool searches;  // the wave at every step, in place of following it
    HeatCourse course;
    HeatSolver::Way way;
    HeatCourse::Lap lap{};  // its states
    std::unique_ptr<CourseSensitivity> sensitivity{};
  };
  WarmUp& known_warm_up(const LoadPoint& load, bool searches);
  /// That reaches this time with the wave that the motor has.
  WarmUp& warm_up(const LoadPoint& load, double time);
  double after(const MetricRequest& request);
  MetricDerivative of_after(const MetricRequest& request, const MetricValue& value, bool fixed);
  double voltage_to_spare(double temperature) const;
  double start_temperature();
  MetricDerivative of_start(const MetricValue& value, bool fixed);

  const Motor& motor_;
  const MotorDesign& design_;
  std::shared_ptr<WarmMotors> motors_;
  std::optional<HeatNetwork> network_;
  std::list<Known> known_;  // references stay valid
  std::list<WarmUp> warm_ups_;
  std::optional<Operation> operation_;
  std::unique_ptr<CourseSensitivity> sensitivity_;  // of the operation
};

}  // namespace twum::inline v0_1::core
