// SPDX-License-Identifier: Apache-2.0
#include "drive/force_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::core {
namespace {

// Amplitudes beyond those of any motor [m]: where the bounds are infinite, without damping or preload.
constexpr double kLargest = 1, kSmallest = 1e-30;

// Beyond the backbone, where R stays negative, both |R| and I grow.
double highest_extremum(const DrivenWaves& waves) {
  const double softness = -dynamic_stiffness(waves.modes(), waves.omega());
  return softness > 0 ? 2 * (waves.pressure_bound() + waves.traction_bound()) / softness : 0;
}

double highest(const DrivenWaves& waves) {
  return std::fmin(std::fmax(highest_extremum(waves), largest_amplitude(waves)), kLargest);
}

// At rest H is proportional to the amplitude as long as the contact sticks all round (C20.3): to the largest such amplitude, but for
// a share of it.
double last_locked(const DrivenWaves& waves, double low, double high) {
  if (!locks_at_rest(waves.motor(low))) return low;
  while (high > kRules.last_locked * low) {
    const double middle = std::sqrt(low * high);
    (locks_at_rest(waves.motor(middle)) ? low : high) = middle;
  }
  return low;
}

// The contact is full and H is proportional to the amplitude up to here, or what bends it is no extremum.
double lowest(const DrivenWaves& waves, double speed) {
  const double high = highest(waves), full = waves.full_contact_amplitude();
  const double bent = waves.has_static_excess() ? kRules.smallest_running * full : 0.01 * full;
  const double low = std::fmax(std::fmin(bent, 1e-3 * high), kSmallest);
  return speed == 0 && low < full ? last_locked(waves, low, std::fmin(full, high)) : low;
}

PlaneRange range_of(double low, double high) {
  return {{std::log(low), -HUGE_VAL}, {std::log(high), HUGE_VAL}};
}

// What the slopes of two neighbours do not explain of the change of ln H.
double unexplained(const CurveNode& a, const CurveNode& b) {
  return std::fabs(b.at.y - a.at.y - 0.5 * (a.rise + b.rise) * (b.at.x - a.at.x));
}

// H does not jump between two neighbours. Where zones begin or end between them its slope may change at once, and so much that this
// hides a jump.
bool joined(const CurveNode& a, const CurveNode& b) {
  const double hidden = std::fabs(b.rise - a.rise) * (b.at.x - a.at.x);
  return unexplained(a, b) <= kRules.jump &&
         (hidden <= kRules.hidden_jump || a.solved.signature() == b.solved.signature());
}

bool jumps(const CurveNode& a, const CurveNode& b) { return a.jump && b.jump; }

}  // namespace

double largest_amplitude(const DrivenWaves& w) {
  const StatorModes<double>& m = w.modes();
  const double damped = (w.drive() + w.traction_bound()) / (w.omega() * m.damping);
  const double stiff = (w.drive() + w.pressure_bound() + w.traction_bound()) /
                       std::fabs(dynamic_stiffness(m, w.omega()));
  return std::fmin(std::fmin(damped, stiff) * (1 + 1e-9), kLargest);
}

ForceLine::ForceLine(const DrivenWaves& waves, double speed, double low, double high, Jumps jumps)
    : waves_(waves),
      speed_(speed),
      curve_(ForcePlane::of_voltage(waves, speed), range_of(low, high), kRules.voltage) {
  follow(std::log(low), std::log(high), jumps);
}

ForceLine::ForceLine(const DrivenWaves& waves, double speed)
    : ForceLine(waves, speed, lowest(waves, speed), highest(waves)) {
  if (waves.drive() > 0) extend_below(waves.drive());
}

// With mu_0 = mu H is continuous. Otherwise it is sampled, as some amplitudes have no periodic state, and only laps from rest tell
// which of several is the layer's.
void ForceLine::follow(double low, double high, Jumps jumps) {
  const bool sampled = waves_.has_static_excess();
  for (double x = low; x < high; x += sampled ? kRules.jumping_step : kRules.voltage.longest) {
    const auto first = curve_.at_amplitude(x);
    if (!first) continue;
    if (!sampled) {
      // Where R is negative in any case both |R| and I grow.
      const double y = std::log(waves_.drive()), last = 0.5 * highest_extremum(waves_);
      nodes_ = curve_.follow(*first, true, [y, last](const std::vector<CurveNode>& nodes) {
        const CurveNode& n = nodes.back();
        return n.amplitude > last && n.behind && n.rise > 1 && n.at.y > y;
      });
      for (int i = 0; i < kRules.hidden_folds && look_closer(); ++i) continue;
      return;
    }
    nodes_.empty() ? nodes_.push_back(*first) : append(*first, jumps);
  }
}

