// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/drive/driven_wave.hpp"

#include <vector>

namespace twum::performance {

/// A wave that the drive holds at a speed: a root of H(A) = Theta u_0 (D2.4).
struct WaveSolution {
  SlopedWave sloped;
  Stability stability;
  bool past_maximum;  ///< H has a maximum at a smaller amplitude
  bool only_one;      ///< H has no extremum: each voltage holds one wave, running and dead alike

  const DrivenWave& wave() const { return sloped.wave; }
  /// Behind the drive by more than a quarter of a turn, or beyond the maximum that a start has to pass.
  bool beyond_start() const { return past_maximum || wave().balance.real <= 0; }
  bool running() const { return stability.stable() && (beyond_start() || only_one); }
};

struct WaveSolutions {
  std::vector<WaveSolution> found;
  long zones;  ///< followed: what the search cost
};

/// An extremum of H over the amplitude: with rising voltage the motor starts at a maximum, with falling
/// voltage it stops at a minimum.
struct ForceExtremum {
  double amplitude, force;  ///< [m], [N]
  bool maximum;
  double bend;  ///< H_AA, negative at a maximum [N/m^2]
  /// Amplitude beyond a kink, where a zone begins or ends and H_A jumps past zero; then `amplitude` is the one below it. 0 where
  /// H_A is zero.
  double beyond_kink{0};
};

/// All solutions at a speed, the smallest amplitude first (D2.8): H is sampled over all possible amplitudes, its
/// extrema between samples are refined, and each change of sign is bisected. Amplitudes whose contact has no periodic
/// state are skipped. Takes 20 microseconds with an elastic layer, 70 with inertia.
WaveSolutions wave_solutions(const DrivenWaves& waves, double speed);

/// The same where all extrema of H at that speed are known, and every amplitude has a periodic state: each change of sign lies
/// between two of them. A third of the work.
WaveSolutions wave_solutions(const DrivenWaves& waves, double speed,
                             const std::vector<ForceExtremum>& extrema);

/// All extrema of H at a speed, the smallest amplitude first. None where the drive's frequency is not above the
/// free stator's resonance.
std::vector<ForceExtremum> force_extrema(const DrivenWaves& waves, double speed);

struct LeastForce {
  double amplitude, force;  ///< [m], [N]
};

/// The minimum of H between two amplitudes, if it has one, else the smaller end.
LeastForce least_force(const DrivenWaves& waves, double speed, double low, double high);

}  // namespace twum::performance
