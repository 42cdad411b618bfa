// SPDX-License-Identifier: Apache-2.0
#include "drive/frequency_path.hpp"
#include "drive/rules.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
// Equal steps of the place are quadratic steps of the amplitude near the end where the flanks meet, because there the
// frequency changes with the square root of the distance.
double FrequencyPath::Stretch::amplitude(double place) const {
  const double depth = std::log(high / low);
  const double share = closed ? 0.5 * (1 - std::cos(std::numbers::pi * place)) : place * place;
  return high * std::exp(-depth * share);  // (D5.2)
}

FrequencyPath::FrequencyPath(const DrivenWaves& waves, const RotorLoad& load, double lowest,
                             double highest)
    : held_(waves, load), lowest_(lowest), highest_(highest), stretches_(stretches()) {
  for (std::size_t i = 0; i < stretches_.size(); ++i) follow(i);
}

std::optional<ResponseWave> FrequencyPath::wave_at(const Stretch& stretch, double place,
                                                   const HeldWaves::Guess& guess) const {
  const double end = stretch.closed && std::fabs(place) == 1 ? 0 : place;
  const double side = end > 0 ? 1 : end < 0 ? -1 : 0;
  auto wave = held_.held(stretch.amplitude(place), side, guess);
  if (wave) wave->place = place;
  return wave;
}

std::optional<ResponseWave> FrequencyPath::between(const Stretch& stretch, const ResponseWave& a,
                                                   const ResponseWave& b, double place) const {
  const double t = (place - a.place) / (b.place - a.place);
  const HeldWaves::Guess p = held_.guess_of(a), q = held_.guess_of(b);
  HeldWaves::Guess guess = t < 0.5 ? p : q;
  guess.omega = p.omega + t * (q.omega - p.omega);
  guess.speed_ratio = p.speed_ratio + t * (q.speed_ratio - p.speed_ratio);
  return wave_at(stretch, place, guess);
}

// Theta u_0 - |I| on the backbone; its sign says whether the drive holds a wave of this amplitude (D5.1).
double FrequencyPath::excess(const ResponseWave& on_backbone) const {
  return held_.waves().drive() - std::fabs(on_backbone.resistive_force);
}

Vector<FrequencyPath::Stretch> FrequencyPath::stretches() const {
  const DrivenWaves at_low = held_.waves().at_frequency(lowest_),
                    at_high = held_.waves().at_frequency(highest_);
  const double divider = std::fmax(at_low.divider(), at_high.divider());
  const double stiff =
      std::fmax(std::fabs(at_low.dynamic_stiffness()), std::fabs(at_high.dynamic_stiffness()));
  const double damping = std::fmax(at_low.damping(), at_high.damping());
  const double steepest = stiff + highest_ * damping + 2 * held_.waves().contact_stiffness();
  const double low =
      std::fmax(0.3 * held_.waves().drive() / (divider * steepest), kRules.smallest_amplitude);
  const double drive = held_.waves().drive() / std::fmin(at_low.divider(), at_high.divider());
  const double high = std::fmin(
      1.01 * (drive + held_.waves().traction_bound()) / (lowest_ * held_.waves().modes().damping),
      kRules.largest_amplitude);
  if (!(held_.waves().drive() > 0 && low < high)) return {};
  Vector<ResponseWave> scan;
  std::optional<ResponseWave> last;
  const auto wave_near = [&](double a) {
    const auto wave =
        held_.held(a, 0, last ? held_.guess_of(*last) : HeldWaves::Guess{held_.waves().omega(), 1});
    if (wave) last = wave;
    return wave;
  };
  for (double a = low, before = 0; before < high; before = a, a *= kResponseRules.scan)
    if (const auto wave = wave_near(std::fmin(a, high))) scan.push_back(*wave);
  with_islands(scan);
  return between_borders(scan);
}

// Adds the amplitude between three others at which the drive has most force left, if it has any only there.
void FrequencyPath::with_islands(Vector<ResponseWave>& scan) const {
  for (std::size_t i = 1; i + 1 < scan.size(); ++i) {
    const double here = excess(scan[i]);
    if (here > 0 || here < excess(scan[i - 1]) || here < excess(scan[i + 1])) continue;
    const ResponseWave middle = scan[i];
    const auto missing = [&](double share) {
      const auto wave = held_.held(share * middle.amplitude, 0, held_.guess_of(middle));
      return wave ? -excess(*wave) : HUGE_VAL;
    };
    const LeastValue least = least_between("the least force between two waves", missing,
                                           scan[i - 1].amplitude / middle.amplitude,
                                           scan[i + 1].amplitude / middle.amplitude);
    const auto top = held_.held(least.place * middle.amplitude, 0, held_.guess_of(middle));
    if (least.value < 0 && top)
      scan.insert(scan.begin() + static_cast<std::ptrdiff_t>(i) + (least.place > 1), *top), ++i;
  }
}

