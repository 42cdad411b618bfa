// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/measured_points.hpp"

#include <twum/io/diagnostics.hpp>
#include <twum/io/units.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

/// Role of a column in a table of measurements.
enum class ColumnRole : unsigned char {
  argument,
  time,  ///< since the motor at ambient temperature took up the load
  measured,
  deviation,
  weight,
  parameter,
  unused
};

/// One column.
struct MeasuredColumn {
  ColumnRole role{ColumnRole::measured};
  std::string name;                   ///< of its heading
  Reading reading;                    ///< of a measured one
  Argument argument{Argument::none};  ///< of an argument
  Parameter parameter{};              ///< of a parameter
  std::size_t of{0};                  ///< of a deviation: index of its measured column
  Scale scale;                        ///< of its cells
  std::string unit;                   ///< as typed
  std::string_view expected;          ///< SI unit, static lifetime
  SourceMark mark;                    ///< of its heading
  bool reversed{false};               ///< its values count with the other sign
};

/// A heading as typed, and where it stands.
struct ColumnHeading {
  std::string text;
  SourceMark mark;
  bool chosen{false};    ///< the study says what it is; see ColumnChoice
  bool reversed{false};  ///< its values count with the other sign
  bool unused{false};    ///< whatever its heading says
};

/// True for a heading of a quantity that a table may hold, with or without a unit.
bool is_measured_heading(std::string_view heading);
/// True for a heading of a measured quantity: a metric, a torque, or a part of the impedance.
bool is_reading_heading(std::string_view heading);

/// The heading with the name of a quantity in small letters, where only these are known: "Speed (rpm)" as "speed [rpm]".
std::string with_usual_case(const std::string& heading);

/// The columns of a table of measurements, in their order; see read_measured_points(). If something is wrong, adds
/// errors, and the result is not valid.
std::vector<MeasuredColumn> measured_columns(const std::vector<ColumnHeading>& headings,
                                             SourceMark begin, Diagnostics& diagnostics);

/// Headings without a unit that have a dimension, with the SI unit they are read in: "torque [N.m]".
std::vector<std::string> without_unit(const std::vector<MeasuredColumn>& columns);

/// Headings of the columns that are not used.
std::vector<std::string> unused(const std::vector<MeasuredColumn>& columns);

/// Columns that set a parameter by a letter: "h sets thickness".
std::vector<std::string> by_letter(const std::vector<MeasuredColumn>& columns);

}  // namespace twum::inline v0_1::motors
