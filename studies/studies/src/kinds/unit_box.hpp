// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/problem/motor_problem.hpp>

#include <span>
#include <vector>

namespace twum::studies {

/// Takes points of the unit cube to the ranges of variables, evenly or in the logarithm. A parameter of
/// whole numbers takes each of its values on the same share.
class UnitBox {
 public:
  explicit UnitBox(std::vector<DesignVariable> ranges) : ranges_(std::move(ranges)) {}

  std::size_t size() const noexcept { return ranges_.size(); }
  std::vector<Parameter> parameters() const;
  /// SI values of a point.
  std::vector<double> values(std::span<const double> unit) const;
  /// The coordinates themselves, or those of the whole numbers that they stand for.
  std::vector<double> coordinates(std::span<const double> unit) const;
  /// Derivative of a variable's value by its coordinate; NaN of a whole number.
  double slope(std::size_t variable, double value) const;

 private:
  std::vector<DesignVariable> ranges_;
};

}  // namespace twum::studies
