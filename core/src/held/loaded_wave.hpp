// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// Every constant of the search for held points.
struct HeldRules {
  /// ln A from wave to wave below the first that carries the torque. A step is as long as `longest` only where the torque rises or
  /// falls evenly along it; ripples of a layer that rings are longer than `finest`, jumps (mu_0 > mu) are approached by steps down
  /// to `shortest`.
  double longest = 0.2, finest = 0.04, shortest = 2e-3;
  /// Even: the slopes at both ends are no more than this many times the mean slope, and no less than that part of it.
  double even = 2;
  /// Of the distance at which the torque is expected: most often it is reached then.
  double beyond = 1.2;
  /// Damping over inertia of a layer, C / M, from which on it does not ring in a partial contact.
  double dies_away = 1.5;
  /// ln A of the longest step towards a load of which one side is not known yet.
  double blind = 0.5;
  /// What a step leaves of the difference from the load, at most, unless the bracket is to be halved.
  double fast = 0.25;
  /// The search ends at this many times the amplitude at which the stator's crest is as fast as the rotor.
  double farthest = 1e4;
  int most_steps = 400, most_tries = 80;
  /// Last step of A, and of omega, which is not solved again.
  double settled = 1e-12;
  /// Accuracy of the layer's states of a wave that is expected to be off by more, of itself, and only leads to others.
  double crude = 1e-6;
  /// T_p - T goes with the cube of A_p - A: closer to the plateau the amplitude is not determined.
  double reach = 1 - 1e-6;
  /// Of the torque's scale: a larger step of the torque between two amplitudes that rounding cannot part is a jump.
  double jump = 1e-9;
  /// Of A: where a peak of the torque is known well enough to tell whether it carries the load.
  double peak = 1e-6;
  /// Newton's steps for amplitude and frequency together, and the longest of them, of themselves.
  int most_newtons = 12;
  double longest_newton = 0.5;
  /// Of the design's frequency: so far from it a likely wave is as good with a crest as fast.
  double nearby = 0.03;
  /// Last step of the frequency, of itself, of a wave that only leads to others.
  double beside_flank = 3e-3;
  /// Of the least voltage that a load needs: so little above it the waves of a flank turn back, and so little is rounding.
  double near_least = 1e-3, just_enough = 2e-11;
  /// Largest step of the frequency, of itself.
  double longest_in_frequency = 0.05;
  /// A likely amplitude is right to some per cent, so that it may lie on the plateau, where no slope leads back: by what part of
  /// itself it is then lessened. How often that is done, or a step halved that leads there.
  double back = 0.04;
  int most_back = 4;
};
inline constexpr HeldRules kHeldRules{};

/// A wave at a speed, with the derivatives of its torque and of its force from the drive in amplitude and frequency.
struct LoadedWave {
  double amplitude{0}, omega{0};
  double accuracy{0};     ///< of the layer's states, as find_periodic_state()
  bool off_flank{false};  ///< no frequency of (Y2.3) was found for it
  SolvedPoint solved;
  double torque{0};
  double root{0};                   ///< cube root of T_p - T
  WaveBalance<double> force{0, 0};  ///< R and I of the drive's force (D2.3)
  /// Of a wave that is differentiated. @{
  double torque_in_amplitude{0}, torque_in_omega{0};
  WaveBalance<double> in_amplitude{0, 0}, in_omega{0, 0};
  MovingStates states;  ///< how the layer moves with the wave
  /// @}

  bool ok() const { return solved.status == PointStatus::ok && !off_flank; }
  bool exact() const { return accuracy == 0; }
  /// Takes the derivatives of a wave next to it.
  void take_slopes(LoadedWave&& near);
};

/// A motor at one speed under one load, whose drive follows.
class LoadedWaves {
 public:
  LoadedWaves(const DrivenWaves& waves, double speed);

  /// From now on the load is another one; at first it is none.
  void carry(double torque);

  double torque() const { return torque_; }
  /// Torque of a contact that slips and drives all through, the largest with mu_0 = mu.
  double plateau() const { return plateau_; }
  /// Cube root of what the load leaves of it.
  double root() const { return root_; }

  /// A wave without its derivatives; `near` is one that has them.
  LoadedWave found(double amplitude, double omega, const LoadedWave* near = nullptr,
                   double accuracy = 0) const;
  void differentiate(LoadedWave& wave) const;
  /// Both.
  LoadedWave at(double amplitude, double omega, const LoadedWave* near = nullptr,
                double accuracy = 0) const;
  /// Moves a wave that is differentiated to another frequency, to first order.
  void move(LoadedWave& wave, double omega_step) const;
  /// How well the layer's states of a wave have to be known.
  /// @param off  what Newton's method leaves of it: the square of its step, of itself
  static double accuracy_of(double off) { return off > kHeldRules.crude ? kHeldRules.crude : 0; }
  /// What a wave lacks of the load, as Newton's method for the cube root of T_p - T sees it [N m].
  double missing(const LoadedWave& wave) const;

  /// A wave of a frequency that carries about the load, whether that is its first or not. Nothing if there is no telling: with
  /// mu_0 > mu, which makes the torque jump, or if its layer has no periodic state.
  /// @param amplitude  a guess, such as likely_amplitude()
  std::optional<LoadedWave> likely(double amplitude, double omega) const;
  /// The whole contact slips and drives: no slope leads back.
  static bool on_plateau(const LoadedWave& w) { return w.ok() && w.solved.drives(); }
  double likely_amplitude(double omega) const;
  /// The layer's own oscillation outlives a contact: C < 1.5 M.
  bool rings(double omega) const;
  /// T(A) is known to rise up to its plateau.
  bool surely_rises(double omega) const;
  /// mu_0 > mu: T(A) jumps.
  bool jumps() const { return waves_.has_static_excess(); }
  /// A of the wave whose crest is as fast as the rotor [m].
  double crest_amplitude(double omega) const {
    return speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude();
  }
  /// The frequency at which a force, apart from that of the wave's own mass, is less by `gap` [rad/s].
  double omega_beside(double omega, double gap, double amplitude) const;

 private:
  const DrivenWaves& waves_;
  double speed_, plateau_;
  double torque_{0};
  double root_{0};  // cube root of T_p - T_L
};

}  // namespace twum::inline v0_1::core
