// SPDX-License-Identifier: Apache-2.0
#include "contact/periodic_state.hpp"
#include "contact/radial_state.hpp"

#include "contact/return_map.hpp"
#include "contact/zone_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {
namespace {

constexpr int kMaxLaps = 1500;
constexpr long kMaxZonesInAll = 60'000;
constexpr int kMaxFollowed = 12;
constexpr double kFloor = 1000;      // of tolerances: where rounding may keep Newton's method
constexpr double kSameState = 1000;  // of tolerances: a state that came back
constexpr double kFast = 0.1;        // contraction by a lap that leaves no doubt where laps lead
constexpr double kSlow = 0.5;  // the same at which a state is off by no more than twice its gap
constexpr LapEntry<double> kAtRest{{0, 0}, false, ZoneState::stick};
constexpr int kSteadyDrift = 4;  // laps that drift alike before one leaps over laps
constexpr double kAlike = 0.02;  // of a lap's drift: how it may differ from the last one's
constexpr double kSlowDrift =
    1e-5;  // of the layer's swing: what a lap may drift, so that leaps end where laps would
constexpr double kLeap = 0.2;        // of the drift: how it may change over a leap
constexpr double kResonance = 1e16;  // response to the wave's own frequency, squared

class Search {
 public:
  Search(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer, double accuracy,
         bool decided, PeriodicState& state)
      : s_(state),
        n_(numbers),
        layer_(layer),
        monotone_(decided || !(numbers.threshold > numbers.kinetic)),
        unique_(monotone_ && layer.C > 0 && !numbers.full),
        swing_(std::sqrt(layer.response)),
        tolerance_(4e-16 * numbers.threshold * (swing_ + numbers.peak)),
        tight_(4e-16 * numbers.threshold * std::min(numbers.peak, 1.0) * swing_),
        loose_(monotone_ && layer.C > 0 ? accuracy / 4e-16 * tight_ : 0) {}

  void run(const LapGuess* guess) {
    if (layer_.response > kResonance) return give_up(PeriodicStatus::resonance);
    if (unique_ && guess) {
      const LapGuess from = followed(*guess);
      turn(from, from.zones);
    } else {
      first_turn(unique_ ? after_slip() : kAtRest);
    }
    while (s_.laps < kMaxLaps && s_.zones < kMaxZonesInAll && s_.lap.status == LapStatus::ok) {
      if (settled()) {
        if (s_.lap.has_means) return finish();
        turn(s_.entry);
        continue;
      }
      if (cycles()) break;
      advance();
    }
    if (s_.lap.status != LapStatus::ok) return give_up(PeriodicStatus::unresolved);
    return give_up(monotone_ ? PeriodicStatus::not_converged : PeriodicStatus::no_periodic_state);
  }

 private:
  // What the last lap told beside the one before, to go back to.
  struct LapHistory {
    double gap{0}, progress{1};
    Turn before{};
    int repeats{0};
  };
  struct Standing {
    LapEntry<double> entry;
    Lap<double> lap;
    LapHistory history;
  };

  Standing standing() const { return {s_.entry, s_.lap, history_}; }
  void go_back(const Standing& where) {
    s_.entry = where.entry;
    s_.lap = where.lap;
    history_ = where.history;
  }

  // Entry of a layer that left the contact as if it had slipped all through, and long enough for its own
  // motion to be over: nearer than rest where that motion is not over at the next entry.
  LapEntry<double> after_slip() const {
    const double mean_slip = n_.edge.sin / n_.half_angle - n_.speed_ratio;
    const Harmonic<double> f = forced_response(n_, layer_, mean_slip > 0 ? -1 : 1);
    const LayerState<double> exit{f.at(n_.half_angle, n_.edge), f.slope(n_.edge)};
    return {layer_.at(layer_.start(layer_.own_part(exit)), flight()), false, ZoneState::stick};
  }

  double flight() const { return n_.full ? 0 : 2 * (std::numbers::pi - n_.half_angle); }
  // What is left of the layer's motion after the free flight is less than a share.
  bool forgets(double share) const { return layer_.slowest_decay() * flight() > -std::log(share); }

