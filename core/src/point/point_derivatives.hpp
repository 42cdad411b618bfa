// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scalars.hpp"
#include "point/point.hpp"
#include "point/slice_count.hpp"

#include <twum/core/metric_value.hpp>

namespace twum::inline v0_1::core {

/// The design's motor with derivatives: each of kModelParameters a direction of its own, the speed the last one.
/// @param track  of the motor in double; absent: found again
/// @{
template <typename S>
DrivenMotor<S> differentiated_motor(const MotorDesign& design, const TrackRule& track);
template <typename S>
DrivenMotor<S> differentiated_motor(const MotorDesign& design) {
  return differentiated_motor<S>(design, track_rule(design));
}
/// @}

/// The same under a wave of another amplitude, a direction of its own; T is double or carries its derivative in speed.
template <typename T>
DrivenMotor<Dual<T, kDirections>> differentiated_motor(const MotorDesign& design,
                                                       const T& amplitude, const TrackRule& track);

/// The same with second derivatives along a speed on which the motor does not depend: its wave is prescribed.
DrivenMotor<ModelDual2> constant_in_speed(const DrivenMotor<ModelDual>& motor);

/// Speed as an independent variable of the model's derivatives.
template <typename S>
S speed_variable(double speed);
template <>
ModelDual speed_variable<ModelDual>(double speed);
template <>
ModelDual2 speed_variable<ModelDual2>(double speed);

/// Smallest v_rel margin -v_rel s / V0 of a contact that slips and drives all through, at `speed`:
/// positive on the plateau of the torque, zero at its end (T7.17). Of several slices that of the first one to stick.
struct Margin {
  double value;  ///< smallest margin, in units of P
  double slope;  ///< its derivative in speed
  double place;  ///< phase since entry where it is smallest [rad]
  bool exit;     ///< the smallest place is the exit edge
  bool slips;    ///< the contact does slip and drive all through there
};
Margin plateau_margin(const DrivenMotor<double>& model, double speed);

/// The margin at the end of the plateau of the slices with its derivatives.
ModelDual plateau_margin_derivative(const DrivenMotor<ModelDual>& motor, double speed);

/// End of the plateau of the whole track (W5.4): before that of its slices where an edge sticks first, since they lie within
/// the track.
/// @param end  of the slices
double track_plateau_end(const DrivenMotor<double>& motor, double end);
/// The margin at an end that an edge brings, with its derivatives.
ModelDual edge_margin_derivative(const DrivenMotor<ModelDual>& motor, double end);

}  // namespace twum::inline v0_1::core
