// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/no_value.hpp>
#include <twum/optim/estimate.hpp>
#include <twum/optim/result.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/optim/yield_estimate.hpp>

#include <map>

namespace twum::inline v0_1::optim {

/// A mean over products, and its standard error.
struct SampledMean {
  double value{0.0};  ///< NaN if not known
  double error{0.0};  ///< standard error; NaN if not known
};

/// Statistics of an independent sample of products of a design.
struct Verification {
  std::vector<YieldEstimate> yields{};         ///< of each yield target
  std::vector<IntervalEstimate> statistics{};  ///< of each statistic, with 95 % intervals
  /// for each end of a limit, in the order of RobustResult::risks, the share of products that violates it
  std::vector<double> term_shares{};
  /// True for yields above 99.99 %: yields and shares come from importance samples about the worst points, 16
  /// independently scrambled ones.
  bool weighted{false};
  /// number of products without an answer by reason; they count as violating all limits
  std::map<std::string, std::uint64_t> lost{};
  /// of each response, one value for each product; NaN without an answer
  std::vector<std::vector<double>> values{};
  /// For each input, the change of the first yield if its spread is 1 % smaller, from the failing products only,
  /// U6.6. NaN if its distribution is not normal.
  std::vector<SampledMean> tighter{};
};

/// Contribution of one end of a limit to the risk, U6.1.
struct RiskShare {
  std::string limit{};     ///< its name
  Side side{Side::lower};  ///< which end of the limit
  std::size_t target{0};   ///< index of its yield target
  double beta{0.0};        ///< its reliability index
  /// share of the sampled products that violate it; NaN if none were drawn
  double probability{kNoValue};
  /// share of it among the products that violate any limit of the target; likewise
  double share{kNoValue};
  /// alpha_k^2 of each input, or with correlated inputs the part of U1.10, which can be negative: its share in the cause of
  /// failures; the sum is 1. Empty with measured rows
  std::vector<double> importance{};
  double multiplier{0.0};  ///< improvement of the goal per unit of relaxation of this end
  double delta{0.0};       ///< correction of its margin in the last round, user units
  bool converged{true};    ///< the search for its worst point converged to 1e-8
};

/// A point of the trade-off between yield and goal.
struct YieldPrice {
  double yield{0.0};      ///< yield of the first target, from an importance sample
  double objective{0.0};  ///< goal of the best design with that yield
};

/// Value of tightening one tolerance, U6.2 to U6.5. NaN where it follows from failures with measured rows; then
/// Verification::tighter still counts them.
struct TolerancePrice {
  std::string input{};  ///< its name
  double gain_per_percent_tighter{
      0};  ///< improvement of the goal if its spread is 1 % smaller, to first order
  double yield_per_percent_tighter{
      0};  ///< change of the first target's yield for the same change, at the same design
};

/// One round of correction, U4.
struct RobustRoundReport {
  std::uint64_t products{0};  ///< size of the importance sample
  double risk{0.0};           ///< p_any of the first target at the design before the correction
  double error{0.0};          ///< standard error of `risk`
  double kappa{0.0};          ///< correction of the first target
  double objective{0.0};      ///< goal after the correction
};

/// Result of a robust search.
struct RobustResult {
  /// optimal: the yield holds; feasible: not distinguishable; infeasible: violated, or no design exists
  Outcome outcome{Outcome::failed};
  YieldVerdict verdict{
      YieldVerdict::
          broken};  ///< verdict on the target or the limited statistic with the worst result
  std::vector<double> design{};  ///< values of the variables
  /// result of the last round's problem, in variables and reliability indices, with its certificate; its stages
  /// report the goal
  Result last{};
  /// Derivative of the goal with respect to the objective of `last`, which is the logarithm of a risk for a yield
  /// and a variance for a standard deviation.
  double goal_per_objective{1.0};
  Verification verification{};           ///< independent sample of products of the design
  std::vector<RiskShare> risks{};        ///< one for every end of a limit
  std::vector<TolerancePrice> prices{};  ///< one for every input
  double price_of_yield{
      0.0};  ///< loss of the goal per unit of the first target's yield, U6.4; NaN with measured rows
  std::vector<RobustRoundReport> rounds{};  ///< in order
  std::vector<double> aimed{};  ///< yields of the first target that the rounds aimed at, U5.4
  /// best goal at several yields, up to the largest possible yield
  std::vector<YieldPrice> prices_of_yields{};
  double largest_yield{
      0.0};  ///< largest yield of the first target if the wanted one cannot be reached; else NaN
  Counters counters{};  ///< evaluations of problems in variables and reliability indices
};

/// Options of a robust search. Of `solve`, the tolerances, seed, stop and threads are used, and the budget for each
/// search.
struct RobustOptions {
  SolveOptions solve{};  ///< options of each search
  /// start designs, such as nominal optima; more are drawn
  std::vector<std::vector<double>> starts{};
  /// aim above the wanted yield, so that an independent sample is likely to confirm it
  bool back_off{true};
  bool price_yields{true};  ///< also find the best goal at other yields
  std::size_t draws{3};     ///< starts from a low-discrepancy sequence
  /// Called instead of the problem of a round, for callers that store evaluations. Equal numbers of rounds (0, 1,
  /// ...) mean the same problem. Never called by two threads at once for one stage.
  std::function<Evaluation(std::uint64_t round, std::span<const double> y, bool gradient,
                           const Evaluator& evaluate)>
      recall{};
  /// Called with every evaluation of a round's problem, by one thread at a time.
  std::function<void(std::uint64_t round, const Observation&)> observer{};
  /// Called while a sample is drawn, with the number of its products so far and the largest there may be, by one thread at
  /// a time.
  std::function<void(std::uint64_t made, std::uint64_t most)> sampled{};
};

/// Finds the best design for which the wanted shares of products meet their limits (docs/theory/robust-design.md).
///
/// Inverse FORM with exact gradients allocates reliability indices to the limits. Importance samples correct them.
/// The last corrected problem is certified, and an independent sample of products estimates the yield. The answer
/// depends on problem, options and seed, not on the number of threads.
/// @throws InputError for a problem that cannot be posed
RobustResult solve_robust(const RobustProblem& problem, const RobustOptions& options = {});

/// An independent sample of products of any design, with the threads, seed and stop of the options.
/// @param products  the most that are made
/// @param stream    selects their random numbers; solve_robust() uses 0 to 3
/// @param width     of the 95 % intervals of all yields, at which the sample ends early; not used if statistics are wanted
Verification verify_design(const RobustProblem& problem, std::span<const double> design,
                           std::uint64_t products, const RobustOptions& options,
                           std::uint64_t stream, double width = 0);

/// FORM only, the first round of solve_robust(), without a sample or a verdict. For tests and fronts.
RobustResult solve_form(const RobustProblem& problem, const RobustOptions& options = {});

}  // namespace twum::inline v0_1::optim
