// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/motor_limit.hpp>
#include <twum/motors/parameter_set.hpp>
#include <twum/motors/statistic.hpp>
#include <twum/motors/varied_parameters.hpp>
#include <twum/optim/problem.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {

/// A motor parameter that may be changed, in its SI unit.
struct DesignVariable {
  Parameter parameter{};                                   ///< which one
  double min{0};                                           ///< admissible, SI
  double max{1};                                           ///< admissible, SI, >= min
  optim::Scale scale{optim::Scale::linear};                ///< logarithmic where min > 0
  double start{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: the motor's own value
};

/// Objective for a motor, or for the motors built to a design.
struct DesignObjective {
  MetricExpression metric{};  ///< quantity to be maximized or minimized
  bool maximize{false};       ///< otherwise minimize
  /// objective in place of the metric; for robust_problem() only
  std::optional<StatisticRequest> statistic{};

  /// As typed.
  const std::string& text() const { return statistic ? statistic->text : metric.text; }
  /// SI unit of its value.
  std::string unit() const { return statistic ? statistic->unit() : std::string(metric.unit()); }
};

/// Sets of parameters of which each design has one, such as two linings.
struct DesignChoice {
  std::string name{};                ///< its name in results, such as "lining"
  std::vector<ParameterSet> sets{};  ///< at least one, each with a name of its own
};

/// Largest number of combinations of sets. Each combination is solved separately.
inline constexpr std::size_t kMostCombinations = 64;

/// An operating point that a motor has to reach.
struct DutyPoint {
  double torque{0};  ///< load [N m]
  double speed{0};   ///< of the rotor [rad/s]
  /// The limit that it is, by which answers name it; empty: from the numbers, "torque_at(10.5 rad/s) >= 0.5 N.m"
  std::string text{};
};

/// How a motor reaches the points of its duty.
enum class DutyDrive : unsigned char {
  fixed,  ///< all of them at one setting of its drive: its torque at each speed is at least the load
  follows  ///< each of them held by its drive, which follows (held_point())
};

/// "fixed" or "follows"; static lifetime.
const char* to_string(DutyDrive drive);

/// A design question about a motor: variables, objectives and limits.
///
///     DesignProblem problem{motor};
///     problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
///     problem.maximize("peak_power");
///     problem.limit("no_load_speed >= 100 rpm").limit("max_pressure <= 10 MPa");
///     optim::Result best = optim::solve(motor_problem(problem));
struct DesignProblem {
  MotorDesign motor{};  ///< values of everything that the variables do not change
  std::vector<DesignVariable> variables{};    ///< what may be changed
  std::vector<DesignObjective> objectives{};  ///< one for solve(), two or three for pareto_front()
  std::vector<MotorLimit> limits{};           ///< what must hold
  std::vector<DerivedParameter> derived{};    ///< what follows from the variables
  std::vector<DesignChoice> choices{};        ///< sets of parameters, applied before the variables
  std::vector<DutyPoint> held{};              ///< what the drive, which follows, has to hold