  // Unless the layer comes back with next to nothing, the first lap is hardly the last and needs no means.
  void first_turn(const LapEntry<double>& entry) {
    forgets(1e-10) ? turn(entry, ZoneSequence()) : take(entry, search_states(n_, layer_, entry));
  }

  void turn(const LapEntry<double>& entry) { turn(entry, s_.lap.sequence); }

  void turn(const LapEntry<double>& entry, const ZoneSequence& near) {
    take(entry, prove_lap(n_, layer_, entry, near));
  }

  void take(const LapEntry<double>& entry, const Lap<double>& lap) {
    const Turn before = last_turn();
    const std::uint64_t itinerary = s_.lap.itinerary;
    s_.entry = entry;
    s_.lap = lap;
    ++s_.laps;
    s_.zones += s_.lap.zones;
    const double gap = distance(layer_, s_.entry.layer, s_.lap.next.layer);
    history_ = {gap, history_.gap > 0 ? gap / history_.gap : 1, before,
                s_.lap.itinerary == itinerary ? history_.repeats + 1 : 0};
  }

  Turn last_turn() const { return {s_.entry.layer, s_.lap.next.layer}; }

  bool same_zone() const {
    return !n_.full || (s_.entry.carried && s_.entry.zone == s_.lap.next.zone);
  }

  // Rounding of the closed forms sets the looser bound; in small contacts series do better.
  bool settled() const {
    return same_zone() &&
           (history_.gap <= enough() || (history_.gap <= tolerance_ && history_.progress > 0.5));
  }

  // Gap of a state that is known well enough. Full contact may drift slowly, lap by lap.
  double enough() const {
    const bool drifts = n_.full && (sticks_all_round() || !contracts(kSlow));
    return drifts ? tight_ : std::max(tight_, loose_);
  }

  void finish() {
    s_.status = PeriodicStatus::ok;
    s_.remembers = n_.full || s_.lap.next.layer.e != 0 || s_.lap.next.layer.rate != 0;
  }

  void give_up(PeriodicStatus status) { s_.status = status; }

  void advance() {
    if (sticks_all_round()) return turn(after_drift());
    if (secants_may_help()) {
      if (!may_follow()) return turn(after_secant());
      if (follow()) return;
    }
    if (newton_may_help() && newton()) return;
    if (drifts_alike() && leap()) return;
    turn(s_.lap.next);
  }

  // The last lap brought states closer to one another, to less than a share.
  bool contracts(double share) const {
    const Turn now = last_turn();
    return s_.laps > 1 && distance(layer_, now.out, history_.before.out) <=
                              share * distance(layer_, now.in, history_.before.in);
  }

  bool sticks() const { return s_.lap.means.stick_length > 0; }

  // Sticking leaves the layer one way to differ, so the return map has a slope of rank one, which two
  // laps tell. With mu_0 > mu they must go through the same zones and seem to settle; in full contact a state
  // that is not quite one of the zone it is carried on in would be torn out of it.
  bool secants_may_help() const {
    return !n_.full && sticks() && (monotone_ || (history_.repeats > 0 && contracts(kFast)));
  }

  // Laps of undamped layers may circle round a state without coming nearer.
  bool may_follow() const { return s_.laps >= follow_from_ && (monotone_ || layer_.C > 0); }

  LapEntry<double> after_secant() const {
    LapEntry<double> entry = s_.lap.next;
    if (contracts(kFast)) entry.layer = secant(history_.before, last_turn(), layer_);
    return entry;
  }

  // Follows laps through the zones of the last one to the state that repeats itself there, and proves the lap
  // from it. False if that goes through other zones or is no better: then nothing has happened.
  bool follow() {
    const Standing from = standing();
    const LapGuess found = followed();
    turn(found, found.zones);
    const bool kept = s_.lap.status == LapStatus::ok &&
                      (monotone_ || s_.lap.itinerary == from.lap.itinerary) &&
                      history_.gap <= 0.5 * from.history.gap;
    if (kept) return true;
    follow_from_ = 2 * s_.laps;
    go_back(from);
    return false;
  }

  // (E6.5) The entry that secants over followed laps lead to, and the ends of the last of them.
  LapGuess followed() {
    LapGuess from(s_.lap.next, s_.lap.sequence);
    return followed(from, last_turn());
  }

