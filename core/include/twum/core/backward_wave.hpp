// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1 {

/// The wave that runs against the driven one, to first order in its amplitude (theory of the driven stator, section
/// 6). Unknown numbers are NaN. All are unknown in full contact with stick, with radial_motion, and where some of the layer sticks
/// and the layer has damping or inertia, or mu_0 > mu. Without modal data all but fed_damping are unknown.
struct BackwardWave {
  double ratio;  ///< |z| / A, driven by unequal phases and modes (D6.5); 0 if they are equal [1]
  double standing_wave_ratio;  ///< (A + |z|) / (A - |z|) [1]
  double first_current;        ///< of the first phase, rms (D6.6) [A]
  double second_current;       ///< of the second [A]
  /// Negative damping that friction gives a free backward wave (D6.8) [N s/m]. The wave grows where this is more than
  /// the stator's modal_damping. Without modal data it is taken at the drive frequency, which is near that of the
  /// wave.
  double fed_damping;
  double squeal_rate;  ///< growth rate of the free backward wave (D6.7) [1/s]
};

}  // namespace twum::inline v0_1
