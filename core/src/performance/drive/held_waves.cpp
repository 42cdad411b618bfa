// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/held_waves.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace twum::performance {
namespace {

constexpr double kSettledSquare = 1e-14;  // of omega^2
constexpr int kMostPicards = 40;
constexpr double kFarWindow = 0.02, kNearWindow = 1e-3;     // of the speed ratio
constexpr double kFastestSought = 1.5, kSoughtStep = 0.05;  // speed ratios looked at for a load
constexpr double kFastestBack = 1e3;  // at tiny waves any load turns the rotor fast
constexpr double kNearRoot = 1e-8;    // of the amplitude: Newton's step leaves its square
constexpr int kMostNewtons = 10;
constexpr double kTorqueKept = 1e-9;  // of mu_0 F_N r: more off is a jump and no root

}  // namespace

double root_between(const std::function<double(double)>& f, double low, double high, double at_low,
                    double at_high) {
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  std::uintmax_t most = 60;
  const auto [x, y] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(51), most);
  return std::fabs(f(x)) < std::fabs(f(y)) ? x : y;
}

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
      high = kFastestSought, at_high = excess(high);
      if (at_high > 0) return {};
      low = high;
      for (double step = kSoughtStep; true; high = low, at_high = at_low) {
        low = low > 0 ? std::fmax(low - step, 0) : low - (step *= 2);
        if (low < -kFastestBack) return {};
        if ((at_low = excess(low)) > 0) break;
        // At rest friction holds the load in a contact that is locked all round.
        if (low == 0 && locks_at_rest(waves.motor(amplitude)) && load_.value <= -last.torque)
          return Carried{last, true};
      }
    }
    const double ratio = root_between(excess, low, high, at_low, at_high);
    if (std::fabs(excess(ratio)) > kTorqueKept * waves.traction_bound()) return {};
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

HeldWaves::Guess HeldWaves::guess_of(const ResponseWave& wave) const {
  const double crest = waves_.at_frequency(wave.omega).crest_speed_per_amplitude() * wave.amplitude;
  return {wave.omega, wave.speed / crest};
}

// Picard's steps for omega^2 (D5.1), which the contact hardly feels, made secants.
std::optional<ResponseWave> HeldWaves::held(double amplitude, double side,
                                            const Guess& guess) const {
  const double inertia = waves_.modes().mass * amplitude;
  double square = guess.omega * guess.omega, before = 0, step_before = 0, ratio = guess.speed_ratio;
  for (int i = 0; i < kMostPicards; ++i) {
    const double omega = std::sqrt(square);
    const DrivenWaves waves = waves_.at_frequency(omega);
    const auto found = carried(waves, amplitude, ratio, i == 0 ? kFarWindow : kNearWindow);
    if (!found) return {};
    const WaveBalance<double>& b = found->wave.balance;
    const double room = (waves.drive() - b.imaginary) * (waves.drive() + b.imaginary);
    const double wanted = room > 0 ? -side * std::sqrt(room) : 0;
    const double step = (b.real - wanted) / inertia;
    ratio = found->wave.speed / (waves.crest_speed_per_amplitude() * amplitude);
    if (std::fabs(step) <= kSettledSquare * square)
      return ResponseWave{
          0, omega, amplitude, found->wave.speed, found->standing, false, found->wave.start};
    const double slope = i > 0 ? (step - step_before) / (square - before) : -1;
    before = square, step_before = step;
    square += slope < -0.2 && slope > -5 ? -step / slope : step;
    if (!(square > 0)) return {};
  }
  return {};
}

// (D2.6), and with a torque given (D5.4).
bool HeldWaves::lasts(const ResponseWave& wave) const {
  const DrivenWaves waves = waves_.at_frequency(wave.omega);
  const bool loaded = load_.given == Argument::torque && !wave.standing;
  if (!loaded)
    return waves.stability(waves.in_amplitude(wave.amplitude, wave.speed, &wave.start)).stable();
  const DrivenWaves::LevelSlopes s = waves.slopes(wave.amplitude, wave.speed, &wave.start);
  return waves.stability(s.in_amplitude).stable() && s.torque_per_speed() < 0;
}

// Newton's steps for H = Theta u_0 and, where a torque is given, for that torque, both at one frequency.
std::optional<ResponseWave> HeldWaves::polished(ResponseWave wave) const {
  const DrivenWaves waves = waves_.at_frequency(wave.omega);
  const bool loaded = load_.given == Argument::torque && !wave.standing;
  for (int i = 0; i < kMostNewtons; ++i) {
    const DrivenWaves::LevelSlopes s = waves.slopes(wave.amplitude, wave.speed, &wave.start);
    const SlopedWave& a = s.in_amplitude;
    if (a.wave.status != PointStatus::ok) return {};
    const double force = a.wave.force(),
                 excess = 0.5 * (force - waves.drive()) * (force + waves.drive());
    double step = -excess / a.fold(), turn = 0;
    if (loaded) {
      const double missing = load_.value - a.wave.torque;
      turn = (missing - a.torque_slope * step) / s.torque_per_speed();
      step += s.amplitude_per_speed() * turn;
    }
    wave.amplitude += step, wave.speed += turn, wave.start = a.wave.start;
    if (!(std::fabs(step) < 0.1 * wave.amplitude)) return {};
    const double crest = waves.crest_speed_per_amplitude() * wave.amplitude;
    if (std::fabs(step) <= kNearRoot * wave.amplitude && std::fabs(turn) <= kNearRoot * crest)
      return wave;
  }
  return {};
}

}  // namespace twum::performance
