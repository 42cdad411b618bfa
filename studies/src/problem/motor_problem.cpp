// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor_problem.hpp>

#include "problem/motor_responses.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace twum::inline v0_1::studies {
namespace {

void require_admissible(const DesignVariable& variable, double value, const char* what) {
  const std::string text = complaint(variable.parameter, value);
  if (!text.empty())
    throw InputError(std::string(info(variable.parameter).name) + ": its " + what + " " + text);
}

optim::Variable variable_of(const DesignProblem& problem, const DesignVariable& variable) {
  require_admissible(variable, variable.min, "smallest value");
  require_admissible(variable, variable.max, "largest value");
  const ParameterInfo& row = info(variable.parameter);
  optim::Variable v;
  v.name = row.name;
  v.lower = variable.min;
  v.upper = variable.max;
  v.start = std::isnan(variable.start) ? get(problem.motor, variable.parameter) : variable.start;
  v.scale = variable.scale;
  v.integer = row.integer;
  v.lowest = row.min;
  v.highest = row.max;
  v.unit = row.unit;
  return v;
}

// Only one of a parameter and its alternative can be free.
void refuse_alternatives_together(const DesignProblem& problem) {
  for (const DesignVariable& a : problem.variables) {
    const auto alternative = info(a.parameter).alternative;
    for (const DesignVariable& b : problem.variables) {
      if (alternative == b.parameter)
        throw InputError(std::string(info(a.parameter).name) + " and " +
                         std::string(info(b.parameter).name) +
                         " exclude each other; vary one of them");
    }
  }
}

optim::Variable variable_of(const DesignChoice& choice) {
  optim::Variable v;
  v.name = choice.name;
  v.lower = v.start = 1;
  v.upper = static_cast<double>(choice.sets.size());
  v.integer = true;
  return v;
}

void refuse_wrong_choices(const DesignProblem& problem) {
  const std::vector<ChoiceComplaint> wrong = choice_complaints(problem);
  if (!wrong.empty()) throw InputError(wrong.front().found + "; " + wrong.front().expected);
}

optim::Constraint limit_of(const MotorLimit& limit) {
  return {limit.text, limit.lower, limit.upper, limit.tolerance, limit.metric.unit()};
}

// "cost <= 5", "1 W <= peak_power <= 2 W"
std::string limit_text(const std::string& name, const std::string& unit, double lower,
                       double upper) {
  const auto end = [&](double value) {
    return number_text(value) + (unit == "1" ? "" : " " + unit);
  };
  if (lower > upper) throw ValueError(name + " with ends that cross", "give the smaller end first");
  if (std::isfinite(lower) && std::isfinite(upper))
    return end(lower) + " <= " + name + " <= " + end(upper);
  if (std::isfinite(upper)) return name + " <= " + end(upper);
  if (std::isfinite(lower)) return name + " >= " + end(lower);
  throw ValueError(name + " without a limit", "give at least one finite end");
}

// A life with a free profile has no derivatives.
bool asks_for_free_life(const MotorDesign& motor, const MetricExpression& metric) {
  return wears_freely(motor) && std::ranges::any_of(metric.terms, [](const auto& term) {
           const auto* one = std::get_if<MetricRequest>(&term);
           return one != nullptr && is_of_life(*one);
         });
}

bool has_derivatives(const DesignProblem& problem) {
  const auto has_some = [&](const auto& one) {
    return one.metric.has_derivatives() && !asks_for_free_life(problem.motor, one.metric);
  };
  return std::ranges::all_of(problem.objectives, has_some) &&
         std::ranges::all_of(problem.limits, has_some);
}

DesignProblem& want(DesignProblem& problem, std::string_view metric, bool maximize) {
  problem.objectives.push_back({parse_metric(metric), maximize});
  return problem;
}

}  // namespace

DesignProblem& DesignProblem::vary(Parameter parameter, double min, double max, optim::Scale scale,
                                   std::optional<double> start) {
  variables.push_back({parameter, min, max, scale, start.value_or(DesignVariable{}.start)});
  return *this;
}

