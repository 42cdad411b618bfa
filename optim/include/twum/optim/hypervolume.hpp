// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::optim {

/// Volume dominated by a set of points and bounded by a reference point; every objective is minimized. Points that do
/// not dominate the reference, and duplicates, add nothing. Exact; the unit is the product of the objectives' units.
/// Cost for m points: m log m with two objectives, m^2 with three. Continuous in the points, with kinks where a point
/// begins to dominate.
/// @throws InputError unless every point has the same two or three objectives.
double hypervolume(const std::vector<std::vector<double>>& points,
                   const std::vector<double>& reference);

/// Whether a is no worse than b in every objective and better in at least one. Objectives are minimized; a and b have
/// the same size.
bool dominates(const std::vector<double>& a, const std::vector<double>& b);

/// Positions of the points that no other point dominates, in ascending order; of equal points only the first. All
/// points have the same size. m^2 comparisons for m points.
std::vector<std::size_t> nondominated(const std::vector<std::vector<double>>& points);

/// Positions of the `count` points of a front of two objectives that together have the largest hypervolume, in order
/// of the first objective; the two ends of the front are always among them. Exact, by dynamic programming in count
/// m^2 steps for m points. Returns all points if there are at most `count`, or if `count` is below 2.
/// @param front  points that do not dominate each other, minimized
std::vector<std::size_t> best_subset(const std::vector<std::vector<double>>& front,
                                     std::size_t count, const std::vector<double>& reference);

/// Positions of `count` points chosen one after the other, each the one that adds the most hypervolume. The result
/// has at least 1 - 1/e of the best subset's hypervolume, in practice within a percent of it. Two or three
/// objectives, minimized.
/// @throws InputError as hypervolume()
std::vector<std::size_t> greedy_subset(const std::vector<std::vector<double>>& front,
                                       std::size_t count, const std::vector<double>& reference);

}  // namespace twum::inline v0_1::optim