// The ranges of amplitudes that the drive holds.
Vector<FrequencyPath::Stretch> FrequencyPath::between_borders(
    const Vector<ResponseWave>& scan) const {
  Vector<Stretch> found;
  if (scan.empty()) return found;
  double begin = scan.front().amplitude;
  bool closed = false;
  for (std::size_t i = 1; i < scan.size(); ++i) {
    const ResponseWave &a = scan[i - 1], &b = scan[i];
    if ((excess(a) > 0) == (excess(b) > 0)) continue;
    const auto excess_at = [&](double amplitude) {
      const auto wave = held_.held(amplitude, 0, held_.guess_of(a));
      if (!wave) throw NoWave{};
      return excess(*wave);
    };
    double border = b.amplitude;
    try {
      border = closed_in("an end of a stretch of waves", excess_at,
                         {a.amplitude, b.amplitude, excess(a), excess(b)})
                   .nearest();
    } catch (const NoWave&) {  // then it stays less accurate
    }
    if (excess(a) > 0) found.push_back({begin, border, closed});
    begin = border, closed = true;
  }
  return found;
}

// Follows both flanks from the resonance outwards; each wave is near the one before.
void FrequencyPath::follow(std::size_t index) {
  const Stretch& stretch = stretches_[index];
  const auto top = wave_at(stretch, 0, {held_.waves().omega(), 1});
  if (!top) return;
  resonances_.push_back(top->omega);
  Vector<std::optional<ResponseWave>> waves(2 * kResponseRules.flank_nodes + 1);
  const auto node = [&](int i) -> std::optional<ResponseWave>& {
    return waves[static_cast<std::size_t>(i + kResponseRules.flank_nodes)];
  };
  node(0) = top;
  for (const int side : {-1, 1}) {
    HeldWaves::Guess guess = held_.guess_of(*top);
    for (int i = 1; i <= kResponseRules.flank_nodes; ++i) {
      auto& wave = node(side * i);
      wave = wave_at(stretch, static_cast<double>(side * i) / kResponseRules.flank_nodes, guess);
      if (!wave) continue;
      guess = held_.guess_of(*wave);
      // Beyond all resonances each frequency has one wave, so the path does not return into the range.
      if (wave->omega < lowest_ || wave->omega > highest_) break;
    }
  }
  Vector<ResponseWave> run;
  const auto finish = [&] {
    if (run.size() > 1) cut(with_turns(stretch, run), index);
    run.clear();
  };
  for (auto& wave : waves) {
    if (!wave) {
      finish();
      continue;
    }
    wave->margin = held_.margin(*wave);
    wave->stable = wave->margin > 0;
    run.push_back(*wave);
  }
  finish();
}

ResponseWave FrequencyPath::surely_between(const Stretch& stretch, const ResponseWave& a,
                                           const ResponseWave& b, double place) const {
  const auto wave = between(stretch, a, b, place);
  if (!wave) throw NoWave{};
  return *wave;
}

// The wave next to b at which the frequency turns (D5.3), if b is the highest or the lowest of the three.
std::optional<ResponseWave> FrequencyPath::turn(const Stretch& stretch, const ResponseWave& a,
                                                const ResponseWave& b,
                                                const ResponseWave& c) const {
  const bool highest = b.omega >= a.omega && b.omega > c.omega,
             lowest = b.omega <= a.omega && b.omega < c.omega;
  if (!(highest || lowest)) return {};
  const auto at_place = [&](double place) {
    return place < b.place ? surely_between(stretch, a, b, place)
                           : surely_between(stretch, b, c, place);
  };
  const double sign = highest ? -1 : 1;
  try {
    const auto omega = [&](double s) { return sign * at_place(s).omega; };
    return at_place(
        least_between("the least frequency of a stretch of waves", omega, a.place, c.place).place);
  } catch (const NoWave&) {
    return {};
  }
}

// The last stable wave between a stable and an unstable one: the search for the change of sign stays between the last of each.
ResponseWave FrequencyPath::last_stable(const Stretch& stretch, const ResponseWave& a,
                                        const ResponseWave& b) const {
  ResponseWave last = a.stable ? a : b;
  const auto margin_at = [&](double place) {
    const ResponseWave wave = surely_between(stretch, a, b, place);
    const double margin = held_.margin(wave);
    if (margin > 0) last = wave;
    return margin;
  };
  try {
    closed_in("a loss of stability", margin_at, {a.place, b.place, a.margin, b.margin});
  } catch (const NoWave&) {  // then it stays less accurate
  }
  return last;
}