// Adds a wave between two neighbours where H keeps rising or falling, but lines through the slopes on both sides lead to one that is much
// smaller: there may be two extrema. False if there was none.
bool ForceLine::look_closer() {
  std::vector<double> places;
  for (std::size_t i = 1; i + 2 < nodes_.size(); ++i) {
    const CurveNode *n = &nodes_[i - 1], &a = n[1], &b = n[2];
    if (a.fold || b.fold || a.rise * b.rise < 0) continue;
    const double apart = b.at.x - a.at.x, sign = a.rise > 0 ? 1 : -1,
                 before = sign * (a.rise - n[0].rise) / (a.at.x - n[0].at.x),
                 after = sign * (n[3].rise - b.rise) / (n[3].at.x - b.at.x);
    if (!(before < 0 && after > 0)) continue;
    const double met =
        std::clamp((after * apart - sign * (b.rise - a.rise)) / (after - before), 0.0, apart);
    const double least = std::fmin(std::fabs(a.rise), std::fabs(b.rise));
    if (sign * a.rise + before * met < kRules.flat * least) places.push_back(a.at.x + 0.5 * apart);
  }
  if (places.empty()) return false;
  std::vector<CurveNode> all;
  std::swap(all, nodes_);
  std::erase_if(all, [](const CurveNode& n) { return n.fold; });
  const auto below = [](double x, const CurveNode& n) { return x < n.at.x; };
  for (const double x : places)
    if (auto n = curve_.at_amplitude(x))
      all.insert(std::upper_bound(all.begin(), all.end(), x, below), std::move(*n));
  for (CurveNode& n : all)
    nodes_.empty() ? nodes_.push_back(std::move(n)) : curve_.add(nodes_, std::move(n));
  return true;
}

// A sample, after what lies between it and the last one: halves until the slopes explain how H changes, or only a jump is left.
void ForceLine::append(CurveNode next, Jumps jumps) {
  const CurveNode& last = nodes_.back();
  if (joined(last, next) && turns_to(next)) return;
  const bool met = jumps == Jumps::all || may_hold_between(last, next);
  if (!met || next.at.x - last.at.x <= kRules.kink) return push_jump(std::move(next));
  const double x = 0.5 * (last.at.x + next.at.x);
  if (auto middle = curve_.at_amplitude(x)) {
    append(std::move(*middle), jumps);
    append(std::move(next), jumps);
  } else {
    pass_gap(std::move(next), x, jumps);
  }
}

// Adds a sample and the extremum between it and the last one. False if what looks like one is a jump.
bool ForceLine::turns_to(const CurveNode& next) {
  const std::size_t last = nodes_.size() - 1;
  const CurveNode before = nodes_.back();
  curve_.add(nodes_, next);
  for (std::size_t i = last; i < nodes_.size(); ++i) {
    const CurveNode& n = nodes_[i];
    if (!n.fold || (i == last && before.fold)) continue;
    if (n.beyond_kink == 0 && std::fabs(n.rise) <= kRules.doubtful) continue;
    const auto other =
        n.beyond_kink > 0 ? curve_.at_amplitude(std::log(n.beyond_kink)) : std::nullopt;
    if (other && std::fabs(other->at.y - n.at.y) <= kRules.extremum) continue;
    nodes_.resize(last + 1, before);
    nodes_.back() = before;
    return false;
  }
  return true;
}

// H may reach beyond two samples by what they do not explain, and by what it changes over a step.
bool ForceLine::may_hold_between(const CurveNode& a, const CurveNode& b) const {
  const double y = std::log(waves_.drive());
  const double reach =
      unexplained(a, b) + std::fmax(std::fabs(a.rise), std::fabs(b.rise)) * (b.at.x - a.at.x);
  return y > std::fmin(a.at.y, b.at.y) - reach && y < std::fmax(a.at.y, b.at.y) + reach;
}

