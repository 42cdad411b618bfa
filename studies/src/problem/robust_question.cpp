// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/robust_question.hpp>

#include "problem/motor_responses.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace twum::inline v0_1::studies {
namespace {

using Kind = StatisticRequest::Kind;

bool has_metric(const MotorLimit& limit) {
  return std::any_of(limit.metric.terms.begin(), limit.metric.terms.end(),
                     [](const Term& term) { return !std::holds_alternative<Parameter>(term); });
}

// Every statistic of the question: the goals, then the limits.
std::vector<const StatisticRequest*> statistics_of(const RobustQuestion& question) {
  std::vector<const StatisticRequest*> list;
  for (const DesignObjective& goal : question.design.objectives)
    if (goal.statistic) list.push_back(&*goal.statistic);
  for (const StatisticLimit& limit : question.statistics) list.push_back(&limit.statistic);
  return list;
}

bool asks_yield(const RobustQuestion& question) {
  const auto list = statistics_of(question);
  return std::any_of(list.begin(), list.end(),
                     [](const StatisticRequest* s) { return s->kind == Kind::yield; });
}

optim::Law law_of(Tolerance::Shape shape) {
  switch (shape) {
    case Tolerance::Shape::normal: return optim::Law::normal;
    case Tolerance::Shape::lognormal: return optim::Law::lognormal;
    case Tolerance::Shape::uniform: return optim::Law::uniform;
    case Tolerance::Shape::triangular:
    case Tolerance::Shape::truncated:
    case Tolerance::Shape::weibull:
    case Tolerance::Shape::beta: break;  // these three are refused
  }
  return optim::Law::triangular;
}

optim::RandomInput input_of(const RobustQuestion& question, const Tolerance& tolerance) {
  if (const auto wrong = search_complaint(tolerance))
    throw InputError(std::string(info(tolerance.parameter).name) + ": " + wrong->found() + "; " +
                     wrong->expected());
  optim::RandomInput input;
  input.name = info(tolerance.parameter).name;
  input.law = law_of(tolerance.shape);
  const Spread& spread = tolerance.sd      ? *tolerance.sd
                         : tolerance.range ? *tolerance.range
                                           : *tolerance.below;
  input.spread = spread.amount;
  input.relative = spread.relative;
  if (tolerance.above) input.above = tolerance.above->amount;
  input.value = get(question.design.motor, tolerance.parameter);
  const auto& variables = question.design.variables;
  for (std::size_t j = 0; j < variables.size(); ++j)
    if (variables[j].parameter == tolerance.parameter) input.variable = j;
  return input;
}

// The parameters of a built motor in the order of optim::BuiltEvaluator.
std::vector<DesignVariable> built_variables(const RobustQuestion& question) {
  std::vector<DesignVariable> list = question.design.variables;
  const auto varied = parameters_of(list);
  for (const Tolerance& tolerance : question.tolerances)
    if (std::find(varied.begin(), varied.end(), tolerance.parameter) == varied.end())
      list.push_back({tolerance.parameter});
  for (const Parameter parameter : question.parts.parameters) list.push_back({parameter});
  for (DesignVariable& variable : list) {
    variable.min = info(variable.parameter).min;
    variable.max = info(variable.parameter).max;
  }
  return list;
}

// Responses of built motors, all at once, or a single one, which costs less.
class BuiltMotors {
 public:
  explicit BuiltMotors(DesignProblem asked) : all_(asked, RunningReserves::large) {
    const auto one = [&](MotorLimit limit) {
      DesignProblem alone = asked;
      alone.limits = {std::move(limit)};
      alone_.emplace_back(std::move(alone), RunningReserves::large);
    };
    for (const MotorLimit& limit : asked.limits) one(limit);
    for (const ImpliedLimit& limit : all_.implied())
      if (!limit.orders_friction()) one({limit.limit.metric.text, limit.limit.metric});
  }

  optim::Evaluation evaluate(std::span<const double> built, std::optional<std::size_t> only,
                             bool gradient) const {
    if (!only) return all_.evaluate(built, gradient);
    const bool alone = *only < alone_.size();
    optim::Evaluation answer = (alone ? alone_[*only] : all_).evaluate(built, gradient);
    if (!answer.ok()) return answer;
    const std::size_t row = alone ? 0 : *only;
    answer.values = {answer.values[row]};
    if (gradient) {
      const auto begin = answer.jacobian.begin() + static_cast<std::ptrdiff_t>(row * built.size());
      answer.jacobian = {begin, begin + static_cast<std::ptrdiff_t>(built.size())};
    }
    answer.kinks.clear();
    return answer;
  }

