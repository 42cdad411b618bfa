// SPDX-License-Identifier: Apache-2.0
#include "held/loaded_wave.hpp"

#include "drive/curve_node.hpp"
#include "held/torque_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

double log_step(const LoadedWave& from, const LoadedWave& to) {
  return std::log(to.amplitude / from.amplitude);
}

// dT / d ln A
double rise(const LoadedWave& w) { return w.torque_in_amplitude * w.amplitude; }

// Where the torque rises behind one wave and falls before the next one.
bool has_peak(const LoadedWave& low, const LoadedWave& high) {
  return low.torque_in_amplitude > 0 && high.torque_in_amplitude < 0;
}

}  // namespace

void LoadedWave::take_slopes(const LoadedWave& near) {
  torque_in_amplitude = near.torque_in_amplitude, torque_in_omega = near.torque_in_omega;
  in_amplitude = near.in_amplitude, in_omega = near.in_omega;
  states = near.states;
}

LoadedWaves::LoadedWaves(const DrivenWaves& waves, double speed) : waves_(waves), speed_(speed) {
  const MotorModel<double>& m = waves_.model();
  const double lever =
      m.track.nodes == 1 ? m.r : waves_.motor(waves_.full_contact_amplitude()).lever;
  plateau_ = m.kinetic * m.preload * lever;
  carry(0);
}

void LoadedWaves::carry(double torque) { torque_ = torque, root_ = std::cbrt(plateau_ - torque); }

// To first order the layer enters as the derivatives of the wave nearby say.
LoadedWave LoadedWaves::found(double amplitude, double omega, const LoadedWave* near,
                              double accuracy) const {
  const DrivenWaves there = waves_.at_frequency(omega);
  std::optional<WarmStart> start;
  if (near)
    start =
        moved(near->solved.start(), near->states, amplitude - near->amplitude, omega - near->omega);
  LoadedWave w;
  w.amplitude = amplitude, w.omega = omega, w.accuracy = accuracy;
  w.solved = solve_point(there.motor(amplitude), speed_, start ? &*start : nullptr, accuracy);
  w.torque = w.solved.numbers.torque;
  w.force = there.balance(w.solved.numbers, amplitude);
  return w;
}

void LoadedWaves::differentiate(LoadedWave& w) const {
  DrivenWaves::MovingWave moving =
      waves_.at_frequency(w.omega).moving(w.solved, w.amplitude, speed_, Continued::frequency);
  const auto slope = [&moving](std::size_t k) {
    return WaveBalance<double>{moving.balance.real.d[k], moving.balance.imaginary.d[k]};
  };
  w.torque_in_amplitude = moving.numbers.torque.d[contact::kInAmplitude];
  w.torque_in_omega = moving.numbers.torque.d[contact::kInSpeed];
  w.in_amplitude = slope(contact::kInAmplitude), w.in_omega = slope(contact::kInSpeed);
  w.states = std::move(moving.states);
}

LoadedWave LoadedWaves::at(double amplitude, double omega, const LoadedWave* near,
                           double accuracy) const {
  LoadedWave w = found(amplitude, omega, near, accuracy);
  if (w.ok()) differentiate(w);
  return w;
}

// T_p - T goes nearly with the cube of A_p - A, so that its cube root c is nearly straight: c - c_L times dT / dc.
double LoadedWaves::missing(const LoadedWave& w) const {
  const double here = std::cbrt(plateau_ - w.torque);
  return 3 * here * here * (here - root_);
}

double LoadedWaves::likely_amplitude(double omega) const {
  return TorqueLaw(waves_.at_frequency(omega), speed_).amplitude(torque_ / plateau_);
}

std::optional<LoadedWave> LoadedWaves::likely(double amplitude, double omega) const {
  if (waves_.has_static_excess()) return {};
  LoadedWave w = at(amplitude, omega, nullptr, kHeldRules.crude);
  for (int i = 0; i < kHeldRules.most_back && on_plateau(w); ++i)
    w = at(amplitude *= 1 - kHeldRules.back, omega, nullptr, kHeldRules.crude);
  return w.ok() ? std::optional(std::move(w)) : std::nullopt;
}

bool LoadedWaves::rings(double omega) const {
  const MotorModel<double>& m = waves_.model();
  const double viscosity = waves_.at_frequency(omega).model().viscosity;
  return viscosity < kHeldRules.dies_away * m.inertia * (omega + m.kappa * m.r * speed_);
}

// T(A) rises up to its plateau without inertia (980 curves), and where a layer does not ring in a contact that is partial from the
// crest's speed on (260,000 motors with C from 1.3 M to 2.6 M; 80 ripple, all in full contact).
bool LoadedWaves::surely_rises(double omega) const {
  if (waves_.model().inertia == 0) return true;
  const double at_crest = speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude();
  return !rings(omega) && waves_.model().track.nodes == 1 &&
         at_crest > waves_.full_contact_amplitude();
}

