// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"

#include <twum/motors/motor_file.hpp>

#include <string>

namespace twum::cli {

inline constexpr PlotSize kCurvePlotSize{720, 860};

/// Script of a picture of torque, powers and efficiency against speed, with stall, plateau, peak power
/// and no-load marked where they are between `first` and `last` [rad/s].
std::string curve_plot(const studies::MotorFile& file, double first, double last);

}  // namespace twum::cli
