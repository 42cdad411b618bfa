// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stretches.hpp"

#include <twum/motion/motion.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace twum::inline v0_1::motion {

/// Takes a speed into the largest of a motion.
inline void take_speed(Motion& motion, double speed) {
  if (std::fabs(speed) > std::fabs(motion.fastest)) motion.fastest = speed;
}

/// A motor that is followed in time, stretch after stretch.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  /// Takes the state at the beginning, under the first values of drive and load.
  virtual void begin(const Stretch& first) = 0;
  /// Follows a stretch to its end. False where the motion ends early.
  virtual bool follow(const Stretch& stretch) = 0;
  /// theta_r at the end of the last stretch, or at the beginning [rad].
  virtual double angle() const = 0;
  /// Omega there [rad/s].
  virtual double speed() const = 0;
  /// What was computed, with samples up to the end of the last stretch.
  virtual Motion finish() = 0;
};

/// The engine of a task; `design` and `task` have to outlive it.
/// @throws InputError as simulate()
std::unique_ptr<Engine> engine_of(const MotorDesign& design, const MotionTask& task);

/// Takes an engine to the beginning of a task, whose stretches are given.
void begin(Engine& engine, const MotionTask& task, const std::vector<Stretch>& stretches);

/// The motion that an engine makes of a task.
Motion followed(Engine& engine, const MotionTask& task, const std::vector<Stretch>& stretches);

}  // namespace twum::inline v0_1::motion
