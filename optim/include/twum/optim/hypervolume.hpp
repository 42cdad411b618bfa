// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace twum::optim {

/// Volume dominated by a set of points and bounded by a reference point; every objective is
/// minimized. Points that do not dominate the reference, and duplicates, add nothing. Exact, in the
/// product of the objectives' units. m log m for m points of two objectives, m^2 of three. Continuous,
/// with kinks where a point begins to dominate.
/// @throws InputError unless there are two or three objectives, in every point.
double hypervolume(const std::vector<std::vector<double>>& points,
                   const std::vector<double>& reference);

/// Whether a is no worse than b in every objective and better in one (minimized). Both of one size.
bool dominates(const std::vector<double>& a, const std::vector<double>& b);

/// Positions of the points that no other dominates, in order; of equal points the first. All of one
/// size; m^2 comparisons for m points.
std::vector<std::size_t> nondominated(const std::vector<std::vector<double>>& points);

/// Positions of the `count` points of a front of two objectives that together have the largest
/// hypervolume, in order of the first objective; the two ends of the front are always among them.
/// Exact, by dynamic programming: count m^2 for m points. No more points than `count`, or a count
/// below 2: all of them.
/// @param front  points that do not dominate each other, minimized
std::vector<std::size_t> best_subset(const std::vector<std::vector<double>>& front,
                                     std::size_t count, const std::vector<double>& reference);

/// Positions of `count` points chosen one by one, each adding the most hypervolume to those before
/// (at least 1 - 1/e of the best subset's; in practice within a percent). Two or three objectives,
/// minimized.
/// @throws InputError as hypervolume()
std::vector<std::size_t> greedy_subset(const std::vector<std::vector<double>>& front,
                                       std::size_t count, const std::vector<double>& reference);

}  // namespace twum::optim
