// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust_problem.hpp>
#include <twum/studies/metrics/statistic.hpp>
#include <twum/studies/problem/motor_problem.hpp>
#include <twum/studies/problem/tolerance.hpp>

#include <vector>

namespace twum::studies {

/// A question about the motors that are built to a design.
///
///     RobustQuestion question{{motor}};
///     question.design.vary(Parameter::preload, 60, 300).maximize("peak_power");
///     question.design.limit("no_load_speed >= 100 rpm");
///     question.tolerances = {...};
///     question.statistics = {parse_statistic_limit("yield >= 99 %")};
///     optim::RobustResult best = optim::solve_robust(robust_problem(question));
///
/// Where `yield` stands, limits with a metric in them count in it and are not imposed on the design itself; limits on
/// parameters alone hold for the design. Without `yield` every limit holds for the design.
struct RobustQuestion {
  DesignProblem
      design;  ///< what may vary, what is wanted (a metric, or a statistic), what must hold
  std::vector<Tolerance> tolerances;       ///< what scatters, independently
  std::vector<StatisticLimit> statistics;  ///< what must hold of the built motors
};

/// Why a tolerance cannot be used in a search; nothing if it can.
std::optional<ValueError> search_complaint(const Tolerance& tolerance);

/// Whether a goal has a value without tolerances: a metric, its mean or a quantile of it. A spread and a share have none.
bool has_nominal_value(const DesignObjective& goal);

/// What a search without tolerances looks for in place of a goal, to begin with: the metric itself; of a share the first
/// metric in it, away from its limit.
DesignObjective nominal_goal(const DesignObjective& goal, const std::vector<MotorLimit>& limits);

/// The question as a robust problem in SI units. Its responses are the limits and metrics of the statistics, then limits that
/// follow from them as motor_problem() has it. It keeps a copy of the question.
/// @throws InputError if the question cannot be posed
optim::RobustProblem robust_problem(const RobustQuestion& question);

}  // namespace twum::studies
