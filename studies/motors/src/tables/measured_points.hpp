// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/source.hpp>

#include "metrics/circuit_quantity.hpp"
#include "tables/measured_table.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace twum::inline v0_1::motors {

/// A measured quantity: a metric of the motor, or a part of the impedance of its free stator.
using Reading = std::variant<MetricRequest, CircuitPart>;

/// As in a heading, such as "torque_at" or "conductance"; static lifetime.
std::string_view name_of(const Reading& reading);
/// Its SI unit; static lifetime.
std::string_view unit_of(const Reading& reading);
/// Whether two readings are of the same quantity, at any speed or torque.
bool same_kind(const Reading& a, const Reading& b);
/// Whether two readings have errors of one size: those of one quantity, and both parts of a complex number.
bool same_scale(const Reading& a, const Reading& b);

/// One number that was read.
struct MeasuredPoint {
  Reading reading;      ///< what it is, and at which speed or torque
  double value{0};      ///< SI
  double weight{1};     ///< of its squared residual
  double deviation{0};  ///< standard deviation, SI; 0: not given
  /// parameters that were set on the bench, in place of the motor's
  std::vector<ParameterValue> set = {};
  SourceMark cell{};     ///< place of its cell in the table
  SourceMark heading{};  ///< of its column
  std::size_t table{0};  ///< number of its table among several
};

/// A torque read at a rotor speed that the test stand sets; SI.
MeasuredPoint torque_point(double speed, double torque, double weight = 1, double deviation = 0);

/// What a table of measured points holds.
struct MeasuredPoints {
  std::vector<MeasuredPoint> points;
  std::vector<std::string>
      without_unit;  ///< headings without a unit, and the SI unit they are read in: "torque [N.m]"
  std::vector<std::string>
      by_letter{};  ///< columns that set a parameter by a letter: "h sets thickness"
  std::vector<std::pair<Parameter, SourceMark>> set{};  ///< columns of parameters that were set
  std::vector<std::string> unused{};                    ///< headings of columns that are not read
  std::string
      instrument{};  ///< "an impedance analyser's table of R and X"; empty: headings of twum or chosen ones
};

/// Reads a table of measurements. Columns are
///
/// * `speed` or `torque`: the operating point that the bench sets, at which metrics such as electrical_power_at are
///   read; beside `speed`, `torque` is a reading;
/// * `time`, beside temperatures: since the motor, at ambient temperature, took up the load of the row; without it they are
///   steady;
/// * metrics by name, and conductance, susceptance, resistance, reactance, impedance and impedance_phase of a phase of the
///   free stator: readings; a cell may be empty if its row has another reading;
/// * `NAME_sd`: the standard deviation s of column NAME, which gives the weight 1 / s^2; or `weight`;
/// * parameters by name: values that were set in place of the motor's;
/// * those of an impedance analyser (instrument_headings.hpp), and those that `choices` name. Others are not used.
///
/// The weights have the mean 1.
/// @throws FileError with everything that is wrong in it
/// @{
MeasuredPoints read_measured_points(const MeasuredTable& table,
                                    const std::vector<ColumnChoice>& choices);
/// The same of a file as it is.
MeasuredPoints read_measured_points(const Source& source,
                                    const std::vector<ColumnChoice>& choices = {});
/// @}

/// The points of several files as one table. Points of several kinds have the weight 1 / s^2; otherwise weights are
/// scaled to the mean 1.
/// @throws InputError if points of several kinds, or only some of the points, have no standard deviation
MeasuredPoints joined(std::vector<MeasuredPoints> files);

}  // namespace twum::inline v0_1::motors
