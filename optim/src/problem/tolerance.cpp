// SPDX-License-Identifier: Apache-2.0
#include "problem/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

double term_magnitude(const Problem& problem, std::size_t response, const Evaluation& evaluation,
                      std::span<const double> design) {
  constexpr double kLeast = 1e-4;
  const std::size_t n = problem.variables.size();
  double largest = 0.0;
  for (std::size_t j = 0; j < n && !evaluation.jacobian.empty(); ++j) {
    const Variable& v = problem.variables[j];
    const double size = std::max(std::abs(design[j]), kLeast * std::min(1.0, v.upper - v.lower));
    const double term = std::abs(evaluation.jacobian[response * n + j]) * size;
    if (std::isfinite(term)) largest = std::max(largest, term);
  }
  return largest;
}

double limit_tolerance(const Constraint& constraint, double bound, double terms, double relative) {
  if (constraint.tolerance >= 0.0) return constraint.tolerance;
  return relative * std::max(std::abs(bound), terms);
}

double relative_violation(const Problem& problem, const Evaluation& evaluation,
                          std::span<const double> design, double relative) {
  double worst = 0.0;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    const std::size_t r = problem.objectives.size() + i;
    const double value = evaluation.values[r];
    const double bound = value < c.lower ? c.lower : c.upper;
    const double excess = std::max(c.lower - value, value - c.upper);
    if (!(excess > 0.0)) continue;
    const double terms = term_magnitude(problem, r, evaluation, design);
    worst = std::max(worst, relative * (excess / limit_tolerance(c, bound, terms, relative)));
  }
  return worst;
}

}  // namespace twum::inline v0_1::optim