  /// Lets a parameter vary from min to max [SI] on a linear or logarithmic scale. It is checked by motor_problem().
  /// @param start  SI; none: the motor's own value
  DesignProblem& vary(Parameter parameter, double min, double max,
                      optim::Scale scale = optim::Scale::linear, std::optional<double> start = {});
  /// The same by texts: vary("preload", "60 N", "300 N"). The start is that of the motor.
  /// @throws ValueError for an unknown parameter, or a value that is not one of it
  DesignProblem& vary(std::string_view parameter, std::string_view min, std::string_view max,
                      optim::Scale scale = optim::Scale::linear);
  /// Ties a parameter to others: derive(Parameter::contact_width, "0.15 * contact_radius").
  /// @throws ValueError as parse_derived().
  DesignProblem& derive(Parameter parameter, std::string_view text);
  /// Lets the design have one of several sets of parameters. They are checked by motor_problem().
  DesignProblem& choose(std::string name, std::vector<ParameterSet> sets);
  /// Adds an objective to maximize.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& maximize(std::string_view metric);
  /// Adds an objective to minimize.
  /// @throws ValueError if the text is no metric, as parse_metric().
  DesignProblem& minimize(std::string_view metric);
  /// Adds a metric of the program as an objective.
  /// @throws InputError as expression_of()
  /// @{
  DesignProblem& maximize(OwnMetric metric);
  DesignProblem& minimize(OwnMetric metric);
  /// @}
  /// The same of a function without unit and derivatives, which answers name "own".
  /// @throws InputError as expression_of()
  /// @{
  DesignProblem& maximize(std::function<double(const Motor&)> function);
  DesignProblem& minimize(std::function<double(const Motor&)> function);
  /// @}
  /// Adds a limit such as "max_pressure <= 10 MPa".
  /// @throws ValueError if the text is no limit, as parse_limit().
  DesignProblem& limit(std::string_view text);
  /// Adds lower <= metric <= upper [SI]; an infinite end is none: limit(Metric::max_pressure, -kInfinity, 10e6).
  /// @throws ValueError if no end is finite, or the ends cross
  DesignProblem& limit(Metric metric, double lower, double upper);
  /// The same for a metric of the program.
  /// @throws ValueError as above, InputError as expression_of()
  DesignProblem& limit(OwnMetric metric, double lower, double upper);
  /// The same of a function without unit and derivatives: limit("cost", cost, -kInfinity, 12).
  DesignProblem& limit(std::string name, std::function<double(const Motor&)> function, double lower,
                       double upper);
};

/// The motor of a design. `design` holds the values of the variables in their order, then for each choice the number
/// of its set, from 1. Sets are applied first, then the variables, then the derived parameters. A static_friction
/// below kinetic_friction is raised to it.
/// @throws InputError if a value is not admissible, EvaluationError if a derived value is not
MotorDesign motor_of(const DesignProblem& problem, std::span<const double> design);

/// The set that a design has of each choice.
std::vector<const ParameterSet*> chosen_sets(const DesignProblem& problem,
                                             std::span<const double> design);

/// What is wrong with a choice.
struct ChoiceComplaint {
  std::size_t choice{0};             ///< position among the choices
  std::optional<std::size_t> set{};  ///< position of the set in it; none: the choice itself
  std::optional<Parameter> other{};  ///< the variable or derived parameter that the set gives too
  std::string found{};     ///< "thickness is varied, and 'peek.yaml' of 'lining' gives it too"
  std::string expected{};  ///< what would be right
};

/// Everything that is wrong with the choices of a question: a set that gives a parameter that is varied, derived or
/// in a set of another choice; a name used twice; more than kMostCombinations; sets that do not give a valid motor.
std::vector<ChoiceComplaint> choice_complaints(const DesignProblem& problem);

/// Checks that static_friction is not varied beside a derived kinetic_friction, which could exceed it.
/// @throws ValueError if it is
void require_ordered_friction(const DesignProblem& problem);

/// The question as a mathematical problem in SI units, with exact first derivatives. Its responses
/// are the objectives, the limits in their order, then limits that follow from them:
///
/// * max_torque >= T for every load T in a metric such as efficiency_at(T). A motor that cannot carry T is
///   infeasible, not a failure. The metric is then evaluated at 0.999 of the largest torque, so that a solver gets
///   finite values and finds its way back.
/// * static_friction >= kinetic_friction where static_friction is varied.
///
/// A choice is an integer variable after the others. Its column in the Jacobian is 0, because it has no derivatives.
///
/// A design without an answer gets a failure such as "no_load_speed: no-periodic-state". At a kink of a metric the
/// evaluation holds both one-sided derivatives, found by differentiating next to it; entries without a derivative are
/// NaN. If an OwnMetric has no gradient, the problem has no derivatives. The evaluator is a thread-safe pure function and keeps a copy of the question. One gradient of a few metrics
/// costs about 50 microseconds with one slice and a given amplitude, ten times as much under a voltage, two hundred times as much
/// with `auto` slices.
/// @throws InputError for a question that has no meaning: a parameter twice or with its alternative, a limit twice,
///         bounds that cross or are not admissible, no variable or objective, an objective that is a statistic, or
///         choice_complaints().
optim::Problem motor_problem(const DesignProblem& problem);

}  // namespace twum::inline v0_1::studies
