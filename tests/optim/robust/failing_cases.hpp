// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/reliability.hpp>

#include <cmath>
#include <functional>
#include <vector>

// Limits of standard normal numbers whose share of failures is known by a closed form or a quadrature.
namespace twum::test {

// Four ways to fail (Waarts' series system), two of them curved: z1, z2 to the least of four margins.
inline optim::Evaluation four_branches(double b, std::span<const double> z) {
  const double root = std::sqrt(2.0), d = z[0] - z[1], s = (z[0] + z[1]) / root;
  const double curved = b + 0.1 * d * d - std::abs(s), flat = root * b - std::abs(d);
  const double along = s < 0 ? 1 / root : -1 / root, across = d < 0 ? 1.0 : -1.0;
  if (curved < flat) return {{curved}, {0.2 * d + along, -0.2 * d + along}, {}, {}};
  return {{flat}, {across, -across}, {}, {}};
}

// 2 Phi(-b) + 2 int phi(d) Phi(-(b + 0.2 d^2)) over |d| < b, by Simpson's rule; its error is far below 1e-10 of it.
inline double four_branches_risk(double b) {
  constexpr int kSteps = 4000;
  const auto f = [b](double d) {
    return 2 * optim::normal_density(d) * optim::normal_cdf(-(b + 0.2 * d * d));
  };
  double sum = f(-b) + f(b);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 ? 4 : 2) * f(-b + 2 * b * i / kSteps);
  return 2 * optim::normal_cdf(-b) + sum * (2 * b / kSteps) / 3;
}

/// Rows of values and slopes of responses of standard normal numbers.
struct Rows {
  std::vector<double> values;
  std::vector<std::vector<double>> slopes;
};

/// A fixed design whose responses depend on standard normal numbers; all of them >= 0.
template <typename F>
optim::RobustProblem fixed_problem(std::size_t inputs, std::size_t limits, F rows) {
  optim::RobustProblem problem;
  for (std::size_t k = 0; k < inputs; ++k) {
    optim::RandomInput input{"Z" + std::to_string(k + 1), optim::Law::given};
    input.transform = [](double z) { return optim::BuiltValue{z, 0, 1, 0}; };
    problem.inputs.push_back(std::move(input));
  }
  optim::YieldTarget all{"yield"};
  for (std::size_t j = 0; j < limits; ++j) {
    problem.limits.push_back({"limit " + std::to_string(j), 0.0});
    all.limits.push_back(j);
  }
  problem.yields = {all};
  problem.built = [rows](std::span<const double> z, std::optional<std::size_t> only,
                         bool gradient) {
    const Rows found = rows(z);
    optim::Evaluation answer;
    for (std::size_t j = 0; j < found.values.size(); ++j) {
      if (only && *only != j) continue;
      answer.values.push_back(found.values[j]);
      if (gradient)
        answer.jacobian.insert(answer.jacobian.end(), found.slopes[j].begin(),
                               found.slopes[j].end());
    }
    return answer;
  };
  return problem;
}

/// Shares of failures of all limits and of each, from weighted products.
struct Reliability {
  optim::WaysToFail ways;
  optim::FailureShares any;
  std::vector<optim::FailureShares> of_limit;
};

inline Reliability reliability(const optim::RobustProblem& problem, std::uint64_t seed = 1,
                               std::uint64_t products = 16384) {
  optim::WaysOptions options;
  options.seed = seed;
  const optim::FailureShares none(problem.inputs.size());
  Reliability found{optim::ways_to_fail(problem, options), none,
                    std::vector(problem.limits.size(), none)};
  const optim::WeightedProducts drawn(problem.inputs.size(), seed, found.ways.centres);
  for (std::uint64_t i = 0; i < products; ++i) {
    const std::vector<double> z = drawn.normals(i);
    const std::vector<double> y = problem.correlation.correlated(z);
    std::vector<double> built;
    for (std::size_t k = 0; k < y.size(); ++k)
      built.push_back(problem.inputs[k].transform(y[k]).value);
    optim::Evaluation answer;
    try {
      answer = problem.built(built, {}, false);
    } catch (const twum::EvaluationError&) {
      answer.values.assign(problem.limits.size(), -optim::kInfinity);
    }
    bool any = false;
    const auto parts = problem.correlation.parts(z);
    for (std::size_t j = 0; j < answer.values.size(); ++j) {
      const bool fails = answer.values[j] < problem.limits[j].lower;
      any = any || fails;
      fails ? found.of_limit[j].add_failing(i, drawn.weight(z), parts) : found.of_limit[j].add(i);
    }
    any ? found.any.add_failing(i, drawn.weight(z), parts) : found.any.add(i);
  }
  return found;
}

}  // namespace twum::test
