// SPDX-License-Identifier: Apache-2.0
#include "contact/lap.hpp"

#include "contact/scalars.hpp"
#include "contact/short_slip.hpp"
#include "contact/zone_curves.hpp"
#include "contact/zone_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace twum::contact {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr long kMaxSamples = 4'000'000;
constexpr double kSamePlace = 1e-14;  // [rad]
constexpr int kMaxZones = 200'000;

// A free layer that has decayed by exp(-37) = 9e-17 enters the next contact at rest.
constexpr double kForgotten = 37;

// Where the ends of zones come from.
enum class Ends : unsigned char {
  searched,  // the first root of a function; given by a script, if there is one
  proven,    // those near the ones of a script, once they are proven to be the first
  followed   // those near the ones of a script, without proof
};

template <typename S, Ends kEnds = Ends::searched>
class LapRunner {
  // The return map needs no means.
  static constexpr bool kHasMeans = kEnds != Ends::followed && !std::is_same_v<S, StateDual>;

 public:
  LapRunner(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer, const Script* script,
            std::vector<ZoneTrace>* trace, Lap<S>& lap)
      : lap_(lap),
        n_(numbers),
        layer_(layer),
        script_(script && script->complete() ? script : nullptr),
        trace_(trace),
        theta_(-numbers.half_angle),
        at_{-numbers.edge.sin, numbers.edge.cos, numbers.edge.versine},
        delicate_(is_delicate()) {}

  void run(const LapEntry<S>& entry) {
    state_ = entry.layer;
    entry.carried ? carry_on(entry.zone) : enter();
    lap_.first = zone_;
    while (!done_ && lap_.status == LapStatus::ok) {
      if (!follows_on()) return fail();
      zone_ == ZoneState::stick ? stick() : slip();
      if (lap_.zones > kMaxZones) lap_.status = LapStatus::unresolved;
    }
    lap_.one_slip = lap_.zones == 1 && lap_.first != ZoneState::stick;
    leave();
  }

 private:
  static double sign(ZoneState zone) { return -static_cast<double>(zone); }  // of v_rel
  static ZoneState slipping(double sign_of_v_rel) {
    return sign_of_v_rel < 0 ? ZoneState::slip_plus : ZoneState::slip_minus;
  }

  S pressure() const { return n_.peak - at_.versine; }
  // v_rel = 0 (T4.2): e' = s (cos theta - V)
  S sticking_rate() const { return n_.stick_rate * ((1.0 - n_.speed_ratio) - at_.versine); }
  S sticking_traction() const {
    return state_.e + layer_.C * sticking_rate() - layer_.M * n_.stick_rate * at_.sin;
  }

  // Response e of a layer that slips with v_rel of sign sigma to t = -sigma mu p (T5.1).
  Harmonic<S> forced(double sigma) const { return forced_response(n_, layer_, sigma); }

  // Own and forced part of the layer's motion cancel in small contacts, which costs the closed forms
  // eps (1 + response) / (s theta_L^3) of the powers: more than 1e-13 is too much.
  bool is_delicate() const {
    const double size = std::min<double>(value_of(n_.half_angle), 1.0);
    return layer_.kind() != LayerKind::elastic &&
           1 + value_of(layer_.response) > 600 * value_of(n_.stick_rate) * size * size * size;
  }

  // ---- which zone begins ------------------------------------------------------------------------

  void begin_slip(double sigma, StartOrder order) {
    zone_ = slipping(sigma);
    order_ = order;
  }

  void begin_stick(StartOrder plus_side, StartOrder minus_side) {
    zone_ = ZoneState::stick;
    side_order_[0] = plus_side;
    side_order_[1] = minus_side;
    if (layer_.has_inertia()) state_.rate = sticking_rate();
  }

  // The zone of the lap before goes on, unless a Newton step has moved the state out of it.
  void carry_on(ZoneState zone) {
    if (zone == ZoneState::stick) {
      const double traction = value_of(sticking_traction());
      if (std::fabs(traction) <= value_of(n_.static_) * value_of(pressure())) {
        return begin_stick(StartOrder::positive, StartOrder::positive);
      }
      return begin_slip(traction > 0 ? -1 : 1,
                        layer_.has_inertia() ? StartOrder::zero : StartOrder::positive);
    }
    if (sign(zone) * slip_rate(sign(zone)) > 0) return begin_slip(sign(zone), StartOrder::positive);
    enter();
  }