  LapGuess followed(LapGuess from, Turn now) {
    double gap = distance(layer_, now.in, now.out);
    for (int i = 0; i < kMaxFollowed; ++i) {
      const Turn before = now;
      const Lap<double> lap = follow_states(n_, layer_, from, from.zones);
      if (lap.status != LapStatus::ok) break;
      ++s_.laps;
      now = {from.layer, lap.next.layer};
      from.layer = secant(before, now, layer_);
      from.zones = lap.sequence;
      const double gap_before = gap;
      gap = distance(layer_, now.in, now.out);
      // The next gap would be small enough, or they do not settle.
      if (gap * gap <= enough() * gap_before || gap > gap_before) break;
    }
    return from;
  }

  // The same from a guess, if the layer comes back from a turn with anything at all.
  LapGuess followed(const LapGuess& guess) {
    if (guess.followed || guess.zones.count == 0) return guess;
    const Lap<double> lap = follow_states(n_, layer_, guess, guess.zones);
    if (lap.status != LapStatus::ok) return guess;
    ++s_.laps;
    const Turn now{guess.layer, lap.next.layer};
    const LapGuess next(lap.next, lap.sequence);
    return distance(layer_, now.in, now.out) <= enough() ? next : followed(next, now);
  }

  // At first nothing is known but how much of the layer's motion outlives the free flight. With mu_0 > mu
  // laps come first, until they seem to settle.
  bool newton_may_help() const {
    if (!same_zone()) return false;
    if (!monotone_) return history_.repeats >= (!sticks() && contracts(kFast) ? 1 : patience_);
    return s_.laps > 1 || !forgets(kFast);
  }

  bool newton() {
    const Standing from = standing();
    const LayerState<double> at = from.entry.layer, next = from.lap.next.layer;
    const Matrix2 j = return_jacobian(n_, s_.entry, &s_.lap.sequence);
    ++s_.laps;
    const LayerState<double> step = resolvent(j) * difference(next, at);
    // Near a threshold that is just touched the full step overshoots: shorten it.
    double share = std::isfinite(step.e) && std::isfinite(step.rate) ? 1 : 0;
    for (int i = 0; i < 12 && share > 0; ++i, share *= 0.25) {
      LapEntry<double> entry = from.entry;
      entry.layer = {at.e + share * step.e, at.rate + share * step.rate};
      turn(entry);
      if (s_.lap.status != LapStatus::ok) break;
      // A state that sticks all round drifts: it is no step towards one that slips as much as it drifts.
      const bool kept = (monotone_ && !sticks_all_round()) ||
                        (s_.lap.itinerary == from.lap.itinerary && attracts(j));
      const double gap = from.history.gap;
      if (kept && (history_.gap < (1 - 0.5 * share) * gap || history_.gap <= tolerance_))
        return true;
      if (kept && gap <= kFloor * tolerance_) {
        history_.gap = 0;  // at the floor of rounding no step can do better
        return true;
      }
      if (!monotone_) break;
    }
    patience_ = std::min(2 * patience_, kMaxLaps);
    const int repeats = history_.repeats;
    go_back(from);
    history_.repeats = repeats;  // a step through other zones is a reason to wait as well
    return false;
  }

  LayerState<double> drift() const { return difference(s_.lap.next.layer, s_.entry.layer); }

  // Where a periodic state has just ceased to be, laps pass by it in ever smaller steps, and those towards one that is about to cease
  // come to it in such. A layer that sticks in each lap drifts along a line.
  bool drifts_alike() const {
    if (monotone_ || !sticks() || s_.laps < leap_from_ || history_.repeats < kSteadyDrift)
      return false;
    const LayerState<double> before = difference(history_.before.out, history_.before.in);
    return history_.gap <= kSlowDrift * n_.threshold * swing_ &&
           distance(layer_, drift(), before) <= kAlike * history_.gap;
  }

