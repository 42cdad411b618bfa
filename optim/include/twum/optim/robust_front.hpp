// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>

namespace twum::optim {

/// A design of a front under tolerances.
struct RobustFrontPoint {
  std::vector<double> design;  ///< values of the variables
  std::vector<double> goals;   ///< as the last round has them, a yield as a share; user units
  Certificate certificate;     ///< Pareto stationarity in the last round of this point
  Verification verification;   ///< fresh products of the design
  YieldVerdict verdict{YieldVerdict::holds};  ///< of the limited yield that fares worst
};

/// A trade-off under tolerances.
struct RobustFront {
  Outcome outcome{Outcome::failed};      ///< optimal: every point certified, every verdict `holds`
  std::vector<RobustFrontPoint> points;  ///< none dominated; in order of the first goal
  std::vector<double> reference;         ///< of the hypervolume, user units
  double hypervolume{0.0};               ///< product of the goals' units
  Verification largest;  ///< where no design was found: products of the design of largest yield
  Counters counters;     ///< of problems in design and indices
};

/// The trade-off between two or three goals: objectives of the design, statistics, yields.
///
/// The front of FORM's problem comes first (pareto_front() in design and reliability indices). Each of its points is then
/// corrected by two importance samples about its own worst points, solved again along the ray of Pascoletti and Serafini that
/// leads through it, and certified; fresh products tell its yield, and a point that does not hold is moved back as
/// solve_robust() does (docs/theory/robust-design.md, section 7). For any number of threads the same.
/// @param points  at most
/// @throws InputError for a problem that cannot be posed
RobustFront solve_robust_front(const RobustProblem& problem, std::size_t points,
                               const RobustOptions& options = {});

}  // namespace twum::optim
