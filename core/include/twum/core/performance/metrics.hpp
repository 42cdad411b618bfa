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
  layer_aspect,
  pressure_nonuniformity,
  max_overall_efficiency,
  speed_at_max_overall_efficiency,
  pull_out_torque,
  start_voltage,
  hold_voltage,
  start_frequency,
  pull_out_frequency,
  loaded_resonance,
  coupling_factor,
  capacitance_ratio,
  mode_separation,
  ceramic_stress,
  torque_at,
  speed_at,
  output_power_at,
  stator_power_at,
  friction_power_at,
  layer_loss_at,
  efficiency_at,
  contact_efficiency_at,
  wear_intensity_at,
  stick_fraction_at,
  amplitude_at,
  phase_lag_at,
  electrical_power_at,
  overall_efficiency_at,
  phase_current_at,
  power_factor_at,
  backward_ratio_at,
  squeal_rate_at,
  sensor_voltage_at,
  sensor_phase_at
};

/// Rows of the metric table.
inline constexpr std::size_t kMetricCount = 48;

/// What a metric is asked at.
enum class Argument : unsigned char {
  none,            ///< nothing: a number of the motor, such as stall_torque
  speed,           ///< a rotor speed [rad/s]
  torque,          ///< a load torque [N m]
  speed_or_torque  ///< either; only in the table, never in a request
};

/// One row of the metric table.
struct MetricInfo {
  Metric metric;               ///< whose row it is
  std::string_view name;       ///< as in studies, such as "torque_at"
  std::string_view unit;       ///< SI unit, "1" if dimensionless
  Argument argument;           ///< what it takes
  std::string_view text;       ///< what it is, in one line
  bool needs_modes{false};     ///< has a value only where the design has modal data of the stator
  bool needs_geometry{false};  ///< has a value only where the stator is given by its geometry
};

/// The table, one row for each Metric, in its order; static lifetime.
std::span<const MetricInfo> metric_table();

/// The row of a metric; static lifetime.
const MetricInfo& info(Metric metric);

/// The metric of a name such as "torque_at"; nothing if there is none.
std::optional<Metric> find_metric(std::string_view name);

/// A metric and what it is asked at, in SI units: {Metric::torque_at, Argument::speed, 10.5}. A metric
/// that takes nothing does not look at `at`; with Argument::none a metric that takes a speed, or
/// either, takes `at` for a speed, and speed_at takes it for a torque.
struct MetricRequest {
  Metric metric{Metric::stall_torque};  ///< what is asked
  Argument argument{Argument::none};    ///< what `at` is
  double at{0};                         ///< rotor speed [rad/s] or load torque [N m]
};

/// Whether a metric has a value.
enum class MetricStatus : unsigned char {
  ok,
  undefined,  ///< has no meaning for this motor: no stall torque, no stator damping, no input power
  unreachable,         ///< the motor cannot carry the torque asked for
  no_periodic_state,   ///< needs a point without a periodic state
  not_converged,       ///< needs a point that did not converge
  resonance,           ///< needs a point at an undamped resonance
  unresolved,          ///< needs a point with too many zones
  inaccurate,          ///< needs a point where rounding breaks a law, or is not finite
  out_of_range,        ///< asked at a speed at or below the negative wave speed
  pulled_out,          ///< under the voltage there is no running wave at the speed that is needed
  no_running_branch,   ///< under the voltage there is no running wave at any speed
  no_dead_branch,      ///< the motor starts by itself
  unstable_amplitude,  ///< needs a wave that grows or decays away from its balance
  backward_wave_unknown,  ///< the layer sticks and has damping or inertia, or mu_0 > mu: no theory of the backward wave
  does_not_pull_out  ///< the running wave exists down to rest
};

/// Short machine-readable word, such as "unreachable"; "ok" for ok. Static lifetime.
const char* to_string(MetricStatus status) noexcept;