// Below the first wave that carries a smaller load at the same frequency nothing carries even that.
bool LoadedWaves::is_first(const LoadedWave& w, const LoadedWave* lower) const {
  if (surely_rises(w.omega)) return true;
  const bool known = lower && lower->omega == w.omega && lower->torque < torque_;
  const LoadedWave low = known ? *lower : below_load(w.omega);
  return low.ok() && low.amplitude < w.amplitude && w.torque_in_amplitude > 0 &&
         stays_below(low, w);
}

// Where the stator's crest is as fast as the rotor the contact brakes. A layer that sticks brakes less there, so that a load that
// drives may be carried below.
LoadedWave LoadedWaves::below_load(double omega) const {
  LoadedWave w = at(speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude(), omega, nullptr,
                    kHeldRules.crude);
  for (int i = 0; i < kHeldRules.most_steps && w.ok() && w.torque >= torque_; ++i)
    w = at(w.amplitude * std::exp(-kHeldRules.longest), omega, &w, kHeldRules.crude);
  return w;
}

// The cube root of T_p - T goes all the way from one end to the other, as the cubic through both and their slopes does, and nearly
// straight. Towards the plateau the torque itself bends.
bool LoadedWaves::is_even(const LoadedWave& low, const LoadedWave& high) const {
  const double length = log_step(low, high);
  const double a = std::cbrt(plateau_ - low.torque), b = std::cbrt(plateau_ - high.torque);
  const double mean = (b - a) / length;
  const auto like_mean = [mean](double root, const LoadedWave& end) {
    const double ratio = -rise(end) / (3 * root * root * mean);
    return ratio <= kHeldRules.even && ratio * kHeldRules.even >= 1;
  };
  return length <= kHeldRules.longest && like_mean(a, low) && like_mean(b, high);
}

// Between two waves that carry no more than the load none carries more, as far as ever finer steps tell.
bool LoadedWaves::stays_below(const LoadedWave& low, const LoadedWave& high) const {
  if (is_even(low, high)) return true;
  if (log_step(low, high) <= kHeldRules.finest) return !has_peak(low, high);
  const LoadedWave middle = at(std::sqrt(low.amplitude * high.amplitude), high.omega, &low);
  return middle.ok() && middle.torque < torque_ && stays_below(low, middle) &&
         stays_below(middle, high);
}

// ln A of the next wave. Torques that jump are approached by halves.
double LoadedWaves::next_step(const LoadedWave& from) const {
  const bool jumps = waves_.has_static_excess();
  const double longest = jumps ? kHeldRules.finest : kHeldRules.longest;
  const double lacks = jumps ? torque_ - from.torque : missing(from);
  const double left = lacks / rise(from);
  if (!(left > 0)) return longest;
  return std::clamp((jumps ? 0.5 : kHeldRules.beyond) * left, kHeldRules.shortest, longest);
}

