// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// Every constant of the search for held points.
struct HeldRules {
  /// ln A from wave to wave below the first that carries the torque. Ripples of a layer that rings are longer.
  double longest = 0.04, shortest = 2e-3;
  /// Without ripples: the first step, and how each is longer than the last.
  double first = 0.16, growth = 1.3;
  /// The search ends at this many times the amplitude at which the stator's crest is as fast as the rotor.
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
  /// Torque of a contact that slips and drives all through, the largest with mu_0 = mu.
  double plateau() const;
  LoadedWave at(double amplitude, double omega, const LoadedWave* near = nullptr) const;

  /// Two waves of a frequency between which the torque first reaches the load as the amplitude rises.
  struct Bracket {
    LoadedWave low, high;
  };
  /// Nothing if no amplitude carries the load; `lost` then says whether amplitudes without a periodic state were passed by.
  struct Search {
    std::optional<Bracket> found;
    bool lost{false};
  };
  Search first_reached(double omega) const;
  /// A wave between them, from which Newton's method leads to the load.
  LoadedWave within(const Bracket& ends) const;
  /// The wave between them that carries the load (Y2.1); nothing where the torque jumps past it, or has no periodic state.
  std::optional<LoadedWave> solve_between(Bracket ends) const;
  /// The wave that carries the load at another frequency, from one that is known; nothing if Newton's method leads elsewhere.
  std::optional<LoadedWave> solve_at_frequency(const LoadedWave& known, double omega) const;

 private:
  std::optional<LoadedWave> peak_between(const LoadedWave& low, const LoadedWave& high) const;
  LoadedWave below_load(double omega) const;
  bool is_monotone() const;
  double next_step(const LoadedWave& from, double last) const;

  const DrivenWaves& waves_;
  double torque_, speed_;
};

}  // namespace twum::inline v0_1::core
