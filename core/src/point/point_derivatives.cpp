// SPDX-License-Identifier: Apache-2.0
#include "point/point_derivatives.hpp"

#include "contact/slip_margin.hpp"
#include "model/contact_directions.hpp"
#include "model/mapped_motor.hpp"
#include "model/moving_splits.hpp"
#include "model/track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace twum::inline v0_1::core {
namespace {

using contact::ContactNumbers;
using contact::MotionDual;
using contact::NumbersDual;
using contact::SpeedDual;

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

DrivenMotor<ModelDual2> constant_in_speed(const DrivenMotor<ModelDual>& motor) {
  return mapped<ModelDual2>(motor, [](const ModelDual& x) {
    ModelDual2 r;
    r.v = SpeedDual(x.v);
    for (int j = 0; j < kDirections; ++j) r.d[j] = SpeedDual(x.d[j]);
    return r;
  });
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

namespace {

// The splits of a track in the motor's scalar.
template <typename S, typename R>
Vector<SplitPlace<S>> places_of(const DrivenMotor<S>& m, const R& speed,
                                std::span<const Split> splits) {
  if constexpr (std::is_same_v<S, R>) {
    return moving_splits(m, speed, splits);
  } else {
    return fixed_places(splits);
  }
}

}  // namespace

// The sum over slices of what `differentiate` says of each that is not locked.
template <typename S, typename R, typename Differentiate>
PointNumbers<R> SolvedPoint::summed(const DrivenMotor<S>& m, const R& speed,
                                    Differentiate differentiate) const {
  if (special) return special_point(m, speed);
  const Vector<SplitPlace<S>> places = places_of(m, speed, splits_);
  const PointSlices<S> slices(m, places);
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

namespace {

// Means of a periodic state with the derivatives that its eight numbers have.
template <typename S>
contact::ContactMeans<S> chained_means(const ContactNumbers<S>& n,
                                       const contact::PeriodicState& state) {
  using K = typename ContactScalar<S>::Outer;
  const contact::ContactMeans<K> means = contact::periodic_means(seeded<K>(n), values_of(n), state);
  const std::array<S, 8> x = listed(n);
  return {chained(means.traction, x),       chained(means.stator_power, x),
          chained(means.friction_power, x), chained(means.layer_loss, x),
          chained(means.stick_length, x),   chained(means.reactive_force, x)};
}

}  // namespace

template <typename S>
PointNumbers<S> SolvedPoint::differentiated(const DrivenMotor<S>& m, const S& speed) const {
  return summed(m, speed, chained_means<S>);
}

#ifndef __wasm__  // of worn tracks
Vector<PointNumbers<ModelDual>> SolvedPoint::differentiated_slices(const DrivenMotor<ModelDual>& m,
                                                                   const ModelDual& speed) const {
  Vector<PointNumbers<ModelDual>> numbers;
  if (special) return numbers;
  const PointSlices<ModelDual> slices(m, {});
  for (std::size_t k = 0; k < size(); ++k) {
    const Slice<ModelDual>& s = slices[k];
    if (slice(k).locked) {
      numbers.push_back(locked_slice(m, s, speed));
      continue;
    }
    const contact::PeriodicState& state = slice(k).state;
    numbers.push_back(
        slice_numbers(m, s, state.lap, chained_means(contact_numbers(m, s, speed), state)));
  }
  return numbers;
}
#endif

PointNumbers<MotionDual> SolvedPoint::differentiated(const DrivenMotor<double>& m,
                                                     const MotionDual& speed,
                                                     contact::Means wanted) const {
  const auto means = [wanted](const ContactNumbers<MotionDual>& n,
                              const contact::PeriodicState& state) {
    return contact::moving_means(n, state, wanted).means;
  };
  const bool moves = std::any_of(splits_.begin(), splits_.end(),
                                 [](const Split& split) { return split.jump.has_value(); });
  return moves ? summed(mapped<MotionDual>(m, [](double x) { return MotionDual(x); }), speed, means)
               : summed(m, speed, means);
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

namespace {

// With mu_0 > mu a slice that sticks may hold on to it at speeds at which it could slip all through.
double last_driving_speed(const DrivenMotor<double>& m, const Slice<double>& slice, double end) {
  constexpr double kBeside = 1e-9;  // at the end itself slip and stick meet
  if (slice_drives(m, slice, end * (1 - kBeside))) return end;
  double low = 0, high = end;
  while (high - low > 1e-15 * end) {
    const double middle = 0.5 * (low + high);
    (slice_drives(m, slice, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double track_plateau_end(const DrivenMotor<double>& m, double end) {
  for (const Slice<double>& edge : edges_of(m)) {
    if (!(margin_in(m, edge, 0).value > 0)) return 0;
    if (margin_in(m, edge, end).value < 0) end = sticking_speed(m, edge, end);
    if (has_static_excess(m)) end = last_driving_speed(m, edge, end);
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

}  // namespace twum::inline v0_1::core
