// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum {

/// The wave that runs against the driven one, to first order in its amplitude (theory of the driven stator, section 6). What is
/// not known is NaN: all of it where a layer that has damping or inertia, or mu_0 > mu, sticks somewhere, and in full contact
/// with stick; all but fed_damping without modal data.
struct BackwardWave {
  double ratio;  ///< |z| / A, what unequal phases and modes force (D6.5); 0 without them [1]
  double standing_wave_ratio;  ///< (A + |z|) / (A - |z|) [1]
  double first_current;        ///< of the first phase, rms (D6.6) [A]
  double second_current;       ///< of the second [A]
  /// Damping that friction feeds a free backward wave with (D6.8): it grows where this is more than the stator's
  /// modal_damping. Without modal data at the frequency of the drive, to which that wave's is near [N s/m].
  double fed_damping;
  double squeal_rate;  ///< at which the free wave grows (D6.7) [1/s]
};

}  // namespace twum
