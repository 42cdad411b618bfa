// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/pareto.hpp>
#include <twum/optim/result.hpp>
#include <twum/studies/problem/motor_problem.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace twum::studies {

/// What a question about a motor comes to.
struct DesignAnswer {
  optim::Result search;  ///< outcome, certificate, counts, and the variables of the best design
  MotorDesign motor;     ///< the best design, or the least infeasible one; as asked if all failed
};

/// Solves a question with one objective, as the study `optimize` does: from several starts, each
/// answer measured again and certified. Thread-safe; the answer follows from the question and
/// the options alone (a wall-clock budget and a stop request apart).
///
/// Costs some hundred to some thousand evaluations of about 50 microseconds; with solver "ipopt" one
/// solve at a time goes on in a process.
/// @throws InputError as motor_problem() and optim::solve()
DesignAnswer solve(const DesignProblem& problem, const optim::SolveOptions& options = {});

/// The trade-off between two or three objectives.
struct DesignFront {
  optim::Front search;              ///< outcome, certificates, hypervolume
  std::vector<MotorDesign> motors;  ///< one for each point, in order of the first objective
};

/// Solves a question with two or three objectives, as the study `pareto` does. Costs what
/// optim::pareto_front() does, at about 50 microseconds an evaluation. What solve() says of threads
/// and of the answer's causes holds here.
/// @throws InputError as motor_problem() and optim::pareto_front()
DesignFront solve_front(const DesignProblem& problem, const optim::ParetoOptions& options = {});

/// An operating point that a motor has to reach.
struct DutyPoint {
  double torque{0};  ///< load [N m]
  double speed{0};   ///< of the rotor [rad/s]
};

/// A duty as one would say it: duty_point("0.5 N.m", "100 rpm").
/// @throws InputError naming what is wrong
DutyPoint duty_point(std::string_view torque, std::string_view speed);

/// A motor for a duty, as the study `size` finds it: among the motors within the question's limits
/// whose torque at each speed is at least the load, the one with the least maximum pressure, or with the
/// best of the question's objective if it has one.
///
///     DesignProblem problem{motor};
///     problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
///     problem.limit("max_pressure <= 10 MPa").limit("wear_intensity_at(100 rpm) <= 10 kW/m^2");
///     DesignAnswer best = size(problem, duty_point("0.5 N.m", "100 rpm"));
///
/// Costs what solve() does, and is as safe from threads.
/// @throws InputError as solve(), and for an empty duty
/// @{
DesignAnswer size(const DesignProblem& problem, std::span<const DutyPoint> duty,
                  const optim::SolveOptions& options = {});
DesignAnswer size(const DesignProblem& problem, const DutyPoint& duty,
                  const optim::SolveOptions& options = {});
/// @}

}  // namespace twum::studies
