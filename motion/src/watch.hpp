// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"

#include <twum/motion/motion.hpp>

#include <vector>

namespace twum::inline v0_1::motion {

inline constexpr double kStarted =
    3;  ///< times A_1, a wave that has started: the contact has opened over most of it
/// Of the holding torque, by which a rotor drives the wave: more than the ripple of a steady run.
inline constexpr double kOverrunShare = 0.01;

/// Looks for the events that change nothing: the wave starts or pulls out, the rotor overruns it.
class Watch {
 public:
  explicit Watch(Equations& equations) : equations_(&equations) {}

  /// Forgets the largest amplitude: the rotor was released in this state.
  void released(double amplitude) { largest_ = amplitude; }
  /// Events within the last step of the integrator, in the order of time.
  std::vector<MotionEvent> events(const Integrator& integrator, double begin);

 private:
  /// Distance from an event, which happens where it falls through zero.
  double distance(MotionEventKind kind, double time, const Integrator& integrator) const;
  bool looks_for(MotionEventKind kind) const;
  double pull_out_amplitude() const;

  Equations* equations_;
  double largest_{0};     ///< amplitude since the release
  bool overruns_{false};  ///< and has not driven since
};

}  // namespace twum::inline v0_1::motion
