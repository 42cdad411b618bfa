// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"
#include "contact/short_slip.hpp"
#include "contact/zone_ends.hpp"
#include "contact/zone_integrals.hpp"
#include "contact/zone_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::contact {
// Unnamed, so that each source has a class of its own: GCC then inlines a function of any length that only one place calls.
namespace {

/// Follows a lap zone by zone. The return map needs no means.
template <typename S, Ends kEnds = Ends::searched, bool kHasMeans = true>
class LapRunner {
 public:
  LapRunner(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
            const ZoneSequence* sequence, core::Vector<ZoneTrace>* trace, Means means, Lap<S>& lap)
      : lap_(lap),
        n_(numbers),
        layer_(layer),
        start_(numbers, layer),
        ends_(numbers, layer, sequence),
        trace_(trace),
        means_(means),
        here_{{-numbers.half_angle, {-numbers.edge.sin, numbers.edge.cos, numbers.edge.versine}},
              {S(0.0), S(0.0)}},
        delicate_(is_delicate(numbers, layer)) {}

  /// @param zones  how many of them; the lap is whole if it has no more
  void run(const LapEntry<S>& entry, int zones = std::numeric_limits<int>::max()) {
    here_.layer = entry.layer;
    lap_.has_means = kHasMeans;
    begin(entry.carried ? start_.carry_on(entry.zone, here_) : start_.enter(here_));
    lap_.first = zone_.zone;
    while (!done_ && lap_.status == LapStatus::ok && lap_.sequence.count < zones) {
      const ZoneSequence::End* known = ends_.known(zone_.zone, lap_.sequence.count);
      // A lap that follows another goes through the same zones.
      if (kEnds == Ends::trusted && !known) return fail();
      zone_.zone == ZoneState::stick ? stick(known) : slip(known);
      if (lap_.zones > kMaxZones) lap_.status = LapStatus::unresolved;
    }
    lap_.one_slip = lap_.zones == 1 && lap_.first != ZoneState::stick;
    leave();
  }

  LapPlace<S> here() const { return here_; }

 private:
  static constexpr double kSamePlace = 1e-14;  // [rad]
  static constexpr int kMaxZones = 200'000;

  void begin(const ZoneBegin& zone) {
    zone_ = zone;
    if (zone.zone == ZoneState::stick) stay();
  }

  // A layer that sticks moves as the stator does.
  void stay() {
    if (layer_.has_inertia()) here_.layer.rate = sticking_rate(n_, here_.at);
  }

  // Elastic layer: t falls from mu_0 p to mu p at once; all the energy released is friction work (T4.4).
  void snap(double iota) {
    const S p = pressure(n_, here_.at);
    const S before = iota * n_.threshold * p, after = iota * n_.kinetic * p;
    if constexpr (kHasMeans)
      lap_.means.friction_power += 0.5 * (before * before - after * after) / n_.stick_rate;
    here_.layer.e = after;
    mark(7);
  }

  // @param known  the zone's end in the lap nearby; null if it has no such zone
  void slip(const ZoneSequence::End* known) {
    const double sigma = sign_of(zone_.zone);
    const Harmonic<S> f = forced_response(n_, layer_, sigma);  // t = -sigma mu p (T4.3, T5.1)
    const LapPlace<S> from = here_;
    const LayerState<S> h0 = layer_.own_part(
        {from.layer.e - f.at(from.theta, from.at), from.layer.rate - f.slope(from.at)});
    const FreeMotion<S> motion = layer_.start(h0);
    const Harmonic<S> slow = relative_rate(n_, f);
    const double x = ends_.slip_end(motion, slow, zone_, here_, known);
    if (std::isnan(x)) return fail();
    note({x, 0, zone_.zone});
    const S length = x == kNoZero ? S(n_.half_angle - from.theta)
                                  : ends_.settled_slip_end(motion, slow, here_, x);
    x == kNoZero ? reach_exit() : advance(length);
    record(from);
    if (delicate_ && ShortSlip<S>::rate(layer_) * value_of(length) <= ShortSlip<S>::kReach) {
      const ShortSlip<S> zone(n_, layer_, sigma, from, length, from.layer, motion.u);
      if constexpr (kHasMeans) {
        SlipWork<S> work;
        if (means_ == Means::all) work = zone.work(from, here_);
        add(lap_.means, slip_integrals(n_, sigma, Moments<S>(from, here_), from, here_, work));
      }
      here_.layer = zone.end();
    } else {
      const LayerState<S> h1 = layer_.at(motion, length);
      if constexpr (kHasMeans) {
        const Moments<S> moments(from, here_);
        SlipWork<S> work;
        if (means_ == Means::all) work = slip_work(n_, layer_, f, moments, from, here_, h0, h1);
        add(lap_.means, slip_integrals(n_, sigma, moments, from, here_, work));
      }
      here_.layer = {h1.e + f.at(here_.theta, here_.at), h1.rate + f.slope(here_.at)};
    }
    mark(mark_of(zone_.zone));
    if (x != kNoZero) begin(start_.after_slip(sigma, here_));
  }

