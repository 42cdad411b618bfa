// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/optimize_result.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::studies {

/// Answer of `pareto`: a front, in order of the first goal.
struct ParetoResult {
  /// One design of the front.
  struct Point {
    std::vector<double> goals;  ///< values of the goals, SI
    DesignReport report;        ///< multipliers are those of the weighted goals; see gains()
    std::vector<RobustYield> yields{};  ///< under tolerances, of new random motors of this design
  };

  std::vector<Goal> goals;   ///< what was wanted
  std::vector<Point> front;  ///< in order of the first goal
  /// The point farthest beyond the line (plane) through the ends, in goals scaled by the front's span:
  /// on either side of it one gives much for little. An end where the front bends the other way. Of
  /// no meaning if the front is empty.
  std::size_t knee{0};
  std::vector<std::size_t> ends;  ///< the best point of each goal
  /// These points once more, as optima of that one goal alone: what its limits are worth there. Empty
  /// for a front found without gradients.
  std::vector<DesignReport> alone;
  double hypervolume{0};                       ///< product of the goals' units
  std::vector<double> reference_point;         ///< of the hypervolume, in the goals' units
  std::vector<NamedValue> before_design;       ///< the motor as it was: its variables
  std::vector<NamedValue> before_metrics;      ///< the same metrics as those of the front
  Explanation explanation;                     ///< why no design satisfies all limits
  std::optional<RobustYield> largest_yield{};  ///< where no design has the wanted one

  /// False of a front that bends the other way, and of an empty one.
  bool has_knee() const;
};

}  // namespace twum::studies
