// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>
#include <twum/optim/random_input.hpp>

namespace twum::optim {

/// Responses of one built product. `built` holds the design variables, then the inputs that are no variable, in their
/// order. With `only` the answer has the row of that response alone. Failures and purity as Evaluator.
using BuiltEvaluator = std::function<Evaluation(std::span<const double> built,
                                                std::optional<std::size_t> only, bool gradient)>;

/// A response of built products and the ends between which it has to stay; one of them is finite.
struct RandomLimit {
  std::string name;          ///< unique among the limits
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units, > lower
};

/// A share of the products that has to keep a set of limits.
struct YieldTarget {
  std::string name;                 ///< such as "yield"
  std::vector<std::size_t> limits;  ///< positions in RobustProblem::limits
  double at_least{0.99};            ///< in (0, 1); of a goal it is not used
};

/// What is told of the distribution of a response.
enum class Statistic : std::uint8_t { mean, sd, quantile };

/// A statistic of a response that has to stay between two ends, or is the goal.
struct StatisticTarget {
  std::string name;          ///< such as "mean(peak_power)"
  Statistic kind{};          ///< which
  std::size_t response{0};   ///< position in RobustProblem::limits
  double probability{0.5};   ///< of a quantile, in (0, 1)
  double lower{-kInfinity};  ///< user units
  double upper{kInfinity};   ///< user units
};

/// Kinds of goals of a robust search.
enum class RobustGoal : std::uint8_t {
  nominal,   ///< an objective of `design`
  yield,     ///< the largest share of a yield target
  statistic  ///< a statistic; of a standard deviation the variance is what is optimized
};

/// What a robust search is to improve.
struct RobustObjective {
  RobustGoal kind{RobustGoal::nominal};  ///< which kind
  std::size_t index{0};          ///< position among the objectives, yield targets or statistics
  Sense sense{Sense::maximize};  ///< of a statistic
};

/// A design problem whose products differ from the design and from each other.
struct RobustProblem {
  Problem
      design;  ///< variables; objectives, of goals that are nominal; constraints on the design itself
  std::vector<RandomInput> inputs;  ///< what scatters
  std::vector<RandomLimit> limits;  ///< responses of the built products, in order
  BuiltEvaluator built;             ///< of these responses
  std::vector<YieldTarget> yields;  ///< each with its own limits
  std::vector<StatisticTarget>
      statistics;  ///< responses without ends may stand in `limits` for them
  std::vector<RobustObjective> goals{{}};  ///< what is improved: one, of a front two or three
};

/// The problem without tolerances: every built product is the design, and every limit has to hold. Its constraints are those
/// of the design, then the limits. Needs nominal goals.
Problem nominal_problem(const RobustProblem& problem);

}  // namespace twum::optim
