// SPDX-License-Identifier: Apache-2.0
#include "drive/force_line.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

// Beyond the backbone, where R stays negative, both |R| and I grow.
double highest_extremum(const DrivenWaves& waves) {
  const double softness = -waves.dynamic_stiffness();
  return softness > 0 ? 2 * (waves.pressure_bound() + waves.traction_bound()) / softness : 0;
}

double highest(const DrivenWaves& waves) {
  return std::fmin(std::fmax(highest_extremum(waves), largest_amplitude(waves)),
                   kRules.largest_amplitude);
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
  const double low = std::fmax(std::fmin(bent, 1e-3 * high), kRules.smallest_amplitude);
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

// The second derivative of ln H over ln A at both ends of the cubic through two neighbours.
struct EndBends {
  double at_a, at_b;
};

EndBends end_bends(const CurveNode& a, const CurveNode& b) {
  const double apart = b.at.x - a.at.x, mean = (b.at.y - a.at.y) / apart;
  return {(6 * mean - 4 * a.rise - 2 * b.rise) / apart,
          (2 * a.rise + 4 * b.rise - 6 * mean) / apart};
}

// The smallest slope of that cubic, where both ends rise or both fall; negative if it changes its sign between them.
double least_slope(const CurveNode& a, const CurveNode& b) {
  const EndBends bends = end_bends(a, b);
  const double sign = a.rise > 0 ? 1 : -1, ka = sign * bends.at_a, kb = sign * bends.at_b;
  if (!(ka < 0 && kb > 0)) return std::fmin(sign * a.rise, sign * b.rise);
  return sign * a.rise - 0.5 * ka * ka * (b.at.x - a.at.x) / (kb - ka);
}

// H has one extremum between two neighbours if its slope changes its sign from one to the other, and else none.
// @param doubt  by how much the cubics on both sides of a neighbour differ in the second derivative there
bool turns_as_slopes_tell(const CurveNode& a, const CurveNode& b, double doubt) {
  const EndBends bends = end_bends(a, b);
  const double apart = b.at.x - a.at.x, ka = std::fabs(bends.at_a), kb = std::fabs(bends.at_b);
  if (apart <= kRules.closest || std::fmax(ka, kb) * apart * apart <= kRules.hidden_bend)
    return true;
  const bool slope_goes_one_way =
      bends.at_a * bends.at_b > 0 && std::fmin(ka, kb) > kRules.sure_bend * doubt;
  const bool keeps_sign = a.rise * b.rise > 0;
  return slope_goes_one_way ||
         (keeps_sign && least_slope(a, b) > kRules.sure_slope * doubt * apart);
}

// Of the step from the last sample of a list to the next one, which is the last of those ahead.
bool in_doubt(const Vector<CurveNode>& done, const Vector<CurveNode>& ahead) {
  const CurveNode &a = done.back(), &b = ahead.back();
  const EndBends here = end_bends(a, b);
  double doubt = 0;
  if (done.size() > 1) doubt = std::fabs(here.at_a - end_bends(done.end()[-2], a).at_b);
  if (ahead.size() > 1)
    doubt = std::fmax(doubt, std::fabs(here.at_b - end_bends(b, ahead.end()[-2]).at_a));
  return !turns_as_slopes_tell(a, b, doubt);
}

bool jumps(const CurveNode& a, const CurveNode& b) { return a.jump && b.jump; }

}  // namespace

double largest_amplitude(const DrivenWaves& w) {
  const double drive = w.drive() / w.divider();
  const double damped = (drive + w.traction_bound()) / (w.omega() * w.damping());
  const double stiff =
      (drive + w.pressure_bound() + w.traction_bound()) / std::fabs(w.dynamic_stiffness());
  return std::fmin(std::fmin(damped, stiff) * (1 + 1e-9), kRules.largest_amplitude);
}

ForceLine::ForceLine(const DrivenWaves& waves, double speed, double low, double high, Jumps jumps)
    : ForceLine(waves, speed, range_of(low, high)) {
  follow(std::log(low), std::log(high), jumps);
}