  const std::vector<ImpliedLimit>& implied() const { return all_.implied(); }

 private:
  MotorResponses all_;
  std::vector<MotorResponses> alone_;
};

// Puts the responses of a question together.
class RobustBuilder {
 public:
  explicit RobustBuilder(const RobustQuestion& question) : question_(question) {
    asked_ = question.design;
    asked_.objectives.clear();
    asked_.limits.clear();
    asked_.variables = built_variables(question);
  }

  optim::RobustProblem build() {
    optim::RobustProblem problem;
    problem.design = design();
    add_inputs(problem);
    for (const StatisticRequest* statistic : statistics_of(question_)) ask(*statistic);
    const auto motors = std::make_shared<const BuiltMotors>(asked_);
    for (const MotorLimit& limit : asked_.limits)
      problem.limits.push_back({limit.text, limit.lower, limit.upper});
    for (const ImpliedLimit& limit : motors->implied())
      problem.limits.push_back({limit.limit.text, limit.limit.lower, limit.limit.upper});
    problem.built = [motors](std::span<const double> built, std::optional<std::size_t> only,
                             bool gradient) { return motors->evaluate(built, only, gradient); };
    add_targets(motors->implied(), problem);
    return problem;
  }

 private:
  // The tolerances, and behind them the measured parts.
  void add_inputs(optim::RobustProblem& problem) const {
    for (const Tolerance& tolerance : question_.tolerances)
      problem.inputs.push_back(input_of(question_, tolerance));
    std::vector<optim::CorrelatedPair> pairs =
        correlated_pairs(question_.tolerances, question_.correlations);
    const auto& [parameters, rows] = question_.parts;
    for (const optim::CorrelatedPair& pair : measured_pairs(rows, problem.inputs.size()))
      pairs.push_back(pair);
    for (std::size_t column = 0; column < parameters.size(); ++column)
      problem.inputs.push_back(measured_input(rows, column,
                                              std::string(info(parameters[column]).name),
                                              get(question_.design.motor, parameters[column])));
    problem.correlation = {problem.inputs.size(), pairs};
    problem.measured = rows;
  }

  // Objectives and limits of the design itself.
  optim::Problem design() const {
    DesignProblem own = question_.design;
    std::erase_if(own.objectives, [](const DesignObjective& goal) { return goal.statistic; });
    if (asks_yield(question_)) std::erase_if(own.limits, has_metric);
    return posed_problem(own);
  }

  // Position of a response, which is added if it is not there.
  std::size_t response(const MotorLimit& limit) {
    auto& limits = asked_.limits;
    const auto found = std::find_if(limits.begin(), limits.end(),
                                    [&](const MotorLimit& c) { return c.text == limit.text; });
    if (found != limits.end()) return static_cast<std::size_t>(found - limits.begin());
    if (limit.lower == limit.upper)
      throw InputError(limit.text +
                       ": an equality without a tolerance, which no built motor keeps; add one "
                       "such as '+- 2 %'");
    limits.push_back(limit);
    return limits.size() - 1;
  }

  std::vector<std::size_t> limits_of(const StatisticRequest& statistic) {
    if (statistic.kind == Kind::probability) return {response(*statistic.limit)};
    std::vector<std::size_t> list;
    for (const MotorLimit& limit : question_.design.limits)
      if (has_metric(limit)) list.push_back(response(limit));
    return list;
  }

  void ask(const StatisticRequest& statistic) {
    const bool share = statistic.kind == Kind::probability || statistic.kind == Kind::yield;
    if (share)
      limits_of(statistic);
    else
      response({statistic.metric.text, statistic.metric});
  }

  // A motor that cannot carry a load violates every limit at that load.
  std::vector<std::size_t> with_implied(std::vector<std::size_t> limits,
                                        const std::vector<ImpliedLimit>& implied) const {
    const std::size_t own = limits.size();
    for (std::size_t k = 0; k < implied.size(); ++k) {
      bool concerned = implied[k].orders_friction();
      for (std::size_t i = 0; i < own && !concerned; ++i)
        concerned = implied[k].is_about(asked_.limits[limits[i]].metric);
      if (concerned) limits.push_back(asked_.limits.size() + k);
    }
    return limits;
  }