DesignProblem& DesignProblem::vary(std::string_view parameter, std::string_view min,
                                   std::string_view max, optim::Scale scale) {
  const Parameter which = parse_parameter(parameter);
  const auto value = [&](std::string_view text) {
    return parse_setting(std::string(info(which).name) + "=" + std::string(text)).second;
  };
  return vary(which, value(min), value(max), scale);
}

DesignProblem& DesignProblem::maximize(std::string_view metric) {
  return want(*this, metric, true);
}

DesignProblem& DesignProblem::minimize(std::string_view metric) {
  return want(*this, metric, false);
}

DesignProblem& DesignProblem::limit(std::string_view text) {
  limits.push_back(parse_limit(text));
  return *this;
}

DesignProblem& DesignProblem::maximize(OwnMetric metric) {
  objectives.push_back({expression_of(std::move(metric)), true});
  return *this;
}

DesignProblem& DesignProblem::minimize(OwnMetric metric) {
  objectives.push_back({expression_of(std::move(metric)), false});
  return *this;
}

DesignProblem& DesignProblem::maximize(std::function<double(const Motor&)> function) {
  return maximize(OwnMetric{.name = "own", .value = std::move(function)});
}

DesignProblem& DesignProblem::minimize(std::function<double(const Motor&)> function) {
  return minimize(OwnMetric{.name = "own", .value = std::move(function)});
}

DesignProblem& DesignProblem::limit(std::string name, std::function<double(const Motor&)> function,
                                    double lower, double upper) {
  return limit(OwnMetric{.name = std::move(name), .value = std::move(function)}, lower, upper);
}

DesignProblem& DesignProblem::limit(Metric metric, double lower, double upper) {
  const MetricInfo& row = info(metric);
  return limit(limit_text(std::string(row.name), std::string(row.unit), lower, upper));
}

DesignProblem& DesignProblem::limit(OwnMetric metric, double lower, double upper) {
  std::string text = limit_text(metric.name, metric.unit, lower, upper);
  limits.push_back({std::move(text), expression_of(std::move(metric)), lower, upper});
  return *this;
}

DesignProblem& DesignProblem::derive(Parameter parameter, std::string_view text) {
  derived.push_back(parse_derived(parameter, text));
  return *this;
}

void require_ordered_friction(const DesignProblem& problem) {
  const auto varied = parameters_of(problem.variables);
  const auto derived = parameters_of(problem.derived);
  const auto has = [](const std::vector<Parameter>& list, Parameter parameter) {
    return std::find(list.begin(), list.end(), parameter) != list.end();
  };
  if (has(varied, Parameter::static_friction) && has(derived, Parameter::kinetic_friction))
    throw ValueError("static_friction is varied and kinetic_friction derived",
                     "vary kinetic_friction and derive static_friction");
}

optim::Problem motor_problem(const DesignProblem& problem) {
  optim::Problem result = posed_problem(problem);
  validate(result);
  return result;
}

optim::Problem posed_problem(const DesignProblem& problem) {
  refuse_alternatives_together(problem);
  require_ordered_friction(problem);
  refuse_wrong_choices(problem);
  optim::Problem result;
  for (const DesignVariable& variable : problem.variables)
    result.variables.push_back(variable_of(problem, variable));
  for (const DesignChoice& choice : problem.choices)
    result.variables.push_back(variable_of(choice));
  for (const DesignObjective& objective : problem.objectives) {
    if (objective.statistic)
      throw InputError(objective.text() + ": a statistic of built motors, which need tolerances");
    result.objectives.push_back(
        {objective.metric.text,
         objective.maximize ? optim::Sense::maximize : optim::Sense::minimize, objective.unit()});
  }
  for (const MotorLimit& limit : problem.limits) result.constraints.push_back(limit_of(limit));
  const auto responses = std::make_shared<const MotorResponses>(problem);
  for (const ImpliedLimit& limit : responses->implied())
    result.constraints.push_back(limit_of(limit.limit));
  result.derivatives = has_derivatives(problem);
  result.evaluate = [responses](std::span<const double> design, bool gradient) {
    return responses->evaluate(design, gradient);
  };
  return result;
}

}  // namespace twum::inline v0_1::studies
