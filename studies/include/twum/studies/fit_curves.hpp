// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>
#include <twum/studies/study_file.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A measured quantity of the fitted motor, along what the bench varied.
struct FitCurve {
  std::string quantity;  ///< such as "torque_at"
  std::string unit;      ///< its SI unit
  NamedValue over;       ///< "speed", "torque", "time", or a parameter that the bench set; value 0
  std::vector<NamedValue>
      set;                 ///< further parameters that the bench had set; over "time" the load too
  std::string file;        ///< table with values of its own; empty: all
  std::vector<double> at;  ///< places, from the least on [SI]
  std::vector<double> value;  ///< there [SI]; NaN where the motor has none
  std::vector<double> low;    ///< lower edge of the confidence band (L3.3) [SI]; NaN without one
  std::vector<double> high;   ///< its upper edge [SI]
  std::vector<std::size_t> points;  ///< numbers of the measured points on it
};

/// "b.csv" of a point that stands at "b.csv:12".
std::string table_of(const CalibrateResult::Point& point);
/// The speed or torque that a point was read at, under its name.
NamedValue load_of(const CalibrateResult::Point& point);
/// What the bench varied for a quantity: the time under a load, the speed or torque that it is read at, else the parameter with most values; none
/// if all were read alike.
std::optional<NamedValue> axis_of(const std::vector<CalibrateResult::Point>& data,
                                  const CalibrateResult::Point& point);
/// Where on this axis a point was read [SI]; 0 for a speed without load and a torque at rest; NaN if the bench did not say.
double place_on(const CalibrateResult::Point& point, const NamedValue& over);

/// The curves that the measured points lie on: one for each quantity, setting of the bench and table with values of its
/// own. Readings without anything that the bench varied have none.
std::vector<FitCurve> fit_curves(const StudyFile& study, const CalibrateResult& result);

}  // namespace twum::inline v0_1::studies
