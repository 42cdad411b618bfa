// SPDX-License-Identifier: Apache-2.0
#include "performance/zone_splits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::performance {
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
// Where the means jump, their error is as large as that of the split. By how much it may be off.
constexpr double kSharp = 1e-14;
// A bracket that does not tell its jump is narrowed to this.
constexpr double kCloseToJump = 1e-10;
constexpr int kMostJumpSteps = 20;
constexpr int kMostProbes = 40;
constexpr int kMostSplits = 6;  // between two nodes

struct Probe {
  double place;  // in parts of the piece
  SliceZones zones;
};

// Two probes with the same zones, the nearer one to the other side first.
struct Side {
  Probe near;
  std::optional<Probe> beyond;

  void take(const Probe& probe) {
    beyond = probe.zones.signature == near.zones.signature ? std::optional(near) : std::nullopt;
    near = probe;
  }

  // Where the shortest zone of this side vanishes: the square of its length falls in proportion to the distance.
  std::optional<double> vanishing_place() const {
    if (!beyond) return {};
    const double here = near.zones.shortest * near.zones.shortest;
    const double there = beyond->zones.shortest * beyond->zones.shortest;
    if (!(here < there)) return {};
    return near.place + (near.place - beyond->place) * here / (there - here);
  }
};

// One piece and what can be asked there.
struct PieceQueries {
  const Piece<double>& piece;
  const SliceQueries& at;

  double radius(double place) const { return piece.low + (piece.high - piece.low) * place; }
  Probe probe(double place) const { return {place, at.zones(radius(place))}; }
};

// A split, in parts of the piece.
struct Place {
  double place;
  std::optional<contact::Jump> jump{};
  double gap{0};  // beyond it slices have no answer over this length
};
using Places = std::vector<Place>;

// Splits where zones begin from nothing.
class SmoothSplits {
 public:
  explicit SmoothSplits(const PieceQueries& queries) : queries_(queries) {}

  Places among(const std::vector<Probe>& probes) const {
    Places places;
    for (std::size_t k = 1; k < probes.size(); ++k) {
      Side low{probes[k - 1], {}}, high{probes[k], {}};
      if (k > 1) low = side_of(probes[k - 1], probes[k - 2]);
      if (k + 1 < probes.size()) high = side_of(probes[k], probes[k + 1]);
      for (int i = 0; i < kMostSplits && low.near.zones.signature != probes[k].zones.signature;
           ++i) {
        const auto [place, next] = end_of(low, high);
        if (!places.empty() && place - places.back().place < kNarrow) places.pop_back();
        places.push_back({place});
        low = {next, {}};
      }
    }
    return places;
  }

 private:
  static Side side_of(const Probe& near, const Probe& beyond) {
    Side side{beyond, {}};
    side.take(near);
    return side;
  }

  struct End {
    double place;
    Probe next;  // just beyond
  };

  // Where the zones of the low side end: secants on the side whose shortest zone vanishes there, in a bracket.
  End end_of(Side low, Side high) const {
    const std::uint64_t own = low.near.zones.signature;
    for (int i = 0; i < kMostProbes && high.near.place - low.near.place > kClose; ++i) {
      const bool below = low.near.zones.shortest < high.near.zones.shortest;
      const auto zero = (below ? low : high).vanishing_place();
      const bool inside = zero && *zero > low.near.place && *zero < high.near.place;
      if (inside && std::fabs(*zero - (below ? low : high).near.place) < kNear) {
        // What lies across has to be the other side's, and not what comes between.
        const double across = *zero + (below ? kNarrow : -kNarrow);
        if (!(across > low.near.place && across < high.near.place)) return {*zero, high.near};
        const Probe there = queries_.probe(across);
        if (below && there.zones.signature != own) return {*zero, there};
        if (!below && there.zones.signature == own) return {*zero, high.near};
        (below ? low : high).take(there);
        continue;
      }
      const double share = below ? 1 - kHopeful : kHopeful;
      const Probe here =
          queries_.probe(inside ? *zero : std::lerp(low.near.place, high.near.place, share));
      (here.zones.signature == own ? low : high).take(here);
    }
    return {0.5 * (low.near.place + high.near.place), high.near};
  }

