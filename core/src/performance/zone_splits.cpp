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

// The splits of one piece.
class PieceSplits {
 public:
  PieceSplits(const Piece<double>& piece, const ZonesAt& zones_at)
      : piece_(piece), zones_at_(zones_at) {}

  Probe probe(double place) const {
    return {place, zones_at_(piece_.low + (piece_.high - piece_.low) * place)};
  }

  std::vector<double> among(const std::vector<Probe>& probes) const {
    std::vector<double> places;
    for (std::size_t k = 1; k < probes.size(); ++k) {
      Side low{probes[k - 1], {}}, high{probes[k], {}};
      if (k > 1) low = side_of(probes[k - 1], probes[k - 2]);
      if (k + 1 < probes.size()) high = side_of(probes[k], probes[k + 1]);
      for (int i = 0; i < kMostSplits && low.near.zones.signature != probes[k].zones.signature;
           ++i) {
        const auto [place, next] = end_of(low, high);
        if (!places.empty() && place - places.back() < kNarrow) places.pop_back();
        places.push_back(place);
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
        const Probe there = probe(across);
        if (below && there.zones.signature != own) return {*zero, there};
        if (!below && there.zones.signature == own) return {*zero, high.near};
        (below ? low : high).take(there);
        continue;
      }
      const double share = below ? 1 - kHopeful : kHopeful;
      const Probe here = probe(inside ? *zero : std::lerp(low.near.place, high.near.place, share));
      (here.zones.signature == own ? low : high).take(here);
    }
    return {0.5 * (low.near.place + high.near.place), high.near};
  }

  const Piece<double>& piece_;
  const ZonesAt& zones_at_;
};

}  // namespace

std::vector<Split> zone_splits(const DrivenMotor<double>& m,
                               const std::vector<SliceZones>& at_nodes, const ZonesAt& zones_at) {
  std::vector<Split> splits;
  std::size_t node = 0;
  for (std::size_t k = 0; k < m.pieces.size(); ++k) {
    const Piece<double>& piece = m.pieces[k];
    const PieceSplits own(piece, zones_at);
    std::vector<Probe> probes;
    // Where a contact begins or closes its slices are nearer to the end than any split has to be.
    if (!piece.root_low) probes.push_back(own.probe(0));
    for (; node < at_nodes.size() && m.annulus[node].radius < piece.high; ++node)
      probes.push_back(
          {(m.annulus[node].radius - piece.low) / (piece.high - piece.low), at_nodes[node]});
    if (!piece.root_high) probes.push_back(own.probe(1));
    for (const double place : own.among(probes)) splits.push_back({k, place});
  }
  return splits;
}

}  // namespace twum::performance