// From wave to wave upwards. A step along which the torque is not even is made again, shorter.
LoadedWaves::Search LoadedWaves::first_reached(double omega) const {
  LoadedWave first = below_load(omega);
  double amplitude = first.amplitude, step = first.ok() ? next_step(first) : kHeldRules.finest;
  const double farthest = kHeldRules.farthest * amplitude;
  std::optional<LoadedWave> low;  // the largest so far that carries less
  Search search{{}, !first.ok()};
  if (first.ok()) low = std::move(first);
  for (int i = 0; i < kHeldRules.most_steps && amplitude < farthest; ++i) {
    LoadedWave next = at(amplitude * std::exp(step), omega, low ? &*low : nullptr);
    if (step > kHeldRules.finest && !(next.ok() && is_even(*low, next))) {
      step = std::fmax(0.5 * step, kHeldRules.finest);
      continue;
    }
    amplitude = next.amplitude, step = kHeldRules.finest;
    search.lost = search.lost || !next.ok();
    if (!next.ok()) continue;
    if (next.torque >= torque_) {
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

std::optional<LoadedWave> LoadedWaves::peak_between(const LoadedWave& low,
                                                    const LoadedWave& high) const {
  if (!has_peak(low, high)) return {};
  LoadedWave a = low, b = high;
  for (int i = 0;
       i < kHeldRules.most_tries && b.amplitude - a.amplitude > kHeldRules.peak * b.amplitude;
       ++i) {
    const double share = a.torque_in_amplitude / (a.torque_in_amplitude - b.torque_in_amplitude);
    const double next = a.amplitude + std::clamp(share, 0.1, 0.9) * (b.amplitude - a.amplitude);
    LoadedWave w = at(next, low.omega, &a);
    if (!w.ok()) return {};
    if (w.torque >= torque_) return w;
    (w.torque_in_amplitude > 0 ? a : b) = std::move(w);
  }
  return {};
}

LoadedWaves::Reached LoadedWaves::between(LoadedWave low, LoadedWave high) const {
  Reached ends{{}, std::move(low), std::move(high)};
  ends.near = at(towards_load(*ends.high, &*ends.low, ends), ends.high->omega, &*ends.high);
  return ends;
}

// Where A reaches the load as a function of c, the cube root of T_p - T: by the cubic through two waves and their slopes.
double LoadedWaves::on_cubic(const LoadedWave& p, const LoadedWave& q) const {
  const double a = std::cbrt(plateau_ - p.torque), b = std::cbrt(plateau_ - q.torque);
  const double t = (a - root_) / (a - b), left = 1 - t;
  const double from_p = 3 * a * a * (a - b) / p.torque_in_amplitude,
               to_q = 3 * b * b * (a - b) / q.torque_in_amplitude;
  return left * left * ((1 + 2 * t) * p.amplitude + t * from_p) +
         t * t * ((1 + 2 * left) * q.amplitude - left * to_q);
}

// The next amplitude to try: by the cubic through the last two waves, or Newton's method from the last; halfway between two ends or a
// step from the only one where that leaves them.
double LoadedWaves::towards_load(const LoadedWave& near, const LoadedWave* before,
                                 const Reached& ends) const {
  const auto& [unused, low, high] = ends;
  const bool rises = before && before->torque_in_amplitude > 0 && near.torque_in_amplitude > 0;
  const double next =
      rises ? on_cubic(*before, near) : near.amplitude + missing(near) / near.torque_in_amplitude;
  const double longest = std::exp(kHeldRules.blind);
  const double least = low ? low->amplitude : (high ? *high : near).amplitude / longest,
               most = high ? high->amplitude : (low ? *low : near).amplitude * longest;
  if (next > least && next < most) return next;
  if (low && high) return 0.5 * (least + most);
  return near.torque < torque_ ? most : least;
}

// Steps towards the load in a bracket, which halve it where they do not lead there fast: at a jump.
std::optional<LoadedWave> LoadedWaves::solve(Reached ends) const {
  auto& [near, low, high] = ends;
  std::optional<LoadedWave> before = low;
  bool halved = false;
  double last = HUGE_VAL;
  for (int i = 0; i < kHeldRules.most_tries && near.ok(); ++i) {
    const double off = std::fabs(torque_ - near.torque);
    if (near.exact()) (near.torque < torque_ ? low : high) = near;
    if (low && high && high->amplitude - low->amplitude <= kHeldRules.settled * high->amplitude) {
      // A jump of the torque passes by the load.
      const double scale = std::fabs(torque_) + plateau_;
      return high->torque - low->torque <= kHeldRules.jump * scale ? high : std::nullopt;
    }
    halved = !halved && low && high && off > kHeldRules.fast * last;
    const double next = halved ? 0.5 * (low->amplitude + high->amplitude)
                               : towards_load(near, before ? &*before : nullptr, ends);
    const double step = std::fabs(next - near.amplitude) / near.amplitude;
    if (step <= kHeldRules.settled && near.exact()) return near;
    const double by_cubic = before ? log_step(*before, near) : 1;
    LoadedWave tried =
        found(next, near.omega, &near, accuracy_of(step * step * by_cubic * by_cubic));
    const bool settled =
        std::fabs(torque_ - tried.torque) <= kHeldRules.settled * next * near.torque_in_amplitude;
    if (tried.ok() && tried.exact() && settled) {
      tried.take_slopes(near);
      return tried;
    }
    if (tried.ok()) differentiate(tried);
    before = std::exchange(near, std::move(tried));
    last = off;
  }
  return {};
}

std::optional<LoadedWave> LoadedWaves::solve_at_frequency(const LoadedWave& known,
                                                          double omega) const {
  const double follows = -known.torque_in_omega / known.torque_in_amplitude;
  LoadedWave w = at(known.amplitude + follows * (omega - known.omega), omega, &known);
  double last = HUGE_VAL;
  for (int i = 0; i < kHeldRules.most_tries && w.ok(); ++i) {
    const double step = missing(w) / w.torque_in_amplitude;
    if (!(w.torque_in_amplitude > 0) || !(std::fabs(step) < last)) return {};
    if (std::fabs(step) <= kHeldRules.settled * w.amplitude) return w;
    last = std::fabs(step);
    w = at(w.amplitude + step, omega, &w);
  }
  return {};
}

}  // namespace twum::inline v0_1::core
