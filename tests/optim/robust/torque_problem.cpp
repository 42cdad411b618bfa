// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace twum::test {
namespace {

// Fields of a line of CSV, which may be quoted.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

}  // namespace

double robust_case(const char* name, const char* quantity, std::size_t place) {
  std::ifstream file(TWUM_TEST_DATA "/reference/robust.csv");
  for (std::string line; std::getline(file, line);) {
    const auto fields = fields_of(line);
    if (fields[0] != name || fields[1] != quantity) continue;
    std::istringstream numbers(fields[2]);
    std::string number;
    for (std::size_t i = 0; i <= place; ++i) std::getline(numbers, number, ';');
    return std::stod(number);
  }
  throw std::runtime_error(std::string("no case ") + name + ", " + quantity);
}

optim::RobustProblem torque_problem(optim::Law law) {
  constexpr double kRadius = 26.5e-3;
  optim::RobustProblem problem;
  problem.design.variables = {{"F", 60.0, 300.0, 160.0}};
  problem.design.objectives = {{"F", optim::Sense::maximize}};
  problem.design.evaluate = [](std::span<const double> x, bool) {
    return optim::Evaluation{{x[0]}, {1.0}, {}, {}};
  };
  problem.inputs = {{"mu", law, 0.1, 0.0, true, {}, 0.2}, {"F", law, 0.03, 0.0, true, 0, 0.0}};
  problem.limits = {{"torque"}};
  problem.built = [](std::span<const double> built, std::optional<std::size_t>, bool) {
    const double force = built[0], mu = built[1];
    return optim::Evaluation{{mu * force * kRadius}, {mu * kRadius, force * kRadius}, {}, {}};
  };
  return problem;
}

optim::RobustProblem linear_problem(const std::vector<std::vector<double>>& directions,
                                    const std::vector<double>& weights, double yield) {
  optim::RobustProblem problem;
  const std::size_t n = directions.size(), m = directions.front().size();
  for (std::size_t j = 0; j < n; ++j) {
    problem.design.variables.push_back({"x" + std::to_string(j + 1), 0.0, 6.0, 2.5});
    problem.limits.push_back({"limit " + std::to_string(j + 1), 0.0});
  }
  problem.design.objectives = {{"cost", optim::Sense::minimize}};
  problem.design.evaluate = [weights](std::span<const double> x, bool) {
    double sum = 0.0;
    for (std::size_t j = 0; j < x.size(); ++j) sum += weights[j] * x[j];
    return optim::Evaluation{{sum}, weights, {}, {}};
  };
  for (std::size_t k = 0; k < m; ++k) {
    optim::RandomInput input{"Z" + std::to_string(k + 1), optim::Law::normal, 1.0};
    input.relative = false;
    problem.inputs.push_back(input);
  }
  problem.yields = {{"yield", {}, yield}};
  for (std::size_t j = 0; j < n; ++j) problem.yields[0].limits.push_back(j);
  problem.built = [directions, n, m](std::span<const double> built, std::optional<std::size_t> only,
                                     bool) {
    optim::Evaluation answer;
    for (std::size_t j = 0; j < n; ++j) {
      if (only && *only != j) continue;
      double value = built[j];
      for (std::size_t i = 0; i < n; ++i) answer.jacobian.push_back(i == j ? 1.0 : 0.0);
      for (std::size_t k = 0; k < m; ++k) {
        value -= directions[j][k] * built[n + k];
        answer.jacobian.push_back(-directions[j][k]);
      }
      answer.values.push_back(value);
    }
    return answer;
  };
  return problem;
}

}  // namespace twum::test
