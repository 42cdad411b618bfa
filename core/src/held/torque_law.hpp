// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

namespace twum::inline v0_1::core {

/// Roughly the torque over the amplitude at a speed, in closed form (Y2.7): where the search for a held wave begins. Of an elastic
/// layer two waves are known. One carries nothing and sticks all through, V = sin theta_L / theta_L. One just slips all through
/// and carries T_p, V = cos theta_L - mu sin theta_L / s. Towards the second T_p - T goes with the cube of the distance. A layer
/// with inertia carries the same at a smaller amplitude.
class TorqueLaw {
 public:
  TorqueLaw(const DrivenWaves& waves, double speed);

  /// A of the wave that carries a share of T_p, which is less than 1 [m].
  double amplitude(double share) const;

 private:
  double soft_;   ///< A (sin theta_L - theta_L cos theta_L), from (T3.2) [m]
  double steep_;  ///< mu / s
  double slow_;   ///< V / (sin theta_L - theta_L cos theta_L)
  double rings_;  ///< root of M
};

/// Force of the traction in phase with the wave, of a contact that carries a share of T_p (Y2.8) [N].
double likely_traction(const DrivenMotor<double>& motor, double speed, double share);

}  // namespace twum::inline v0_1::core
