// SPDX-License-Identifier: Apache-2.0
#include "problem/combinations.hpp"

#include <twum/base/error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// The number of a set in a design, from 0.
std::size_t number_of_set(double value) { return static_cast<std::size_t>(std::lround(value)) - 1; }

// Checks the number of values of a design: those of its variables, then a number for each choice.
void require_size(const DesignProblem& problem, std::span<const double> design) {
  const std::size_t expected = problem.variables.size() + problem.choices.size();
  if (design.size() == expected) return;
  throw InputError("design: " + counted(design.size(), "value") + ", but the problem has " +
                   std::to_string(expected) + " variables and choices");
}

// The motor with the sets of the combination `number`.
MotorDesign motor_with_sets(const DesignProblem& problem, std::size_t combination) {
  MotorDesign motor = problem.motor;
  for (const DesignChoice& choice : problem.choices) {
    motor = with(motor, choice.sets[combination % choice.sets.size()].values);
    combination /= choice.sets.size();
  }
  return motor;
}

}  // namespace

DesignProblem& DesignProblem::choose(std::string name, std::vector<ParameterSet> sets) {
  choices.push_back({std::move(name), std::move(sets)});
  return *this;
}

std::vector<DesignProblem> combinations(const DesignProblem& problem) {
  std::size_t count = 1;
  for (const DesignChoice& choice : problem.choices) count *= choice.sets.size();
  std::vector<DesignProblem> list;
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(problem);
    list.back().motor = motor_with_sets(problem, i);
    list.back().choices.clear();
  }
  return list;
}

std::size_t combination_of(const DesignProblem& problem, std::span<const double> design) {
  require_size(problem, design);
  std::size_t combination = 0;
  for (std::size_t i = problem.choices.size(); i-- > 0;)
    combination = combination * problem.choices[i].sets.size() +
                  number_of_set(design[problem.variables.size() + i]);
  return combination;
}

std::vector<const ParameterSet*> chosen_sets(const DesignProblem& problem,
                                             std::span<const double> design) {
  require_size(problem, design);
  std::vector<const ParameterSet*> sets;
  for (std::size_t i = 0; i < problem.choices.size(); ++i)
    sets.push_back(
        &problem.choices[i].sets.at(number_of_set(design[problem.variables.size() + i])));
  return sets;
}

VariedParameters varied_parameters(const DesignProblem& problem) {
  return {problem.motor, parameters_of(problem.variables), problem.derived};
}

MotorDesign motor_of(const DesignProblem& problem, std::span<const double> design) {
  DesignProblem made = problem;
  made.choices.clear();
  for (const ParameterSet* set : chosen_sets(problem, design))
    made.motor = with(made.motor, set->values);
  return motor_of_combination(made, varied_parameters(made),
                              design.first(problem.variables.size()));
}

MotorDesign motor_of_combination(const DesignProblem& problem, const VariedParameters& varied,
                                 std::span<const double> values) {
  std::vector<double> list(values.begin(), values.end());
  double kinetic = problem.motor.friction.kinetic;
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (problem.variables[j].parameter == Parameter::kinetic_friction) kinetic = values[j];
  }
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (problem.variables[j].parameter == Parameter::static_friction)
      list[j] = std::max(list[j], kinetic);
  }
  return varied.motor(list);
}

}  // namespace twum::inline v0_1::studies
