// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"
#include "solid/solid_stator.hpp"

#include <twum/motors/motor_file.hpp>

#include <string>

namespace twum::inline v0_1::cli {

inline constexpr PlotSize kSolidPlotSize{720, 640};

/// Script of a picture of the wave of a stator as a solid: R over the radius beside that of the plate, and the cross-section
/// through a tooth at the crest of the wave.
std::string solid_plot(const studies::MotorFile& file, const SolidStator& solid);

}  // namespace twum::inline v0_1::cli