  const PieceQueries& queries_;
};

// Splits where zones may begin with a length, as with mu_0 > mu.
class JumpSplits {
 public:
  explicit JumpSplits(const PieceQueries& queries) : queries_(queries) {}

  Places among(const std::vector<Probe>& probes) const {
    Places places;
    for (std::size_t k = 1; k < probes.size(); ++k) {
      Probe low = probes[k - 1];
      for (int i = 0; i < kMostSplits && low.zones.signature != probes[k].zones.signature; ++i) {
        const auto [place, next] = end_of(low, probes[k]);
        const bool after_gap =
            !low.zones.has_answer() && !places.empty() && place - places.back().place < kNarrow;
        // Between two sequences the layer may go through both in turns, over next to nothing of the track.
        if (after_gap) {
          places.back().gap = place - places.back().place + kClose;
        } else {
          places.push_back({place, jump_between(place - kBesideJump, place + kBesideJump)});
        }
        low = next;
      }
    }
    return places;
  }

 private:
  struct End {
    double place;
    Probe next;  // just beyond
  };

  std::optional<contact::Jump> jump_between(double low, double high) const {
    return queries_.at.jump(queries_.radius(low), queries_.radius(high));
  }

  // Where the zones at `low` end.
  End end_of(Probe low, Probe high) const {
    const std::uint64_t own = low.zones.signature;
    const bool answers = low.zones.has_answer();
    if (answers)
      if (const std::optional<End> end = jump_in(low, high)) return *end;
    while (high.place - low.place > (answers ? kCloseToJump : kClose)) {
      const Probe here = queries_.probe(0.5 * (low.place + high.place));
      (here.zones.signature == own ? low : high) = here;
    }
    return {0.5 * (low.place + high.place), high};
  }

  // The jump between two places, by secants over its margin; nothing if another one comes before.
  std::optional<End> jump_in(const Probe& low, const Probe& high) const {
    const auto jump = jump_between(low.place, high.place);
    if (!jump) return {};
    const auto margin = [&](double place) {
      return queries_.at.margin(queries_.radius(place), *jump);
    };
    double a = low.place, b = high.place, at_a = margin(a), at_b = margin(b);
    if (!(at_a * at_b < 0)) return {};
    for (int i = 0; i < kMostJumpSteps && std::fabs(b - a) > kSharp && at_b != 0; ++i) {
      const double next = b - at_b * (b - a) / (at_b - at_a);
      if (!(next > low.place && next < high.place)) return {};
      a = b, at_a = at_b, b = next, at_b = margin(next);
    }
    const Probe below = queries_.probe(b - kBesideJump), above = queries_.probe(b + kBesideJump);
    const bool parts = below.zones.signature == low.zones.signature &&
                       above.zones.signature != low.zones.signature;
    return parts ? std::optional(End{b, above}) : std::nullopt;
  }

  const PieceQueries& queries_;
};

}  // namespace

std::vector<Split> zone_splits(const DrivenMotor<double>& m,
                               const std::vector<SliceZones>& at_nodes, const SliceQueries& at) {
  std::vector<Split> splits;
  std::size_t node = 0;
  for (std::size_t k = 0; k < m.pieces.size(); ++k) {
    const Piece<double>& piece = m.pieces[k];
    const PieceQueries queries{piece, at};
    std::vector<Probe> probes;
    // Where a contact begins or closes its slices are nearer to the end than any split has to be.
    if (!piece.root_low) probes.push_back(queries.probe(0));
    for (; node < at_nodes.size() && m.annulus[node].radius < piece.high; ++node)
      probes.push_back(
          {(m.annulus[node].radius - piece.low) / (piece.high - piece.low), at_nodes[node]});
    if (!piece.root_high) probes.push_back(queries.probe(1));
    const Places places = has_static_excess(m) ? JumpSplits(queries).among(probes)
                                               : SmoothSplits(queries).among(probes);
    for (const auto& [place, jump, gap] : places) splits.push_back({{k, place, gap}, jump});
  }
  return splits;
}

}  // namespace twum::performance
