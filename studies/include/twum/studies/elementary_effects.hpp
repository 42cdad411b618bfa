// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/estimate.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// Morris' trajectories (1991) on four levels of [0, 1]: each changes one coordinate after another, in random order,
/// by 2/3 up or down. A trajectory depends on the seed and its number only.
class MorrisDesign {
 public:
  /// @param variables  dimension of the box, >= 1
  MorrisDesign(std::size_t variables, std::uint64_t seed) : variables_(variables), seed_(seed) {}

  /// Dimension of the box.
  std::size_t variables() const noexcept { return variables_; }
  /// Points of a trajectory.
  std::size_t trajectory_size() const noexcept { return variables_ + 1; }
  /// One point of a trajectory; `unit` has room for a number for each variable. Safe from any number of
  /// threads.
  /// @param member  0 .. trajectory_size() - 1
  void point(std::uint64_t trajectory, std::size_t member, std::span<double> unit) const;

 private:
  std::size_t variables_;
  std::uint64_t seed_;
};

/// Effect of a variable over its range, in the unit of the function.
struct ElementaryEffect {
  double mu;         ///< mean effect, with its sign
  Estimate mu_star;  ///< mean magnitude (Campolongo et al. 2007)
  Estimate sigma;    ///< standard deviation of the effects: measures interaction and curvature
};

/// Elementary effects from the values along trajectories. The trajectories are independent of each other, so mu* has
/// Student's interval and sigma Bonett's.
class ElementaryEffects {
 public:
  /// For a function of so many variables, without trajectories yet.
  explicit ElementaryEffects(std::size_t variables) : effects_(variables), magnitudes_(variables) {}

  /// Adds a trajectory: its d + 1 points, one after another, that differ from their neighbour in
  /// one coordinate, and the values there. A value that is NaN drops the whole trajectory.
  void add(std::span<const double> points, std::span<const double> values);

  /// Trajectories that were used.
  std::uint64_t trajectories() const noexcept { return trajectories_; }
  /// Trajectories that were dropped.
  std::uint64_t dropped() const noexcept { return dropped_; }
  /// One for each variable; intervals are NaN with fewer than two trajectories.
  /// @param confidence  between 0 and 1
  std::vector<ElementaryEffect> effects(double confidence) const;

 private:
  std::vector<Moments> effects_;
  std::vector<Moments> magnitudes_;
  std::uint64_t trajectories_{0};
  std::uint64_t dropped_{0};
};

}  // namespace twum::inline v0_1::studies
