// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <map>
#include <stop_token>

namespace twum::inline v0_1::optim {

/// Limits of a solve. A solve that reaches one ends with the best answer so far, without an error.
struct Budget {
  std::size_t evaluations{20000};  ///< calls of the evaluator in all stages together
  double seconds{kInfinity};  ///< wall time [s]; with a finite limit results depend on the machine
};

/// One call of the evaluator, reported when it is done.
///
/// The sequence of designs within a stage depends on the problem, the options and the seed only; threads only change
/// how stages interleave. So (stage, index) identifies an evaluation, and a caller that stores evaluations can answer
/// a repeated solve from its store.
struct Observation {
  std::uint64_t stage{0};  ///< part of the solve: a start, a rung of the ladder, a point of a front
  std::uint64_t index{0};  ///< number of the call within its stage
  std::span<const double> design{};  ///< user units
  bool gradient{false};              ///< whether the Jacobian was asked for
  const Evaluation& evaluation;      ///< its result
};

/// Called with every evaluation. An exception that it throws ends the solve and reaches the caller.
using Observer = std::function<void(const Observation&)>;

/// Options of a solve. The defaults suit most problems.
struct SolveOptions {
  std::string solver{"auto"};  ///< a name of solvers(), or "auto"
  /// Most local searches of auto: the first from the start design, the others from a low-discrepancy sequence. With 1,
  /// the first certified design ends the search. More than half of them are enough if all come to one optimum.
  std::size_t starts{8};
  /// number of designs that look_further() samples; solve() samples as many where no search from a start keeps all limits
  std::size_t scan{512};
  double tolerance{1e-6};  ///< stationarity at which the certificate passes (O3.2)
  /// A limit is kept if it is broken by at most this part of the larger of the limit and the magnitude of its terms at
  /// the design (O2.1), or by its own tolerance.
  double feasibility_tolerance{1e-8};
  std::uint64_t seed{1};   ///< seed of all random choices
  Budget budget{};         ///< limits of evaluations and time
  std::stop_token stop{};  ///< a request ends the solve with the best answer so far
  Observer observer{};     ///< called for every evaluation, never by two threads at once
  /// number of threads for the starts of auto and for samples of the range; the answer does not depend on it
  std::size_t jobs{1};
  std::string global{};  ///< auto only: a global algorithm to run first, such as "nlopt:isres"
  std::map<std::string, std::string>
      solver_options{};  ///< for the named solver; unknown names are refused
  bool analyse_infeasible{
      true};          ///< explain a problem without a feasible point (costs more solves)
  bool polish{true};  ///< improve a nearly optimal answer by Newton steps on the active set
  std::uint64_t first_stage{
      0};  ///< number of the first stage, for callers that solve more than once
};

/// Checks that options have a meaning.
/// @throws InputError naming the option: a tolerance that is not in (0, 1), a feasibility tolerance that is negative or not
///         finite, seconds that are negative or not a number, options of a solver beside "auto", a global algorithm
///         beside a named solver
void validate(const SolveOptions& options);

}  // namespace twum::inline v0_1::optim
