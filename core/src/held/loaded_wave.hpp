// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <optional>

namespace twum::core {

/// Every constant of the search for held points.
struct HeldRules {
  /// ln A from wave to wave below the first that carries the torque. Ripples of a layer that rings are longer.
  double longest = 0.04, shortest = 2e-3;
  /// The search begins where the stator's crest is as fast as the rotor, and ends at this many times that amplitude.
  double farthest = 1e4;
  int most_steps = 400, most_tries = 80;
  /// Last step of A, and of omega, which is not solved again.
  double settled = 1e-12;
  /// T_p - T goes with the cube of A_p - A: closer to the plateau the amplitude is not determined.
  double reach = 1 - 1e-6;
  /// Of the torque's scale: a larger step of the torque between two amplitudes that rounding cannot part is a jump.
  double jump = 1e-9;
  /// Of A: where a peak of the torque is known well enough to tell whether it carries the load.
  double peak = 1e-6;
  /// Newton's steps for amplitude and frequency together, and the longest of them, of themselves.
  int most_newtons = 12;
  double longest_newton = 0.5;
  /// Largest step of the frequency, of itself.
  double longest_in_frequency = 0.05;
};
inline constexpr HeldRules kHeldRules{};

/// A wave at a speed, with the derivatives of its torque and of its force from the drive in amplitude and frequency.
struct LoadedWave {
  double amplitude{0}, omega{0};
  double torque{0}, torque_in_amplitude{0}, torque_in_omega{0};
  /// R and I of the drive's force (D2.3) and their derivatives.
  WaveBalance<double> force{0, 0}, in_amplitude{0, 0}, in_omega{0, 0};
  DrivenWaves::LevelSlopes slopes{};

  bool ok() const { return slopes.solved.status == PointStatus::ok; }
};

/// A motor at one speed under one load, whose drive follows.
class LoadedWaves {
 public:
  LoadedWaves(const DrivenWaves& waves, double torque, double speed)
      : waves_(waves), torque_(torque), speed_(speed) {}

  double torque() const { return torque_; }
  /// Torque of a contact that slips and drives all through; with mu_0 > mu a few per cent more are possible.
  double plateau() const;
  LoadedWave at(double amplitude, double omega, const LoadedWave* near = nullptr) const;
  /// The wave of the smallest amplitude that carries the torque at a frequency (Y2.1); nothing if none does.
  std::optional<LoadedWave> smallest(double omega) const;
  /// A wave near it, from which Newton's method leads there.
  std::optional<LoadedWave> near_smallest(double omega) const;
  /// The same near a wave that is known, by Newton's method; nothing if that leads elsewhere.
  std::optional<LoadedWave> near(const LoadedWave& known, double omega) const;

 private:
  /// Two waves between which the torque reaches the load.
  struct Bracket {
    LoadedWave low, high;
  };
  std::optional<LoadedWave> between(Bracket ends) const;
  std::optional<LoadedWave> peak_between(const LoadedWave& low, const LoadedWave& high) const;
  std::optional<Bracket> first_bracket(double omega) const;
  bool is_monotone() const;

  const DrivenWaves& waves_;
  double torque_, speed_;
};

}  // namespace twum::core
