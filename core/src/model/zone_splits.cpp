// SPDX-License-Identifier: Apache-2.0
#include "model/zone_splits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

// Lengths along the track are in parts of a piece. A zone of length l = d^(1/2) adds l^2 = d to the means (W4.4): a split that
// is off by d leaves d of the derivatives and d^2 of the means. A secant step of kNear is good to its square.
constexpr double kNear = 1e-4;
// A bracket in which no zone vanishes is narrowed to this.
constexpr double kClose = 1e-6;
// Zones that come and go within this are not split twice.
constexpr double kNarrow = 0.005;
// Where only one end of a bracket has a short zone, the next place lies this share of the bracket towards that end.
constexpr double kHopeful = 0.7;
constexpr double kAcross = 0.1;  // the same where it would vanish at the other end
// Tolerance of a split at which the means jump, in parts of the piece; the means inherit it.
constexpr double kSharp = 1e-14;
// A bracket that does not tell its jump is narrowed to this.
constexpr double kCloseToJump = 1e-10;
// The same where a state ends because it no longer attracts: each turn then brings it little nearer.
constexpr double kCloseToSlow = 1e-7;
constexpr int kSlow = 200;  // turns
constexpr int kMostJumpSteps = 20;
constexpr double kFirstStep = 1e-6;  // of secants from a point nearby
constexpr double kFollowed = 0.3;    // their reach
// A bracket this much narrower tells more of its jump.
constexpr double kNarrower = 0.15;
// Of so many steps one halves, should the shortest zone mislead.
constexpr int kHalvedOnce = 4;
// At this distance from the end of a short zone the zones are those beyond it.
constexpr double kJustBeyond = 1e-5;
constexpr double kFarther = 30;  // steps away from where laps part for a while
constexpr double kWider = 2;     // steps through a gap
constexpr int kMostProbes = 60;
constexpr int kMostSplits = 6;  // between two nodes

struct Probe {
  double place;  // in parts of the piece
  SliceZones zones;
};

// Probes with the same zones, the nearest one to the other side first.
struct Side {
  Probe near;
  std::optional<Probe> beyond{}, farther{};

  void take(const Probe& probe) {
    const bool same = probe.zones.signature == near.zones.signature;
    farther = same ? beyond : std::nullopt;
    beyond = same ? std::optional(near) : std::nullopt;
    near = probe;
  }

  // Where the shortest zone of this side vanishes: its length falls in proportion to the distance, or the square does (W4.4).
  // A third probe tells which; without it, the square.
  std::optional<double> vanishing_place() const {
    if (!beyond || !(near.zones.shortest < beyond->zones.shortest)) return {};
    const double squares = vanishing_place(2);
    if (!farther) return squares;
    const double lengths = vanishing_place(1);
    return error(lengths, 1) < error(squares, 2) ? lengths : squares;
  }

 private:
  double vanishing_place(int power) const {
    const double here = std::pow(near.zones.shortest, power),
                 there = std::pow(beyond->zones.shortest, power);
    return near.place + (near.place - beyond->place) * here / (there - here);
  }
  // Of the third probe's length, if the zone vanishes there.
  double error(double zero, int power) const {
    const double ratio = (farther->place - zero) / (near.place - zero);
    return std::fabs(near.zones.shortest * std::pow(ratio, 1.0 / power) - farther->zones.shortest);
  }
};

struct Value {
  double place, f;
};

// Zero of f by secants from two values; nothing if a step leaves where they may go, or if they do not settle.
template <typename F, typename Inside>
std::optional<double> secant_zero(const F& f, Value a, Value b, const Inside& inside) {
  for (int i = 0; i < kMostJumpSteps && std::fabs(b.place - a.place) > kSharp && b.f != 0; ++i) {
    const double next = b.place - b.f * (b.place - a.place) / (b.f - a.f);
    if (!inside(next)) return {};
    a = b, b = {next, f(next)};
  }
  return std::fabs(b.place - a.place) < kBesideJump ? std::optional(b.place) : std::nullopt;
}

