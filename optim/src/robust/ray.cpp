// SPDX-License-Identifier: Apache-2.0
#include "robust/ray.hpp"

namespace twum::inline v0_1::optim {
namespace {

constexpr double kLongestRay = 10.0;  // of t, in units of n

// The rows of a problem behind a first row t, its objectives shifted by t.
Evaluation with_ray(const Problem& problem, const Evaluation& at, const std::vector<double>& slope,
                    double t) {
  if (!at.ok()) return at;
  const std::size_t columns = problem.variables.size(), objectives = slope.size();
  Evaluation answer;
  answer.values = {t};
  answer.values.insert(answer.values.end(), at.values.begin(), at.values.end());
  for (std::size_t k = 0; k < objectives; ++k) answer.values[k + 1] += slope[k] * t;
  if (at.jacobian.empty()) return answer;
  answer.jacobian.assign(columns, 0.0);
  answer.jacobian.push_back(1.0);
  for (std::size_t row = 0; row < at.values.size(); ++row) {
    const auto begin = at.jacobian.begin() + static_cast<std::ptrdiff_t>(row * columns);
    answer.jacobian.insert(answer.jacobian.end(), begin,
                           begin + static_cast<std::ptrdiff_t>(columns));
    answer.jacobian.push_back(row < objectives ? slope[row] : 0.0);
  }
  return answer;
}

}  // namespace

Problem ray_problem(const Problem& problem, const std::vector<double>& f,
                    const std::vector<double>& n) {
  Problem ray;
  ray.variables = problem.variables;
  ray.variables.push_back({"t", -kLongestRay, kLongestRay, 0.0});
  ray.objectives = {{"t", Sense::minimize}};
  std::vector<double> slope;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const bool largest = problem.objectives[k].sense == Sense::maximize;
    slope.push_back(largest ? n[k] : -n[k]);
    const std::string name = "goal " + problem.objectives[k].name;
    ray.constraints.push_back(largest ? Constraint{name, f[k], kInfinity}
                                      : Constraint{name, -kInfinity, f[k]});
  }
  ray.constraints.insert(ray.constraints.end(), problem.constraints.begin(),
                         problem.constraints.end());
  ray.evaluate = [problem, slope](std::span<const double> y, bool gradient) {
    return with_ray(problem, problem.evaluate(y.first(y.size() - 1), gradient), slope, y.back());
  };
  return ray;
}

}  // namespace twum::inline v0_1::optim
