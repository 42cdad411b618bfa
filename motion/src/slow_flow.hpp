// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <Eigen/Core>

namespace twum::inline v0_1::motion {

/// A number of the contact and its derivatives in amplitude and speed.
struct ForceSlopes {
  double value, per_amplitude, per_speed;
};

/// Amplitude, phase lag and speed near a wave (M7.1).
struct SlowFlow {
  double divisor;            ///< D = (omega + omega_b) m_s
  Eigen::Matrix3d jacobian;  ///< of their rates
};

SlowFlow slow_flow(const MotionModel& model, double amplitude, double omega,
                   const ForceSlopes& reactive, const ForceSlopes& active,
                   const ForceSlopes& torque);

}  // namespace twum::inline v0_1::motion
