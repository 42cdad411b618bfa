// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/motors/motor_file.hpp>

namespace twum::inline v0_1::cli {

/// Torque, powers and efficiency against speed between `first` and `last` [rad/s].
Picture curve_picture(const studies::MotorFile& file, double first, double last);

}  // namespace twum::inline v0_1::cli
