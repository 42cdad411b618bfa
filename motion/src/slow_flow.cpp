// SPDX-License-Identifier: Apache-2.0
#include "slow_flow.hpp"

#include <cmath>

namespace twum::inline v0_1::motion {

// R + i I is the force that sustains the wave (D2.3); an index is a derivative.
SlowFlow slow_flow(const MotionModel& m, double A, double omega, const ForceSlopes& re,
                   const ForceSlopes& im, const ForceSlopes& T) {
  const double detuning = m.stiffness_of_wave - omega * omega * m.mass;
  const double R = detuning * A + re.value, I = omega * m.damping * A + im.value;
  const double free = std::sqrt((m.stiffness_of_wave + re.value / A) / m.mass);
  const double D = (omega + free) * m.mass, J = m.inertia;
  Eigen::Matrix3d a;
  a << -(omega * m.damping + im.per_amplitude) / D, R / D, -im.per_speed / D,           //
      -(detuning + re.per_amplitude) / (D * A), -I / (D * A), -re.per_speed / (D * A),  //
      T.per_amplitude / J, 0, (T.per_speed - m.load_damping) / J;
  return {D, a};
}

}  // namespace twum::inline v0_1::motion
