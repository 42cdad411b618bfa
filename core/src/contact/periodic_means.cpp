// SPDX-License-Identifier: Apache-2.0
// Derivatives of the periodic state: the implicit function theorem at the fixed point of the return map.
#include "contact/periodic_state.hpp"

#include "contact/radial_state.hpp"
#include "contact/return_map.hpp"
#include "contact/scalars.hpp"
#include "contact/widened.hpp"

namespace twum::inline v0_1::contact {
namespace {

// One Newton step of the fixed point in S; the values are known, only derivatives come in. Where the
// return map has no isolated fixed point there are none.
template <typename S>
void correct(const Matrix2& j, const LayerState<S>& next, LayerState<S>& at,
             const LayerState<double>& value) {
  const LayerState<S> step = resolvent(j) * LayerState<S>{next.e - at.e, next.rate - at.rate};
  at = {with_value(S(at.e + step.e), value.e), with_value(S(at.rate + step.rate), value.rate)};
}

// A turn from the periodic state, with derivatives in N numbers and, behind them, in the state at entry (E6.2); and what they
// are together by the implicit function theorem. Where the return map has no isolated fixed point there are no derivatives.
template <int N>
class DifferentiatedTurn {
 public:
  using Wide = Dual<double, N + 2>;

  DifferentiatedTurn(const ContactNumbers<Dual<double, N>>& numbers, const PeriodicState& state,
                     Means means = Means::all) {
    const ContactNumbers<Wide> n = widened<2>(numbers);
    LapEntry<Wide> entry = constant_entry<Wide>(state.entry);
    entry.layer.e.d[N] = 1;
    entry.layer.rate.d[N + 1] = 1;
    const Lap<Wide> lap =
        run_lap(n, {n.inertia, n.damping}, entry, &state.lap.sequence, nullptr, means);
    means_ = lap.means;
    const LayerState<Wide>& next = lap.next.layer;
    resolvent_ =
        contact::resolvent({next.e.d[N], next.e.d[N + 1], next.rate.d[N], next.rate.d[N + 1]});
    for (int i = 0; i < N; ++i)
      motion_[i] = resolvent_ * LayerState<double>{next.e.d[i], next.rate.d[i]};
  }

  const Matrix2& resolvent() const { return resolvent_; }
  /// How the state at entry moves with a number: (I - J)^-1 times what the return map gains in it.
  const LayerState<double>& motion(int i) const { return motion_[i]; }
  const ContactMeans<Wide>& turn() const { return means_; }

  ContactMeans<Dual<double, N>> means() const {
    return {along(means_.traction),   along(means_.stator_power), along(means_.friction_power),
            along(means_.layer_loss), along(means_.stick_length), along(means_.reactive_force)};
  }

 private:
  // x along the periodic state.
  Dual<double, N> along(const Wide& x) const {
    Dual<double, N> r;
    r.v = x.v;
    for (int i = 0; i < N; ++i)
      r.d[i] = x.d[i] + x.d[N] * motion_[i].e + x.d[N + 1] * motion_[i].rate;
    return r;
  }

  ContactMeans<Wide> means_;
  Matrix2 resolvent_;
  LayerState<double> motion_[N];
};

}  // namespace

MovingMeans moving_means(const ContactNumbers<MotionDual>& numbers, const PeriodicState& state,
                         Means means) {
  if constexpr (kHasRadialMotion)
    if (value_of(numbers.radial) != 0) return {radial_means(numbers, state), {}};
  if constexpr (!kStateAlways) {
    if (!state.remembers) {
      const LapEntry<MotionDual> entry = constant_entry<MotionDual>(state.entry);
      const LayerMotion<MotionDual> layer(numbers.inertia, numbers.damping);
      return {run_lap(numbers, layer, entry, &state.lap.sequence, nullptr, means).means, {}};
    }
  }
  const DifferentiatedTurn turn(numbers, state, means);
  if (!state.remembers) return {turn.means(), {}};
  const auto in_state = [](const WithState<MotionDual>::Type& x) {
    return LayerState<double>{x.d[2], x.d[3]};
  };
  return {turn.means(),
          {turn.resolvent(), turn.motion(kInSpeed), turn.motion(kInAmplitude),
           in_state(turn.turn().stator_power), in_state(turn.turn().reactive_force)}};
}

template <typename S>
ContactMeans<S> periodic_means(const ContactNumbers<S>& numbers,
                               const ContactNumbers<double>& values, const PeriodicState& state) {
  if constexpr (kDualDepth<S> == 0) {
    return state.lap.means;
  } else {
    if constexpr (kHasRadialMotion)
      if (value_of(numbers.radial) != 0) return radial_means(numbers, state);
    const LayerMotion<S> layer(numbers.inertia, numbers.damping);
    LapEntry<S> entry = constant_entry<S>(state.entry);
    const ZoneSequence* sequence = &state.lap.sequence;
    constexpr Means means = kDualDepth<S> == 1 ? Means::all : Means::of_wave;
    if constexpr (kDualDepth<S> == 1) {
      if constexpr (!kStateAlways)
        if (!state.remembers) return run_lap(numbers, layer, entry, sequence, nullptr, means).means;
      return DifferentiatedTurn(numbers, state).means();
    } else {
      if (!state.remembers) return run_lap(numbers, layer, entry, sequence, nullptr, means).means;
      const Matrix2 j = return_jacobian(values, state.entry, sequence);
      for (int i = 0; i < kDualDepth<S>; ++i) {
        const LayerState<S> next =
            run_lap(numbers, layer, entry, sequence, nullptr, means).next.layer;
        correct(j, next, entry.layer, state.entry.layer);
      }
      return run_lap(numbers, layer, entry, sequence, nullptr, means).means;
    }
  }
}

#define TWUM_INSTANTIATE(S)                                                                        \
  template ContactMeans<S> periodic_means(const ContactNumbers<S>&, const ContactNumbers<double>&, \
                                          const PeriodicState&);
TWUM_INSTANTIATE(double)
TWUM_INSTANTIATE(NumbersDual)
TWUM_INSTANTIATE(NumbersDual2)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
