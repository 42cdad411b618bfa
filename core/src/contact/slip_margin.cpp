// SPDX-License-Identifier: Apache-2.0
#include "contact/slip_margin.hpp"

#include "contact/scalars.hpp"
#include "contact/zone_curves.hpp"
#include "contact/zone_integrals.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {
namespace {

constexpr double kDriving = -1;  // sign of v_rel
constexpr long kMostSamples = 1'000'000;
constexpr int kMaxSlides = 200'000;

template <typename S>
LayerState<S> state_of(const Harmonic<S>& f, const S& theta, const Trig<S>& at) {
  return {f.at(theta, at), f.slope(at)};
}

template <typename S>
LayerState<S> moved(const LayerMotion<S>& layer, const LayerState<S>& h, const S& x) {
  return layer.at(layer.start(layer.own_part(h)), x);
}

template <typename S>
LayerState<S> difference(const LayerState<S>& a, const LayerState<S>& b) {
  return {a.e - b.e, a.rate - b.rate};
}

// State at entry of a layer that slips all through every turn. The turn is linear, y -> Phi y + c.
template <typename S>
LayerState<S> slipping_entry(const ContactNumbers<S>& n, const LayerMotion<S>& layer) {
  const Harmonic<S> f = forced_response(n, layer, kDriving);
  const S zero(0.0);
  const S start = -n.half_angle;
  const LayerState<S> f0 = state_of(f, start, {-n.edge.sin, n.edge.cos, n.edge.versine});
  if (n.full) return f0;
  const LayerState<S> f1 = state_of(f, n.half_angle, n.edge);
  const S length = 2.0 * n.half_angle, flight = 2 * std::numbers::pi - length;
  if (layer.slowest_decay() * value_of(flight) > 50) return {zero, zero};
  const auto turn = [&](const LayerState<S>& y) {
    const LayerState<S> h = moved(layer, difference(y, f0), length);
    return moved(layer, {h.e + f1.e, h.rate + f1.rate}, flight);
  };
  const LayerState<S> c = turn({zero, zero});
  const LayerState<S> a = difference(turn({S(1.0), zero}), c),
                      b = difference(turn({zero, S(1.0)}), c);
  const S p = 1.0 - a.e, q = 1.0 - b.rate, det = p * q - b.e * a.rate;
  return {(q * c.e + b.e * c.rate) / det, (a.rate * c.e + p * c.rate) / det};
}

// Everything the search needs about the slipping contact.
struct SlippingContact {
  LayerMotion<double> layer;
  Harmonic<double> slow;
  LayerState<double> own;  // of the layer at entry
  double start, length;
  Trig<double> exit;

  CurveSample sample(double x) const { return curve(0, x).first(); }

  // Margin less `level`, from `x` on.
  SlipCurve curve(double level, double x) const {
    const LayerState<double> h = layer.at(layer.start(own), x);
    return {layer,
            layer.start(h),
            {slow.k0 - kDriving * level, 0, slow.kw, slow.ks},
            kDriving,
            start + x,
            trig(start + x),
            length - x,
            exit};
  }
};

// Length over which f keeps falling, by the bounds of its second and its third derivative: f' stays
// negative as long as f' + l2 t and f' + f'' t + l3 t^2 / 2 do. Near the minimum the latter is Newton's
// step, short by what l3 may bend.
double falling_step(const CurveSample& c) {
  const double bend = c.f2 + std::sqrt(c.f2 * c.f2 - 2 * c.l3 * c.f1);
  return std::fmax(-c.f1 / c.l2, bend > 0 ? -2 * c.f1 / bend : 0);
}

// Slides down from x to the next minimum by steps that cannot pass it. Stops at the exit.
double next_minimum(const SlippingContact& contact, double x) {
  for (int i = 0; i < kMaxSlides && x < contact.length; ++i) {
    const CurveSample c = contact.sample(x);
    if (!(c.f1 < 0)) break;
    const double step = falling_step(c);
    x += step;
    if (step < 1e-13) break;
  }
  return std::fmin(x, contact.length);
}

}  // namespace

SlipMargin slip_margin(const ContactNumbers<double>& n) {
  const LayerMotion<double> layer(n.inertia, n.damping);
  const Harmonic<double> f = forced_response(n, layer, kDriving);
  const LayerState<double> entry = slipping_entry(n, layer);
  const LayerState<double> f0 =
      state_of(f, -n.half_angle, {-n.edge.sin, n.edge.cos, n.edge.versine});
  const SlippingContact contact{
      layer,         relative_rate(n, f), layer.own_part(difference(entry, f0)),
      -n.half_angle, 2 * n.half_angle,    n.edge};
  SlipMargin low{contact.sample(0).f, 0, false, false, entry};
  const double at_exit = contact.sample(contact.length).f;
  if (at_exit < low.value) low = {at_exit, contact.length, true, false, entry};
  const double slack = 1e-14 * (n.stick_rate * (1 + std::fabs(n.speed_ratio)) + n.kinetic);
  double x = 0;
  long samples = 0;
  StartOrder order = StartOrder::positive;
  while (x < contact.length) {
    const double zero = first_zero(contact.curve(low.value - slack, x), contact.length - x, order,
                                   samples, kMostSamples);
    if (!(zero < contact.length - x)) break;
    x = next_minimum(contact, x + zero);
    const CurveSample c = contact.sample(x);
    if (c.f < low.value) low = {c.f, x, !(x < contact.length), false, entry};
    // The search goes on from the minimum itself, where only f'' says how f rises (E3.4).
    order = c.f2 > 0 ? StartOrder::double_zero : StartOrder::positive;
  }
  low.slips = low.value > 0;
  return low;
}

template <typename S>
S slip_margin_at(const ContactNumbers<S>& n, const SlipMargin& margin) {
  const LayerMotion<S> layer(n.inertia, n.damping);
  const Harmonic<S> f = forced_response(n, layer, kDriving);
  const S start = -n.half_angle;
  const LayerState<S> f0 = state_of(f, start, {-n.edge.sin, n.edge.cos, n.edge.versine});
  const S x = margin.exit ? S(2.0 * n.half_angle) : S(margin.place);
  const LayerState<S> h = moved(layer, difference(slipping_entry(n, layer), f0), x);
  const S theta = start + x;
  const Harmonic<S> slow = relative_rate(n, f);
  return -(slow.at(theta, trig(theta)) + h.rate);
}

#define TWUM_INSTANTIATE(S) template S slip_margin_at(const ContactNumbers<S>&, const SlipMargin&);
TWUM_FOR_EACH_CONTACT_SCALAR(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
