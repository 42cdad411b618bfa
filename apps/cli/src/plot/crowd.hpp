// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// More designs than a picture can show one by one.
namespace twum::inline v0_1::cli {

/// More points than these on a picture of some 600 by 200 pixels cannot be distinguished.
inline constexpr std::size_t kMostPoints = 5000;

/// Rows that a picture shows if there are more than `most`: a random sample, always the same one. Taking every k-th
/// row would be wrong, because every k-th point of a grid or a sequence lies in a part of the space only.
std::vector<std::size_t> shown_rows(std::size_t count, std::size_t most = kMostPoints);

/// How many of these points lie in each cell that has any, as rows of Draw::cells; empty if all have one x or one y.
std::vector<std::vector<double>> counted_cells(const std::vector<double>& x,
                                               const std::vector<double>& y);

/// The cells of a grid, which meet half way between its values, each with its value: rows of Draw::cells.
std::vector<std::vector<double>> grid_cells(const std::vector<double>& x,
                                            const std::vector<double>& y,
                                            const std::vector<double>& z);

}  // namespace twum::inline v0_1::cli
