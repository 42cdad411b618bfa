// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/motor.hpp>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace twum {

/// Every metric of a motor; definitions in theory section 7.
enum class Metric : unsigned char {
  stall_torque,
  max_torque,
  holding_torque,
  no_load_speed,
  plateau_speed,
  peak_power,
  speed_at_peak_power,
  torque_at_peak_power,
  contact_efficiency_at_peak_power,
  max_efficiency,
  speed_at_max_efficiency,
  contact_half_length,
  contact_ratio,
  max_pressure,
  torque_at,
  speed_at,
  output_power_at,
  stator_power_at,
  friction_power_at,
  layer_loss_at,
  efficiency_at,
  contact_efficiency_at,
  wear_intensity_at,
  stick_fraction_at
};

inline constexpr std::size_t kMetricCount = 24;

/// What a metric is asked at.
enum class Argument : unsigned char {
  none,            ///< nothing: a number of the motor, such as stall_torque
  speed,           ///< a rotor speed [rad/s]
  torque,          ///< a load torque [N m]
  speed_or_torque  ///< either; only in the table, never in a request
};

/// One row of the metric table.
struct MetricInfo {
  Metric metric;
  std::string_view name;  ///< as in studies, such as "torque_at"
  std::string_view unit;  ///< SI unit, "1" if dimensionless
  Argument argument;      ///< what it takes
  std::string_view text;  ///< what it is, in one line
};

/// The table, one row for each Metric, in its order.
std::span<const MetricInfo> metric_table();
const MetricInfo& info(Metric metric);
std::optional<Metric> find_metric(std::string_view name);

/// A metric and what it is asked at, in SI units: {Metric::torque_at, Argument::speed, 10.5}.
struct MetricRequest {
  Metric metric{Metric::stall_torque};
  Argument argument{Argument::none};
  double at{0};  ///< rotor speed [rad/s] or load torque [N m]
};

enum class MetricStatus : unsigned char {
  ok,
  undefined,  ///< has no meaning for this motor: no stall torque, no stator damping, no input power
  unreachable,        ///< the motor cannot carry the torque asked for
  no_periodic_state,  ///< needs a point without a periodic state
  not_converged,      ///< needs a point that did not converge
  resonance,          ///< needs a point at an undamped resonance
  unresolved,         ///< needs a point with too many zones
  out_of_range        ///< asked at a speed at or below the negative wave speed
};

/// Short machine-readable word, such as "unreachable"; "ok" for ok.
const char* to_string(MetricStatus status) noexcept;

/// A metric's value in SI units; NaN unless status is ok.
struct MetricValue {
  double value{0};
  MetricStatus status{MetricStatus::ok};
};

/// What a gradient can be trusted for.
enum class Smoothness : unsigned char {
  smooth,     ///< the derivative
  flat,       ///< exactly zero in the amplitude, thickness, ... here: the value sits on a plateau
  one_sided,  ///< at a kink or jump: the derivative of the branch the value lies on
  undefined   ///< no derivative; entries are NaN
};

const char* to_string(Smoothness smoothness) noexcept;

/// A metric with its derivatives with respect to every parameter, in SI units.
///
/// gradient[index_of(p)] is the derivative with the other parameters that are in use held fixed and
/// those that follow from them moving along: E moves G, gamma; h moves m; mu moves mu_0 in proportion
/// (set `fixed_static_friction` to hold mu_0). It is 0 for a parameter that is not in use (in_use()).
struct MetricDerivative {
  MetricValue value;
  std::array<double, kParameterCount> gradient{};
  Smoothness smoothness{Smoothness::smooth};
};

/// Derivatives of an operating point with respect to the rotor speed. SI units.
struct SpeedDerivative {
  OperatingPoint point;
  double torque{0};          ///< dT / dOmega [N m s]
  double output_power{0};    ///< [W s]
  double stator_power{0};    ///< [W s]
  double friction_power{0};  ///< [W s]
  double layer_loss{0};      ///< [W s]
  double stick_fraction{0};  ///< [s]
  Smoothness smoothness{Smoothness::smooth};
};

/// Operating point with its derivatives in speed; NaN and `undefined` where the point has no answer.
/// About twice the cost of the point. @throws InputError as Motor::operating_point.
SpeedDerivative differentiate_in_speed(const Motor& motor, double speed);

/// Metrics of a motor, in the order asked. Work shared by several metrics is done once.
/// About 40 microseconds for all metrics without argument.
std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests);
MetricValue evaluate(const Motor& motor, const MetricRequest& request);

/// Metrics with exact derivatives: forward mode through the closed forms, implicit differentiation at
/// every root.
std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction = false);

}  // namespace twum
