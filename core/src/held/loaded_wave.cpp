// SPDX-License-Identifier: Apache-2.0
#include "held/loaded_wave.hpp"

#include <algorithm>
#include <cmath>

namespace twum::core {

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
std::optional<LoadedWave> LoadedWaves::between(Bracket ends) const {
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

// From the amplitude on at which the stator's crest is as fast as the rotor, where the contact only brakes.
std::optional<LoadedWaves::Bracket> LoadedWaves::first_bracket(double omega) const {
  const double least = speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude();
  LoadedWave last = at(least, omega);
  const bool monotone = is_monotone();
  double step = monotone ? 4 * kHeldRules.longest : kHeldRules.longest;
  for (int i = 0; i < kHeldRules.most_steps; ++i) {
    LoadedWave next = at(last.amplitude * std::exp(step), omega, last.ok() ? &last : nullptr);
    if (next.amplitude > kHeldRules.farthest * least + 1) return {};
    if (monotone) step *= 1.3;
    if (!next.ok() || !last.ok()) {
      last = std::move(next);
      continue;
    }
    if (next.torque >= torque_) return Bracket{std::move(last), std::move(next)};
    if (!monotone) {
      if (auto peak = peak_between(last, next)) return Bracket{std::move(last), std::move(*peak)};
      const double left = (torque_ - next.torque) / (next.torque_in_amplitude * next.amplitude);
      step = left > 0 ? std::clamp(0.5 * left, kHeldRules.shortest, kHeldRules.longest)
                      : kHeldRules.longest;
      // Beyond the plateau nothing changes any more.
      if (next.slopes.solved.drives() && last.slopes.solved.drives() &&
          i > kHeldRules.most_steps / 2)
        return {};
    }
    last = std::move(next);
  }
  return {};
}

std::optional<LoadedWave> LoadedWaves::smallest(double omega) const {
  auto ends = first_bracket(omega);
  return ends ? between(std::move(*ends)) : std::nullopt;
}

// Below the load, as the torque bends towards its plateau: from there Newton's method does not leave the branch.
std::optional<LoadedWave> LoadedWaves::near_smallest(double omega) const {
  auto ends = first_bracket(omega);
  if (!ends) return {};
  auto& [low, high] = *ends;
  const double share = (torque_ - low.torque) / (high.torque - low.torque);
  LoadedWave w = at(low.amplitude + share * (high.amplitude - low.amplitude), omega, &high);
  return w.ok() && w.torque_in_amplitude > 0 ? std::optional(std::move(w)) : std::nullopt;
}

std::optional<LoadedWave> LoadedWaves::near(const LoadedWave& known, double omega) const {
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

}  // namespace twum::core