// One piece and what can be asked there.
struct PieceQueries {
  const Piece<double>& piece;
  const SliceQueries& at;

  double radius(double place) const { return piece.low + (piece.high - piece.low) * place; }
  Probe probe(double place) const { return {place, at.zones(radius(place))}; }
  double margin(double place, const contact::Jump& jump) const {
    return at.margin(radius(place), jump);
  }
};

// A split, in parts of the piece.
struct Place {
  double place;
  std::optional<contact::Jump> jump{};
  double gap{0};  // beyond it slices have no answer over this length
};
using Places = Vector<Place>;

// Where the zones at one of two probes end, between them.
struct End {
  double place;
  Probe next;  // just beyond
  std::optional<contact::Jump> jump{};
};

// Searches for the end of the zones of the low side: secants over the margin of a jump, or over the length of the shortest zone, in
// a bracket. With mu_0 > mu zones may begin with a length.
class EndSearch {
 public:
  EndSearch(const PieceQueries& queries, bool may_jump, Side low, Side high)
      : queries_(queries),
        may_jump_(may_jump),
        low_(std::move(low)),
        high_(std::move(high)),
        tried_(length()) {}

  End run() {
    for (int i = 0; i < kMostProbes && length() > close_enough(); ++i) {
      if (may_jump_ && length() < kNarrower * tried_) {
        tried_ = length();
        if (const std::optional<double> jump = jump_inside()) {
          if (const std::optional<End> end = end_at_jump(*jump)) return *end;
          continue;
        }
      }
      const bool below = low_.near.zones.shortest < high_.near.zones.shortest;
      const std::optional<double> zero =
          i % kHalvedOnce == kHalvedOnce - 1 ? std::nullopt : side(below).vanishing_place();
      if (!zero || *zero < low_.near.place || *zero > high_.near.place) {
        halve(below, zero);
      } else if (std::fabs(*zero - side(below).near.place) >= kNear) {
        take_at(*zero);
      } else if (const std::optional<End> end = end_at_zero(*zero, below)) {
        return *end;
      }
    }
    return {std::midpoint(low_.near.place, high_.near.place), high_.near,
            may_jump_ ? jump_between(low_.near, high_.near) : std::nullopt};
  }

 private:
  const Side& side(bool low) const { return low ? low_ : high_; }
  double length() const { return high_.near.place - low_.near.place; }
  bool holds(double place) const { return place > low_.near.place && place < high_.near.place; }
  bool is_low(const Probe& probe) const {
    return probe.zones.signature == low_.near.zones.signature;
  }
  void take(const Probe& probe) { (is_low(probe) ? low_ : high_).take(probe); }
  Probe take_at(double place) {
    const Probe there = queries_.probe(place);
    take(there);
    return there;
  }

  // Length of a bracket that needs no more probes.
  double close_enough() const {
    if (!may_jump_) return kClose;
    const int turns = std::max(low_.near.zones.turns, high_.near.zones.turns);
    return turns > kSlow ? kCloseToSlow : kCloseToJump;
  }

  // A zero at the other probe, or just beyond, leaves the end just on this side of it.
  void halve(bool below, const std::optional<double>& zero) {
    const double other = side(!below).near.place;
    const bool across = zero && std::fabs(*zero - other) < kAcross * length();
    const double own = across ? kAcross : may_jump_ ? 0.5 : kHopeful;
    take_at(std::lerp(low_.near.place, high_.near.place, below ? 1 - own : own));
  }

  // What lies across has to be the other side's, and not what comes between.
  std::optional<End> end_at_zero(double zero, bool below) {
    const double step = may_jump_ ? kJustBeyond : kNarrow, across = zero + (below ? step : -step);
    if (!holds(across)) return End{zero, high_.near};
    const Probe there = queries_.probe(across);
    if (is_low(there) != below) return End{zero, below ? there : high_.near};
    take(there);
    return {};
  }

