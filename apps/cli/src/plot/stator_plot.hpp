// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"

#include <twum/motors/motor_file.hpp>

#include <string>

namespace twum::inline v0_1::cli {

inline constexpr PlotSize kStatorPlotSize{720, 1140};

/// Script of a picture of a stator with a geometry: its cross-section to scale, R over the radius with the contact track, the deflected
/// plate, and the modes
/// of n - 2 to n + 2 over frequency with that of the drive marked.
std::string stator_plot(const studies::MotorFile& file);

}  // namespace twum::inline v0_1::cli
