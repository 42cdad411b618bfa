// SPDX-License-Identifier: Apache-2.0
#include "performance/point_derivatives.hpp"

#include "contact/slip_margin.hpp"
#include "performance/track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::performance {
namespace {

using contact::ContactNumbers;
using contact::MotionDual;
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
ContactNumbers<double> values_of(const ContactNumbers<S>& n) {
  const auto at = [](const S& x) { return value_of(x); };
  return {at(n.inertia),
          at(n.damping),
          at(n.stick_rate),
          at(n.speed_ratio),
          at(n.half_angle),
          at(n.peak),
          at(n.kinetic),
          at(n.static_),
          {at(n.edge.sin), at(n.edge.cos), at(n.edge.versine)},
          n.full};
}

// Each of kModelParameters a direction of its own.
template <typename S>
ModelArray<S> variables(const MotorDesign& design) {
  const ModelArray<double> values = model_values(design);
  ModelArray<S> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = S::variable(values[i], static_cast<int>(i));
  return p;
}

}  // namespace

template <typename S>
DrivenMotor<S> differentiated_motor(const MotorDesign& design, const TrackRule& track) {
  const ModelArray<S> p = variables<S>(design);
  return driven(motor_model(p, track), design_wave(p));
}

template <typename T>
DrivenMotor<Dual<T, kDirections>> differentiated_motor(const MotorDesign& design,
                                                       const T& amplitude, const TrackRule& track) {
  using S = Dual<T, kDirections>;
  constexpr std::size_t kAmplitude = model_index(Parameter::amplitude);
  ModelArray<S> p = variables<S>(design);
  p[kAmplitude] = S::variable(amplitude, static_cast<int>(kAmplitude));
  return driven(motor_model(p, track), design_wave(p));
}

namespace {

// The same along a speed on which it does not depend.
ModelDual2 constant_in_speed(const ModelDual& x) {
  ModelDual2 r;
  r.v = SpeedDual(x.v);
  for (int j = 0; j < kDirections; ++j) r.d[j] = SpeedDual(x.d[j]);
  return r;
}

Slice<ModelDual2> constant_in_speed(const Slice<ModelDual>& s) {
  const auto c = [](const ModelDual& x) { return constant_in_speed(x); };
  const NormalContact<ModelDual>& n = s.contact;
  return {c(s.radius),
          c(s.width),
          c(s.shape),
          c(s.amplitude),
          c(s.crest_velocity),
          c(s.load),
          c(s.share),
          {c(n.half_angle), c(n.edge_cosine), c(n.pressure_amplitude), c(n.half_length),
           c(n.load_ratio), c(n.ratio), c(n.max_pressure), n.full},
          c(s.stick_gain),
          c(s.peak),
          {c(s.edge.sin), c(s.edge.cos), c(s.edge.versine)},
          c(s.pressure_force),
          c(s.torque_scale),
          c(s.power_scale),
          c(s.force_scale)};
}

}  // namespace

DrivenMotor<ModelDual2> constant_in_speed(const DrivenMotor<ModelDual>& m) {
  const auto c = [](const ModelDual& x) { return constant_in_speed(x); };
  DrivenMotor<ModelDual2> r;
  static_cast<MotorModel<ModelDual2>&>(r) = {
      c(m.n),       c(m.r),          c(m.b),       c(m.kappa),          c(m.tilt),
      c(m.youngs),  c(m.thickness),  c(m.shear),   c(m.viscosity),      c(m.inertia),
      c(m.kinetic), c(m.static_),    c(m.preload), c(m.stator_damping), {},
      c(m.slope),   c(m.compliance), m.track};
  std::transform(m.shape_numbers.begin(), m.shape_numbers.end(), r.shape_numbers.begin(), c);
  static_cast<Slice<ModelDual2>&>(r) = constant_in_speed(static_cast<const Slice<ModelDual>&>(m));
  r.omega = c(m.omega), r.lever = c(m.lever), r.holding_lever = c(m.holding_lever);
  r.indentation = c(m.indentation);
  for (const Piece<ModelDual>& p : m.pieces)
    r.pieces.push_back({c(p.low), c(p.high), p.root_low, p.root_high});
  for (const Slice<ModelDual>& s : m.annulus) r.annulus.push_back(constant_in_speed(s));
  return r;
}

template DrivenMotor<ModelDual> differentiated_motor(const MotorDesign&, const double&,
                                                     const TrackRule&);
template DrivenMotor<ModelDual2> differentiated_motor(const MotorDesign&, const SpeedDual&,
                                                      const TrackRule&);

template <>
ModelDual speed_variable<ModelDual>(double speed) {
  return ModelDual::variable(speed, kSpeedDirection);
}

template <>
ModelDual2 speed_variable<ModelDual2>(double speed) {
  return ModelDual2::variable(SpeedDual::variable(speed, 0), kSpeedDirection);
}

// The sum over slices of what `differentiate` says of each that is not locked.
template <typename S, typename R, typename Differentiate>
PointNumbers<R> SolvedPoint::summed(const DrivenMotor<S>& m, const R& speed,
                                    Differentiate differentiate) const {
  if (special) return special_point(m, speed);
  const PointSlices<S> slices(m, splits_);
  const auto numbers_of = [&](std::size_t k) {
    const Slice<S>& s = slices[k];
    if (slice(k).locked) return locked_slice(m, s, speed);
    const contact::PeriodicState& state = slice(k).state;
    return slice_numbers(m, s, state.lap, differentiate(contact_numbers(m, s, speed), state));
  };
  PointNumbers<R> sum = numbers_of(0);
  for (std::size_t k = 1; k < size(); ++k) sum = sum + numbers_of(k);
  return sum;
}