// The nodes with the waves added at which the frequency turns back or stability is lost.
Vector<FrequencyPath::Node> FrequencyPath::with_turns(const Stretch& stretch,
                                                      const Vector<ResponseWave>& run) const {
  Vector<Node> nodes;
  for (const ResponseWave& wave : run) nodes.push_back({wave, BranchEndKind::open});
  const auto in_order = [&nodes] {
    std::sort(nodes.begin(), nodes.end(),
              [](const Node& a, const Node& b) { return a.wave.place < b.wave.place; });
  };
  for (std::size_t i = 1; i + 1 < run.size(); ++i)
    if (const auto wave = turn(stretch, run[i - 1], run[i], run[i + 1]))
      nodes.push_back({*wave, BranchEndKind::fold});
  in_order();
  const Vector<Node> turned = nodes;
  for (std::size_t i = 0; i + 1 < turned.size(); ++i) {
    const Node &a = turned[i], &b = turned[i + 1];
    const bool beside_turn = a.kind == BranchEndKind::fold || b.kind == BranchEndKind::fold;
    if (!beside_turn && a.wave.stable != b.wave.stable)
      nodes.push_back({last_stable(stretch, a.wave, b.wave), BranchEndKind::growing});
  }
  in_order();
  return nodes;
}

// Cuts the path into pieces at turns of the frequency and losses of stability. A wave on a border belongs to both
// pieces.
void FrequencyPath::cut(const Vector<Node>& nodes, std::size_t stretch) {
  const auto end_of = [&](std::size_t i) {
    const Node& n = nodes[i];
    if (n.kind != BranchEndKind::open) return n.kind;
    const bool outside = n.wave.omega < lowest_ || n.wave.omega > highest_;
    return outside || std::fabs(n.wave.place) == 1 ? BranchEndKind::open : BranchEndKind::lost;
  };
  std::size_t first = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].kind == BranchEndKind::open && i + 1 < nodes.size()) continue;
    PathPiece piece{{}, false, end_of(first), end_of(i)};
    for (std::size_t k = first; k <= i; ++k) piece.waves.push_back(nodes[k].wave);
    if (i > first + 1) {
      piece.stable = nodes[first + 1].wave.stable;
    } else if (const auto middle =
                   between(stretches_[stretch], piece.waves.front(), piece.waves.back(),
                           0.5 * (piece.waves.front().place + piece.waves.back().place))) {
      piece.stable = held_.margin(*middle) > 0;
    }
    for (ResponseWave& wave : piece.waves) wave.stable = piece.stable;
    pieces_.push_back(std::move(piece));
    stretch_of_.push_back(stretch);
    first = i;
  }
}

// Searches between two neighbouring waves of a piece by Newton's method, and by bisection if a step leaves the
// interval.
std::optional<ResponseWave> FrequencyPath::at(const Stretch& stretch, const ResponseWave& a,
                                              const ResponseWave& b, double omega) const {
  const double t = (omega - a.omega) / (b.omega - a.omega);
  const auto mixed = [t](double x, double y) { return x + t * (y - x); };
  if (a.standing == b.standing) {
    ResponseWave near = a;
    near.place = mixed(a.place, b.place), near.omega = omega;
    near.amplitude = mixed(a.amplitude, b.amplitude), near.speed = mixed(a.speed, b.speed);
    const auto found = held_.solve_to_rounding(near);
    if (found && (found->amplitude - a.amplitude) * (found->amplitude - b.amplitude) <= 0)
      return found;
  }
  std::optional<ResponseWave> last;
  const auto excess = [&](double place) {
    last = between(stretch, a, b, place);
    if (!last) throw NoWave{};
    return last->omega - omega;
  };
  try {
    excess(closed_in("a wave at a frequency", excess,
                     {a.place, b.place, a.omega - omega, b.omega - omega})
               .nearest());
    return last;
  } catch (const NoWave&) {
    return {};
  }
}

std::optional<ResponseWave> FrequencyPath::at(const PathPiece& piece, double omega) const {
  const Stretch& stretch =
      stretches_[stretch_of_[static_cast<std::size_t>(&piece - pieces_.data())]];
  for (std::size_t i = 0; i + 1 < piece.waves.size(); ++i) {
    const ResponseWave &a = piece.waves[i], &b = piece.waves[i + 1];
    if (omega == a.omega) return a;
    if (omega == b.omega) return b;
    if ((a.omega < omega) == (b.omega < omega)) continue;
    auto wave = at(stretch, a, b, omega);
    if (wave) wave->stable = piece.stable;
    return wave;
  }
  return {};
}

}  // namespace twum::inline v0_1::core