ForceLine::ForceLine(const DrivenWaves& waves, double speed, const PlaneRange& range)
    : waves_(waves),
      speed_(speed),
      curve_(ForcePlane::of_voltage(waves, speed), range, kRules.voltage) {}

ForceLine::ForceLine(const DrivenWaves& waves, double speed)
    : ForceLine(waves, speed, lowest(waves, speed), highest(waves)) {
  if (waves.drive() > 0) extend_below(waves.drive());
}

// With mu_0 > mu some amplitudes have no periodic state, and only laps from rest tell which of several is the layer's.
void ForceLine::follow(double low, double high, Jumps jumps) {
  if (!waves_.has_static_excess()) return follow_continuous(low, high);
  for (double x = low; x < high; x += kRules.jumping_step) {
    auto next = curve_.at_amplitude(x);
    if (next) nodes_.empty() ? nodes_.push_back(std::move(*next)) : append(std::move(*next), jumps);
  }
}

// With mu_0 = mu H is continuous, and so is its slope but at kinks.
void ForceLine::follow_continuous(double low, double high) {
  const double steps = std::fmax(std::ceil((high - low) / kRules.voltage.longest), 1);
  Vector<CurveNode> samples;  // none where the contact has no answer
  const auto is_done = [&] { return samples.size() > 1 && is_past_extrema(samples.back()); };
  for (double i = 0; i <= steps && !is_done(); ++i) {
    auto next = curve_.at_amplitude(low + i / steps * (high - low),
                                    samples.empty() ? nullptr : &samples.back().start);
    if (!next) continue;
    samples.push_back(std::move(*next));
  }
  take(std::move(samples));
}

// As long as the drive's force holds no wave of the amplitude.
void ForceLine::follow_down_to_drive(double high) {
  const double drive = std::log(waves_.drive());
  Vector<CurveNode> samples;
  for (double x = high; samples.empty() || samples.back().at.y > drive;
       x -= kRules.voltage.longest) {
    auto next = curve_.at_amplitude(x, samples.empty() ? nullptr : &samples.back().start);
    if (!next) return;
    samples.push_back(std::move(*next));
  }
  std::reverse(samples.begin(), samples.end());
  take(std::move(samples));
}

void ForceLine::take(Vector<CurveNode> samples) {
  for (CurveNode& n : halved_where_in_doubt(std::move(samples)))
    nodes_.empty() ? nodes_.push_back(std::move(n)) : curve_.append(nodes_, std::move(n));
}

// Where R is negative in any case both |R| and I grow.
bool ForceLine::is_past_extrema(const CurveNode& n) const {
  return n.amplitude > 0.5 * highest_extremum(waves_) && n.behind && n.rise > 1 &&
         n.at.y > std::log(waves_.drive());
}

