// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"

#include <twum/core/frequency_response.hpp>
#include <twum/motors/motor_file.hpp>

#include <optional>
#include <vector>

namespace twum::cli {

inline constexpr PlotSize kFrequencyPlotSize{760, 820};

/// What a picture of a response shows.
struct FrequencyPicture {
  std::vector<ResponseBranch> branches;
  std::vector<Jump> jumps;
  double from, to;                 // [Hz]
  double operating;                // the drive's own frequency [Hz]
  std::optional<double> pull_out;  // below which the running wave ends [Hz]
  bool at_speed;                   // the speed is given: the torque is shown
};

/// Amplitude, speed or torque, powers and current over the frequency: unstable waves dashed, jumps as arrows, the operating
/// frequency and its margin to the pull-out marked.
std::string frequency_plot(const studies::MotorFile& file, const FrequencyPicture& picture);

}  // namespace twum::cli
