// SPDX-License-Identifier: Apache-2.0
#include "robust/validate.hpp"

#include <algorithm>
#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {

void validate_robust(const RobustProblem& problem) {
  if (problem.inputs.empty())
    throw InputError("a robust problem has at least one input that scatters");
  for (const RandomInput& input : problem.inputs) {
    if (input.law == Law::given) continue;
    if (!(input.spread > 0.0) && !(input.law == Law::triangular && input.above > 0.0))
      throw InputError(input.name + ": its spread must be more than 0");
  }
  const MeasuredRows& measured = problem.measured;
  if (measured.columns() > problem.inputs.size() ||
      (!measured.empty() && !(measured.sum_of_weights() > 0.0)))
    throw InputError("measured rows have a weight, and a column for each of the last inputs");
  if (!problem.measured.empty() &&
      std::any_of(problem.goals.begin(), problem.goals.end(),
                  [](const RobustObjective& goal) { return goal.kind == RobustGoal::yield; }))
    throw InputError(
        "the share of measured parts moves in steps, which no search by derivatives finds; limit "
        "it, such as 'yield >= 95 %', and make a metric the goal");
  if (problem.goals.empty()) throw InputError("a robust problem has a goal");
  for (const RobustObjective& goal : problem.goals) {
    if (goal.kind == RobustGoal::nominal && goal.index >= problem.design.objectives.size())
      throw InputError("a robust problem whose goal is nominal has an objective");
    if (goal.kind == RobustGoal::yield && goal.index >= problem.yields.size())
      throw InputError("a robust problem whose goal is the yield has a yield target");
    if (goal.kind == RobustGoal::statistic && goal.index >= problem.statistics.size())
      throw InputError("a robust problem whose goal is a statistic has one");
  }
  for (std::size_t s = 0; s < problem.yields.size(); ++s) {
    const YieldTarget& target = problem.yields[s];
    if (target.limits.empty()) throw InputError(target.name + ": no limit counts in it");
    const bool wanted =
        std::any_of(problem.goals.begin(), problem.goals.end(), [&](const RobustObjective& goal) {
          return goal.kind == RobustGoal::yield && goal.index == s;
        });
    if (!(target.at_least > 0.0 && target.at_least < 1.0) && !wanted)
      throw InputError(target.name + ": must be between 0 and 100 %");
  }
}

const char* to_string(Statistic value) noexcept {
  switch (value) {
    case Statistic::mean: return "mean";
    case Statistic::sd: return "sd";
    case Statistic::quantile: return "quantile";
  }
  return "unknown";
}

const char* to_string(RobustGoal value) noexcept {
  switch (value) {
    case RobustGoal::nominal: return "nominal";
    case RobustGoal::yield: return "yield";
    case RobustGoal::statistic: return "statistic";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
