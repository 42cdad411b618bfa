// SPDX-License-Identifier: Apache-2.0
#include "held/first_wave.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

double log_step(const LoadedWave& from, const LoadedWave& to) {
  return std::log(to.amplitude / from.amplitude);
}

}  // namespace

double WavePath::flank(const LoadedWave& w) const {
  const double square = *drive * *drive - w.force.imaginary * w.force.imaginary;
  return square > 0 ? std::sqrt(square) : 0;
}

double WavePath::slope_above_flank(const LoadedWave& w, const WaveBalance<double>& along) const {
  const double height = flank(w);
  return height > 0 ? along.real - w.force.imaginary * along.imaginary / height : along.real;
}

double WavePath::follows(const LoadedWave& w) const {
  return -slope_above_flank(w, w.in_amplitude) / slope_above_flank(w, w.in_omega);
}

LoadedWave FirstWave::at(double amplitude, const LoadedWave* near, double accuracy) const {
  if (path_.drive) return on_flank(amplitude, near, accuracy);
  return waves_.at(amplitude, path_.omega, near, accuracy);
}

// Newton's method for (Y2.3) over the frequency. A wave that only leads to others is known well enough as soon as what the last step
// leaves is, which moves it to first order.
LoadedWave FirstWave::on_flank(double amplitude, const LoadedWave* near, double accuracy) const {
  const double settled = accuracy > 0 ? kHeldRules.beside_flank : kHeldRules.settled;
  double omega = near ? likely_omega(*near, amplitude) : path_.omega;
  LoadedWave w;
  for (int i = 0; i < kHeldRules.most_tries; ++i) {
    w = waves_.at(amplitude, omega, near, accuracy);
    if (!w.ok()) break;
    double slope = path_.slope_above_flank(w, w.in_omega);
    if (!(slope < 0)) slope = w.in_omega.real;  // next to R = 0 the root is steep
    const double step = -path_.above_flank(w) / slope,
                 room = kHeldRules.longest_in_frequency * omega;
    if (std::fabs(step) <= settled * omega) {
      waves_.move(w, step);
      return w;
    }
    omega += std::clamp(step, -room, room), near = &w;
  }
  w.off_flank = w.ok();
  return w;
}

// R and I go on from a wave as their slopes say, and the wave's own inertia takes what they leave.
double FirstWave::likely_omega(const LoadedWave& near, double amplitude) const {
  const double grown = amplitude - near.amplitude;
  LoadedWave there;
  there.force = {near.force.real + grown * near.in_amplitude.real,
                 near.force.imaginary + grown * near.in_amplitude.imaginary};
  return waves_.omega_beside(near.omega, path_.above_flank(there), amplitude);
}

// Where the torque rises behind one wave and falls before the next one.
bool FirstWave::has_peak(const LoadedWave& low, const LoadedWave& high) const {
  return path_.slope(low) > 0 && path_.slope(high) < 0;
}

// Below the first wave of the path that carries a smaller load nothing carries even that.
bool FirstWave::is(const LoadedWave& w, const LoadedWave* lower) const {
  if (waves_.surely_rises(w.omega)) return true;
  const bool of_path = lower && (path_.drive || lower->omega == w.omega);
  const bool known = of_path && lower->torque < waves_.torque();
  const LoadedWave low = known ? *lower : below_load(&w);
  return low.ok() && low.amplitude < w.amplitude && path_.slope(w) > 0 && stays_below(low, w);
}

// Where the stator's crest is as fast as the rotor the contact brakes. A layer that sticks brakes less there, so that a load that
// drives may be carried below.
LoadedWave FirstWave::below_load(const LoadedWave* near) const {
  LoadedWave w =
      at(waves_.crest_amplitude(near ? near->omega : path_.omega), near, kHeldRules.crude);
  for (int i = 0; i < kHeldRules.most_steps && w.ok() && w.torque >= waves_.torque(); ++i)
    w = at(w.amplitude * std::exp(-kHeldRules.longest), &w, kHeldRules.crude);
  return w;
}