/// A metric's value in SI units; NaN unless status is ok.
struct MetricValue {
  double value{0};                        ///< in the unit of its row
  MetricStatus status{MetricStatus::ok};  ///< why there is none
};

/// What a gradient can be trusted for.
enum class Smoothness : unsigned char {
  smooth,     ///< the derivative
  flat,       ///< exactly zero in the amplitude, thickness, ... here: the value sits on a plateau
  one_sided,  ///< at a kink or jump: the derivative of the branch the value lies on
  undefined   ///< no derivative; entries are NaN
};

/// "smooth", "flat", "one-sided" or "undefined"; static lifetime.
const char* to_string(Smoothness smoothness) noexcept;

/// A metric with its derivatives with respect to every parameter, in SI units.
///
/// gradient[index_of(p)] is the derivative with the other parameters that are in use held fixed and
/// those that follow from them moving along: E moves G, gamma; h moves m; mu moves mu_0 in proportion
/// (set `fixed_static_friction` to hold mu_0). It is 0 for a parameter that is not in use (in_use()).
struct MetricDerivative {
  MetricValue value;                               ///< bit for bit that of evaluate()
  std::array<double, kParameterCount> gradient{};  ///< SI; NaN where undefined
  Smoothness smoothness{Smoothness::smooth};       ///< what the gradient is good for
};

/// Derivatives of an operating point with respect to the rotor speed. SI units.
struct SpeedDerivative {
  OperatingPoint point;                       ///< the point itself
  double torque{0};                           ///< dT / dOmega [N m s]
  double output_power{0};                     ///< [W s]
  double stator_power{0};                     ///< [W s]
  double friction_power{0};                   ///< [W s]
  double layer_loss{0};                       ///< [W s]
  double stick_fraction{0};                   ///< [s]
  Smoothness smoothness{Smoothness::smooth};  ///< what the derivatives are good for
};

/// Operating point with its derivatives in speed; NaN and `undefined` where the point has no answer.
/// Smooth means that no zone comes or goes within 1e-9 of the crest speed, or that the layer is elastic with
/// mu_0 = mu, where that does no harm. About five times the cost of the point.
/// @param speed  rotor speed [rad/s], > -motor.wave_speed().
/// @throws InputError as Motor::operating_point.
SpeedDerivative differentiate_in_speed(const Motor& motor, double speed);

/// Metrics of a motor as T7.1 to T7.18 define them, in the order asked. Work shared by several metrics is
/// done once. About 30 microseconds for all metrics without argument, a microsecond for a point metric at
/// a speed; about 300 microseconds where mu_0 > mu. Never throws for a number asked at: a speed at or below
/// -motor.wave_speed() has the status out_of_range, a torque beyond the motor's is unreachable.
/// Continuous in the parameters but for jumps where mu_0 > mu; differentiate() says how smooth.
/// @{
std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests);
MetricValue evaluate(const Motor& motor, const MetricRequest& request);
/// @}

/// Metrics with exact derivatives: forward mode through the closed forms, implicit differentiation at
/// every root. All derivatives of all metrics together cost about 2.6 times the metrics alone.
/// Never throws for a number asked at, as evaluate(). For the number of wavelengths of a motor with a geometry, and for radii of
/// its plate that coincide, see parameter_jacobian().
/// @param fixed_static_friction  mu_0 stays where it is when mu moves; otherwise it keeps its ratio
std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction = false);

/// A point metric, or speed_at, at a load of a share of the largest torque, a load that moves with the design: a search that
/// has left the motors that carry a load sees finite numbers there. The status is `unreachable` if there is no torque at all.
/// @param share  of the largest torque [1], more than 0 and below 1
/// @{
MetricValue evaluate_at_share(const Motor& motor, Metric metric, double share);
MetricDerivative differentiate_at_share(const Motor& motor, Metric metric, double share,
                                        bool fixed_static_friction = false);
/// @}

}  // namespace twum