template <typename S>
PointNumbers<S> SolvedPoint::differentiated(const DrivenMotor<S>& m, const S& speed) const {
  using K = typename ContactScalar<S>::Outer;
  return summed(m, speed, [](const ContactNumbers<S>& n, const contact::PeriodicState& state) {
    const contact::ContactMeans<K> means =
        contact::periodic_means(seeded<K>(n), values_of(n), state);
    const std::array<S, 7> x = listed(n);
    return contact::ContactMeans<S>{
        chained(means.traction, x),       chained(means.stator_power, x),
        chained(means.friction_power, x), chained(means.layer_loss, x),
        chained(means.stick_length, x),   chained(means.reactive_force, x)};
  });
}

PointNumbers<MotionDual> SolvedPoint::differentiated(const DrivenMotor<double>& m,
                                                     const MotionDual& speed) const {
  return summed(m, speed,
                [](const ContactNumbers<MotionDual>& n, const contact::PeriodicState& state) {
                  return contact::moving_means(n, state, contact::Means::all).means;
                });
}

MovingPoint SolvedPoint::moving(const DrivenMotor<MotionDual>& m, const MotionDual& speed) const {
  MovingStates states;
  states.reserve(size());
  const PointNumbers<MotionDual> numbers =
      summed(m, speed,
             [&states](const ContactNumbers<MotionDual>& n, const contact::PeriodicState& state) {
               const contact::MovingMeans moving =
                   contact::moving_means(n, state, contact::Means::of_wave);
               states.push_back(moving.slopes);
               return moving.means;
             });
  if (states.size() != size()) states.clear();
  return {numbers, std::move(states)};
}

namespace {

Margin margin_in(const DrivenMotor<double>& m, const Slice<double>& slice, double speed) {
  const contact::SlipMargin low = contact::slip_margin(contact_numbers(m, slice, speed));
  const MotionDual omega = MotionDual::variable(speed, contact::kInSpeed);
  const MotionDual at = contact::slip_margin_at(contact_numbers(m, slice, omega), low);
  return {at.v, at.d[0], low.place, low.exit, low.slips};
}

// How far the plateau's end is away by the margin's slope; the units of a slice drop out.
double reach(const Margin& margin) { return margin.value / std::fabs(margin.slope); }

}  // namespace

Margin plateau_margin(const DrivenMotor<double>& m, double speed) {
  const auto slices = m.slices();
  Margin first = margin_in(m, slices[0], speed);
  for (const Slice<double>& slice : slices.subspan(1)) {
    const Margin next = margin_in(m, slice, speed);
    const bool slips = first.slips && next.slips;
    if (reach(next) < reach(first)) first = next;
    first.slips = slips;
  }
  return first;
}

namespace {

ModelDual margin_in(const DrivenMotor<ModelDual>& m, const Slice<ModelDual>& slice, double speed) {
  const ContactNumbers<ModelDual> x = contact_numbers(m, slice, speed_variable<ModelDual>(speed));
  const contact::SlipMargin low = contact::slip_margin(values_of(x));
  return chained(contact::slip_margin_at(seeded<NumbersDual>(x), low), listed(x));
}

// The margin that is used up first, of some slices.
ModelDual first_margin(const DrivenMotor<ModelDual>& m, std::span<const Slice<ModelDual>> slices,
                       double speed) {
  const auto reach_of = [](const ModelDual& margin) {
    return margin.v / std::fabs(margin.d[kSpeedDirection]);
  };
  ModelDual margin = margin_in(m, slices[0], speed);
  for (const Slice<ModelDual>& slice : slices.subspan(1)) {
    const ModelDual next = margin_in(m, slice, speed);
    if (reach_of(next) < reach_of(margin)) margin = next;
  }
  return margin;
}

// Where a slice that sticks at `high` begins to, by Newton's method in a bracket from rest.
double sticking_speed(const DrivenMotor<double>& m, const Slice<double>& slice, double high) {
  double low = 0, speed = high;
  for (int i = 0; i < 100 && high - low > 1e-15 * high; ++i) {
    const Margin margin = margin_in(m, slice, speed);
    (margin.value > 0 ? low : high) = speed;
    double next = speed - margin.value / margin.slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::fabs(next - speed) <= 1e-12 * high) return next;
    speed = next;
  }
  return speed;
}

}  // namespace

ModelDual plateau_margin_derivative(const DrivenMotor<ModelDual>& motor, double speed) {
  return first_margin(motor, motor.slices(), speed);
}

double track_plateau_end(const DrivenMotor<double>& m, double end) {
  for (const Slice<double>& edge : edges_of(m)) {
    if (!(margin_in(m, edge, 0).value > 0)) return 0;
    if (margin_in(m, edge, end).value < 0) end = sticking_speed(m, edge, end);
  }
  return end;
}

ModelDual edge_margin_derivative(const DrivenMotor<ModelDual>& m, double end) {
  return first_margin(m, edges_of(m), end);
}

#define TWUM_INSTANTIATE(S)                                                           \
  template DrivenMotor<S> differentiated_motor(const MotorDesign&, const TrackRule&); \
  template PointNumbers<S> SolvedPoint::differentiated(const DrivenMotor<S>&, const S&) const;
TWUM_INSTANTIATE(ModelDual)
TWUM_INSTANTIATE(ModelDual2)
#undef TWUM_INSTANTIATE

}  // namespace twum::performance
