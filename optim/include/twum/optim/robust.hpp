// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/optim/yield_estimate.hpp>

#include <map>

namespace twum::optim {

/// A mean over products with its standard error.
struct SampledMean {
  double value{0.0};  ///< NaN: not known
  double error{0.0};  ///< likewise
};

/// What fresh products of a design came to.
struct Verification {
  std::vector<YieldEstimate> yields;  ///< of each yield target
  std::vector<double>
      term_shares;  ///< of each end of a limit, in the order of RobustResult::risks:
                    ///< the share that breaks it
  /// Yields above 99.99 % are known from weighted products about the worst points, 16 samples with a scramble of their own
  /// each; shares of ends likewise.
  bool weighted{false};
  std::map<std::string, std::uint64_t>
      lost;  ///< products without an answer, by reason; all their limits fail
  std::vector<std::vector<double>>
      values;  ///< of each response, one for each product; NaN without an answer
  /// Of each input: change of the first yield if its spread is 1 % smaller, from the failing products alone, U6.6; NaN
  /// where its law is not normal.
  std::vector<SampledMean> tighter;
};

/// Where the risk of one end of a limit goes, U6.1.
struct RiskShare {
  std::string limit;                 ///< its name
  Side side{Side::lower};            ///< which end
  std::size_t target{0};             ///< yield target that it belongs to
  double beta{0.0};                  ///< its reliability index
  double probability{0.0};           ///< share of the fresh products that break it
  double share{0.0};                 ///< of those products that break any limit of the target
  std::vector<double> importance{};  ///< alpha_k^2 of each input, sum 1: what makes it fail
  double multiplier{0.0};            ///< improvement of the goal per unit that this end is relaxed
  double delta{0.0};                 ///< correction of its margin in the last round, user units
  bool converged{true};              ///< its worst point was found to 1e-8
};

/// A design between the wanted yield and others.
struct YieldPrice {
  double yield{0.0};      ///< of the first target, by an importance sample
  double objective{0.0};  ///< the goal of the best design that has it
};

/// What one tolerance costs, U6.2 to U6.5.
struct TolerancePrice {
  std::string input;  ///< its name
  double gain_per_percent_tighter{
      0};  ///< improvement of the goal if its spread is 1 % smaller, first order
  double yield_per_percent_tighter{
      0};  ///< change of the first target's yield then, at the same design
};

/// One round of correction, U4.
struct RobustRoundReport {
  std::uint64_t products{0};  ///< of the importance sample
  double risk{0.0};           ///< p_any of the first target at its design, before its correction
  double error{0.0};          ///< standard error of it
  double kappa{0.0};          ///< correction of the first target
  double objective{0.0};      ///< the goal after it
};

/// What a robust search has found.
struct RobustResult {
  Outcome outcome{
      Outcome::
          failed};  ///< optimal: holds; feasible: not distinguishable; infeasible: broken or impossible
  YieldVerdict verdict{YieldVerdict::broken};  ///< of the target that fares worst
  std::vector<double> design;                  ///< values of the variables
  Result
      last;  ///< of the last round's problem, in design and indices: its certificate; stages tell the goal
  double goal_per_objective{
      1.0};  ///< a unit of the objective of `last` in units of the goal: it is the logarithm of a
             ///< risk, the square of a spread
  Verification verification;           ///< fresh products of the design
  std::vector<RiskShare> risks;        ///< of every end of a limit
  std::vector<TolerancePrice> prices;  ///< of every input
  double price_of_yield{0.0};  ///< loss of the goal per unit of the first target's yield, U6.4
  std::vector<RobustRoundReport> rounds;  ///< in order
  std::vector<double> aimed;              ///< yields of the first target that were aimed at, U5.4
  std::vector<YieldPrice>
      prices_of_yields;  ///< goal over yield, rising to the largest yield there is
  double largest_yield{
      0.0};           ///< of the first target, where the wanted one cannot be reached; else NaN
  Counters counters;  ///< of problems in design and indices
};

/// How to search. Of `solve` the tolerances, seed, stop and threads count, and its budget for each search.
struct RobustOptions {
  SolveOptions solve;                       ///< of every search in it
  std::vector<std::vector<double>> starts;  ///< designs, such as nominal optima; more are drawn
  bool back_off{true};  ///< aim above the wanted yield, so that fresh products show that it holds
  bool price_yields{true};  ///< find the best goal at other yields too
  std::size_t draws{3};     ///< starts from a low-discrepancy sequence
  /// Called with the round (0, 1, ...; the same number is the same problem), instead of calling the problem of that round; for
  /// callers with a memory. Never by two threads at once for one stage.
  std::function<Evaluation(std::uint64_t round, std::span<const double> y, bool gradient,
                           const Evaluator& evaluate)>
      recall{};
  /// Told of every evaluation of a round's problem, from one thread at a time.
  std::function<void(std::uint64_t round, const Observation&)> observer{};
};

/// The best design of which the wanted shares of products keep their limits (docs/theory/robust-design.md).
///
/// Reliability indices are allocated to the limits by inverse FORM with exact gradients, corrected by importance samples,
/// certified on the last corrected problem, and the yield is told from fresh products. The answer follows from problem,
/// options and seed, for any number of threads.
/// @throws InputError for a problem that cannot be posed
RobustResult solve_robust(const RobustProblem& problem, const RobustOptions& options = {});

/// Fresh products of any design, with the threads, seed and stop of the options.
/// @param stream  names their random numbers; 0 to 3 are those of solve_robust()
Verification verify_design(const RobustProblem& problem, std::span<const double> design,
                           std::uint64_t products, const RobustOptions& options,
                           std::uint64_t stream);

/// FORM alone, the first round of solve_robust(): no sample, no verdict. For tests and for fronts.
RobustResult solve_form(const RobustProblem& problem, const RobustOptions& options = {});

}  // namespace twum::optim
