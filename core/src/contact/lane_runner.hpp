// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lane_batch.hpp"
#include "contact/lanes.hpp"
#include "contact/zone_curves.hpp"
#include "contact/zone_integrals.hpp"
#include "contact/zone_start.hpp"

#include <cstddef>
#include <numbers>

// Inlines all calls of a function. Not with the checks of a sanitizer: the compiler would take ten minutes for one function.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TWUM_FLATTEN
#else
#define TWUM_FLATTEN [[gnu::flatten]]
#endif

namespace twum::inline v0_1::contact {

/// sigma v_rel along a slip zone, as SlipCurve but for the steps of (E4.6).
template <LaneWidth W>
class SlipLanes : public SlipTerms<Lanes<W>> {
  using Base = SlipTerms<Lanes<W>>;
  using typename Base::Own;

 public:
  using Base::Base;

  SampleOf<Lanes<W>> first() const { return sample(0.0, this->at_, this->own_start()); }
  SampleOf<Lanes<W>> sample(const Lanes<W>& x) const {
    return sample(x, quick_trig(Lanes<W>(this->theta_ + x)), this->own_motion(x));
  }

 private:
  SampleOf<Lanes<W>> sample(const Lanes<W>& x, const Trig<Lanes<W>>& a, const Own& own) const {
    const Lanes<W> least =
        this->lowest(this->length_ - x, this->slow_.at(0.0, a), this->slow_.slope(a));
    LaneMask<W> clear = least > own.bound0;
    const LaneMask<W> asks = !clear && this->depth_may_be(least, own);
    if (any(asks)) {
      const Lanes<W> value = this->sigma_ * own.rate, slope = this->sigma_ * own.rate1;
      clear |= asks && least > this->layer_.depth(value, slope);
    }
    return this->bounded(a, own, select(clear, kNoZero, 0.0));
  }
};

/// Laps from rest in step: what LapRunner does, in lanes.
template <LaneWidth W>
class LaneRunner {
  using S = Lanes<W>;
  using Mask = LaneMask<W>;

 public:
  /// @param lane  the first of those that are one vector
  LaneRunner(const LayerMotion<double>& layer, LaneBatch& batch, int lane)
      : layer_(layer), batch_(batch), lane_(lane), n_(loaded(batch.contacts)) {}

  void run() {
    enter();
    for (zone_ = 0; zone_ < batch_.zones.size(); zone_ += 2) {
      any(goes_on_) ? slip() : skip(zone_);
      any(goes_on_ && sticks_) ? stick() : skip(zone_ + 1);
    }
    found_ &= !goes_on_;
    leave();
  }

 private:
  static constexpr double kShortestZone = 1e-12;  // [rad]; what is shorter is left to LapRunner
  static constexpr int kMaxSamples = 8;           // until a zero is bracketed or ruled out
  static constexpr int kMaxSteps = 8;             // to a bracketed zero

  S loaded(const LaneArray& array) const { return S(array.v + lane_); }
  void store(const S& x, LaneArray& array) const { x.store(array.v + lane_); }

  ContactNumbers<S> loaded(const ContactNumbers<LaneArray>& n) const {
    return {loaded(n.inertia),
            loaded(n.damping),
            loaded(n.stick_rate),
            loaded(n.speed_ratio),
            loaded(n.half_angle),
            loaded(n.peak),
            loaded(n.kinetic),
            loaded(n.threshold),
            {loaded(n.edge.sin), loaded(n.edge.cos), loaded(n.edge.versine)},
            false};
  }

  // As ZoneStart::enter() of a layer that is at rest.
  void enter() {
    here_ = {{-n_.half_angle, {-n_.edge.sin, n_.edge.cos, n_.edge.versine}}, {0.0, 0.0}};
    const S rate = sticking_rate(n_, here_.at);
    sigma_ = select(rate > 0.0, -1.0, 1.0);
    found_ = rate > 0.0 || rate < 0.0;
    goes_on_ = found_;
  }

  void slip() {
    const Mask slips = goes_on_;
    const LapPlace<S> from = here_;
    const Harmonic<S> f = forced_response(n_, layer_, sigma_);
    const LayerState<S> h0{from.layer.e - f.at(from.theta, from.at),
                           from.layer.rate - f.slope(from.at)};
    const FreeMotion<S> motion = layer_.start(h0);
    const S rest = n_.half_angle - from.theta;
    const SlipLanes<W> curve(layer_, motion, relative_rate(n_, f), sigma_, from.theta, from.at,
                             rest, n_.edge);
    const S end = first_zero(curve, goes_on_, starts_at_zero_, rest);
    const S length = min(end, rest);
    go(slips, end < rest, length);
    record(zone_, slips, -sigma_, end, 0.0);
    const LayerState<S> h1 = layer_.at(motion, length);
    const Moments<S> moments(from, here_);
    const SlipWork<S> work = slip_work(n_, layer_, f, moments, from, here_, h0, h1);
    add_to(slips, slip_integrals(n_, sigma_, moments, from, here_, work));
    set(slips, {h1.e + f.at(here_.theta, here_.at), h1.rate + f.slope(here_.at)});
    goes_on_ &= end < rest;
    after_slip();
  }

