// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// Lines of equal value on a grid; internal.
namespace twum::inline v0_1::studies::telling {

/// Values at the crossings of evenly spaced lines.
struct ValueGrid {
  std::size_t columns{0}, rows{0};
  double left{0}, right{0}, bottom{0}, top{0};
  std::vector<double> values;  ///< row by row from the bottom; NaN where there is none

  double x(double column) const {
    return left + (right - left) * column / static_cast<double>(columns - 1);
  }
  double y(double row) const {
    return bottom + (top - bottom) * row / static_cast<double>(rows - 1);
  }
  double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

/// A line through points in their order.
struct ContourLine {
  std::vector<double> x, y;
};

/// Lines on which the values, linear along the lines of the grid, are `level`; the longest first.
std::vector<ContourLine> contour_lines(const ValueGrid& grid, double level);

/// Round levels, rising, of which about ten divide the values, and which contain them. Empty if there are no two values that
/// differ by more than rounding.
std::vector<double> round_levels(const std::vector<double>& values);

}  // namespace twum::inline v0_1::studies::telling
