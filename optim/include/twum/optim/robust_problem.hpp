// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/correlation.hpp>
#include <twum/optim/measured_rows.hpp>
#include <twum/optim/problem.hpp>
#include <twum/optim/random_input.hpp>

namespace twum::inline v0_1::optim {

/// Responses of one built product. `built` holds the design variables, then the inputs that are not variables, in
/// their order. With `only`, the result has the row of that response only. For failures and purity see Evaluator.
using BuiltEvaluator = std::function<Evaluation(std::span<const double> built,
                                                std::optional<std::size_t> only, bool gradient)>;

/// A response of built products and the ends between which it has to stay. At least one end is finite.
struct RandomLimit {
  std::string name{};        ///< unique among the limits
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units, > lower
};

/// A share of the products that has to meet a set of limits.
struct YieldTarget {
  std::string name{};                 ///< such as "yield"
  std::vector<std::size_t> limits{};  ///< positions in RobustProblem::limits
  double at_least{0.99};              ///< in (0, 1); not used for a goal
};

/// Statistic of the distribution of a response.
enum class Statistic : std::uint8_t { mean, sd, quantile };
/// As in a study; static lifetime.
const char* to_string(Statistic value) noexcept;

/// A statistic of a response that has to stay between two ends, or is the goal.
struct StatisticTarget {
  std::string name{};        ///< such as "mean(peak_power)"
  Statistic kind{};          ///< kind of statistic
  std::size_t response{0};   ///< position in RobustProblem::limits
  double probability{0.5};   ///< for a quantile, in (0, 1)
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units
};

/// Kinds of goals of a robust search.
enum class RobustGoal : std::uint8_t {
  nominal,   ///< an objective of `design`
  yield,     ///< the largest share of a yield target
  statistic  ///< a statistic; for a standard deviation the variance is optimized
};
/// Its name; static lifetime.
const char* to_string(RobustGoal value) noexcept;

/// Goal of a robust search.
struct RobustObjective {
  RobustGoal kind{RobustGoal::nominal};  ///< kind of goal
  std::size_t index{0};          ///< position among the objectives, yield targets or statistics
  Sense sense{Sense::maximize};  ///< for a statistic
};

/// A design problem whose built products scatter about the design.
struct RobustProblem {
  Problem
      design{};  ///< variables, objectives of nominal goals, and constraints on the design itself
  std::vector<RandomInput> inputs{};  ///< inputs that scatter
  Correlation correlation{};          ///< of their normal numbers
  /// Values of the last inputs, one column for each. Products that are drawn take a whole row; the search itself sees the law
  /// and the correlations of these inputs (measured_input(), measured_pairs()). Empty: none was measured.
  MeasuredRows measured{};
  std::vector<RandomLimit> limits{};  ///< responses of the built products, in order
  BuiltEvaluator built{};             ///< evaluates these responses
  std::vector<YieldTarget> yields{};  ///< each with its own limits
  /// their responses stand in `limits`, where they need no ends
  std::vector<StatisticTarget> statistics{};
  std::vector<RobustObjective> goals{{}};  ///< one goal; two or three for a front
};

/// The problem without tolerances: every built product equals the design, and every limit has to hold. Its
/// constraints are those of the design, followed by the limits. All goals must be nominal.
Problem nominal_problem(const RobustProblem& problem);

}  // namespace twum::inline v0_1::optim
