// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motion/motion.hpp>

#include <vector>

namespace twum::inline v0_1::motion {

/// A number that is linear in time.
struct Ramp {
  double begin, value, slope;
  double at(double time) const { return value + slope * (time - begin); }
};

/// A part of a motion without kinks of its inputs.
struct Stretch {
  double begin, end;
  Ramp voltage, amplitude, frequency, load_torque, phase_difference;
  bool off;
  double direction;  ///< of the wave, 1 or -1
};

/// The first values, before a step at the beginning, with the drive on.
Stretch before_the_first(const MotionTask& task);

/// Of the duration: times that are closer are one.
inline constexpr double kSameTime = 1e-12;

/// The stretches of a motion, in their order. Each time at which an input has a kink ends one of them, once.
/// @param more  times at which stretches end besides
/// @throws InputError for a task that is not admissible.
std::vector<Stretch> stretches_of(const MotionTask& task, bool driven,
                                  const std::vector<double>& more = {});

}  // namespace twum::inline v0_1::motion