// Halves the steps in which H may turn more often than the slopes at their ends tell. What is known of a step follows from the ones
// beside it, so that the one before a halved step is looked at again.
Vector<CurveNode> ForceLine::halved_where_in_doubt(Vector<CurveNode> samples) const {
  Vector<CurveNode> done,
      ahead(std::make_move_iterator(samples.rbegin()), std::make_move_iterator(samples.rend()));
  const auto move_last = [](Vector<CurveNode>& from, Vector<CurveNode>& to) {
    to.push_back(std::move(from.back())), from.pop_back();
  };
  while (!ahead.empty()) {
    std::optional<CurveNode> middle;
    if (!done.empty() && in_doubt(done, ahead)) middle = curve_.halfway(done.back(), ahead.back());
    if (!middle) {
      move_last(ahead, done);
      continue;
    }
    ahead.push_back(std::move(*middle));
    if (done.size() > 1) move_last(done, ahead);
  }
  return done;
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

// Beside amplitudes without a periodic state: by how much ln H may change from a sample to their edge. Where a state ends at a fold of
// its own, H goes on like the root of the distance, by twice what its slope tells.
double ForceLine::Edge::reach() const {
  return (kRules.towards_edge * std::fabs(sample->rise) + kRules.bend * apart()) * apart();
}

bool ForceLine::Edge::may_hold(double drive) const {
  return std::fabs(drive - sample->at.y) < reach();
}

// H rises towards an edge and is lower beyond the gap, or falls towards it and is higher there.
bool ForceLine::Edge::may_be_extremum(const Edge& beyond) const {
  const double higher = sample->at.y - beyond.sample->at.y;
  const double towards = edge > sample->at.x ? sample->rise : -sample->rise;
  const bool sure =
      std::fabs(higher) > reach() + beyond.reach() && std::fabs(towards) > kRules.bend * apart();
  return !sure || (higher > 0) == (towards > 0);
}

// Halves towards both ends of a range of amplitudes without a periodic state, of which one is known, as long as what lies there is
// asked for.
void ForceLine::pass_gap(CurveNode next, double inside, Jumps jumps) {
  const double drive = std::log(waves_.drive());
  const auto matters = [&](const Edge& edge, const Edge& beyond) {
    return edge.apart() > kRules.kink &&
           (edge.may_hold(drive) || (jumps == Jumps::all && edge.may_be_extremum(beyond)));
  };
  Vector<CurveNode> ahead{std::move(next)};
  for (double low = inside, high = inside;;) {
    const Edge below{&nodes_.back(), low}, above{&ahead.back(), high};
    const bool first = matters(below, above), second = matters(above, below);
    if (!first && !second) break;
    if (first && (!second || below.apart() >= above.apart())) {
      const double x = 0.5 * (below.sample->at.x + low);
      auto n = curve_.at_amplitude(x);
      n ? append(std::move(*n), jumps) : void(low = x);
    } else {
      const double x = 0.5 * (above.sample->at.x + high);
      auto n = curve_.at_amplitude(x);
      n ? ahead.push_back(std::move(*n)) : void(high = x);
    }
  }
  push_jump(std::move(ahead.back()));
  for (ahead.pop_back(); !ahead.empty(); ahead.pop_back()) append(std::move(ahead.back()), jumps);
}

// H(0) = 0.
void ForceLine::extend_below(double force) {
  while (!nodes_.empty() && nodes_.front().at.y > std::log(force)) {
    const double x = nodes_.front().at.x - std::log(10.0);
    const auto next = curve_.at_amplitude(x);
    if (!next || x < std::log(kRules.smallest_amplitude)) return;
    const double apart = std::hypot(nodes_.front().at.x - x, nodes_.front().at.y - next->at.y);
    nodes_.insert(nodes_.begin(), *next);
    nodes_.front().place = nodes_[1].place - apart;
  }
}

Vector<ForceExtremum> ForceLine::extrema() const {
  Vector<ForceExtremum> found;
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

Vector<CurveNode> ForceLine::held() const {
  Vector<CurveNode> found;
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
    if (auto wave = held_after(i)) found.push_back(std::move(*wave));
  return found;
}

std::optional<CurveNode> ForceLine::largest_held() const {
  for (std::size_t i = nodes_.size(); i > 1; --i)
    if (auto wave = held_after(i - 2)) return wave;
  return {};
}

std::optional<CurveNode> ForceLine::largest_held(const DrivenWaves& waves, double speed) {
  const double most = largest_amplitude(waves);
  if (!(waves.drive() > 0)) return {};
  ForceLine line(waves, speed, range_of(kRules.smallest_amplitude, most));
  line.follow_down_to_drive(std::log(most));
  return line.largest_held();
}

Vector<WaveSolution> ForceLine::solutions() const {
  const Vector<ForceExtremum> all = extrema();
  Vector<WaveSolution> found;
  for (const CurveNode& n : held()) {
    const SlopedWave wave = waves_.in_amplitude(n.amplitude, speed_);
    const bool past = std::any_of(all.begin(), all.end(), [&](const ForceExtremum& e) {
      return e.maximum && e.amplitude < n.amplitude;
    });
    found.push_back({wave, waves_.stability(wave), past, all.empty()});
  }
  return found;
}

}  // namespace twum::inline v0_1::core
