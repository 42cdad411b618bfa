// SPDX-License-Identifier: Apache-2.0
#include "problem_state.hpp"

#include "conversions.hpp"

#include <twum/motors/motor_file.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>
#include <variant>

namespace twum::inline v0_1::python {

using namespace py::literals;
using studies::DesignProblem;

namespace {

py::dict set_values(const studies::ParameterSet& set) {
  py::dict values;
  for (const auto& [parameter, value] : set.values) values[to_py(info(parameter).name)] = value;
  return values;
}

template <typename List>
bool has_functions(const List& list) {
  return std::ranges::any_of(list, [](const auto& one) {
    return std::ranges::any_of(one.metric.terms, [](const studies::Term& term) {
      return std::holds_alternative<std::shared_ptr<const studies::OwnMetric>>(term);
    });
  });
}

}  // namespace

py::dict problem_state(const PyProblem& self) {
  const DesignProblem& problem = self.problem;
  if (has_functions(problem.objectives) || has_functions(problem.limits))
    throw py::type_error("a problem with a function as a metric cannot be pickled");
  return py::dict("motor"_a = studies::motor_text({self.name, problem.motor}),
                  "variables"_a = list_of(problem.variables,
                                          [](const studies::DesignVariable& one) {
                                            return py::make_tuple(
                                                to_py(info(one.parameter).name), one.min, one.max,
                                                one.scale == optim::Scale::log, one.start);
                                          }),
                  "derived"_a = list_of(problem.derived,
                                        [](const studies::DerivedParameter& one) {
                                          return py::make_tuple(to_py(info(one.parameter).name),
                                                                one.value.text);
                                        }),
                  "choices"_a = list_of(
                      problem.choices,
                      [](const studies::DesignChoice& choice) {
                        return py::make_tuple(
                            choice.name, list_of(choice.sets, [](const studies::ParameterSet& set) {
                              return py::make_tuple(set.name, set.file, set_values(set));
                            }));
                      }),
                  "objectives"_a = list_of(problem.objectives,
                                           [](const studies::DesignObjective& one) {
                                             return py::make_tuple(one.metric.text, one.maximize);
                                           }),
                  "limits"_a = list_of(problem.limits, [](const studies::MotorLimit& one) {
                    return py::str(one.text);
                  }));
}

namespace {

void restore_questions(const py::object& state, DesignProblem& problem) {
  for (const py::handle one : state["objectives"]) {
    const auto [metric, maximize] = py::cast<std::pair<std::string, bool>>(one);
    maximize ? problem.maximize(metric) : problem.minimize(metric);
  }
  for (const py::handle one : state["limits"]) problem.limit(py::cast<std::string>(one));
}

void restore_freedom(const py::object& state, DesignProblem& problem) {
  for (const py::handle one : state["variables"]) {
    const auto [name, min, max, log, start] =
        py::cast<std::tuple<std::string, double, double, bool, double>>(one);
    problem.variables.push_back({studies::parse_parameter(name), min, max,
                                 log ? optim::Scale::log : optim::Scale::linear, start});
  }
  for (const py::handle one : state["derived"]) {
    const auto [name, expression] = py::cast<std::pair<std::string, std::string>>(one);
    problem.derive(studies::parse_parameter(name), expression);
  }
  for (const py::handle one : state["choices"]) {
    const auto [choice, pickled] = py::cast<std::pair<std::string, py::list>>(one);
    std::vector<studies::ParameterSet> sets;
    for (const py::handle set : pickled) {
      const auto [name, file, values] =
          py::cast<std::tuple<std::string, std::string, py::dict>>(set);
      sets.push_back({name, file, to_parameter_values(values)});
    }
    problem.choose(choice, std::move(sets));
  }
}

}  // namespace

PyProblem problem_from(const py::object& state) {
  const studies::Source source("motor", py::cast<std::string>(state["motor"]));
  const studies::MotorFile file = studies::read_motor(source);
  PyProblem self{file.name, DesignProblem{file.design}};
  restore_freedom(state, self.problem);
  restore_questions(state, self.problem);
  return self;
}

}  // namespace twum::inline v0_1::python