  // As ZoneStart::after_slip() of a layer with inertia.
  void after_slip() {
    const S traction =
        sticking_traction(n_, layer_, here_, here_.layer.e).at(here_.theta, here_.at);
    sticks_ = goes_on_ && fabs(traction) <= n_.threshold * pressure(n_, here_.at);
    sigma_ = -sigma_;
    starts_at_zero_ = !Mask{}, starts_flat_ = Mask{};
  }

  void stick() {
    const Mask sticks = goes_on_ && sticks_;
    set(sticks, {here_.layer.e, sticking_rate(n_, here_.at)});
    const LapPlace<S> from = here_;
    const Harmonic<S> t = sticking_traction(n_, layer_, from, from.layer.e);
    const S rest = n_.half_angle - from.theta;
    // First on the side that the traction would reach at the exit, as in ZoneEnds::stick_end().
    S iota = select(t.at(n_.half_angle, n_.edge) < 0.0, -1.0, 1.0);
    const StickTerms<S> likely(reserve(n_, t, iota), from.theta, from.at),
        other(reserve(n_, t, S(-iota)), from.theta, from.at);
    const S first = stick_end(likely, sticks, rest, likely.last(rest, n_.edge));
    const S until = min(first, rest), second = stick_end(other, sticks, until, other.terms(until));
    const S length = min(first, second);
    iota = select(second < first, -iota, iota);
    fail(sticks && !(length < rest));
    go(sticks, sticks, length);
    record(zone_ + 1, sticks, 0.0, length, iota);
    add_to(sticks, stick_integrals(n_, layer_, t, from, here_));
    set(sticks, {sticking_strain(n_, from, from.layer.e, here_), sticking_rate(n_, here_.at)});
    sigma_ = select(sticks, -iota, sigma_);
    starts_flat_ = sticks;
  }

  // As ZoneEnds::stick_end_on().
  S stick_end(const StickTerms<S>& curve, const Mask& lanes, const S& length,
              const SampleOf<S>& end) {
    const SampleOf<S> first = curve.first();
    const Mask tells = length < StickTerms<S>::kHalfTurn && first.f > 0.0;
    const Mask one = lanes && tells && end.f < 0.0 && curve.has_one_zero(first, length);
    const Mask none = tells && end.f > 0.0 && curve.has_no_zero(first, end, length);
    S zero = kNoZero;
    if (any(one)) {
      const S guess = curve.taylor_zero(length);
      zero = select(one, refined(curve, one, 0.0, length, guess, first.l3), kNoZero);
    }
    const Mask open = lanes && !one && !none;
    return any(open) ? select(open, first_zero(curve, open, Mask{}, length), zero) : zero;
  }

  // The march of contact::first_zero(). kNoZero where there is none.
  template <typename Curve>
  S first_zero(const Curve& curve, Mask open, const Mask& starts_at_zero, const S& length) {
    Mask bracketed{};
    S x = 0.0, low = 0.0, reach = 0.0;
    SampleOf<S> c = curve.first();
    const S l3 = c.l3;
    if (any(open && starts_at_zero)) {
      x = select(starts_at_zero, leaving_step(S(select(starts_flat_, 0.0, c.f1)), c), 0.0);
      open &= x < length;
      c = chosen(starts_at_zero, curve.sample(x), c);
    }
    for (int i = 0; i < kMaxSamples && any(open); ++i) {
      if (i > 0) c = curve.sample(x);
      fail(open && !(c.f > 0.0)), open &= found_;
      if (any(open && c.f1 < 0.0)) {
        const S bracket = zero_bracket(c);
        const Mask hit = open && bracket > 0.0;
        low = select(hit, x, low), reach = select(hit, bracket, reach);
        bracketed |= hit, open &= !hit;
      }
      x = x + select(open, max(zero_free_step(c, open), c.skip), 0.0);
      open &= x < length;
    }
    fail(open);
    if (!any(bracketed)) return kNoZero;
    const S zero = refined(curve, bracketed, low, low + reach, low, l3);
    return select(bracketed && zero < length, zero, kNoZero);
  }

