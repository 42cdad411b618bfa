// SPDX-License-Identifier: Apache-2.0
#include "performance/point_derivatives.hpp"

#include "contact/slip_margin.hpp"

#include <cmath>
#include <limits>

namespace twum::performance {
namespace {

using contact::ContactNumbers;
using contact::NumbersDual;
using contact::NumbersDual2;
using contact::SpeedDual;

// The contact's scalar that goes with a model scalar.
template <typename S>
struct ContactScalar;
template <>
struct ContactScalar<ModelDual> {
  using Outer = NumbersDual;
};
template <>
struct ContactScalar<ModelDual2> {
  using Outer = NumbersDual2;
};

// The seven numbers as a list; in partial contact theta_L stands for the edge, in full contact its pressure.
template <typename S>
std::array<S, 7> listed(const ContactNumbers<S>& n) {
  return {n.inertia, n.damping, n.stick_rate, n.speed_ratio, n.full ? n.peak : n.half_angle,
          n.kinetic, n.static_};
}

// Seeds the seven numbers as independent variables.
template <typename K, typename S>
ContactNumbers<K> seeded(const ContactNumbers<S>& n) {
  const std::array<S, 7> x = listed(n);
  const auto variable = [&x](int i) { return K::variable(x[static_cast<std::size_t>(i)].v, i); };
  ContactNumbers<K> k{variable(0), variable(1), variable(2),
                      variable(3), K(0.0),      K(0.0),
                      variable(5), variable(6), {K(0.0), K(0.0), K(0.0)},
                      n.full};
  if (n.full) {
    k.half_angle = K(value_of(n.half_angle));
    k.peak = variable(4);
    k.edge = {K(0.0), K(-1.0), K(2.0)};
  } else {
    k.half_angle = variable(4);
    k.edge = contact::trig(k.half_angle);
    k.peak = k.edge.versine;
  }
  return k;
}

// Derivatives in the seven numbers times those of the numbers.
template <typename S, typename K>
S chained(const K& f, const std::array<S, 7>& x) {
  S r;
  r.v = f.v;
  for (int j = 0; j < kDirections; ++j) {
    r.d[j] = f.d[0] * x[0].d[j];
    for (int i = 1; i < 7; ++i) r.d[j] = r.d[j] + f.d[i] * x[static_cast<std::size_t>(i)].d[j];
  }
  return r;
}

template <typename S>
ParameterArray<S> independent_parameters(const MotorDesign& design, bool fixed_static_friction) {
  const ParameterArray<double> values = parameter_values(design);
  ParameterArray<S> p;
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    p[i] = S(values[i]);
    if (in_use(design, static_cast<Parameter>(i))) p[i].d[i] = 1.0;
  }
  const double mu = design.friction.kinetic;
  if (!fixed_static_friction) {
    p[index_of(Parameter::static_friction)].d[index_of(Parameter::kinetic_friction)] =
        mu > 0 ? design.friction.static_ / mu : 1.0;
  }
  return p;
}

}  // namespace

template <typename S>
MotorModel<S> differentiated_model(const MotorDesign& design, bool fixed_static_friction) {
  return motor_model<S>(design, independent_parameters<S>(design, fixed_static_friction));
}

template <>
ModelDual speed_variable<ModelDual>(double speed) {
  return ModelDual::variable(speed, kSpeedDirection);
}

template <>
ModelDual2 speed_variable<ModelDual2>(double speed) {
  return ModelDual2::variable(SpeedDual::variable(speed, 0), kSpeedDirection);
}

template <typename S>
PointNumbers<S> differentiate_point(const MotorModel<double>& values, const MotorModel<S>& model,
                                    const SolvedPoint& point, double speed) {
  using K = typename ContactScalar<S>::Outer;
  const S omega = speed_variable<S>(speed);
  if (point.special) return special_point(model, omega);
  const ContactNumbers<S> n = contact_numbers(model, omega);
  const contact::ContactMeans<K> m =
      contact::periodic_means(seeded<K>(n), contact_numbers(values, speed), point.state);
  const std::array<S, 7> x = listed(n);
  const contact::ContactMeans<S> means{chained(m.traction, x), chained(m.stator_power, x),
                                       chained(m.friction_power, x), chained(m.layer_loss, x),
                                       chained(m.stick_length, x)};
  return dimensional(model, means, point.state.lap);
}

PointNumbers<SpeedDual> point_in_speed(const MotorModel<double>& m, const SolvedPoint& point,
                                       double speed) {
  const SpeedDual omega = SpeedDual::variable(speed, 0);
  if (point.special) return special_point(m, omega);
  const contact::ContactMeans<SpeedDual> means =
      contact::periodic_means(contact_numbers(m, omega), contact_numbers(m, speed), point.state);
  return dimensional(m, means, point.state.lap);
}

TorqueSlope torque_slope(const MotorModel<double>& m, double speed,
                         const contact::LapEntry<double>* guess) {
  const SolvedPoint point = solve_point(m, speed, guess);
  if (point.status != PointStatus::ok) return {0, 0, 0, 0, point.status, {}};
  const PointNumbers<SpeedDual> n = point_in_speed(m, point, speed);
  return {n.torque.v,          n.torque.d[0], n.stator_power.v,
          n.stator_power.d[0], point.status,  point.state.entry};
}

Margin plateau_margin(const MotorModel<double>& m, double speed) {
  const SpeedDual omega = SpeedDual::variable(speed, 0);
  const ContactNumbers<double> n = contact_numbers(m, speed);
  const contact::SlipMargin low = contact::slip_margin(n);
  const SpeedDual at = contact::slip_margin_at(contact_numbers(m, omega), low);
  return {at.v, at.d[0], low.place, low.exit, low.slips};
}

ModelDual plateau_end_derivative(const MotorModel<double>& values,
                                 const MotorModel<ModelDual>& model, double speed) {
  const ContactNumbers<double> n = contact_numbers(values, speed);
  const contact::SlipMargin low = contact::slip_margin(n);
  const ContactNumbers<ModelDual> x = contact_numbers(model, speed_variable<ModelDual>(speed));
  const ModelDual margin = chained(contact::slip_margin_at(seeded<NumbersDual>(x), low), listed(x));
  // margin(Omega(p), p) = 0
  ModelDual end(speed);
  for (int j = 0; j < kSpeedDirection; ++j) end.d[j] = -margin.d[j] / margin.d[kSpeedDirection];
  return end;
}

#define TWUM_INSTANTIATE(S)                                                                     \
  template MotorModel<S> differentiated_model(const MotorDesign&, bool);                        \
  template PointNumbers<S> differentiate_point(const MotorModel<double>&, const MotorModel<S>&, \
                                               const SolvedPoint&, double);
TWUM_INSTANTIATE(ModelDual)
TWUM_INSTANTIATE(ModelDual2)
#undef TWUM_INSTANTIATE

}  // namespace twum::performance
