// SPDX-License-Identifier: Apache-2.0
#include "drive/running_branch.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

// The lowest minimum of H, which has to be passed to hold a running wave.
std::optional<ForceExtremum> lowest_hold(const Vector<ForceExtremum>& extrema) {
  std::optional<ForceExtremum> least;
  for (const ForceExtremum& e : extrema)
    if (!e.maximum && (!least || e.force < least->force)) least = e;
  return least;
}

bool runs_at_rest(const Vector<ForceExtremum>& extrema, const CurveNode& wave) {
  const auto passed = [&](const ForceExtremum& e) {
    return e.maximum && e.amplitude < wave.amplitude;
  };
  return wave.stable() &&
         (wave.behind || extrema.empty() || std::any_of(extrema.begin(), extrema.end(), passed));
}

// The running branch begins with the largest wave at rest, and there is no larger one at any speed. Larger waves that are not held at
// rest may be at some speed.
bool begins_at_rest(const Vector<ForceExtremum>& at_rest, const CurveNode* largest) {
  const auto is_hold_beyond = [&](const ForceExtremum& e) {
    return !e.maximum && e.amplitude > largest->amplitude;
  };
  return largest && runs_at_rest(at_rest, *largest) &&
         std::none_of(at_rest.begin(), at_rest.end(), is_hold_beyond);
}

}  // namespace

RunningBranch::RunningBranch(const DrivenWaves& waves, const ForceLine& at_rest,
                             const CurveNode* largest, bool with_dead)
    : waves_(waves), at_rest_(at_rest.extrema()) {
  if (!(waves.drive() > 0)) return;
  const auto hold = lowest_hold(at_rest_);
  const bool largest_runs = begins_at_rest(at_rest_, largest);
  const double amplitude = largest_runs ? largest->amplitude : largest_amplitude(waves);
  const double crest = waves.crest_speed_per_amplitude();
  unit_ = crest * (hold && !largest_runs ? hold->amplitude : amplitude);
  fastest_ = kRules.fastest * crest * amplitude;
  if (!(unit_ > 0) || !std::isfinite(fastest_)) return;
  if (largest && runs_at_rest(at_rest_, *largest)) trace(*largest, 0);
  if (with_dead)
    for (const CurveNode& wave : at_rest.held())
      if (wave.rise > 0) trace(wave, 0);
  if (!largest_runs || ends_in_gap()) search();
  list_nodes();
}

WaveCurve RunningBranch::curve(double lowest, double highest, double longest) const {
  return {ForcePlane::of_speed(waves_, unit_),
          {{-HUGE_VAL, lowest / unit_}, {HUGE_VAL, highest / unit_}},
          {longest, kRules.speed.steep, kRules.speed.settled, kRules.speed.states}};
}

// Beyond the fastest wave known are speeds without a periodic state, and no wave within the longest leap.
bool RunningBranch::ends_in_gap() const {
  const BranchPiece* fastest = fastest_piece(true);
  return fastest && fastest->nodes.back().jump;
}

const BranchPiece* RunningBranch::fastest_piece(bool running) const {
  const BranchPiece* fastest = nullptr;
  for (const BranchPiece& p : pieces_)
    if (p.is(running) && (!fastest || p.highest() > fastest->highest())) fastest = &p;
  return fastest;
}

// H at a speed, over the amplitudes of waves that drive.
ForceLine RunningBranch::line(double speed) const {
  const auto hold = lowest_hold(at_rest_);
  const double full = waves_.full_contact_amplitude(),
               lowest = kRules.smallest_running * (hold ? std::fmin(full, hold->amplitude) : full);
  return {waves_, speed, lowest, largest_amplitude(waves_), ForceLine::Jumps::at_drive};
}

// The same next to an amplitude.
ForceLine RunningBranch::near(double amplitude, double speed) const {
  return {waves_, speed, amplitude / kRules.island, amplitude * kRules.island,
          ForceLine::Jumps::at_drive};
}

