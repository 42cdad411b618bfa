// SPDX-License-Identifier: Apache-2.0
#include "drive/held_waves.hpp"
#include "drive/rules.hpp"

#include "drive/learned_slopes.hpp"

#include <twum/base/scalar_search.hpp>

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

// R of the flank on a side (D5.1).
double wanted_force(const DrivenWaves& waves, const DrivenWave& wave, double side) {
  const double active = wave.balance.imaginary,
               room = (waves.drive() - active) * (waves.drive() + active);
  return room > 0 ? -side * std::sqrt(room) : 0;
}

}  // namespace

// The largest speed at which the rotor carries the torque; it is negative where the load drives the rotor back.
std::optional<HeldWaves::Carried> HeldWaves::at_torque(const DrivenWaves& waves, double amplitude,
                                                       double speed_ratio, double window) const {
  const double crest = waves.crest_speed_per_amplitude() * amplitude;
  DrivenWave last;
  WarmStart start;
  bool warm = false;
  const auto excess = [&](double ratio) {
    last = waves.at(amplitude, ratio * crest, warm ? &start : nullptr);
    if (last.status != PointStatus::ok) throw NoWave{};
    start = last.start, warm = true;
    return last.torque - load_.value;
  };
  try {
    double low = speed_ratio - window, high = speed_ratio + window;
    double at_low = 0, at_high = 0;
    const bool near = low > 0 && (at_low = excess(low)) > 0 && (at_high = excess(high)) < 0;
    if (!near) {
      high = kResponseRules.fastest_sought, at_high = excess(high);
      if (at_high > 0) return {};
      low = high;
      for (double step = kResponseRules.sought_step; true; high = low, at_high = at_low) {
        low = low > 0 ? std::fmax(low - step, 0) : low - (step *= 2);
        if (low < -kResponseRules.fastest_back) return {};
        if ((at_low = excess(low)) > 0) break;
        if (low == 0 && stands(amplitude, last.torque)) return Carried{last, true};
      }
    }
    const double ratio =
        closed_in("the speed at a torque", excess, {low, high, at_low, at_high}).nearest();
    if (std::fabs(excess(ratio)) > kResponseRules.torque_kept * waves.traction_bound()) return {};
    return Carried{last, false};
  } catch (const NoWave&) {
    return {};
  }
}

std::optional<HeldWaves::Carried> HeldWaves::carried(const DrivenWaves& waves, double amplitude,
                                                     double speed_ratio, double window) const {
  if (load_.given == Argument::torque) return at_torque(waves, amplitude, speed_ratio, window);
  const DrivenWave wave = waves.at(amplitude, load_.value);
  if (wave.status != PointStatus::ok) return {};
  return Carried{wave, false};
}

HeldWaves::HeldWaves(const DrivenWaves& waves, const RotorLoad& load)
    : waves_(waves), load_(load) {}

HeldWaves::Guess HeldWaves::guess_of(const ResponseWave& wave) const {
  const double crest = waves_.at_frequency(wave.omega).crest_speed_per_amplitude() * wave.amplitude;
  return {wave.omega, wave.speed / crest, wave.torque_slope, wave.standing, &wave.start};
}

std::optional<ResponseWave> HeldWaves::held(double amplitude, double side,
                                            const Guess& guess) const {
  auto wave = solve_by_newton(amplitude, side, guess);
  return wave ? wave : solve_by_secants(amplitude, side, guess);
}

// Solves (D5.1, D5.4) for omega^2 and the speed ratio together, starting from a nearby wave; each step solves one
// contact. Nothing if the iteration does not converge, or converges to another wave.
std::optional<ResponseWave> HeldWaves::solve_by_newton(double amplitude, double side,
                                                       const Guess& guess) const {
  const bool loaded = load_.given == Argument::torque && !guess.standing;
  if (waves_.has_static_excess() || guess.start == nullptr || (loaded && !(guess.torque_slope < 0)))
    return {};
  const double inertia = waves_.modes().mass * amplitude * guess.omega * guess.omega,
               near = kResponseRules.near_ratio +
                      kResponseRules.near_share * std::fabs(guess.speed_ratio);
  ResponseWave wave;
  wave.amplitude = amplitude, wave.standing = guess.standing, wave.start = *guess.start;
  double torque = 0;
  // Residuals of omega^2, relative to the guess, and of the speed ratio.
  const auto residuals = [&](const Pair& x) -> std::optional<Pair> {
    wave.omega = guess.omega * std::sqrt(x[0]);
    const DrivenWaves waves = waves_.at_frequency(wave.omega);
    const double given = load_.given == Argument::speed ? load_.value : 0;
    wave.speed = loaded ? x[1] * waves.crest_speed_per_amplitude() * amplitude : given;
    const DrivenWave found = waves.at(amplitude, wave.speed, &wave.start);
    if (found.status != PointStatus::ok) return {};
    wave.start = found.start, wave.resistive_force = found.balance.imaginary;
    torque = found.torque;
    return Pair{
        (found.balance.real - wanted_force(waves, found, side)) / (inertia * waves.divider()),
        loaded ? (load_.value - torque) / guess.torque_slope : 0};
  };
  Pair x{1, guess.speed_ratio};
  LearnedSlopes slopes;
  auto f = residuals(x);
  for (int i = 0; f && i < kResponseRules.most_broydens; ++i) {
    if (std::fabs((*f)[0]) <= kResponseRules.settled_square &&
        std::fabs((*f)[1]) <= kResponseRules.settled_ratio) {
      if (slopes.second() < kResponseRules.least_slope) return {};
      if (wave.standing && !stands(amplitude, torque)) return {};
      wave.torque_slope = guess.torque_slope * slopes.second();
      return wave;
    }
    const Pair step = slopes.step(*f);
    x[0] += step[0], x[1] += step[1];
    if (!(x[0] > 0.5 && x[0] < 2 && std::fabs(x[1] - guess.speed_ratio) < near)) return {};
    const auto next = residuals(x);
    if (next) slopes.learn(step, {(*f)[0] - (*next)[0], (*f)[1] - (*next)[1]});
    f = next;
  }
  return {};
}

