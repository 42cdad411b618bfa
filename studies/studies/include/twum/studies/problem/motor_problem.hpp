// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/optim/problem.hpp>
#include <twum/studies/metrics/constraint.hpp>
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/metrics/varied_parameters.hpp>

#include <limits>
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

/// What is wanted of a motor.
struct DesignObjective {
  MetricExpression metric;  ///< what should be large or small
  bool maximize{false};     ///< large
};

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
  std::vector<Constraint> limits{};           ///< what must hold
  std::vector<DerivedParameter> derived{};    ///< what follows from the variables

  /// Lets a parameter change from min to max [SI], evenly or by ratio. Whether that can be is seen when
  /// the question is posed: motor_problem().
  DesignProblem& vary(Parameter parameter, double min, double max, bool log = false);
  /// Ties a parameter to others: derive(Parameter::contact_width, "0.15 * contact_radius").
  /// @throws ValueError as parse_derived().
  DesignProblem& derive(Parameter parameter, std::string_view text);
  /// Wants a metric to be large.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& maximize(std::string_view metric);
  /// Wants a metric to be small.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& minimize(std::string_view metric);
  /// Asks for a limit such as "max_pressure <= 10 MPa".
  /// @throws ValueError if the text is no limit, as parse_constraint().
  DesignProblem& limit(std::string_view text);
};

/// The variables of a question and what follows from them.
/// @throws InputError if they do not go together
VariedParameters varied_parameters(const DesignProblem& problem);

/// The motor with the variables at the given values, in their order, and what follows from them. A value of static_friction
/// below that of kinetic_friction counts as equal to it.
/// @throws InputError if a value is not admissible, EvaluationError if one that follows is not
/// @{
MotorDesign motor_of(const DesignProblem& problem, std::span<const double> values);
MotorDesign motor_of(const DesignProblem& problem, const VariedParameters& varied,
                     std::span<const double> values);
/// @}

/// The question as a mathematical problem in SI units, with exact first derivatives. Its responses
/// are the objectives, the limits in their order, then limits that follow from them:
///
/// * max_torque >= T for every load T that a metric such as efficiency_at(T) is asked at. A motor
///   that cannot carry T is infeasible, not a failure; so that a solver finds its way out of there,
///   such a metric is then taken at 0.999 of the largest torque.
/// * static_friction >= kinetic_friction where static_friction is varied.
///
/// A design that has no answer gets a failure such as "no_load_speed: no-periodic-state". Where a
/// metric is at a kink the evaluation holds both one-sided derivatives (by differentiating
/// next to it), where it has no derivative the entries are NaN. The evaluator is a pure
/// function, safe from any number of threads, and keeps a copy of the question; one gradient of a few
/// metrics costs about 50 microseconds.
/// @throws InputError if the question cannot be posed: a parameter twice or with its twin, a limit
///         twice, bounds that cross or are not admissible, no variable or objective.
optim::Problem motor_problem(const DesignProblem& problem);

}  // namespace twum::studies
