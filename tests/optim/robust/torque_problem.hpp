// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>

#include <vector>

// Robust problems whose answers are known in closed form: cases of reference/robust.csv.
namespace twum::test {

/// The value of a case of reference/robust.csv; of a quantity with several values the one at `place`.
double robust_case(const char* name, const char* quantity, std::size_t place = 0);

/// Holding torque mu F r of a motor with mu = 0.2, F = 160 N, r = 26.5 mm, the preload F its only variable, as the only
/// response; friction and preload scatter by 10 % and 3 %.
optim::RobustProblem torque_problem(optim::Law law);

/// Margins x_j - c_j . Z >= 0 of variables x_j in [0, 6], jointly normal; minimizes the sum of weights times x.
optim::RobustProblem linear_problem(const std::vector<std::vector<double>>& directions,
                                    const std::vector<double>& weights, double yield);

/// One response of standard normal numbers alone; a variable "x" without any effect.
template <typename F>
optim::RobustProblem response_problem(std::size_t inputs, optim::Law law, F response) {
  optim::RobustProblem problem;
  problem.design.variables = {{"x", 0.0, 1.0, 0.5}};
  problem.design.objectives = {{"x", optim::Sense::minimize}};
  problem.design.evaluate = [](std::span<const double> x, bool) {
    return optim::Evaluation{{x[0]}, {1.0}, {}, {}};
  };
  for (std::size_t k = 0; k < inputs; ++k) {
    optim::RandomInput input{"Z" + std::to_string(k + 1), law, 1.0};
    input.relative = false;
    problem.inputs.push_back(input);
  }
  problem.built = [response](std::span<const double> built, std::optional<std::size_t> /*only*/,
                             bool /*gradient*/) {
    optim::Evaluation answer = response(built.subspan(1));
    for (std::size_t row = answer.values.size(); row-- > 0;)
      answer.jacobian.insert(
          answer.jacobian.begin() + static_cast<std::ptrdiff_t>(row * (built.size() - 1)), 0.0);
    return answer;
  };
  return problem;
}

}  // namespace twum::test
