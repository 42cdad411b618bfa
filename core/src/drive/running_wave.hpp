// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// The motor under its running wave at a speed, from the waves of this speed and of rest alone: the largest wave, where it drives, is
/// stable and lags by more than a quarter of a turn, and its piece of the curve of waves is no dead one from rest. Null where this
/// does not tell, next to a fold, backwards, and with mu_0 > mu, where pieces are found from pieces beside them.
/// @param speed  [rad/s]
std::optional<MotorPoint> running_point(const DrivenWaves& waves, double speed);

}  // namespace twum::inline v0_1::core
