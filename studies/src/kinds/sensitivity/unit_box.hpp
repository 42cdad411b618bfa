// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor_problem.hpp>

#include <span>
#include <vector>

namespace twum::studies {

/// Maps points of the unit cube to the ranges of variables, on a linear or logarithmic scale. The values of an
/// integer parameter have equal shares.
class UnitBox {
 public:
  explicit UnitBox(std::vector<DesignVariable> ranges) : ranges_(std::move(ranges)) {}

  std::size_t size() const noexcept { return ranges_.size(); }
  std::vector<Parameter> parameters() const;
  /// SI values of a point.
  std::vector<double> values(std::span<const double> unit) const;
  /// The coordinates, rounded to those of integers where the parameter is an integer.
  std::vector<double> coordinates(std::span<const double> unit) const;
  /// Derivative of a variable's value with respect to its coordinate; NaN for an integer.
  double slope(std::size_t variable, double value) const;

 private:
  std::vector<DesignVariable> ranges_;
};

}  // namespace twum::studies