// Waves at some speeds lead to pieces that begin above rest. An island between two of these speeds shows by the least force that
// holds a wave there.
void RunningBranch::search() {
  Vector<std::optional<ForceExtremum>> holds{lowest_hold(at_rest_)};
  const double step = fastest_ / kRules.speeds;
  for (int i = 1; i <= kRules.speeds; ++i) {
    const ForceLine there = line(i * step);
    trace_waves_of(there, i * step);
    holds.push_back(lowest_hold(there.extrema()));
  }
  const auto force = [&](std::size_t i) { return holds[i] ? holds[i]->force : HUGE_VAL; };
  for (std::size_t i = 1; i + 1 < holds.size(); ++i) {
    // Between straight lines as between parabolas the least force lies below the middle one by no more than that.
    const double here = force(i), higher = std::fmax(force(i - 1), force(i + 1)),
                 least = here - 0.5 * (higher - here);
    const bool lowest_one = here <= force(i - 1) && here <= force(i + 1);
    if (holds[i] && lowest_one && here > waves_.drive() && least < waves_.drive())
      search_island(static_cast<double>(i) * step, step, *holds[i]);
  }
}

// Where the minimum of H over the amplitude is least over the speed.
void RunningBranch::search_island(double near, double step, ForceExtremum hold) {
  bool met = false;
  const auto force = [&](double speed) {
    if (met) return HUGE_VAL;
    const ForceLine line(waves_, speed, hold.amplitude / kRules.island,
                         hold.amplitude * kRules.island);
    const auto here = lowest_hold(line.extrema());
    if (!here) return HUGE_VAL;
    hold = *here;
    if (here->force < waves_.drive()) trace_waves_of(line, speed), met = true;
    return here->force;
  };
  least_between("the least force of an island", force, near - step, near + step,
                kRules.island_bits);
}

// The smallest wave is the dead one, unless it lags by more than a quarter of a turn.
void RunningBranch::trace_waves_of(const ForceLine& line, double speed) {
  bool smallest = line.begins_below();
  for (const CurveNode& wave : line.held()) {
    if (!(wave.rise > 0)) continue;
    if (!smallest || (wave.behind && !wave.grows)) trace(wave, speed);
    smallest = false;
  }
}

void RunningBranch::trace(const CurveNode& wave, double speed) {
  if (known(speed, wave.amplitude)) return;
  const WaveCurve on(curve(0, fastest_));
  if (const auto start = on.solve_at({wave.at.x, speed / unit_}, &wave.start))
    ++curves_, add_pieces(on.through(*start), {});
}

// Cuts a curve at its folds. A closed one begins at a fold.
void RunningBranch::add_pieces(Vector<CurveNode> nodes, std::optional<bool> running) {
  const auto fold = [](const CurveNode& n) { return n.fold; };
  const auto turn = std::find_if(nodes.begin(), nodes.end(), fold);
  if (nodes.size() > 1 && nodes.front().at.x == nodes.back().at.x &&
      nodes.front().at.y == nodes.back().at.y && turn != nodes.end()) {
    for (auto n = nodes.begin(); n != turn; ++n) n->place += nodes.back().place;
    nodes.pop_back();
    std::rotate(nodes.begin(), turn, nodes.end());
    nodes.push_back(nodes.front());
    nodes.back().place =
        nodes.end()[-2].place + std::hypot(nodes.back().at.x - nodes.end()[-2].at.x,
                                           nodes.back().at.y - nodes.end()[-2].at.y);
  }
  for (std::size_t first = 0, i = 1; i < nodes.size(); ++i) {
    if (!nodes[i].fold && i + 1 < nodes.size()) continue;
    const CurveNode end = nodes[i];  // the next piece begins there
    const auto begin = std::make_move_iterator(nodes.begin());
    Vector<CurveNode> piece(begin + static_cast<std::ptrdiff_t>(first),
                            begin + static_cast<std::ptrdiff_t>(i) + 1);
    first = i, nodes[i] = end;
    const bool rises = std::any_of(piece.begin(), piece.end(),
                                   [](const CurveNode& n) { return !n.fold && n.rise > 0; });
    if (!rises && piece.size() > 2) continue;
    if (piece.front().at.y > piece.back().at.y) std::reverse(piece.begin(), piece.end());
    const bool runs_here = running.value_or(runs(piece));
    const bool both = piece.front().parameter == 0 && at_rest_.empty();
    pieces_.push_back({std::move(piece), runs_here, !runs_here || both, curves_});
    if (!waves_.has_static_excess()) continue;
    const CurveNode low = pieces_.back().nodes.front(), high = pieces_.back().nodes.back();
    if (low.jump) continue_past_jump(low, false, runs_here);
    if (high.jump) continue_past_jump(high, true, runs_here);
  }
}

