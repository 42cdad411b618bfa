// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <span>
#include <string>
#include <vector>

namespace twum::studies {

/// Parts that were measured: each is drawn whole, so that the laws and correlations of its values are those of the bench; internal.
class MeasuredParts {
 public:
  /// None.
  MeasuredParts() = default;
  /// Reads a table with a column for each parameter, as designs have them, and if need be `weight`: how often a part is drawn
  /// compared with the others.
  /// @throws InputError with file, line, column, what was found and what would be right
  MeasuredParts(const std::string& path, const MotorDesign& base);

  const std::vector<Parameter>& parameters() const { return parameters_; }
  std::size_t size() const { return sums_.size(); }
  /// The values of a part, of which those with the same weight share the numbers from 0 to 1 evenly.
  std::span<const double> draw(double u) const;
  /// Columns that are neither parameters nor the weight.
  const std::vector<std::string>& unused() const { return unused_; }
  /// What the file was besides plain CSV, see PlainTable; empty: nothing.
  const std::string& kind() const { return kind_; }

 private:
  std::vector<Parameter> parameters_;
  std::vector<double> values_;  // part by part
  std::vector<double> sums_;    // of the weights up to each part
  std::vector<std::string> unused_;
  std::string kind_;
};

}  // namespace twum::studies
