// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/optim/problem.hpp>
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/metrics/motor_limit.hpp>
#include <twum/studies/metrics/statistic.hpp>
#include <twum/studies/metrics/varied_parameters.hpp>
#include <twum/studies/motor/parameter_set.hpp>

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {

/// A motor parameter that may be changed, in its SI unit.
struct DesignVariable {
  Parameter parameter{};                                   ///< which one
  double min{0};                                           ///< admissible, SI
  double max{1};                                           ///< admissible, SI, >= min
  bool log{false};                                         ///< spread evenly by ratio; min > 0
  double start{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: the motor's own value
};

/// What is wanted of a motor, or of the motors that are built to a design.
struct DesignObjective {
  MetricExpression metric;                      ///< what should be large or small
  bool maximize{false};                         ///< large
  std::optional<StatisticRequest> statistic{};  ///< wanted instead; only robust_problem() knows it

  /// As typed.
  const std::string& text() const { return statistic ? statistic->text : metric.text; }
  /// SI unit of its value.
  std::string unit() const { return statistic ? statistic->unit() : std::string(metric.unit()); }
};

/// Sets of parameters of which a design has one, such as two linings.
struct DesignChoice {
  std::string name;                ///< what results call it, such as "lining"
  std::vector<ParameterSet> sets;  ///< at least one, each with a name of its own
};

/// Most combinations of sets: each is solved by itself.
inline constexpr std::size_t kMostCombinations = 64;

/// A question about a motor: what may be changed, what is wanted, what must hold.
///
///     DesignProblem problem{motor};
///     problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
///     problem.maximize("peak_power");
///     problem.limit("no_load_speed >= 100 rpm").limit("max_pressure <= 10 MPa");
///     optim::Result best = optim::solve(motor_problem(problem));
struct DesignProblem {
  MotorDesign motor;                          ///< what the variables do not change
  std::vector<DesignVariable> variables{};    ///< what may be changed
  std::vector<DesignObjective> objectives{};  ///< one for solve(), two or three for pareto_front()
  std::vector<MotorLimit> limits{};           ///< what must hold
  std::vector<DerivedParameter> derived{};    ///< what follows from the variables
  std::vector<DesignChoice> choices{};  ///< what is in the motor before the variables change it

  /// Lets a parameter change from min to max [SI], evenly or by ratio. Whether that can be is seen when
  /// the question is posed: motor_problem().
  DesignProblem& vary(Parameter parameter, double min, double max, bool log = false);
  /// Ties a parameter to others: derive(Parameter::contact_width, "0.15 * contact_radius").
  /// @throws ValueError as parse_derived().
  DesignProblem& derive(Parameter parameter, std::string_view text);
  /// Lets the design have one of several sets of parameters. Whether they go together with the rest is seen when the
  /// question is posed.
  DesignProblem& choose(std::string name, std::vector<ParameterSet> sets);
  /// Wants a metric to be large.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& maximize(std::string_view metric);
  /// Wants a metric to be small.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& minimize(std::string_view metric);
  /// Asks for a limit such as "max_pressure <= 10 MPa".
  /// @throws ValueError if the text is no limit, as parse_limit().
  DesignProblem& limit(std::string_view text);
};

/// The motor of a design: the values of the variables in their order, then for each choice the number of its set, from 1.
/// What the sets give is in the motor before the variables, and what follows from those, change it. A value of
/// static_friction below that of kinetic_friction counts as equal to it.
/// @throws InputError if a value is not admissible, EvaluationError if one that follows is not
MotorDesign motor_of(const DesignProblem& problem, std::span<const double> design);

/// The set that a design has of each choice.
std::vector<const ParameterSet*> chosen_sets(const DesignProblem& problem,
                                             std::span<const double> design);

/// What is wrong with a choice.
struct ChoiceComplaint {
  std::size_t choice{0};             ///< position among the choices
  std::optional<std::size_t> set{};  ///< position of the set in it; none: the choice itself
  std::optional<Parameter> other{};  ///< the variable or derived parameter that the set gives too
  std::string found;     ///< "thickness is varied, and 'peek.yaml' of 'lining' gives it too"
  std::string expected;  ///< what would be right
};

/// Everything that is wrong with the choices of a question: a set that gives what is varied, derived or in a set of another
/// choice; a name that is taken; more than kMostCombinations; sets that do not make a motor.
std::vector<ChoiceComplaint> choice_complaints(const DesignProblem& problem);

/// Refuses static_friction among the variables beside a derived kinetic_friction, which could exceed it.
/// @throws ValueError
void require_ordered_friction(const DesignProblem& problem);

/// The question as a mathematical problem in SI units, with exact first derivatives. Its responses
/// are the objectives, the limits in their order, then limits that follow from them:
///
/// * max_torque >= T for every load T that a metric such as efficiency_at(T) is asked at. A motor
///   that cannot carry T is infeasible, not a failure; so that a solver finds its way out of there,
///   such a metric is then taken at 0.999 of the largest torque.
/// * static_friction >= kinetic_friction where static_friction is varied.
///
/// A choice is a variable of whole numbers, behind the others; derivatives by it are 0, since there are none.
///
/// A design that has no answer gets a failure such as "no_load_speed: no-periodic-state". Where a
/// metric is at a kink the evaluation holds both one-sided derivatives (by differentiating
/// next to it), where it has no derivative the entries are NaN. The evaluator is a pure
/// function, safe from any number of threads, and keeps a copy of the question; one gradient of a few
/// metrics costs about 50 microseconds.
/// @throws InputError if the question cannot be posed: a parameter twice or with its twin, a limit
///         twice, bounds that cross or are not admissible, no variable or objective, an objective that is a statistic, or
///         choice_complaints().
optim::Problem motor_problem(const DesignProblem& problem);

}  // namespace twum::studies