  // As contact::zero_free_step().
  static S zero_free_step(const SampleOf<S>& c, const Mask& open) {
    S step = quadratic_step(c);
    const Mask falls = c.f1 < 0.0;
    const S falling = any(open && falls) ? falling_step(c, step) : step;
    if (any(open && !falls)) step = max(step, rising_step(c));
    return select(falls, falling, step);
  }

  // polish_zero() in some lanes.
  template <typename Curve>
  S refined(const Curve& curve, const Mask& lanes, S low, S high, S x, const S& l3) {
    Mask open = lanes && found_;
    for (int i = 0; i < kMaxSteps && any(open); ++i) {
      const SampleOf<S> c = curve.terms(x);
      low = select(c.f > 0.0, x, low), high = select(c.f > 0.0, high, x);
      const S next = x + householder_step(c);
      const Mask inside = next >= low && next <= high;
      const Mask last = inside && is_last_step(c, l3, S(next - x));
      x = select(open, select(inside, next, 0.5 * (low + high)), x);
      open &= !last;
    }
    fail(open);
    return x;
  }

  // On by a length, where the zone ends, else to the exit.
  void go(const Mask& lanes, const Mask& ends, const S& length) {
    const S theta = here_.theta + length;
    const Trig<S> at = trig(theta);
    fail(lanes && ends && !(theta < n_.half_angle && length > kShortestZone));
    const auto place = [&](const S& before, const S& inside, const S& exit) {
      return select(lanes, select(ends, inside, exit), before);
    };
    here_.theta = place(here_.theta, theta, n_.half_angle);
    here_.at = {place(here_.at.sin, at.sin, n_.edge.sin), place(here_.at.cos, at.cos, n_.edge.cos),
                place(here_.at.versine, at.versine, n_.edge.versine)};
  }

  void set(const Mask& lanes, const LayerState<S>& layer) {
    here_.layer = {select(lanes, layer.e, here_.layer.e),
                   select(lanes, layer.rate, here_.layer.rate)};
  }

  void add_to(const Mask& lanes, const ContactMeans<S>& zone) {
    const auto in = [&](const S& value) { return select(lanes, value, 0.0); };
    add(means_,
        ContactMeans<S>{in(zone.traction), in(zone.stator_power), in(zone.friction_power),
                        in(zone.layer_loss), in(zone.stick_length), in(zone.reactive_force)});
  }

  void record(std::size_t place, const Mask& lanes, const S& zone, const S& length, const S& side) {
    LaneBatch::Zone& z = batch_.zones[place];
    store(select(lanes, 1.0, 0.0), z.has);
    store(zone, z.zone), store(length, z.length), store(side, z.side);
  }
  void skip(std::size_t place) { store(0.0, batch_.zones[place].has); }

  static SampleOf<S> chosen(const Mask& lanes, const SampleOf<S>& a, const SampleOf<S>& b) {
    return {select(lanes, a.f, b.f),   select(lanes, a.f1, b.f1), select(lanes, a.f2, b.f2),
            select(lanes, a.l2, b.l2), select(lanes, a.l3, b.l3), select(lanes, a.skip, b.skip),
            select(lanes, a.f3, b.f3)};
  }

  void fail(const Mask& lanes) { found_ &= !lanes, goes_on_ &= !lanes; }

  // The layer loses all that it takes along.
  void leave() {
    if (layer_.C == 0)
      means_.layer_loss = 0.0;
    else
      means_.layer_loss += 0.5 * layer_.energy(here_.layer) / n_.stick_rate;
    const double mean = 1 / (2 * std::numbers::pi);
    ContactMeans<LaneArray>& m = batch_.means;
    store(mean * means_.traction, m.traction);
    store(mean * means_.stator_power, m.stator_power);
    store(mean * means_.friction_power, m.friction_power);
    store(mean * means_.layer_loss, m.layer_loss);
    store(means_.stick_length, m.stick_length);
    store(mean * means_.reactive_force, m.reactive_force);
    store(here_.layer.e, batch_.exit.e), store(here_.layer.rate, batch_.exit.rate);
    store(select(found_, 1.0, 0.0), batch_.found);
  }

  const LayerMotion<double>& layer_;
  LaneBatch& batch_;
  const int lane_;
  const ContactNumbers<S> n_;
  LapPlace<S> here_;
  ContactMeans<S> means_{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  S sigma_;
  std::size_t zone_{0};
  Mask found_, goes_on_, sticks_;
  Mask starts_at_zero_, starts_flat_;  // slip zones after others, and those after stick
};

}  // namespace twum::inline v0_1::contact
