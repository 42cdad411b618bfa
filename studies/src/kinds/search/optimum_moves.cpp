// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/optimum_moves.hpp"

#include "entries/plate_derivatives.hpp"
#include "kinds/calibrate/answer_moves.hpp"

#include <twum/optim/optimum_moves.hpp>

#include <algorithm>

namespace twum::inline v0_1::studies {
namespace {

// Parameters of the motor that are neither varied nor derived.
std::vector<Parameter> held_parameters(const DesignProblem& question, const MotorDesign& motor) {
  std::vector<Parameter> set = parameters_of(question.variables);
  for (const DerivedParameter& rule : question.derived) set.push_back(rule.parameter);
  std::vector<Parameter> held;
  for (const ParameterInfo& row : parameter_table()) {
    const bool taken = std::any_of(set.begin(), set.end(), [&](Parameter other) {
      return other == row.parameter || info(other).alternative == row.parameter;
    });
    if (!taken && may_move(motor, row)) held.push_back(row.parameter);
  }
  return held;
}

// Moves the radii that touch another one into the result's list.
std::vector<Parameter> without_touching(const DesignProblem& question, const MotorDesign& motor,
                                        const std::vector<Parameter>& held,
                                        OptimizeResult& result) {
  std::vector<Parameter> kept;
  for (const Parameter parameter : held) {
    if (const auto other = equal_radius(motor, parameter, question.derived))
      result.touching.emplace_back(info(parameter).name, info(*other).name);
    else
      kept.push_back(parameter);
  }
  return kept;
}

// The same question with these parameters as further variables, each held at its value.
DesignProblem widened(DesignProblem question, const std::vector<Parameter>& held,
                      const MotorDesign& motor) {
  for (const Parameter parameter : held) {
    const double value = get(motor, parameter);
    question.vary(parameter, value, value);
  }
  return question;
}

std::vector<double> with_values(std::vector<double> design, const std::vector<Parameter>& held,
                                const MotorDesign& motor) {
  for (const Parameter parameter : held) design.push_back(get(motor, parameter));
  return design;
}

// The parameters on which at least one response depends.
std::vector<Parameter> counting(const optim::Problem& problem, const std::vector<double>& at,
                                const std::vector<Parameter>& held) {
  const optim::Evaluation here = problem.evaluate(at, true);
  const std::size_t before = at.size() - held.size();
  std::vector<Parameter> list;
  for (std::size_t k = 0; k < held.size(); ++k) {
    bool any = false;
    for (std::size_t r = 0; r < here.values.size(); ++r)
      any = any || here.jacobian[r * at.size() + before + k] != 0;
    if (any) list.push_back(held[k]);
  }
  return list;
}

// A goal may be a variable, such as the least preload.
bool value_there(const std::vector<NamedValue>& values, const std::string& name) {
  return std::any_of(values.begin(), values.end(),
                     [&](const NamedValue& one) { return one.name == name; });
}

}  // namespace

void add_moves(const DesignProblem& question, const optim::Result& found, OptimizeResult& result) {
  // The sets are in the motor, so that the design is that of the variables alone.
  const auto count = static_cast<std::ptrdiff_t>(question.variables.size());
  const std::vector<double> design(found.design.begin(), found.design.begin() + count);
  const MotorDesign motor = motor_of(question, design);
  std::vector<Parameter> held =
      without_touching(question, motor, held_parameters(question, motor), result);
  held = counting(motor_problem(widened(question, held, motor)), with_values(design, held, motor),
                  held);
  const optim::OptimumMoves moves =
      optim::optimum_moves(motor_problem(widened(question, held, motor)),
                           with_values(design, held, motor), held.size(), found.certificate);
  result.unmoved = moves.reason;
  if (moves.objective.empty()) return;
  std::vector<std::size_t> variables;
  for (std::size_t j = 0; j < question.variables.size(); ++j) {
    const ParameterInfo& row = info(question.variables[j].parameter);
    if (row.integer) continue;
    variables.push_back(j);
    result.moving.push_back({std::string(row.name), std::string(row.unit), design[j]});
  }
  const bool of_design = value_there(result.moving, result.goal.metric);
  if (!of_design)
    result.moving.push_back(
        {result.goal.metric, result.goal.unit, found.evaluation.values.front()});
  for (std::size_t k = 0; k < held.size(); ++k) {
    const ParameterInfo& row = info(held[k]);
    Move move{{std::string(row.name), std::string(row.unit), get(motor, held[k])}, {}};
    for (const std::size_t j : variables) move.slopes.push_back(moves.design[j * held.size() + k]);
    if (!of_design) move.slopes.push_back(moves.objective[k]);
    result.moves.push_back(std::move(move));
  }
}

}  // namespace twum::inline v0_1::studies