// Beyond a jump of H, or speeds without a periodic state, the branch goes on with the nearest wave.
void RunningBranch::continue_past_jump(const CurveNode& from, bool upward, bool running) {
  for (double d = 2 * kRules.shortest; d < kRules.longest_leap; d *= 2) {
    const double speed = from.parameter + (upward ? d : -d) * unit_;
    if (speed < 0 || speed > fastest_ || pieces_.size() > kRules.most_pieces) return;
    const ForceLine line = near(from.amplitude, speed);
    std::optional<CurveNode> nearest;
    for (CurveNode& wave : line.held())
      if (wave.rise > 0 &&
          (!nearest || std::fabs(wave.at.x - from.at.x) < std::fabs(nearest->at.x - from.at.x)))
        nearest = std::move(wave);
    if (!nearest) continue;
    if (known(speed, nearest->amplitude)) return;
    const WaveCurve on(curve(0, fastest_));
    if (const auto start = on.solve_at({nearest->at.x, speed / unit_}, &nearest->start)) {
      add_pieces(on.follow(*start, upward), running);
      return;
    }
  }
}

bool RunningBranch::known(double speed, double amplitude) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const BranchPiece& piece) { return passes(piece, speed, amplitude); });
}

// A piece that begins at rest is what its wave is there. Elsewhere a wave runs if it lags by more than a quarter of a turn, or if
// its fold is the minimum of H.
bool RunningBranch::runs(const Vector<CurveNode>& nodes) const {
  const CurveNode &first = nodes.front(), &last = nodes.back();
  if (first.parameter == 0) return runs_at_rest(at_rest_, first);
  if (first.fold && first.at.x < nodes[1].at.x) return true;
  if (last.fold && last.at.x < nodes.end()[-2].at.x) return true;
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const CurveNode& n) { return n.stable() && n.behind; });
}

// The largest wave at each speed.
void RunningBranch::list_nodes() {
  for (const BranchPiece& piece : pieces_)
    for (const CurveNode& n : piece.nodes)
      if (piece.running && about(n.parameter, true).piece == &piece) nodes_.push_back(&n);
  std::sort(nodes_.begin(), nodes_.end(),
            [](const CurveNode* a, const CurveNode* b) { return a->parameter < b->parameter; });
}

// The curve that leads from the fastest waves on: its last fold towards smaller waves.
const CurveNode* RunningBranch::pull_out() const {
  if (nodes_.empty() || first().parameter == 0) return nullptr;
  const CurveNode* end = nullptr;
  const int curve = fastest_piece(true)->curve;
  for (const BranchPiece& piece : pieces_)
    if (piece.running && piece.curve == curve && piece.is_wide() &&
        (!end || piece.nodes.front().at.x < end->at.x))
      end = &piece.nodes.front();
  return end;
}

// Of the largest wave there.
RunningBranch::Neighbours RunningBranch::about(double speed, bool running) const {
  Neighbours largest;
  for (const BranchPiece& piece : pieces_) {
    if (!piece.is(running) || !piece.covers(speed)) continue;
    const auto [a, b] = piece.around(speed);
    if (!largest.piece || a->at.x > largest.a->at.x) largest = {&piece, a, b};
  }
  return largest;
}