void ForceLine::push_jump(CurveNode next) {
  nodes_.back().jump = next.jump = true, next.place = nodes_.back().place;
  nodes_.push_back(std::move(next));
}

// Halves towards both ends of a range of amplitudes without a periodic state, of which one is known.
void ForceLine::pass_gap(CurveNode next, double inside, Jumps jumps) {
  for (double end = inside; end - nodes_.back().at.x > kRules.kink;) {
    const double x = 0.5 * (nodes_.back().at.x + end);
    auto n = curve_.at_amplitude(x);
    n ? append(std::move(*n), jumps) : void(end = x);
  }
  std::vector<CurveNode> beyond{std::move(next)};
  for (double end = inside; beyond.back().at.x - end > kRules.kink;) {
    const double x = 0.5 * (beyond.back().at.x + end);
    auto n = curve_.at_amplitude(x);
    n ? beyond.push_back(std::move(*n)) : void(end = x);
  }
  push_jump(std::move(beyond.back()));
  for (beyond.pop_back(); !beyond.empty(); beyond.pop_back())
    append(std::move(beyond.back()), jumps);
}

// H(0) = 0.
void ForceLine::extend_below(double force) {
  while (!nodes_.empty() && nodes_.front().at.y > std::log(force)) {
    const double x = nodes_.front().at.x - std::log(10.0);
    const auto next = curve_.at_amplitude(x);
    if (!next || x < std::log(kSmallest)) return;
    const double apart = std::hypot(nodes_.front().at.x - x, nodes_.front().at.y - next->at.y);
    nodes_.insert(nodes_.begin(), *next);
    nodes_.front().place = nodes_[1].place - apart;
  }
}

std::vector<ForceExtremum> ForceLine::extrema() const {
  std::vector<ForceExtremum> found;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const CurveNode& n = nodes_[i];
    const auto add = [&](bool maximum) {
      const CurveNode &a = nodes_[i > 0 ? i - 1 : i],
                      &b = nodes_[i + 1 < nodes_.size() ? i + 1 : i];
      found.push_back({n.amplitude, std::exp(n.at.y), maximum,
                       (b.rise - a.rise) / (b.at.x - a.at.x), n.beyond_kink});
    };
    if (n.fold) add(i > 0 ? nodes_[i - 1].rise > 0 : false);
    if (!n.jump) continue;
    const bool before = i + 1 < nodes_.size() && jumps(n, nodes_[i + 1]);
    const CurveNode& other = before ? nodes_[i + 1] : nodes_[i - 1];
    const bool above = n.at.y > other.at.y, rises = before == (n.rise > 0);
    if (above == rises) add(above);
  }
  return found;
}

bool ForceLine::begins_below() const {
  return !nodes_.empty() && nodes_.front().at.y < std::log(waves_.drive());
}

std::optional<CurveNode> ForceLine::held_after(std::size_t i) const {
  if (!(waves_.drive() > 0)) return {};
  const double y = std::log(waves_.drive());
  const CurveNode &a = nodes_[i], &b = nodes_[i + 1];
  if ((a.at.y < y) == (b.at.y < y) || jumps(a, b)) return {};
  return curve_.between(a, b, y);
}

std::vector<CurveNode> ForceLine::held() const {
  std::vector<CurveNode> found;
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
    if (auto wave = held_after(i)) found.push_back(std::move(*wave));
  return found;
}

std::optional<CurveNode> ForceLine::largest_held() const {
  for (std::size_t i = nodes_.size(); i > 1; --i)
    if (auto wave = held_after(i - 2)) return wave;
  return {};
}

std::vector<WaveSolution> ForceLine::solutions() const {
  const std::vector<ForceExtremum> all = extrema();
  std::vector<WaveSolution> found;
  for (const CurveNode& n : held()) {
    const SlopedWave wave = waves_.in_amplitude(n.amplitude, speed_);
    const bool past = std::any_of(all.begin(), all.end(), [&](const ForceExtremum& e) {
      return e.maximum && e.amplitude < n.amplitude;
    });
    found.push_back({wave, waves_.stability(wave), past, all.empty()});
  }
  return found;
}

}  // namespace twum::core