// The cube root of T_p - T goes all the way from one end to the other, as the cubic through both and their slopes does, and nearly
// straight. Towards the plateau the torque itself bends.
bool FirstWave::is_even(const LoadedWave& low, const LoadedWave& high) const {
  const double length = log_step(low, high);
  const double mean = (high.root - low.root) / length;
  const auto like_mean = [&](const LoadedWave& end) {
    const double ratio = -rise(end) / (3 * end.root * end.root * mean);
    return ratio <= kHeldRules.even && ratio * kHeldRules.even >= 1;
  };
  return length <= kHeldRules.longest && like_mean(low) && like_mean(high);
}

// Between two waves that carry no more than the load none carries more, as far as ever finer steps tell.
bool FirstWave::stays_below(const LoadedWave& low, const LoadedWave& high) const {
  if (is_even(low, high)) return true;
  if (log_step(low, high) <= kHeldRules.finest) return !has_peak(low, high);
  const LoadedWave middle = at(std::sqrt(low.amplitude * high.amplitude), &low);
  return middle.ok() && middle.torque < waves_.torque() && stays_below(low, middle) &&
         stays_below(middle, high);
}

// ln A of the next wave. Torques that jump are approached by halves.
double FirstWave::next_step(const LoadedWave& from) const {
  const bool jumps = waves_.jumps();
  const double longest = jumps ? kHeldRules.finest : kHeldRules.longest;
  const double lacks = jumps ? waves_.torque() - from.torque : waves_.missing(from);
  const double left = lacks / rise(from);
  if (!(left > 0)) return longest;
  return std::clamp((jumps ? 0.5 : kHeldRules.beyond) * left, kHeldRules.shortest, longest);
}

// From wave to wave upwards. A step along which the torque is not even is made again, shorter.
FirstWave::Search FirstWave::reached() const {
  LoadedWave first = below_load();
  double amplitude = first.amplitude, step = first.ok() ? next_step(first) : kHeldRules.finest;
  const double farthest = kHeldRules.farthest * amplitude;
  std::optional<LoadedWave> low;  // the largest so far that carries less
  Search search;
  const auto miss = [&search](const LoadedWave& w) {
    search.missed = w.off_flank ? HeldStatus::not_converged : HeldStatus::no_periodic_state;
  };
  if (!first.ok()) miss(first);
  if (first.ok()) low = std::move(first);
  for (int i = 0; i < kHeldRules.most_steps && amplitude < farthest; ++i) {
    LoadedWave next = at(amplitude * std::exp(step), low ? &*low : nullptr, leading());
    if (step > kHeldRules.finest && !(next.ok() && is_even(*low, next))) {
      step = std::fmax(0.5 * step, kHeldRules.finest);
      continue;
    }
    amplitude = next.amplitude, step = kHeldRules.finest;
    if (!next.ok()) {
      miss(next);
      continue;
    }
    if (next.torque >= waves_.torque()) {
      if (low) search.found = between(std::move(*low), std::move(next));
      return search;
    }
    if (auto peak = low ? peak_between(*low, next) : std::nullopt) {
      search.found = between(std::move(*low), std::move(*peak));
      return search;
    }
    step = next_step(next);
    low = std::move(next);
  }
  return search;
}

std::optional<LoadedWave> FirstWave::peak_between(const LoadedWave& low,
                                                  const LoadedWave& high) const {
  if (!has_peak(low, high)) return {};
  LoadedWave a = low, b = high;
  for (int i = 0;
       i < kHeldRules.most_tries && b.amplitude - a.amplitude > kHeldRules.peak * b.amplitude;
       ++i) {
    const double share = path_.slope(a) / (path_.slope(a) - path_.slope(b));
    const double next = a.amplitude + std::clamp(share, 0.1, 0.9) * (b.amplitude - a.amplitude);
    LoadedWave w = at(next, &a);
    if (!w.ok()) return {};
    if (w.torque >= waves_.torque()) return w;
    (path_.slope(w) > 0 ? a : b) = std::move(w);
  }
  return {};
}

