// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>
#include <twum/core/motor_design.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1 {

/// Cubic spline through the rows of a table, C2, with not-a-knot ends.
class ShapeSpline {
 public:
  /// @param rows  at least 4, the first entry of each strictly rising
  explicit ShapeSpline(const std::vector<std::pair<double, double>>& rows);

  /// Radii of the rows.
  const std::vector<double>& knots() const { return x_; }

  /// Value at a radius; the end pieces are continued beyond the table. S is double or carries derivatives.
  template <typename S>
  S at(const S& radius) const {
    const std::size_t k = piece(value_of(radius));
    const double width = x_[k + 1] - x_[k];
    const S right = (radius - x_[k]) / width, left = 1.0 - right;
    const double bend = width * width / 6;
    return left * y_[k] + right * y_[k + 1] + left * (left * left - 1.0) * (bend * m_[k]) +
           right * (right * right - 1.0) * (bend * m_[k + 1]);
  }

  /// Derivative at a radius.
  template <typename S>
  S slope(const S& radius) const {
    const std::size_t k = piece(value_of(radius));
    const double width = x_[k + 1] - x_[k];
    const S right = (radius - x_[k]) / width, left = 1.0 - right;
    return (y_[k + 1] - y_[k]) / width + (width / 6) * ((3.0 * right * right - 1.0) * m_[k + 1] -
                                                        (3.0 * left * left - 1.0) * m_[k]);
  }

 private:
  std::size_t piece(double radius) const {
    const auto next = std::upper_bound(x_.begin() + 1, x_.end() - 1, radius);
    return static_cast<std::size_t>(next - x_.begin()) - 1;
  }

  std::vector<double> x_, y_, m_;  // rows, and second derivatives there
};

/// What is wrong with a track: its inner edge, or the radial shape on it; empty if nothing is.
std::string track_complaint(const MotorDesign& design);

}  // namespace twum::inline v0_1
