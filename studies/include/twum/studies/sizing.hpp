// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/pareto.hpp>
#include <twum/optim/result.hpp>
#include <twum/studies/motor_problem.hpp>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {

/// Answer to a design question.
struct DesignAnswer {
  optim::Result search{};  ///< outcome, certificate, counts, and the variables of the best design
  /// the best design, or the least infeasible one; the motor of the question if all evaluations failed
  MotorDesign motor{};
};

/// Solves a question with one objective, as the study `optimize` does: from several starts, with each answer
/// evaluated again and certified. Thread-safe. The answer depends on the question and the options only, unless a time
/// limit or a stop request ends the search.
///
/// Costs some hundred to some thousand evaluations, see motor_problem(); with solver "ipopt" one solve computes
/// at a time in a process.
/// @throws InputError as motor_problem() and optim::solve()
DesignAnswer solve(const DesignProblem& problem, const optim::SolveOptions& options = {});

/// Pareto front of two or three objectives.
struct DesignFront {
  optim::Front search{};              ///< outcome, certificates, hypervolume
  std::vector<MotorDesign> motors{};  ///< one for each point, in order of the first objective
};

/// Solves a question with two or three objectives, as the study `pareto` does. Costs as much as
/// optim::pareto_front(); see motor_problem() for an evaluation. Threads and reproducibility are as for
/// solve().
/// @throws InputError as motor_problem() and optim::pareto_front()
DesignFront solve_front(const DesignProblem& problem, const optim::ParetoOptions& options = {});

/// A duty point from texts with units: duty_point("0.5 N.m", "100 rpm"). Answers name it by these texts.
/// @throws InputError naming what is wrong
DutyPoint duty_point(std::string_view torque, std::string_view speed);

/// Finds a motor for a duty, as the study `size` does. Among the motors that meet the limits of the question and
/// carry the load at each speed, it takes the one with the lowest maximum pressure, or with the best objective if the
/// question has one.
///
///     DesignProblem problem{motor};
///     problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
///     problem.limit("max_pressure <= 10 MPa").limit("wear_intensity_at(100 rpm) <= 10 kW/m^2");
///     DesignAnswer best = size(problem, duty_point("0.5 N.m", "100 rpm"));
///
/// Cost and thread safety are as for solve().
/// @throws InputError as solve(), and for an empty duty
/// @{
DesignAnswer size(const DesignProblem& problem, std::span<const DutyPoint> duty,
                  const optim::SolveOptions& options = {}, DutyDrive drive = DutyDrive::fixed);
DesignAnswer size(const DesignProblem& problem, std::initializer_list<DutyPoint> duty,
                  const optim::SolveOptions& options = {}, DutyDrive drive = DutyDrive::fixed);
DesignAnswer size(const DesignProblem& problem, const DutyPoint& duty,
                  const optim::SolveOptions& options = {}, DutyDrive drive = DutyDrive::fixed);
/// @}

/// The question whose motors hold each point of a duty with a drive that follows. Limits on max_pressure, layer_aspect and
/// ceramic_stress hold at each of them, and goals are those of the worst of them.
DesignProblem held_at(DesignProblem problem, std::span<const DutyPoint> duty);

}  // namespace twum::inline v0_1::studies
