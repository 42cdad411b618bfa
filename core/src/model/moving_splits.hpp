// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

#include <span>

namespace twum::inline v0_1::core {

/// The splits of a track at a speed, in S. Those at jumps move with parameters, wave and speed, by the implicit function
/// theorem (W4.5); all others may stand still, since the means have no step there (W4.4).
template <typename S>
Vector<SplitPlace<S>> moving_splits(const DrivenMotor<S>& motor, const S& speed,
                                    std::span<const Split> splits);

}  // namespace twum::inline v0_1::core
