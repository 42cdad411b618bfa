// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_request.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace twum::inline v0_1 {

/// Rows of the metric table.
inline constexpr std::size_t kMetricCount =
    static_cast<std::size_t>(Metric::terminal_voltage_at) + 1;

/// One row of the metric table.
struct MetricInfo {
  Metric metric;                ///< whose row it is
  std::string_view name;        ///< as in studies, such as "torque_at"
  std::string_view unit;        ///< SI unit, "1" if dimensionless
  Argument argument;            ///< what it takes
  std::string_view text;        ///< what it is, in one line
  bool needs_modes{false};      ///< has a value only where the design has modal data of the stator
  bool needs_geometry{false};   ///< has a value only where the stator is given by its geometry
  bool needs_thermal{false};    ///< has a value only where the design has a thermal block
  bool absolute{false};         ///< an absolute temperature, which may be compared with degC
  bool needs_operation{false};  ///< has a value only where the design has an operation
  bool needs_wear{false};       ///< has a value only where the design has a wear block
  bool needs_motion{
      false};  ///< of a rotor with inertia, where motions are computed (has_motion_metrics())
  bool timed{false};  ///< may be asked for a time after the motor took up the load
};

/// The table, one row for each Metric, in its order; static lifetime.
std::span<const MetricInfo> metric_table();

/// The row of a metric; static lifetime.
const MetricInfo& info(Metric metric);

/// True for lives and metrics of the motor at the end of its life, but not for the rate at which the new motor wears.
inline bool is_of_life(const MetricRequest& request) {
  return request.worn_at ||
         (info(request.metric).needs_wear && request.metric != Metric::wear_rate_at);
}

/// The metric with a name such as "torque_at", if there is one.
std::optional<Metric> find_metric(std::string_view name);

/// A metric with its derivatives with respect to every parameter, in SI units.
///
/// gradient[index_of(p)] is the derivative with the other parameters in use held fixed. Parameters that follow from p
/// move with it: E moves G, gamma; h moves m; mu moves mu_0 in proportion (set `fixed_static_friction` to hold mu_0).
/// It is 0 for a parameter that is not in use (in_use()).
struct MetricDerivative {
  MetricValue value;                               ///< bit for bit that of evaluate()
  std::array<double, kParameterCount> gradient{};  ///< SI; NaN where undefined
  Smoothness smoothness{Smoothness::smooth};       ///< what the gradient can be used for
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
  Smoothness smoothness{Smoothness::smooth};  ///< what the derivatives can be used for
};

/// Operating point with its derivatives in speed; NaN and `undefined` where the point has no answer. `smooth` means
/// that no zone appears or vanishes within 1e-9 of the crest speed, or that the layer is elastic with mu_0 = mu,
/// where a zone that appears or vanishes leaves the derivative continuous. About five times the cost of the point.
/// @param speed  rotor speed [rad/s], > -motor.wave_speed().
/// @throws InputError as Motor::operating_point.
SpeedDerivative differentiate_in_speed(const Motor& motor, double speed);

/// Metrics of a motor as T7.1 to T7.18 define them, in the order asked. Work shared by several metrics is done once.
/// With one slice and a given amplitude about 30 microseconds for all metrics without argument, a microsecond for a point
/// metric at a speed; about 300 microseconds where mu_0 > mu. With `auto` slices, as in ring-60.yaml, about a millisecond
/// for all metrics. No argument makes it throw: a speed at or below -motor.wave_speed() gives the status
/// out_of_range, a torque that the motor cannot carry gives unreachable. Continuous in the parameters except for
/// jumps where mu_0 > mu; a track that `auto` splits there (W4.5) has none. differentiate() returns the smoothness.
/// @{
std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests);
MetricValue evaluate(const Motor& motor, const MetricRequest& request);
/// @}

/// The same in the memory of a workspace, with the values in an array of the caller's. In a workspace that is large enough metrics
/// of the torque-speed curve and of held points take nothing from the heap, but for the exception inside of one that turns out to
/// have no value. Reserves of voltage, heat, wear and motions take some, and so do held points of a motor whose design holds lists,
/// such as an operation.
/// @param values  as many as there are requests
/// @throws InputError for another number of values
void evaluate(const Motor& motor, std::span<const MetricRequest> requests,
              std::span<MetricValue> values, Workspace& workspace);

/// Metrics with exact derivatives: forward mode through the closed forms, implicit differentiation at every root. All
/// derivatives of all metrics together cost about 2.6 times the metrics alone. No argument makes it throw, as for
/// evaluate(). For the number of wavelengths of a motor with a geometry, and for radii of its plate that coincide,
/// see parameter_jacobian().
/// @param fixed_static_friction  mu_0 stays where it is when mu moves; otherwise it keeps its ratio
std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction = false);
/// The same of one request.
MetricDerivative differentiate(const Motor& motor, const MetricRequest& request,
                               bool fixed_static_friction = false);

/// A point metric, or speed_at, at a load that is a fixed share of the motor's largest torque, so that the load moves
/// with the design. An optimizer that has left the region of motors that carry a fixed load still gets finite
/// numbers. The status is `unreachable` if the motor has no torque at all.
/// @param share  of the largest torque [1], more than 0 and below 1
/// @{
MetricValue evaluate_at_share(const Motor& motor, Metric metric, double share);
MetricDerivative differentiate_at_share(const Motor& motor, Metric metric, double share,
                                        bool fixed_static_friction = false);
/// @}

/// A metric at a torque and a speed that the drive cannot hold: that of the wave that more voltage or amplitude, or another
/// frequency, would hold, or of (1 - 1e-4) of the largest torque where the torque is beyond that (Y5.3). Continuous where the drive
/// just holds it, so that an optimizer outside gets numbers; torque_reserve_at and drive_reserve_at tell how far it has to go.
/// @{
MetricValue evaluate_beyond_drive(const Motor& motor, const MetricRequest& request);
MetricDerivative differentiate_beyond_drive(const Motor& motor, const MetricRequest& request,
                                            bool fixed_static_friction = false);
/// @}

}  // namespace twum::inline v0_1
