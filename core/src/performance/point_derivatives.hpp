// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/point.hpp"
#include "performance/scalars.hpp"

#include <twum/core/performance/metrics.hpp>

namespace twum::performance {

/// The motor model with derivatives: every parameter a direction of its own, the speed the last one.
/// Made once per motor.
template <typename S>
MotorModel<S> differentiated_model(const MotorDesign& design, bool fixed_static_friction);

/// Speed as an independent variable of the model's derivatives.
template <typename S>
S speed_variable(double speed);
template <>
ModelDual speed_variable<ModelDual>(double speed);
template <>
ModelDual2 speed_variable<ModelDual2>(double speed);

/// Numbers of a solved point with derivatives in every parameter and the speed; S is ModelDual or
/// ModelDual2. The contact is differentiated in its own seven numbers and chained.
template <typename S>
PointNumbers<S> differentiate_point(const MotorModel<double>& values, const MotorModel<S>& model,
                                    const SolvedPoint& point, double speed);

/// Numbers of a solved point with their derivatives in speed.
PointNumbers<contact::SpeedDual> point_in_speed(const MotorModel<double>& model,
                                                const SolvedPoint& point, double speed);

/// Torque and its slope in speed.
struct TorqueSlope {
  double torque, slope;  ///< [N m], [N m s]
  double stator_power, power_slope;
  PointStatus status;
  contact::LapEntry<double> entry;  ///< of the periodic state
};
/// @param guess  as solve_point()
TorqueSlope torque_slope(const MotorModel<double>& model, double speed,
                         const contact::LapEntry<double>* guess = nullptr);

/// Smallest v_rel margin -v_rel s / V0 of a contact that slips and drives all through, at `speed`:
/// positive on the plateau of the torque, zero at its end (T7.17).
struct Margin {
  double value;  ///< smallest margin, in units of P
  double slope;  ///< its derivative in speed
  double place;  ///< phase since entry where it is smallest [rad]
  bool exit;     ///< the smallest place is the exit edge
  bool slips;    ///< the contact does slip and drive all through there
};
Margin plateau_margin(const MotorModel<double>& model, double speed);

/// End of the plateau with derivatives in every parameter.
ModelDual plateau_end_derivative(const MotorModel<double>& values,
                                 const MotorModel<ModelDual>& model, double speed);

}  // namespace twum::performance
