// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/motor_file.hpp>

#include <string>

namespace twum::inline v0_1::cli {

inline constexpr PlotSize kFieldsPlotSize{720, 860};

/// Script of a picture of pressure, traction with its friction bounds, and surface velocities over the
/// contact, on a background coloured by zone. The point has to have an answer.
std::string fields_plot(const studies::MotorFile& file, double speed);

/// Script of maps of pressure and slip speed over phase and radius, with the ends of the stick zones; of a motor with several
/// slices. The point has to have an answer.
std::string fields_map(const studies::MotorFile& file, double speed);

}  // namespace twum::inline v0_1::cli
