// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/statistic.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/tolerance.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// Parts that were measured: rows of values of parameters, one column for each. Every built motor has the values of one row.
struct MeasuredParts {
  std::vector<Parameter> parameters{};  ///< none of them a variable or a parameter of a tolerance
  optim::MeasuredRows rows{};           ///< SI
};

/// A design question about the motors built to a design, which scatter within tolerances.
///
///     RobustQuestion question{{motor}};
///     question.design.vary(Parameter::preload, 60, 300).maximize("peak_power");
///     question.design.limit("no_load_speed >= 100 rpm");
///     question.tolerances = {...};
///     question.statistics = {parse_statistic_limit("yield >= 99 %")};
///     optim::RobustResult best = optim::solve_robust(robust_problem(question));
///
/// If there is a limit on `yield`, limits with a metric count in the yield and not for the design itself; limits on
/// parameters only hold for the design. Without it, every limit holds for the design.
struct RobustQuestion {
  DesignProblem design{};  ///< variables, objective (a metric or a statistic) and limits
  std::vector<Tolerance> tolerances{};               ///< parameters that scatter
  std::vector<StatisticLimit> statistics{};          ///< limits on the built motors
  std::vector<ToleranceCorrelation> correlations{};  ///< of the tolerances; others are independent
  MeasuredParts parts{};                             ///< beside the tolerances; may be empty
};

/// Why a tolerance cannot be used in a search, if it cannot.
std::optional<ValueError> search_complaint(const Tolerance& tolerance);

/// Whether a goal has a value without tolerances: a metric, its mean and its quantiles have one, a standard
/// deviation, probability or yield has none.
bool has_nominal_value(const DesignObjective& goal);

/// The goal of the first search, without tolerances: the metric of the goal. For a probability or yield, the first
/// metric in it, in the direction away from its limit.
DesignObjective nominal_goal(const DesignObjective& goal, const std::vector<MotorLimit>& limits);

/// The question as a robust problem in SI units. Its responses are the limits and metrics of the statistics, then the
/// limits that motor_problem() adds. It keeps a copy of the question.
/// @throws InputError if the question has no meaning, as motor_problem()
optim::RobustProblem robust_problem(const RobustQuestion& question);

}  // namespace twum::inline v0_1::studies