  // v_rel s / V0 of a layer that slips with sign sigma from here.
  double slip_rate(double sigma) const {
    const double rate = value_of(sticking_rate()), mu = value_of(n_.kinetic);
    if (layer_.has_inertia()) return value_of(state_.rate) - rate;
    if (layer_.kind() == LayerKind::elastic) return sigma * mu * value_of(at_.sin) - rate;
    return (-sigma * mu * value_of(pressure()) - value_of(state_.e)) / value_of(layer_.C) - rate;
  }

  // At the edge p = 0 and the layer comes with what the free flight left: rates decide.
  void enter() {
    if (layer_.has_inertia())
      return enter_at_rate(value_of(state_.rate) - value_of(sticking_rate()));
    if (n_.full) return enter_under_pressure();
    const double rate = value_of(sticking_rate());
    if (layer_.kind() == LayerKind::elastic) return enter_by_slopes(rate, StartOrder::positive);
    const double C = value_of(layer_.C), relative_rate = -value_of(state_.e) / C - rate;
    if (relative_rate != 0) return enter_at_rate(relative_rate);
    enter_by_slopes(rate + C * value_of(n_.stick_rate) * value_of(n_.edge.sin), StartOrder::zero);
  }

  // Traction and threshold begin at zero: the layer sticks if the traction of stick rises no faster.
  void enter_by_slopes(double gain, StartOrder slip) {
    const double allowed = value_of(n_.kinetic) * value_of(n_.edge.sin);
    if (gain > allowed) return begin_slip(-1, slip);
    if (gain < -allowed) return begin_slip(+1, slip);
    begin_stick(StartOrder::zero, StartOrder::zero);
  }

  void enter_at_rate(double relative_rate) {
    if (relative_rate != 0) return begin_slip(relative_rate < 0 ? -1 : 1, StartOrder::positive);
    if (n_.full) return enter_under_pressure();
    begin_slip(value_of(sticking_traction()) > 0 ? -1 : 1, StartOrder::zero);
  }

  // Full contact, layer without relative velocity: it sticks if it can.
  void enter_under_pressure() {
    const double traction = value_of(sticking_traction());
    if (std::fabs(traction) <= value_of(n_.static_) * value_of(pressure())) {
      begin_stick(StartOrder::positive, StartOrder::positive);
    } else {
      begin_slip(traction > 0 ? -1 : 1, StartOrder::positive);
    }
  }

  bool has_static_excess() const { return value_of(n_.static_) > value_of(n_.kinetic); }

  // A lap that follows another goes through the same zones.
  bool follows_on() const {
    if (kEnds != Ends::followed) return true;
    const int i = lap_.script.count;
    return i < script_->count && script_->ends[i].zone == zone_;
  }

  void after_slip(double sigma) {
    if (!layer_.has_inertia()) {
      // With mu_0 = mu the traction leaves its threshold where slip ends: at once with damping, from rest
      // relative to it in an elastic layer.
      const StartOrder touching = has_static_excess()                   ? StartOrder::positive
                                  : layer_.kind() == LayerKind::elastic ? StartOrder::double_zero
                                                                        : StartOrder::zero;
      return sigma < 0 ? begin_stick(touching, StartOrder::positive)
                       : begin_stick(StartOrder::positive, touching);
    }
    if (std::fabs(value_of(sticking_traction())) <= value_of(n_.static_) * value_of(pressure())) {
      begin_stick(StartOrder::positive, StartOrder::positive);
    } else {
      begin_slip(-sigma, StartOrder::zero);
    }
  }

  void after_stick(double iota) {
    const double sigma = -iota;
    if (layer_.kind() != LayerKind::elastic) {
      if (layer_.has_inertia()) {
        state_.rate = sticking_rate();
        return begin_slip(sigma, has_static_excess() ? StartOrder::zero : StartOrder::double_zero);
      }
      return begin_slip(sigma, has_static_excess() ? StartOrder::positive : StartOrder::zero);
    }
    if (has_static_excess()) snap(iota);
    // The slip branch holds if it gives v_rel its sign; otherwise the layer sticks again.
    if (sigma * slip_rate(sigma) > 0 || !has_static_excess())
      return begin_slip(sigma, StartOrder::positive);
    begin_stick(StartOrder::positive, StartOrder::positive);
  }

