// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/source.hpp>
#include <twum/motors/column_choice.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

/// A table of measurements as plain CSV, each line where it was in the file.
struct MeasuredTable {
  Source source;
  std::string kind;  ///< what the file was besides: "Touchstone, ..."; empty: plain CSV
};

/// Largest file of measurements [bytes].
inline constexpr std::size_t kLargestMeasurements = std::size_t{64} << 20U;

/// Reads a file of a test stand, a logger, a spreadsheet, or of an impedance analyser (CSV or Touchstone).
/// @throws InputError if it cannot be read, or is no text
/// @{
MeasuredTable read_measured_table(const std::string& path,
                                  const std::vector<ColumnChoice>& choices = {});
MeasuredTable measured_table(const Source& source, const std::vector<ColumnChoice>& choices = {});
/// @}

}  // namespace twum::inline v0_1::motors