  void stick(const ZoneSequence::End* known) {
    const LapPlace<S> from = here_;
    const Harmonic<S> t = sticking_traction(n_, layer_, from, from.layer.e);
    const ZoneSequence::End end = ends_.stick_end(t, zone_, here_, known);
    if (std::isnan(end.length)) return fail();
    note(end);
    end.length == kNoZero ? reach_exit() : advance(ends_.settled_stick_end(t, here_, end));
    record(from);
    if constexpr (kHasMeans) {
      add(lap_.means, stick_integrals(n_, layer_, t, from, here_));
    } else {
      lap_.means.stick_length += here_.theta - from.theta;
    }
    here_.layer.e = sticking_strain(n_, from, from.layer.e, here_);
    stay();
    mark(mark_of(zone_.zone));
    if (end.length == kNoZero) return;
    if (layer_.kind() == LayerKind::elastic && start_.has_static_excess()) snap(end.side);
    begin(start_.after_stick(end.side, here_));
  }

  // ---- bookkeeping ------------------------------------------------------------------------------

  void advance(const S& length) {
    // After five events closer than kSamePlace, step over the place by ten times that, which changes nothing that counts.
    stalled_ = value_of(length) < kSamePlace ? stalled_ + 1 : 0;
    here_.theta = here_.theta + length + (stalled_ > 4 ? 10 * kSamePlace : 0.0);
    here_.at = trig(here_.theta);
    if (!(value_of(here_.theta) < value_of(n_.half_angle))) reach_exit();
  }

  void reach_exit() {
    here_.theta = n_.half_angle;
    here_.at = n_.edge;
    done_ = true;
  }

  void fail() {
    lap_.status = LapStatus::unresolved;
    done_ = true;
  }

  void note(const ZoneSequence::End& end) {
    if (lap_.sequence.count < ZoneSequence::kCapacity)
      lap_.sequence.ends[lap_.sequence.count] = end;
    ++lap_.sequence.count;
  }

  void mark(std::uint64_t what) {
    lap_.itinerary = marked(lap_.itinerary, what);
    if (what < 7) ++lap_.zones;
  }

  // A zone from `from` to here.
  void record(const LapPlace<S>& from) {
    const double begin = value_of(from.theta), end = value_of(here_.theta);
    lap_.shortest = std::min<double>(lap_.shortest, end - begin);
    if (trace_ && end > begin) {
      trace_->push_back(
          {{zone_.zone, begin, end}, {value_of(from.layer.e), value_of(from.layer.rate)}});
    }
  }

  // Free flight to the next entry; the energy the layer brings back is all that it keeps.
  void leave() {
    ContactMeans<S>& m = lap_.means;
    lap_.next = {here_.layer, n_.full, zone_.zone};
    lap_.exit = here_.layer;
    if (!n_.full) {
      const S flight = 2 * std::numbers::pi - 2.0 * n_.half_angle;
      lap_.next.layer = enters_at_rest(n_, layer_) ? LayerState<S>{S(0.0), S(0.0)}
                                                   : layer_.at(layer_.start(here_.layer), flight);
      if constexpr (kHasMeans) {
        m.layer_loss +=
            0.5 * (layer_.energy(layer_.own_part(here_.layer)) - layer_.energy(lap_.next.layer)) /
            n_.stick_rate;
      }
    }
    if (value_of(n_.damping) == 0)
      m.layer_loss = S(0.0);  // what is left is rounding of the layer's energy
    const double mean = 1 / (2 * std::numbers::pi);
    m.traction *= mean, m.stator_power *= mean, m.friction_power *= mean, m.layer_loss *= mean;
    m.reactive_force *= mean;
  }

  Lap<S>& lap_;
  const ContactNumbers<S>& n_;
  const LayerMotion<S>& layer_;
  ZoneStart<S> start_;
  ZoneEnds<S, kEnds> ends_;
  core::Vector<ZoneTrace>* trace_;
  Means means_;
  LapPlace<S> here_;
  ZoneBegin zone_{};
  bool delicate_;
  bool done_{false};
  int stalled_{0};
};

}  // namespace

}  // namespace twum::inline v0_1::contact
