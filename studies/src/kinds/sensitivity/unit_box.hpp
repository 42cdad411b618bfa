// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/tolerance.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// Maps points of the unit cube to the ranges of variables, on a linear or logarithmic scale, or to values by their tolerances. The
/// values of an integer parameter have equal shares of a range.
class UnitBox {
 public:
  explicit UnitBox(std::vector<DesignVariable> ranges) : ranges_(std::move(ranges)) {}
  /// The laws of tolerances about the motor's values.
  UnitBox(const std::vector<Tolerance>& tolerances, const MotorDesign& motor);

  std::size_t size() const noexcept { return ranges_.size(); }
  std::vector<Parameter> parameters() const;
  /// SI values of a point.
  std::vector<double> values(std::span<const double> unit) const;
  /// The coordinates, rounded to those of integers where the parameter is an integer.
  std::vector<double> coordinates(std::span<const double> unit) const;
  /// Derivative of a variable's value with respect to its coordinate; NaN for an integer. For a tolerance pi times that with respect
  /// to its standard normal number z: the bound of a total index for a uniform coordinate u, E[(df/du)^2] / (pi^2 V), is then that
  /// for a normal one, E[(df/dz)^2] / V (Chernoff 1981).
  double slope(std::size_t variable, double value) const;
  /// Standard deviation of a variable by its tolerance, SI; NaN without one.
  double sd(std::size_t variable) const;
  const std::vector<DesignVariable>& ranges() const noexcept { return ranges_; }
  bool of_tolerances() const noexcept { return !laws_.empty(); }

 private:
  std::vector<DesignVariable> ranges_;  // of a tolerance only the parameter and its centre
  std::vector<Distribution> laws_;      // one each; none for ranges
};

}  // namespace twum::inline v0_1::studies
