// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <map>
#include <string>
#include <vector>

namespace twum::test {

/// A row of a CSV file: column name -> value.
using Row = std::map<std::string, double>;

/// Rows of a plain CSV file with a header line and numbers only.
/// @throws std::runtime_error if the file is missing or a cell is not a number.
std::vector<Row> read_numbers(const std::string& path);

/// A design from flat parameter names (SI units); shear viscosity and inertia given outright.
/// @throws std::out_of_range for a missing name.
MotorDesign design_from_row(const Row& row);

/// One motor of tests/data/reference with everything known about it.
struct ReferenceCase {
  int number;
  MotorDesign design;
  std::vector<Row> points;  ///< speed, torque, output_power, ...
  Row metrics;              ///< stall_torque, no_load_speed, ...
};

std::vector<ReferenceCase> read_reference_cases(const std::string& folder);

}  // namespace twum::test
