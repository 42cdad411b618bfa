// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>

namespace twum::inline v0_1::optim {

/// A design of a front under tolerances.
struct RobustFrontPoint {
  std::vector<double> design;  ///< values of the variables
  std::vector<double> goals;   ///< goals in the last round, a yield as a share; user units
  Certificate certificate;     ///< Pareto stationarity in the last round of this point
  Verification verification;   ///< independent sample of products of the design
  /// verdict of the limited yield with the worst result
  YieldVerdict verdict{YieldVerdict::holds};
};

/// A Pareto front under tolerances.
struct RobustFront {
  Outcome outcome{Outcome::failed};      ///< optimal: every point certified, every verdict `holds`
  std::vector<RobustFrontPoint> points;  ///< nondominated points in order of the first goal
  std::vector<double> reference;         ///< of the hypervolume, user units
  double hypervolume{0.0};               ///< in the product of the goals' units
  Verification largest;  ///< if no design was found: a sample of the design with the largest yield
  Counters counters;     ///< evaluations of problems in variables and reliability indices
};

/// Computes the Pareto front of two or three goals: objectives of the design, statistics or yields.
///
/// The first step is the front of FORM's problem (pareto_front() in variables and reliability indices). Each of its
/// points is then corrected by two importance samples about its own worst points, solved again along the
/// Pascoletti-Serafini ray through it, and certified. An independent sample of products estimates its yield, and a
/// point whose yield does not hold is moved back as in solve_robust() (docs/theory/robust-design.md, section 7). The
/// result does not depend on the number of threads.
/// @param points  largest number of points
/// @throws InputError for a problem that cannot be posed
RobustFront solve_robust_front(const RobustProblem& problem, std::size_t points,
                               const RobustOptions& options = {});

}  // namespace twum::inline v0_1::optim