  // Elastic layer: t falls from mu_0 p to mu p at once; all the energy released is friction work (T4.4).
  void snap(double iota) {
    const S before = iota * n_.static_ * pressure(), after = iota * n_.kinetic * pressure();
    if constexpr (kHasMeans)
      lap_.means.friction_power += 0.5 * (before * before - after * after) / n_.stick_rate;
    state_.e = after;
    mark(7);
  }

  // ---- slip -------------------------------------------------------------------------------------

  void slip() {
    const double sigma = sign(zone_);
    const Harmonic<S> f = forced(sigma);  // t = -sigma mu p (T4.3)
    const LayerState<S> h0 =
        layer_.own_part({state_.e - f.at(theta_, at_), state_.rate - f.slope(at_)});
    const FreeMotion<S> motion = layer_.start(h0);
    const Harmonic<S> slow = relative_rate(n_, f);
    const double x = find_slip_end(motion, slow, sigma);
    if (std::isnan(x)) return fail();
    note({x, 0, zone_});
    const Phase<S> from{theta_, at_};
    S length = n_.half_angle - theta_;
    if (x == kNoZero) {
      reach_exit();
    } else {
      length = settle_slip_end(motion, slow, x);
      advance(length);
    }
    record(from);
    const Phase<S> to{theta_, at_};
    if (delicate_ && ShortSlip<S>::rate(layer_) * value_of(length) <= ShortSlip<S>::kReach) {
      const ShortSlip<S> zone(n_, layer_, sigma, from, length, state_, motion.u);
      if constexpr (kHasMeans) {
        add(lap_.means, slip_integrals(n_, sigma, Moments<S>(from, to), zone.work(from, to)));
      }
      state_ = zone.end();
    } else {
      const LayerState<S> h1 = layer_.at(motion, length);
      if constexpr (kHasMeans) {
        const Moments<S> moments(from, to);
        const SlipWork<S> work = slip_work(n_, layer_, f, moments, from, to, h0, h1);
        add(lap_.means, slip_integrals(n_, sigma, moments, work));
      }
      state_ = {h1.e + f.at(theta_, at_), h1.rate + f.slope(at_)};
    }
    mark(sigma < 0 ? 1 : 2);
    if (x != kNoZero) after_slip(sigma);
  }

  double find_slip_end(const FreeMotion<S>& motion, const Harmonic<S>& slow, double sigma) {
    if (is_given()) return known_end().length;
    const FreeMotion<double> own{value_of(motion.u), value_of(motion.w)};
    const double length = value_of(n_.half_angle) - value_of(theta_);
    const auto& layer = layer_.values();  // lives as long as the curve
    const SlipCurve curve(layer, own, slow.values(), sigma, value_of(theta_), values(at_), length,
                          values(n_.edge));
    return find_zero(curve, length, order_, kEnds == Ends::searched ? kNoZero : known_end().length);
  }

  // The script's end of a zone like this one, or none.
  Script::End known_end() const {
    const int i = lap_.script.count;
    const bool known = script_ && i < script_->count && script_->ends[i].zone == zone_;
    return known ? script_->ends[i] : Script::End{kNoZero, 0, zone_};
  }

  // True if the zone's end needs no search.
  bool is_given() const {
    return kEnds == Ends::searched ? script_ != nullptr
                                   : kEnds == Ends::followed && known_end().length == kNoZero;
  }

  template <typename Curve>
  double find_zero(const Curve& curve, double length, StartOrder order, double near) {
    if constexpr (kEnds == Ends::searched) {
      return first_zero(curve, length, order, samples_, kMaxSamples);
    } else if constexpr (kEnds == Ends::proven) {
      return first_zero(curve, length, order, samples_, kMaxSamples,
                        known_zero(curve, near, length));
    } else {
      return followed_zero(curve, near, length);
    }
  }

