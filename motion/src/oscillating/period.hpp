// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oscillating/two_waves.hpp"

#include <twum/motion/motion.hpp>

namespace twum::inline v0_1::motion {

/// A number x_1 + i x_2 of both modes or phases, x_1 + i x_2 = f e^(i psi) + b e^(-i psi).
struct BothWays {
  Complex forward{}, backward{};  ///< f and b

  BothWays over(double count) const { return {forward / count, backward / count}; }
  /// Phasor of x_1 (0) or x_2 (1): x_1 = Re (f + b*) e^(i psi), x_2 = Re -i (f - b*) e^(i psi).
  Complex phasor(int number) const {
    const Complex other = std::conj(backward);
    return number == 0 ? forward + other : -kI * (forward - other);
  }
};

/// What an oscillating motor does within one period of the drive.
class Period {
 public:
  Period() = default;
  Period(double time, const WavesState& state, double energy)
      : begin_(time), angle_(state.angle), energy_(energy) {}

  /// The state after a step. Displacements and velocities together part both waves at every instant (M9.4).
  void add(const WavesState& state, double phase, double omega);

  /// Means over the period: zeta of both waves, and the phasors of the voltages.
  BothWays displacement() const { return displacement_.over(steps_); }
  BothWays voltage() const { return voltage_.over(steps_); }
  /// The period as a sample at its middle. @param work  within it
  MotionSample sample(double end, const WavesState& state, const WavesWork& work) const;

 private:
  double begin_{0}, angle_{0}, energy_{0};  // at its beginning
  double steps_{0};
  BothWays displacement_{}, voltage_{};  // sums
};

/// Numbers at a time between those of two samples, which change evenly.
MotionSample between(const MotionSample& earlier, const MotionSample& later, double time);

}  // namespace twum::inline v0_1::motion
