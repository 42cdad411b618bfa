// SPDX-License-Identifier: Apache-2.0
#include "robust/margin.hpp"

#include <cmath>
#include <numeric>
#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

// Where input k stands among the built values.
std::vector<std::size_t> places(const RobustProblem& problem) {
  std::vector<std::size_t> list;
  std::size_t next = problem.design.variables.size();
  for (const RandomInput& input : problem.inputs)
    list.push_back(input.variable ? *input.variable : next++);
  return list;
}

// The measured inputs of a product that is drawn, from the first one on.
struct DrawnRow {
  std::size_t first;
  std::span<const double> values;

  bool has(std::size_t input) const { return input >= first; }
  double of(std::size_t input) const { return values[input - first]; }
};

DrawnRow drawn_row(const RobustProblem& problem, std::span<const double> z) {
  const std::size_t inputs = problem.inputs.size();
  if (z.size() <= inputs) return {inputs, {}};
  return {inputs - problem.measured.columns(), problem.measured.draw(normal_cdf(z.back()))};
}

}  // namespace

std::size_t drawn_numbers(const RobustProblem& problem) {
  return problem.inputs.size() + (problem.measured.empty() ? 0 : 1);
}

std::span<const double> input_numbers(const RobustProblem& problem, std::span<const double> z) {
  return z.first(problem.inputs.size());
}

double norm(std::span<const double> v) { return std::sqrt(dot(v, v)); }

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::vector<Margin> margins_of(const RobustProblem& problem, std::size_t response) {
  const RandomLimit& limit = problem.limits[response];
  std::vector<Margin> list;
  if (limit.lower > -kInfinity) list.push_back({response, 1.0, limit.lower, true});
  if (limit.upper < kInfinity) list.push_back({response, -1.0, limit.upper, true});
  return list;
}

double design_value(const RobustProblem& problem, std::span<const double> x, std::size_t k) {
  const RandomInput& input = problem.inputs[k];
  return input.variable ? x[*input.variable] : input.value;
}

std::vector<double> build(const RobustProblem& problem, std::span<const double> x,
                          std::span<const double> z) {
  std::vector<double> built(x.begin(), x.end());
  const auto numbers = input_numbers(problem, z);
  const std::vector<double> y = problem.correlation.correlated({numbers.begin(), numbers.end()});
  const DrawnRow row = drawn_row(problem, z);
  for (std::size_t k = 0; k < problem.inputs.size(); ++k) {
    const RandomInput& input = problem.inputs[k];
    const double value = row.has(k) ? row.of(k) : input.at(design_value(problem, x, k), y[k]).value;
    if (input.variable)
      built[*input.variable] = value;
    else
      built.push_back(value);
  }
  return built;
}

MarginPoint margin_at(const RobustProblem& problem, const Margin& margin, std::span<const double> x,
                      std::vector<double> z) {
  MarginPoint point;
  point.z = std::move(z);
  Evaluation answer;
  try {
    answer = problem.built(build(problem, x, point.z), margin.response, true);
  } catch (const EvaluationError& error) {
    answer.failure = error.reason();
  }
  point.failure = answer.failure;
  if (!answer.ok()) return point;
  point.value = margin.sign * (answer.values.front() - margin.end);
  for (double& entry : answer.jacobian) entry *= margin.sign;
  point.by_design.assign(answer.jacobian.begin(),
                         answer.jacobian.begin() + static_cast<std::ptrdiff_t>(x.size()));
  const auto place = places(problem);
  const auto numbers = input_numbers(problem, point.z);
  const std::vector<double> y = problem.correlation.correlated({numbers.begin(), numbers.end()});
  const DrawnRow row = drawn_row(problem, point.z);
  for (std::size_t k = 0; k < problem.inputs.size(); ++k) {
    const BuiltValue built = row.has(k) ? BuiltValue{row.of(k)}
                                        : problem.inputs[k].at(design_value(problem, x, k), y[k]);
    const double slope = answer.jacobian[place[k]];
    point.by_input.push_back(slope);
    point.by_normal.push_back(slope * built.by_normal);
    point.by_spread.push_back(slope * built.by_spread);
    if (problem.inputs[k].variable) point.by_design[place[k]] = slope * built.by_design;
  }
  point.by_normal = problem.correlation.slopes(std::move(point.by_normal));
  return point;
}

Problem nominal_problem(const RobustProblem& problem) {
  Problem nominal = problem.design;
  for (const RandomLimit& limit : problem.limits) {
    if (limit.lower > -kInfinity || limit.upper < kInfinity)
      nominal.constraints.push_back({limit.name, limit.lower, limit.upper});
  }
  nominal.evaluate = [problem](std::span<const double> x, bool gradient) {
    Evaluation answer = problem.design.evaluate(x, gradient);
    if (!answer.ok()) return answer;
    if (!gradient) answer.jacobian.clear();  // an evaluator may give it unasked
    std::vector<double> built(x.begin(), x.end());
    for (const RandomInput& input : problem.inputs)
      if (!input.variable) built.push_back(input.value);
    const Evaluation more = problem.built(built, {}, gradient);
    if (!more.ok()) return more;
    for (std::size_t j = 0; j < problem.limits.size(); ++j) {
      if (!(problem.limits[j].lower > -kInfinity || problem.limits[j].upper < kInfinity)) continue;
      answer.values.push_back(more.values[j]);
      if (!gradient) continue;
      const auto row = more.jacobian.begin() + static_cast<std::ptrdiff_t>(j * built.size());
      answer.jacobian.insert(answer.jacobian.end(), row,
                             row + static_cast<std::ptrdiff_t>(x.size()));
    }
    return answer;
  };
  return nominal;
}

}  // namespace twum::inline v0_1::optim