  // Nothing if the zones on both sides of the place are the same: laps from rest differ there in some turns, but end alike. The
  // place where they end differently is not far.
  std::optional<End> end_at_jump(double jump) {
    const Probe below = queries_.probe(jump - kBesideJump);
    const bool low = is_low(below);
    const Probe beside = low ? queries_.probe(jump + kBesideJump) : below;
    if (low && !is_low(beside)) return End{jump, beside, jump_between(below, beside)};
    take(beside);
    double step = low ? kBesideJump : -kBesideJump;
    do {
      step *= kFarther;
    } while (holds(beside.place + step) && is_low(take_at(beside.place + step)) == low);
    tried_ = HUGE_VAL;
    return {};
  }

  std::optional<contact::Jump> jump_between(const Probe& low, const Probe& high) const {
    return queries_.at.jump(queries_.radius(low.place), queries_.radius(high.place));
  }

  // Where laps from rest part, if the probes beside that are inside.
  std::optional<double> jump_inside() const {
    const auto jump = jump_between(low_.near, high_.near);
    if (!jump) return {};
    const std::optional<double> zero =
        jump->beside == 0 ? margin_zero(*jump) : margin_zero_of(side(jump->beside < 0), *jump);
    return zero && holds(*zero - kBesideJump) && holds(*zero + kBesideJump) ? zero : std::nullopt;
  }

  std::optional<double> margin_zero(const contact::Jump& jump) const {
    const auto margin = [&](double place) { return queries_.margin(place, jump); };
    const Value low{low_.near.place, margin(low_.near.place)},
        high{high_.near.place, margin(high_.near.place)};
    if (!(low.f * high.f < 0)) return {};
    return secant_zero(margin, low, high, [this](double place) { return holds(place); });
  }

  // The same from the side that has the state: elsewhere its margin is not smooth.
  std::optional<double> margin_zero_of(const Side& side, const contact::Jump& jump) const {
    if (!side.beyond) return {};
    const double here = queries_.margin(side.near.place, jump),
                 there = queries_.margin(side.beyond->place, jump);
    return side.near.place + (side.near.place - side.beyond->place) * here / (there - here);
  }

  const PieceQueries& queries_;
  bool may_jump_;
  Side low_, high_;
  double tried_;  // length of the bracket when a jump was last looked for
};

// The splits of a piece. With mu_0 > mu slices may have no answer.
class PieceSplits {
 public:
  PieceSplits(const PieceQueries& queries, bool may_jump)
      : queries_(queries), may_jump_(may_jump) {}

  Places among(const Vector<Probe>& probes) {
    for (std::size_t k = 1; k < probes.size(); ++k) {
      Side low{probes[k - 1]}, high{probes[k]};
      if (k > 1) low = side_of(probes[k - 1], probes[k - 2]);
      if (k + 1 < probes.size()) high = side_of(probes[k], probes[k + 1]);
      for (int i = 0; i < kMostSplits && low.near.zones.signature != probes[k].zones.signature; ++i)
        low = {may_jump_ && !low.near.zones.has_answer() ? after_gap(low.near, high.near)
                                                         : after_end(low, high)};
    }
    return places_;
  }

 private:
  static Side side_of(const Probe& near, const Probe& beyond) {
    Side side{beyond};
    side.take(near);
    return side;
  }

  // Adds the place where the zones of the low side end. What lies beyond.
  Probe after_end(const Side& low, const Side& high) {
    const auto [place, next, jump] = EndSearch(queries_, may_jump_, low, high).run();
    if (!may_jump_ && !places_.empty() && place - places_.back().place < kNarrow)
      places_.pop_back();
    places_.push_back({place, jump});
    return next;
  }

  // Between two sequences a layer may go through both in turns, over next to nothing of the track. Adds that to the last place.
  Probe after_gap(const Probe& low, const Probe& high) {
    const Probe next = beyond_gap(low, high);
    const double gap = places_.empty() ? kNarrow : next.place - places_.back().place;
    if (gap < kNarrow)
      places_.back().gap = gap;
    else
      places_.push_back({next.place});
    return next;
  }