std::optional<bool> RunningBranch::runs(double speed, double amplitude) const {
  if (speed < 0 || speed > fastest_) return {};
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const BranchPiece& piece) {
    return piece.running && passes(piece, speed, amplitude);
  });
}

bool RunningBranch::passes(const BranchPiece& piece, double speed, double amplitude) const {
  if (!piece.covers(speed)) return false;
  const auto [a, b] = piece.around(speed);
  const double x = cubic(*a, *b, place_of(*a, *b, speed / unit_)).x;
  return std::fabs(x - std::log(amplitude)) < kRules.same;
}

MotorPoint RunningBranch::without_wave(PointStatus status) const {
  MotorPoint point{waves_.motor(0), {}};
  point.solved.status = status;
  return point;
}

MotorPoint RunningBranch::at(double speed, bool running) const {
  const Neighbours nodes = about(speed, running);
  std::optional<MotorPoint> point = nodes.piece ? between(nodes, speed) : outside(speed, running);
  if (!point) return without_wave(running ? PointStatus::pulled_out : PointStatus::no_dead_branch);
  // The trace changes little between two nodes.
  if (nodes.grows() && point->solved.status == PointStatus::ok && !steady(*point, speed))
    return without_wave(PointStatus::unstable_amplitude);
  return std::move(*point);
}

// Where no piece has a wave.
std::optional<MotorPoint> RunningBranch::outside(double speed, bool running) const {
  const BranchPiece *fastest = fastest_piece(running), *from_rest = nullptr;
  for (const BranchPiece& p : pieces_)
    if (p.is(running) && !from_rest && p.lowest() == 0) from_rest = &p;
  if (!fastest)
    return without_wave(running ? PointStatus::no_running_branch : PointStatus::no_dead_branch);
  std::optional<MotorPoint> point;
  if (speed > fastest_) point = continue_past_end(fastest->nodes.back(), speed);
  if (speed < 0 && from_rest) point = continue_past_end(from_rest->nodes.front(), speed);
  if (!point && waves_.has_static_excess()) point = in_gap(speed, running);
  return point;
}

// Newton's method for H(A) = Theta u_0 and the layer's states together, one turn of the wave a step, with the slopes of the
// nodes: they are off by a small share, of which the last two steps tell how much they leave. The wave is proven by its own
// contact, which alone can tell whether its zones are those of the turns.
std::optional<MotorPoint> RunningBranch::solve_in_known_zones(double speed, const CurveGuess& guess,
                                                              const SolvedPoint& near) const {
  // Where zones begin the slope may be infinite.
  if (!(guess.force_slope > 0) || !std::isfinite(guess.force_slope)) return {};
  double a = guess.amplitude, last = 0;
  WarmStart from = guess.start;
  for (int i = 0; i < kRules.most_turns; ++i) {
    const auto turn = near.newton_turn(waves_.motor(a), speed, from, guess.states);
    if (!turn) return {};
    const double excess = waves_.balance(turn->numbers, a).force() - waves_.drive();
    const double step = -excess / guess.force_slope;
    from = moved(turn->next, guess.states, step);
    a += step;
    const double off = std::fmax(std::fabs(step) / a, turn->gap);
    if (!(off <= (i == 0 ? kRules.far_guess : kRules.quick * last))) return {};
    last = i == 0 ? off / guess.left : last;
    if (off * off / last <= kRules.settled_turn) {
      MotorPoint point{waves_.motor(a), {}};
      // The splits of the guess would leave up to 1e-7 of the torque.
      point.solved = waves_.splits() ? solve_point(point.motor, speed, &from)
                                     : solve_point_near(point.motor, speed, near, from);
      const double force = waves_.balance(point.solved.numbers, a).force();
      const bool balances = point.solved.status == PointStatus::ok &&
                            std::fabs(force - waves_.drive()) <= kRules.balanced * waves_.drive();
      return balances ? std::optional(std::move(point)) : std::nullopt;
    }
    last = off;
  }
  return {};
}