// Friction holds the load if the contact sticks all round and its torque just beyond rest brakes.
bool HeldWaves::stands(double amplitude, double torque_beyond_rest) const {
  return torque_beyond_rest <= load_.value && load_.value <= -torque_beyond_rest &&
         locks_at_rest(waves_.motor(amplitude));
}

double HeldWaves::torque_slope(const DrivenWaves& waves, const DrivenWave& wave) const {
  const double crest = waves.crest_speed_per_amplitude() * wave.amplitude;
  const DrivenWave faster =
      waves.at(wave.amplitude, wave.speed + kResponseRules.slope_step * crest, &wave.start);
  return faster.status == PointStatus::ok
             ? (faster.torque - wave.torque) / kResponseRules.slope_step
             : 0;
}

// Solves (D5.1) for omega^2 by secants that start as Picard steps, since the contact hardly depends on it. Each step
// searches the speed.
std::optional<ResponseWave> HeldWaves::solve_by_secants(double amplitude, double side,
                                                        const Guess& guess) const {
  const double inertia = waves_.modes().mass * amplitude;
  double square = guess.omega * guess.omega, before = 0, step_before = 0, ratio = guess.speed_ratio;
  for (int i = 0; i < kResponseRules.most_secants; ++i) {
    const double omega = std::sqrt(square);
    const DrivenWaves waves = waves_.at_frequency(omega);
    const auto found = carried(waves, amplitude, ratio,
                               i == 0 ? kResponseRules.far_window : kResponseRules.near_window);
    if (!found) return {};
    const WaveBalance<double>& b = found->wave.balance;
    const double step =
        (b.real - wanted_force(waves, found->wave, side)) / (inertia * waves.divider());
    ratio = found->wave.speed / (waves.crest_speed_per_amplitude() * amplitude);
    if (std::fabs(step) <= kResponseRules.settled_square * square) {
      const bool sloped = load_.given == Argument::torque && !found->standing;
      return ResponseWave{0,
                          omega,
                          amplitude,
                          found->wave.speed,
                          found->standing,
                          false,
                          b.imaginary,
                          sloped ? torque_slope(waves, found->wave) : 0,
                          found->wave.start};
    }
    const double slope = i > 0 ? (step - step_before) / (square - before) : -1;
    before = square, step_before = step;
    square += slope < -0.2 && slope > -5 ? -step / slope : step;
    if (!(square > 0)) return {};
  }
  return {};
}

// The least of the conditions (D2.6), in periods of the drive, and with a torque given of (D5.4).
double HeldWaves::margin(const ResponseWave& wave) const {
  const DrivenWaves waves = waves_.at_frequency(wave.omega);
  const DrivenWaves::LevelSlopes s = waves.slopes(wave.amplitude, wave.speed, &wave.start);
  if (s.in_amplitude.wave.status != PointStatus::ok) return -1;
  const Stability flow = waves.stability(s.in_amplitude);
  const double own =
      std::fmin(flow.determinant / (wave.omega * wave.omega), -flow.trace / wave.omega);
  const bool loaded = load_.given == Argument::torque && !wave.standing;
  const double braking = -s.torque_per_speed * waves.crest_speed_per_amplitude() / waves.drive();
  return loaded ? std::fmin(own, braking) : own;
}

// A Newton step for H = Theta u_0 and, if a torque is given, for that torque, at a fixed frequency. Broyden steps
// follow, which solve one contact each.
std::optional<ResponseWave> HeldWaves::solve_to_rounding(ResponseWave wave) const {
  const DrivenWaves waves = waves_.at_frequency(wave.omega);
  const bool loaded = load_.given == Argument::torque && !wave.standing;
  const DrivenWaves::LevelSlopes s = waves.slopes(wave.amplitude, wave.speed, &wave.start);
  const SlopedWave& a = s.in_amplitude;
  // The step for another wave by the derivatives of the first one.
  const auto newton = [&](const DrivenWave& w) -> Pair {
    const double step = 0.5 * (waves.drive() - w.force()) * (waves.drive() + w.force()) / a.fold();
    if (!loaded) return {step, 0};
    const double turn = (load_.value - w.torque - a.torque_slope * step) / s.torque_per_speed;
    return {step + s.amplitude_per_speed * turn, turn};
  };
  DrivenWave found = a.wave;
  LearnedSlopes slopes;
  Pair f = newton(found);
  for (int i = 0; i < kResponseRules.most_polishes && found.status == PointStatus::ok; ++i) {
    const Pair step = slopes.step(f);
    wave.amplitude += step[0], wave.speed += step[1], wave.start = found.start;
    if (!(std::fabs(step[0]) < 0.1 * wave.amplitude)) return {};
    const double crest = waves.crest_speed_per_amplitude() * wave.amplitude;
    if (std::fabs(step[0]) <= kResponseRules.near_root * wave.amplitude &&
        std::fabs(step[1]) <= kResponseRules.near_root * crest)
      return wave;
    found = waves.at(wave.amplitude, wave.speed, &wave.start);
    const Pair next = newton(found);
    slopes.learn(step, {f[0] - next[0], f[1] - next[1]});
    f = next;
  }
  return {};
}

}  // namespace twum::inline v0_1::core