  // Newton steps in S from the root in double: the value stays, the derivatives come in.
  S settle_slip_end(const FreeMotion<S>& motion, const Harmonic<S>& slow, double x) const {
    S length(x);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S theta = theta_ + length;
      const Trig<S> a = trig(theta);
      const LayerState<S> h = layer_.at(motion, length);
      const S rate2 = layer_.kind() == LayerKind::elastic ? S(0.0)
                      : layer_.kind() == LayerKind::relaxing
                          ? S(-h.rate / layer_.C)
                          : S(-(layer_.C * h.rate + h.e) / layer_.M);
      length = newton_step(length, S(slow.at(theta, a) + h.rate), S(slow.slope(a) + rate2), x);
    }
    return length;
  }

  static S newton_step(const S& x, const S& f, const S& slope, double value) {
    if (value_of(slope) == 0) return x;
    return with_value(S(x - with_value(f, 0.0) / slope), value);
  }

  // ---- stick ------------------------------------------------------------------------------------

  void stick() {
    const S& s = n_.stick_rate;
    const S drift = s * n_.speed_ratio;
    // t = M e'' + C e' + e with e from (T5.2): (T5.3, E2.3)
    const Harmonic<S> t{
        state_.e - s * at_.sin + drift * theta_ + layer_.C * s * (1.0 - n_.speed_ratio), -drift,
        -(layer_.C * s), layer_.D * s};
    const Script::End end = find_stick_end(t);
    if (std::isnan(end.length)) return fail();
    note(end);
    const Phase<S> from{theta_, at_};
    const S e0 = state_.e;
    if (end.length == kNoZero) {
      reach_exit();
    } else {
      advance(settle_stick_end(t, end));
    }
    record(from);
    if constexpr (kHasMeans) {
      add(lap_.means, stick_integrals(n_, layer_, t, from, Phase<S>{theta_, at_}));
    }
    state_.e = e0 + s * (at_.sin - from.at.sin) - drift * (theta_ - from.theta);
    if (layer_.has_inertia()) state_.rate = sticking_rate();
    mark(3);
    if (end.length != kNoZero) after_stick(end.side);
  }

  // (E2.4)
  Harmonic<S> reserve(const Harmonic<S>& t, double iota) const {
    return {n_.static_ * n_.peak - iota * t.k0, -iota * t.kb, -n_.static_ - iota * t.kw,
            -iota * t.ks};
  }

  // The side that the traction would reach at the exit comes first. The other is mostly ruled out at a
  // glance.
  Script::End find_stick_end(const Harmonic<S>& t) {
    if (is_given()) return known_end();
    const Harmonic<double> traction = t.values();
    const double exit = value_of(n_.half_angle), length = exit - value_of(theta_);
    const Script::End known = kEnds == Ends::searched ? Script::End{} : known_end();
    if constexpr (kEnds == Ends::followed) {
      return stick_end(find_zero(stick_curve(t, known.side), length, {}, known.length), known.side);
    }
    const double likely = traction.at(exit, values(n_.edge)) < 0 ? -1 : 1;
    const double first = find_stick_end(t, likely, length, values(n_.edge), known);
    if (std::isnan(first)) return stick_end(first, 0);
    const double second =
        first == kNoZero
            ? find_stick_end(t, -likely, length, values(n_.edge), known)
            : find_stick_end(t, -likely, first, quick_trig(value_of(theta_) + first), known);
    return second == kNoZero ? stick_end(first, likely) : stick_end(second, -likely);
  }

  double find_stick_end(const Harmonic<S>& t, double iota, double length, const Trig<double>& end,
                        const Script::End& known) {
    const StickCurve curve = stick_curve(t, iota);
    const double near = known.side == iota ? known.length : kNoZero;
    const StickCurve::Glance glance = curve.glance(length, side_order(iota), end);
    if (glance == StickCurve::Glance::no_zero) return kNoZero;
    if (glance == StickCurve::Glance::one_zero) return curve.only_zero(length, near);
    return find_zero(curve, length, side_order(iota), near);
  }

  StickCurve stick_curve(const Harmonic<S>& t, double iota) const {
    return {reserve(t, iota).values(), value_of(theta_), values(at_)};
  }

  static Script::End stick_end(double length, double side) {
    return {length, static_cast<float>(side), ZoneState::stick};
  }

  StartOrder side_order(double iota) const { return side_order_[iota > 0 ? 0 : 1]; }

  S settle_stick_end(const Harmonic<S>& t, const Script::End& end) const {
    const Harmonic<S> f = reserve(t, end.side);
    S length(end.length);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S theta = theta_ + length;
      const Trig<S> a = trig(theta);
      length = newton_step(length, f.at(theta, a), f.slope(a), end.length);
    }
    return length;
  }

  // ---- bookkeeping ------------------------------------------------------------------------------

  static Trig<double> values(const Trig<S>& a) {
    return {value_of(a.sin), value_of(a.cos), value_of(a.versine)};
  }

  void advance(const S& length) {
    // Events that pile up within rounding of one place are one event: pass it by less than counts.
    stalled_ = value_of(length) < kSamePlace ? stalled_ + 1 : 0;
    theta_ = theta_ + length + (stalled_ > 4 ? 10 * kSamePlace : 0.0);
    at_ = trig(theta_);
    if (!(value_of(theta_) < value_of(n_.half_angle))) reach_exit();
  }

  void reach_exit() {
    theta_ = n_.half_angle;
    at_ = n_.edge;
    done_ = true;
  }

  void fail() {
    lap_.status = LapStatus::unresolved;
    done_ = true;
  }

  void note(const Script::End& end) {
    if (lap_.script.count < Script::kCapacity) lap_.script.ends[lap_.script.count] = end;
    ++lap_.script.count;
  }

  void mark(std::uint64_t what) {
    lap_.itinerary = (lap_.itinerary ^ what) * 0x100000001b3ull;
    if (what < 7) ++lap_.zones;
  }

  // To be called while state_ is still that of the zone's start.
  void record(const Phase<S>& from) {
    lap_.shortest = std::min<double>(lap_.shortest, value_of(theta_) - value_of(from.theta));
    if (trace_ && value_of(theta_) > value_of(from.theta)) {
      trace_->push_back({{zone_, value_of(from.theta), value_of(theta_)},
                         {value_of(state_.e), value_of(state_.rate)}});
    }
  }

  // Free flight to the next entry; the energy the layer brings back is all that it keeps.
  void leave() {
    ContactMeans<S>& m = lap_.means;
    lap_.next = {state_, n_.full, zone_};
    lap_.exit = state_;
    if (!n_.full) {
      const S flight = 2 * kPi - 2.0 * n_.half_angle;
      lap_.next.layer = layer_.slowest_decay() * value_of(flight) > kForgotten
                            ? LayerState<S>{S(0.0), S(0.0)}
                            : layer_.at(layer_.start(state_), flight);
      if constexpr (kHasMeans) {
        m.layer_loss += 0.5 *
                        (layer_.energy(layer_.own_part(state_)) - layer_.energy(lap_.next.layer)) /
                        n_.stick_rate;
      }
    }
    if (value_of(n_.damping) == 0)
      m.layer_loss = S(0.0);  // what is left is rounding of the layer's energy
    const double mean = 1 / (2 * kPi);
    m.traction *= mean, m.stator_power *= mean, m.friction_power *= mean, m.layer_loss *= mean;
  }

  Lap<S>& lap_;
  const ContactNumbers<S>& n_;
  const LayerMotion<S>& layer_;
  const Script* script_;
  std::vector<ZoneTrace>* trace_;
  S theta_;
  Trig<S> at_;
  bool delicate_;
  LayerState<S> state_{S(0.0), S(0.0)};
  ZoneState zone_{ZoneState::stick};
  StartOrder order_{StartOrder::positive};
  StartOrder side_order_[2]{StartOrder::positive, StartOrder::positive};
  bool done_{false};
  int stalled_{0};
  long samples_{0};
};

}  // namespace