// The ends of the bracket are solved if they only led there.
FirstWave::Reached FirstWave::between(LoadedWave low, LoadedWave high) const {
  Reached ends;
  for (LoadedWave* end : {&low, &high}) {
    if (!end->exact()) *end = at(end->amplitude, end);
    if (end->ok()) (end->torque < waves_.torque() ? ends.low : ends.high) = *end;
  }
  const bool closed = ends.low && ends.high;
  ends.near = closed ? at(towards_load(high, &low, ends), &high) : std::move(high);
  return ends;
}

// Where A reaches the load as a function of c, the cube root of T_p - T: by the cubic through two waves and their slopes.
double FirstWave::on_cubic(const LoadedWave& p, const LoadedWave& q) const {
  const double a = p.root, b = q.root;
  const double t = (a - waves_.root()) / (a - b), left = 1 - t;
  const double from_p = 3 * a * a * (a - b) / path_.slope(p),
               to_q = 3 * b * b * (a - b) / path_.slope(q);
  return left * left * ((1 + 2 * t) * p.amplitude + t * from_p) +
         t * t * ((1 + 2 * left) * q.amplitude - left * to_q);
}

// The next amplitude to try: by the cubic through the last two waves, or Newton's method from the last; halfway between two ends or a
// step from the only one where that leaves them.
double FirstWave::towards_load(const LoadedWave& near, const LoadedWave* before,
                               const Reached& ends) const {
  const auto& [unused, low, high] = ends;
  const bool rises = before && path_.slope(*before) > 0 && path_.slope(near) > 0;
  const double next =
      rises ? on_cubic(*before, near) : near.amplitude + waves_.missing(near) / path_.slope(near);
  const double longest = std::exp(kHeldRules.blind);
  const double least = low ? low->amplitude : (high ? *high : near).amplitude / longest,
               most = high ? high->amplitude : (low ? *low : near).amplitude * longest;
  if (next > least && next < most) return next;
  if (low && high) return 0.5 * (least + most);
  return near.torque < waves_.torque() ? most : least;
}

// Steps towards the load in a bracket, which halve it where they do not lead there fast: at a jump.
std::optional<LoadedWave> FirstWave::solve(Reached ends) const {
  auto& [near, low, high] = ends;
  std::optional<LoadedWave> before = low;
  bool halved = false;
  double last = HUGE_VAL;
  for (int i = 0; i < kHeldRules.most_tries && near.ok(); ++i) {
    const double off = std::fabs(waves_.torque() - near.torque);
    // A jump of the torque passes by the load.
    const double jump = kHeldRules.jump * (std::fabs(waves_.torque()) + waves_.plateau());
    if (near.exact()) (near.torque < waves_.torque() ? low : high) = near;
    if (low && high && high->amplitude - low->amplitude <= kHeldRules.settled * high->amplitude)
      return high->torque - low->torque <= jump ? high : std::nullopt;
    halved = !halved && low && high && off > kHeldRules.fast * last;
    const double next = halved ? 0.5 * (low->amplitude + high->amplitude)
                               : towards_load(near, before ? &*before : nullptr, ends);
    const double step = std::fabs(next - near.amplitude) / near.amplitude;
    if (step <= kHeldRules.settled && near.exact())
      return off <= jump ? std::optional(near) : std::nullopt;
    const double by_cubic = before ? log_step(*before, near) : 1;
    const double accuracy = LoadedWaves::accuracy_of(step * step * by_cubic * by_cubic);
    LoadedWave tried = path_.drive ? on_flank(next, &near, accuracy)
                                   : waves_.found(next, path_.omega, &near, accuracy);
    const bool settled =
        std::fabs(waves_.torque() - tried.torque) <= kHeldRules.settled * next * path_.slope(near);
    if (tried.ok() && tried.exact() && settled) {
      if (!path_.drive) tried.take_slopes(std::move(near));
      return tried;
    }
    if (tried.ok() && !path_.drive) waves_.differentiate(tried);
    before = std::exchange(near, std::move(tried));
    last = off;
  }
  return {};
}

}  // namespace twum::inline v0_1::core
