// SPDX-License-Identifier: Apache-2.0
#include "held/loaded_wave.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {

double LoadedWaves::plateau() const {
  const MotorModel<double>& m = waves_.model();
  return m.kinetic * m.preload * waves_.motor(waves_.full_contact_amplitude()).lever;
}

// Without inertia T(A) rises up to its plateau (980 curves); with mu_0 > mu it jumps.
bool LoadedWaves::is_monotone() const {
  return waves_.model().inertia == 0 && !waves_.has_static_excess();
}

LoadedWave LoadedWaves::at(double amplitude, double omega, const LoadedWave* near) const {
  const DrivenWaves there = waves_.at_frequency(omega);
  std::optional<WarmStart> start;
  if (near) start = near->slopes.solved.start();
  LoadedWave w;
  w.amplitude = amplitude, w.omega = omega;
  w.slopes =
      there.slopes(amplitude, speed_, start ? &*start : nullptr, 0, nullptr, Continued::frequency);
  if (!w.ok()) return w;
  const SlopedWave& s = w.slopes.in_amplitude;
  const contact::MotionDual& torque = w.slopes.numbers.torque;
  w.torque = torque.v;
  w.torque_in_amplitude = torque.d[contact::kInAmplitude];
  w.torque_in_omega = torque.d[contact::kInSpeed];
  w.force = s.wave.balance, w.in_amplitude = s.slope;
  w.in_omega = w.slopes.balance_per_speed;
  return w;
}

// Newton's method in a bracket, halving where it leaves it.
std::optional<LoadedWave> LoadedWaves::solve_between(Bracket ends) const {
  auto& [low, high] = ends;
  LoadedWave w = high;
  for (int i = 0; i < kHeldRules.most_tries; ++i) {
    double next = w.amplitude + (torque_ - w.torque) / w.torque_in_amplitude;
    const double step = std::fabs(next - w.amplitude);
    if (step <= kHeldRules.settled * w.amplitude) return w;
    if (!(next > low.amplitude && next < high.amplitude))
      next = 0.5 * (low.amplitude + high.amplitude);
    if (high.amplitude - low.amplitude <= kHeldRules.settled * high.amplitude) {
      // A jump of the torque passes by the load.
      const double scale = std::fabs(torque_) + plateau();
      return high.torque - low.torque <= kHeldRules.jump * scale ? std::optional(high)
                                                                 : std::nullopt;
    }
    w = at(next, w.omega, &w);
    if (!w.ok()) return {};
    (w.torque < torque_ ? low : high) = w;
  }
  return {};
}

// Where the torque rises behind one node and falls before the next one, it has a peak between them.
std::optional<LoadedWave> LoadedWaves::peak_between(const LoadedWave& low,
                                                    const LoadedWave& high) const {
  if (!(low.torque_in_amplitude > 0 && high.torque_in_amplitude < 0)) return {};
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

// Where the stator's crest is as fast as the rotor the contact brakes. A layer that sticks brakes less there, so that a load that
// drives may be carried below.
LoadedWave LoadedWaves::below_load(double omega) const {
  LoadedWave w = at(speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude(), omega);
  for (int i = 0; i < kHeldRules.most_steps && w.ok() && w.torque >= torque_; ++i)
    w = at(w.amplitude * std::exp(-kHeldRules.first), omega, &w);
  return w;
}

double LoadedWaves::next_step(const LoadedWave& from, double last) const {
  if (is_monotone()) return kHeldRules.growth * last;
  const double left = (torque_ - from.torque) / (from.torque_in_amplitude * from.amplitude);
  return left > 0 ? std::clamp(0.5 * left, kHeldRules.shortest, kHeldRules.longest)
                  : kHeldRules.longest;
}

LoadedWaves::Search LoadedWaves::first_reached(double omega) const {
  LoadedWave last = below_load(omega);
  const double farthest = kHeldRules.farthest * last.amplitude;
  std::optional<LoadedWave> low;  // the largest so far that carries less
  Search search;
  double step = is_monotone() ? kHeldRules.first : kHeldRules.longest;
  for (int i = 0; i < kHeldRules.most_steps && last.amplitude < farthest; ++i) {
    if (last.ok()) {
      if (last.torque >= torque_) {
        if (low) search.found = {std::move(*low), std::move(last)};
        return search;
      }
      if (low && !is_monotone())
        if (auto peak = peak_between(*low, last)) {
          search.found = {std::move(*low), std::move(*peak)};
          return search;
        }
      if (low) step = next_step(last, step);
      low = last;
    } else {
      search.lost = true;
    }
    last = at(last.amplitude * std::exp(step), omega, low ? &*low : nullptr);
  }
  return search;
}

// The torque bends towards its plateau: from below the load Newton's method does not leave the branch.
LoadedWave LoadedWaves::within(const Bracket& ends) const {
  const auto& [low, high] = ends;
  const double share = (torque_ - low.torque) / (high.torque - low.torque);
  return at(low.amplitude + share * (high.amplitude - low.amplitude), high.omega, &high);
}

std::optional<LoadedWave> LoadedWaves::solve_at_frequency(const LoadedWave& known,
                                                          double omega) const {
  const double slope = -known.torque_in_omega / known.torque_in_amplitude;
  LoadedWave w = at(known.amplitude + slope * (omega - known.omega), omega, &known);
  double last = HUGE_VAL;
  for (int i = 0; i < kHeldRules.most_tries && w.ok(); ++i) {
    const double step = (torque_ - w.torque) / w.torque_in_amplitude;
    if (!(w.torque_in_amplitude > 0) || !(std::fabs(step) < last)) return {};
    if (std::fabs(step) <= kHeldRules.settled * w.amplitude) return w;
    last = std::fabs(step);
    w = at(w.amplitude + step, omega, &w);
  }
  return {};
}

}  // namespace twum::inline v0_1::core
