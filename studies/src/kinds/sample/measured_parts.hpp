// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/studies/robust_question.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A table of measured parts; internal.
struct PartsTable {
  MeasuredParts parts{};
  std::string name{};  ///< of the file, without its folder; empty: there is no table
  /// Reasons to doubt the answer: how the file was read, and columns that are neither parameters nor the weight.
  std::vector<std::string> notes{};

  std::vector<std::string> notes_after(std::vector<std::string> list) const {
    list.insert(list.end(), notes.begin(), notes.end());
    return list;
  }
};

/// Reads a table with a column for each parameter, as designs have them, and if need be `weight`: how often a part is drawn
/// compared with the others.
/// @param path    as typed in the study; empty: no table
/// @param folder  of the study file
/// @throws InputError with file, line, column, what was found and what would be right
PartsTable read_parts(const std::string& path, const std::string& folder, const MotorDesign& base);

/// @throws InputError if one of the parameters is a column of the table too
/// @param entry  of the study, in which the parameter stands
void check_apart(const PartsTable& table, Parameter parameter, std::string_view entry);

}  // namespace twum::inline v0_1::studies