// Through the zones of the nearer node, or where those do not lead there, of the guess itself: zones begin and end between
// nodes. As splits move with the speed, a track that is split has those of the guess. What does not lead there is found by itself.
std::optional<MotorPoint> RunningBranch::between(const Neighbours& nodes, double speed) const {
  const auto [piece, a, b] = nodes;
  const double t = place_of(*a, *b, speed / unit_);
  const CurveNode& nearer = t < 0.5 ? *a : *b;
  if (nearer.parameter == speed && nearer.fold) return solved(nearer, speed, nearer.solved);
  CurveGuess guess = guess_between(*a, *b, t, piece->outer_neighbours(*a, *b));
  if (!waves_.splits())
    if (auto point = solve_in_known_zones(speed, guess, nearer.solved)) return point;
  const SolvedPoint near =
      solve_point(waves_.motor(guess.amplitude), speed, &guess.start, kRules.speed.states);
  if (near.status == PointStatus::ok && !near.jumps()) {
    guess.start = near.start();
    if (guess.states.size() != guess.start.size())
      guess.states = waves_.moving(near, guess.amplitude, speed).states;
    if (auto point = solve_in_known_zones(speed, guess, near)) return point;
  }
  if (const auto wave = curve(speed, speed).between(*a, *b, speed / unit_))
    return solved(*wave, speed, near);
  if (!waves_.has_static_excess()) return {};
  return beside_gap(speed, guess.amplitude);
}

std::optional<MotorPoint> RunningBranch::solved(const CurveNode& wave, double speed,
                                                const SolvedPoint& near) const {
  MotorPoint point{waves_.motor(wave.amplitude), {}};
  point.solved = near.jumps() ? solve_point_near(point.motor, speed, near, wave.start)
                              : solve_point(point.motor, speed, &wave.start);
  return point.solved.status == PointStatus::ok ? std::optional(std::move(point)) : std::nullopt;
}

// Where the curves were not followed: on from the last wave, by steps as long as they may be.
std::optional<MotorPoint> RunningBranch::continue_past_end(const CurveNode& last,
                                                           double speed) const {
  const bool upward = speed > last.parameter;
  const WaveCurve on = curve(std::fmin(speed, 0), std::fmax(speed, 0), HUGE_VAL);
  const Vector<CurveNode> nodes = on.follow(last, upward);
  const double y = speed / unit_;
  if (nodes.back().at.y != y || nodes.back().fold) return {};
  const auto wave = on.solve_to_rounding(nodes.back());
  return wave ? solved(*wave, speed, nodes.back().solved) : std::nullopt;
}

// Between two pieces that a jump parts.
std::optional<MotorPoint> RunningBranch::in_gap(double speed, bool running) const {
  const CurveNode *below = nullptr, *above = nullptr;
  for (const BranchPiece& p : pieces_) {
    if (!p.is(running)) continue;
    const CurveNode &low = p.nodes.front(), &high = p.nodes.back();
    if (high.parameter <= speed && (!below || high.parameter > below->parameter)) below = &high;
    if (low.parameter >= speed && (!above || low.parameter < above->parameter)) above = &low;
  }
  if (!below || !above || !below->jump) return {};
  return beside_gap(speed, std::sqrt(below->amplitude * above->amplitude));
}

// Amplitudes without a periodic state lie about the wave, or where it would be.
MotorPoint RunningBranch::beside_gap(double speed, double amplitude) const {
  for (const CurveNode& wave : near(amplitude, speed).held())
    if (wave.rise > 0)
      if (auto point = solved(wave, speed, wave.solved)) return *std::move(point);
  return without_wave(PointStatus::no_periodic_state);
}

bool RunningBranch::steady(const MotorPoint& point, double speed) const {
  const WarmStart start = point.solved.start();
  return waves_.stability(waves_.in_amplitude(point.motor.mean.amplitude, speed, &start)).trace < 0;
}

}  // namespace twum::inline v0_1::core
