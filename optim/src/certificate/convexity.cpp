// SPDX-License-Identifier: Apache-2.0
#include "certificate/convexity.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// Which signs of a response have to be convex.
std::vector<double> convex_signs(const Problem& problem, std::size_t response) {
  const std::size_t objectives = problem.objectives.size();
  if (response < objectives)
    return {problem.objectives[response].sense == Sense::maximize ? -1.0 : 1.0};
  const Constraint& c = problem.constraints[response - objectives];
  std::vector<double> signs;
  if (std::isfinite(c.upper)) signs.push_back(1.0);
  if (std::isfinite(c.lower)) signs.push_back(-1.0);
  return signs;
}

bool tangent_is_below(const FirstDesign& at, const FirstDesign& other, std::size_t response,
                      double sign) {
  constexpr double kRounding = 1e-9;
  const std::size_t n = at.design.size();
  const double here = sign * at.evaluation.values[response];
  const double there = sign * other.evaluation.values[response];
  double tangent = here, size = std::abs(here) + std::abs(there);
  for (std::size_t j = 0; j < n; ++j) {
    const double step = other.design[j] - at.design[j];
    const double change =
        step == 0.0 ? 0.0 : sign * at.evaluation.jacobian[response * n + j] * step;
    tangent += change;
    size += std::abs(change);
  }
  return tangent <= there + kRounding * size;
}

}  // namespace

bool agree_with_convexity(const Problem& problem, const std::vector<FirstDesign>& seen) {
  for (std::size_t r = 0; r < problem.responses(); ++r)
    for (const double sign : convex_signs(problem, r))
      for (const FirstDesign& a : seen)
        for (const FirstDesign& b : seen)
          if (&a != &b && !tangent_is_below(a, b, r, sign)) return false;
  return true;
}

}  // namespace twum::inline v0_1::optim