  // Leaps over as many laps of the same zones as change their drift by a small share of it: on the line along which the layer drifts
  // it passes by no state. False if the drift beyond is another one: then nothing has happened.
  bool leap() {
    const Standing from = standing();
    const LayerState<double> step = drift();
    const double change = std::fabs(history_.progress - 1);
    const double laps = std::floor(std::min(kLeap / change, static_cast<double>(kMaxLaps)));
    LapEntry<double> entry = from.lap.next;
    entry.layer = {entry.layer.e + laps * step.e, entry.layer.rate + laps * step.rate};
    turn(entry);
    leap_from_ = s_.laps + 2;  // the next lap tells the drift anew
    const bool kept = s_.lap.status == LapStatus::ok && s_.lap.itinerary == from.lap.itinerary &&
                      distance(layer_, drift(), step) <= 2 * kLeap * from.history.gap;
    if (!kept) go_back(from), leap_from_ = 2 * s_.laps;
    return kept;
  }

  // With mu_0 > mu the laps may end in a cycle of several: the state comes back to a checkpoint, set at
  // laps 8, 16, 32, ..., while it does not repeat itself from lap to lap. As many laps as may be made would not
  // close the gap between two laps, were each to bring as much as the whole cycle has.
  bool cycles() {
    if (monotone_) return false;
    const double back = distance(layer_, s_.entry.layer, checkpoint_);
    if (s_.laps > 8 && back <= kSameState * tolerance_ && kMaxLaps * back <= history_.gap)
      return true;
    if ((s_.laps & (s_.laps - 1)) == 0 || s_.laps - checked_ > s_.laps / 2) {
      checkpoint_ = s_.entry.layer;
      checked_ = s_.laps;
    }
    return false;
  }

  bool sticks_all_round() const {
    return n_.full && s_.entry.carried && s_.lap.zones == 1 && s_.lap.first == ZoneState::stick;
  }

  // Full contact that sticks all round only drifts, by the same amount each lap (E6.3): go on to the last lap
  // before the traction can reach its threshold.
  LapEntry<double> after_drift() const {
    const double s = n_.stick_rate, drift = -2 * std::numbers::pi * s * n_.speed_ratio;
    LapEntry<double> entry = s_.lap.next;
    const double iota = drift < 0 ? -1 : 1;
    const double mean = entry.layer.e - layer_.C * s * n_.speed_ratio;
    const double swing = std::hypot(n_.threshold - iota * layer_.C * s, layer_.D * s);
    const double reserve = n_.threshold * (n_.peak - 1) - iota * mean - swing - std::fabs(drift);
    const double laps = std::floor(reserve / std::fabs(drift)) - 1;
    if (laps > 0 && std::isfinite(laps)) entry.layer.e += laps * drift;
    return entry;
  }

  PeriodicState& s_;
  const ContactNumbers<double>& n_;
  const LayerMotion<double>& layer_;
  bool monotone_;  // any laps lead to the state, or those from rest are known to
  bool unique_;    // only where there is one periodic state may the search start anywhere
  double swing_;   // of the layer that the wave's pressure shakes
  double tolerance_, tight_, loose_;
  LapHistory history_;
  int patience_{4}, follow_from_{0}, leap_from_{0}, checked_{0};
  LayerState<double> checkpoint_{0, 0};
};

// The lap of a layer that enters at rest. It is made in the state, not copied to it, because it is large.
PeriodicState lap_from_rest(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                            const LapGuess* guess) {
  const bool helps = guess != nullptr && !(numbers.threshold > numbers.kinetic);
  PeriodicState state{kAtRest, helps ? prove_lap(numbers, layer, kAtRest, guess->zones)
                                     : run_lap(numbers, layer, kAtRest)};
  state.laps = 1, state.zones = state.lap.zones;
  if (state.lap.status != LapStatus::ok) state.status = PeriodicStatus::unresolved;
  return state;
}

PeriodicState searched_state(const ContactNumbers<double>& numbers,
                             const LayerMotion<double>& layer, const LapGuess* guess,
                             double accuracy) {
  PeriodicState state;
  Search(numbers, layer, accuracy, guess && guess->decided, state).run(guess);
  return state;
}

}  // namespace

PeriodicState find_periodic_state(const ContactNumbers<double>& numbers,
                                  const LayerMotion<double>& layer, const LapGuess* guess,
                                  double accuracy) {
  if constexpr (kHasRadialMotion)
    if (numbers.radial != 0) return find_radial_state(numbers, guess, accuracy);
  return enters_at_rest(numbers, layer) ? lap_from_rest(numbers, layer, guess)
                                        : searched_state(numbers, layer, guess, accuracy);
}

}  // namespace twum::inline v0_1::contact
