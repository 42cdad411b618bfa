// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <map>
#include <stop_token>

namespace twum::optim {

/// What a solve may use up. Reaching a limit ends it with what has been found; it is no error.
struct Budget {
  std::size_t evaluations{20000};  ///< calls of the evaluator, all stages together
  double seconds{kInfinity};  ///< wall time [s]; a finite one makes results depend on the machine
};

/// One call of the evaluator, as it happens.
///
/// The sequence of designs within a stage is a function of the problem, the options and the seed
/// alone; the threads only decide how the stages interleave. So (stage, index) names an
/// evaluation for ever, and a caller that stores them can answer a repeated solve from its store.
struct Observation {
  std::uint64_t stage{0};  ///< part of the solve: a start, a rung of the ladder, a point of a front
  std::uint64_t index{0};  ///< number of the call within its stage
  std::span<const double> design;  ///< user units
  bool gradient{false};            ///< whether the Jacobian was asked for
  const Evaluation& evaluation;    ///< what came out
};

/// Told of every evaluation; its exceptions end the solve and reach its caller.
using Observer = std::function<void(const Observation&)>;

/// How to solve. The defaults are for a user without opinions.
struct SolveOptions {
  std::string solver{"auto"};  ///< a name of solvers(), or "auto"
  std::size_t starts{8};  ///< local searches of auto: the start, then a low-discrepancy sequence
  std::size_t scan{512};  ///< designs that look_further() samples; solve() itself does not
  double tolerance{
      1e-6};  ///< stationarity at which the certificate passes, relative to the gradient's scale
  double feasibility_tolerance{1e-8};  ///< of constraints scaled by their gradients at the start
  std::uint64_t seed{1};               ///< of whatever is random
  Budget budget;                       ///< what it may use up
  std::stop_token stop;                ///< a request ends the solve with what has been found
  Observer observer;       ///< called for every evaluation, never by two threads at once
  std::size_t threads{1};  ///< for the starts of auto; the answer does not depend on it
  std::string global;      ///< auto only: a global algorithm to run first, such as "nlopt:isres"
  std::map<std::string, std::string>
      solver_options;  ///< for the named solver; unknown names are refused
  bool analyse_infeasible{
      true};          ///< explain a problem without a feasible point (costs more solves)
  bool polish{true};  ///< let Newton steps on the active set finish an answer that is nearly right
  std::uint64_t first_stage{
      0};  ///< number of the first stage, for callers that solve more than once
};

}  // namespace twum::optim
