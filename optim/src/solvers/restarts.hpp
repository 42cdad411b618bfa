// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/nlp.hpp"

namespace twum::inline v0_1::optim {

/// Restarts for solvers that cannot handle a design that cannot be evaluated. Their run is stopped and started again
/// from the best design, in a box that excludes the failed one. If a run ends at the boundary of its box, the box
/// grows again. There are at most 60 runs.
class Restarts {
 public:
  Restarts(Nlp& nlp, std::span<const double> start)
      : nlp_(nlp), from_(start.begin(), start.end()) {}

  /// Sets the box of the next run. False if another run is of no use.
  /// @param failed_at  the point that could not be evaluated; empty if the run ended normally
  /// @param ended_at   where it ended
  bool next(std::span<const double> failed_at, std::span<const double> ended_at);

  /// Where the next run begins.
  const std::vector<double>& from() const { return from_; }

 private:
  bool shrink(std::span<const double> failed);
  bool grow(std::span<const double> ended_at);
  bool at_a_wall(std::span<const double> z) const;
  double widest() const;
  void nudge(std::span<const double> failed);

  Nlp& nlp_;
  std::vector<double> from_;
  double radius_{0.0};
  int count_{0};
  int nudges_{0};
};

}  // namespace twum::inline v0_1::optim
