// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/sizing.hpp>

#include "problem/multi_start.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>

namespace twum::studies {
namespace {

double named_quantity(const char* name, std::string_view text, const Expected& expected) {
  try {
    return parse_quantity(text, expected);
  } catch (const InputError& error) {
    throw InputError(std::string(name) + ": " + error.what());
  }
}

// Unlike speed_at(load), the torque at a speed also exists for motors that cannot carry the load.
std::string duty_limit(const DutyPoint& duty) {
  if (!duty.text.empty()) return duty.text;
  return "torque_at(" + number_text(duty.speed) + " rad/s) >= " + number_text(duty.torque) + " N.m";
}

}  // namespace

DesignAnswer solve(const DesignProblem& problem, const optim::SolveOptions& options) {
  DesignAnswer answer{solve_from_starts(motor_problem(problem), options), problem.motor};
  if (!answer.search.design.empty()) answer.motor = motor_of(problem, answer.search.design);
  return answer;
}

DesignFront solve_front(const DesignProblem& problem, const optim::ParetoOptions& options) {
  DesignFront front{optim::pareto_front(motor_problem(problem), options), {}};
  for (const optim::FrontPoint& point : front.search.points)
    front.motors.push_back(motor_of(problem, point.design));
  return front;
}

DutyPoint duty_point(std::string_view torque, std::string_view speed) {
  return {named_quantity("torque", torque, {"N.m", "0.5 N.m"}),
          named_quantity("speed", speed, {"rad/s", "100 rpm"}),
          "torque_at(" + std::string(speed) + ") >= " + std::string(torque)};
}

DesignAnswer size(const DesignProblem& problem, std::span<const DutyPoint> duty,
                  const optim::SolveOptions& options) {
  if (duty.empty()) throw InputError("a duty needs at least one operating point");
  DesignProblem sized = problem;
  sized.limits.clear();
  for (const DutyPoint& point : duty) sized.limit(duty_limit(point));
  sized.limits.insert(sized.limits.end(), problem.limits.begin(), problem.limits.end());
  if (sized.objectives.empty()) sized.minimize("max_pressure");
  return solve(sized, options);
}

DesignAnswer size(const DesignProblem& problem, std::initializer_list<DutyPoint> duty,
                  const optim::SolveOptions& options) {
  return size(problem, std::span(duty.begin(), duty.size()), options);
}

DesignAnswer size(const DesignProblem& problem, const DutyPoint& duty,
                  const optim::SolveOptions& options) {
  return size(problem, std::span(&duty, 1), options);
}

}  // namespace twum::studies