  void add(const StatisticRequest& statistic, double lower, double upper,
           const std::vector<ImpliedLimit>& implied, optim::RobustProblem& problem) {
    switch (statistic.kind) {
      case Kind::yield:
      case Kind::probability:
        problem.yields.push_back(
            {statistic.text, with_implied(limits_of(statistic), implied), lower});
        return;
      case Kind::mean:
      case Kind::sd:
      case Kind::quantile: break;
    }
    const auto kind = static_cast<optim::Statistic>(statistic.kind);
    problem.statistics.push_back({statistic.text, kind,
                                  response({statistic.metric.text, statistic.metric}),
                                  statistic.probability, lower, upper});
  }

  void add_goal(const DesignObjective& goal, const std::vector<ImpliedLimit>& implied,
                optim::RobustProblem& problem) {
    using optim::RobustGoal;
    const optim::Sense sense = goal.maximize ? optim::Sense::maximize : optim::Sense::minimize;
    if (!goal.statistic) {
      const auto nominal = std::count_if(
          problem.goals.begin(), problem.goals.end(),
          [](const optim::RobustObjective& g) { return g.kind == RobustGoal::nominal; });
      problem.goals.push_back({RobustGoal::nominal, static_cast<std::size_t>(nominal), sense});
      return;
    }
    const std::size_t shares = problem.yields.size();
    add(*goal.statistic, -optim::kInfinity, optim::kInfinity, implied, problem);
    if (problem.yields.size() > shares) {
      if (!goal.maximize)
        throw InputError(goal.text() + ": a share of the motors is maximized, not minimized");
      problem.goals.push_back({RobustGoal::yield, shares});
    } else {
      problem.goals.push_back({RobustGoal::statistic, problem.statistics.size() - 1, sense});
    }
  }

  void add_targets(const std::vector<ImpliedLimit>& implied, optim::RobustProblem& problem) {
    problem.goals.clear();
    for (const DesignObjective& goal : question_.design.objectives)
      add_goal(goal, implied, problem);
    for (const StatisticLimit& limit : question_.statistics)
      add(limit.statistic, limit.lower, limit.upper, implied, problem);
  }

  const RobustQuestion& question_;
  DesignProblem asked_;  // of built motors
};

}  // namespace

std::optional<ValueError> search_complaint(const Tolerance& tolerance) {
  if (tolerance.mean || tolerance.min || tolerance.mode || tolerance.max)
    return ValueError(
        "gives the centre of the distribution",
        "in a search the design's value is the centre: give only the spread, such as '3 %'");
  if (tolerance.shape > Tolerance::Shape::triangular)
    return ValueError("a " + std::string(to_string(tolerance.shape)) + " distribution in a search",
                      "give a normal, uniform, lognormal or triangular one, or use an uncertainty "
                      "study");
  if (info(tolerance.parameter).integer)
    return ValueError("a whole number cannot have a tolerance in a search",
                      "leave it out of the tolerances, or use an uncertainty study");
  if (tolerance.below && tolerance.above && tolerance.below->relative != tolerance.above->relative)
    return ValueError("gives one side in % and the other with a unit",
                      "give both sides the same way");
  return {};
}

bool has_nominal_value(const DesignObjective& goal) {
  return !goal.statistic || goal.statistic->kind == Kind::mean ||
         goal.statistic->kind == Kind::quantile;
}

DesignObjective nominal_goal(const DesignObjective& goal, const std::vector<MotorLimit>& limits) {
  if (!goal.statistic) return goal;
  const StatisticRequest& statistic = *goal.statistic;
  if (statistic.kind == Kind::yield || statistic.kind == Kind::probability) {
    if (statistic.limit) return {statistic.limit->metric, std::isfinite(statistic.limit->lower)};
    const auto first = std::find_if(limits.begin(), limits.end(), has_metric);
    if (first == limits.end())
      throw InputError(
          "yield: no limit counts in it; add one with a metric, such as "
          "'no_load_speed >= 100 rpm'");
    return {first->metric, std::isfinite(first->lower)};
  }
  return {statistic.metric, goal.maximize};
}

optim::RobustProblem robust_problem(const RobustQuestion& question) {
  return RobustBuilder(question).build();
}

}  // namespace twum::inline v0_1::studies