  // The first of the places at kWider times the distance each time that has an answer.
  Probe beyond_gap(const Probe& low, const Probe& high) const {
    for (double step = kClose; low.place + step < high.place; step *= kWider)
      if (const Probe there = queries_.probe(low.place + step); there.zones.has_answer())
        return there;
    return high;
  }

  const PieceQueries& queries_;
  bool may_jump_;
  Places places_;
};

}  // namespace

Vector<Split> zone_splits(const DrivenMotor<double>& m, const Vector<SliceZones>& at_nodes,
                          const SliceQueries& at) {
  Vector<Split> splits;
  std::size_t node = 0;
  for (std::size_t k = 0; k < m.pieces.size(); ++k) {
    const Piece<double>& piece = m.pieces[k];
    const PieceQueries queries{piece, at};
    Vector<Probe> probes;
    // Where a contact begins or closes its slices are nearer to the end than any split has to be.
    if (!piece.root_low) probes.push_back(queries.probe(0));
    for (; node < at_nodes.size() && m.annulus[node].radius < piece.high; ++node)
      probes.push_back(
          {(m.annulus[node].radius - piece.low) / (piece.high - piece.low), at_nodes[node]});
    if (!piece.root_high) probes.push_back(queries.probe(1));
    const Places places = PieceSplits(queries, has_static_excess(m)).among(probes);
    for (const auto& [place, jump, gap] : places) splits.push_back({{k, place, gap}, jump});
  }
  return splits;
}

namespace {

// The place of a split's jump, by secants from where it is in a point nearby.
std::optional<double> followed_place(const PieceQueries& queries, const Split& split) {
  const auto margin = [&](double place) { return queries.margin(place, *split.jump); };
  const auto near = [&split](double place) {
    return place > 0 && place < 1 && std::fabs(place - split.place) < kFollowed;
  };
  const double first = split.place, second = first + kFirstStep;
  return secant_zero(margin, {first, margin(first)}, {second, margin(second)}, near);
}

}  // namespace

std::optional<Vector<Split>> followed_splits(const DrivenMotor<double>& m, Vector<Split> splits,
                                             const SliceQueries& at) {
  double last = 0;
  for (Split& split : splits) {
    if (split.jump) {
      if (split.jump->beside != 0) return {};  // its state would have to be followed too
      const auto place = followed_place({m.pieces[split.piece], at}, split);
      if (!place) return {};
      split.place = *place;
    }
    const double along = static_cast<double>(split.piece) + split.place;
    if (!(along > last)) return {};
    last = along;
  }
  return splits;
}

bool change_at_splits(const DrivenMotor<double>& m, const Vector<Split>& splits,
                      std::span<const Slice<double>> slices, const Vector<SliceZones>& at_nodes,
                      const SliceQueries& at) {
  std::size_t node = 0;
  for (std::size_t k = 0; k < m.pieces.size(); ++k) {
    const Piece<double>& piece = m.pieces[k];
    const PieceQueries queries{piece, at};
    std::optional<std::uint64_t> own;  // zones of a panel
    const auto agrees = [&own](const SliceZones& zones) {
      if (!own) own = zones.signature;
      return zones.has_answer() && zones.signature == *own;
    };
    const auto nodes_agree_below = [&](double radius) {
      for (; node < slices.size() && slices[node].radius < radius; ++node)
        if (!agrees(at_nodes[node])) return false;
      return true;
    };
    if (!piece.root_low && !agrees(queries.probe(0).zones)) return false;
    for (const Split& split : splits) {
      if (split.piece != k) continue;
      if (!nodes_agree_below(queries.radius(split.place))) return false;
      if (split.jump && !agrees(queries.probe(split.place - kBesideJump).zones)) return false;
      const auto below = own;
      own.reset();
      if (!split.jump) continue;
      if (!agrees(queries.probe(split.place + split.gap + kBesideJump).zones)) return false;
      if (own == below) return false;
    }
    if (!nodes_agree_below(piece.high)) return false;
    if (!piece.root_high && !agrees(queries.probe(1).zones)) return false;
  }
  return true;
}

}  // namespace twum::inline v0_1::core
