// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/solvers.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// Numbers of a scaled problem at one point.
struct ScaledValues {
  double objective{0.0};           ///< to be minimized
  std::vector<double> rows{};      ///< of the constraints, in their order
  std::vector<double> gradient{};  ///< of the objective, if it was asked for
  std::vector<double> jacobian{};  ///< of the rows, if it was asked for: a row for each constraint
};

/// The problem as a solver sees it: minimize the objective with lower <= z <= upper and row_lower <= rows <= row_upper.
/// Variables have sizes about 1, slopes too. Infinite limits are none, equal ones make an equality.
struct ScaledProblem {
  std::vector<double> lower{};      ///< of the variables
  std::vector<double> upper{};      ///< of the variables
  std::vector<double> row_lower{};  ///< of the rows
  std::vector<double> row_upper{};  ///< of the rows
  std::vector<double> start{};      ///< within lower and upper
  std::uint64_t seed{1};            ///< of random choices
  /// Evaluates a point, which is clamped into the bounds. Nothing for a design without an answer. Throws when the budget ends, if
  /// a stop is requested and what the evaluator throws: the solver has to let these exceptions pass.
  std::function<std::optional<ScaledValues>(std::span<const double> z, bool gradient)> evaluate{};
};

/// A solver of the program. It returns when it has done what it can: the best point that it has evaluated is its answer, which is
/// measured and certified as that of any other solver. It may be called by several threads at once.
using OwnSolver = std::function<void(const ScaledProblem& problem)>;

/// Makes a solver known under info.name, for SolveOptions::solver and find_solver(); solvers() lists those of the library only. To be
/// called before the first solve.
/// @throws InputError for a name that is empty, "auto" or taken, and without a function
void add_solver(SolverInfo info, OwnSolver solver);

}  // namespace twum::inline v0_1::optim
