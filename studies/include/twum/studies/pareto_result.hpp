// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/optimize_result.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Answer of `pareto`: a front, in order of the first goal.
struct ParetoResult {
  /// One design of the front.
  struct Point {
    std::vector<double> goals;  ///< values of the goals, SI
    DesignReport report;        ///< multipliers are those of the weighted goals; see gains()
    /// under tolerances: from a new random sample of motors of this design
    std::vector<RobustYield> yields{};
  };

  std::vector<Goal> goals;   ///< objectives of the search
  std::vector<Point> front;  ///< in order of the first goal
  /// The point farthest beyond the line (plane) through the ends of the front, in goals scaled by the front's span.
  /// An end if the front bends the other way; meaningless if the front is empty.
  std::size_t knee{0};
  std::vector<std::size_t> ends;  ///< the best point of each goal
  /// The same points certified as optima of that one goal, with the multipliers of its limits. Empty for a front
  /// found without gradients.
  std::vector<DesignReport> single_goal_ends;
  double hypervolume{0};                  ///< product of the goals' units
  std::vector<double> reference_point;    ///< of the hypervolume, in the goals' units
  std::vector<NamedValue> before_design;  ///< variables of the motor before the search
  /// metrics of the motor before the search, the same as those of the front
  std::vector<NamedValue> before_metrics;
  Explanation explanation;                     ///< why no design meets all limits
  std::optional<RobustYield> largest_yield{};  ///< if no design has the wanted yield
  std::string parts{};                         ///< name of the table of measured parts; empty: none
  std::uint64_t part_count{0};                 ///< how many there are

  /// False if the front bends the other way or is empty.
  bool has_knee() const;
};

}  // namespace twum::inline v0_1::studies