template <typename S>
Lap<S> run_lap(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
               const LapEntry<S>& entry, const Script* script, std::vector<ZoneTrace>* trace) {
  Lap<S> lap;
  LapRunner<S>(numbers, layer, script, trace, lap).run(entry);
  return lap;
}

void prove_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
               const LapEntry<double>& entry, const Script& near, Lap<double>& lap) {
  lap.clear();
  if (near.count > 0 && near.complete()) {
    LapRunner<double, Ends::proven>(numbers, layer, &near, nullptr, lap).run(entry);
  } else {
    LapRunner<double>(numbers, layer, nullptr, nullptr, lap).run(entry);
  }
}

bool follow_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                const LayerState<double>& entry, Script& script, LayerState<double>& next) {
  if (!script.complete()) return false;
  Lap<double> lap;
  LapRunner<double, Ends::followed>(numbers, layer, &script, nullptr, lap).run({entry});
  if (lap.status != LapStatus::ok || lap.script.count != script.count) return false;
  script = lap.script;
  next = lap.next.layer;
  return true;
}

#define TWUM_INSTANTIATE(S)                                                                    \
  template Lap<S> run_lap(const ContactNumbers<S>&, const LayerMotion<S>&, const LapEntry<S>&, \
                          const Script*, std::vector<ZoneTrace>*);
TWUM_FOR_EACH_CONTACT_SCALAR(TWUM_INSTANTIATE)
TWUM_FOR_EACH_WITH_STATE(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::contact
