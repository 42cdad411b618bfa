// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>

#include <string>

/// Tables of a calibration on the terminal; each is empty where there is nothing to show.
namespace twum::studies {

/// " at 100 rpm" of a torque; " of no_load_speed" of what has no argument.
std::string place_words(const CalibrateResult::Point& point);
/// Numbers that are not all torques, as measured and as fitted.
std::string data_table(const CalibrateResult& result);
/// The next measurements, and the widths of the intervals after them.
std::string plan_table(const CalibrateResult& result);
/// The same where nothing was measured, with what it stands on.
std::string first_plan_words(const CalibrateResult& result);

}  // namespace twum::studies
