// SPDX-License-Identifier: Apache-2.0
#include "fronts/front.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

std::vector<double> minimized(const Problem& problem, const Evaluation& evaluation) {
  std::vector<double> f(
      evaluation.values.begin(),
      evaluation.values.begin() + static_cast<std::ptrdiff_t>(problem.objectives.size()));
  for (std::size_t k = 0; k < f.size(); ++k)
    if (problem.objectives[k].sense == Sense::maximize) f[k] = -f[k];
  return f;
}

void validate_front(const Problem& problem, const std::vector<double>& reference) {
  validate(problem);
  if (!problem.derivatives)
    throw InputError("a front needs derivatives, which this problem does not give");
  const std::size_t k = problem.objectives.size();
  if (k != 2 && k != 3)
    throw InputError("a front needs two or three objectives; the problem has " + std::to_string(k));
  if (!reference.empty() && reference.size() != k)
    throw InputError("the reference point has " + std::to_string(reference.size()) +
                     " values for " + std::to_string(k) + " objectives");
}

void measure(Front& front, const Problem& problem, const std::vector<double>& reference) {
  std::vector<std::vector<double>> points;
  for (const auto& p : front.points) points.push_back(minimized(problem, p.evaluation));
  if (points.empty()) return;
  std::vector<double> turned(problem.objectives.size());
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const double sign = problem.objectives[k].sense == Sense::maximize ? -1.0 : 1.0;
    if (!reference.empty()) {
      turned[k] = sign * reference[k];
      continue;
    }
    const auto less = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
    const double low = (*std::min_element(points.begin(), points.end(), less))[k];
    const double high = (*std::max_element(points.begin(), points.end(), less))[k];
    turned[k] = high + 0.1 * (high > low ? high - low : 1.0);
  }
  front.hypervolume = hypervolume(points, turned);
  front.reference = turned;
  for (std::size_t k = 0; k < turned.size(); ++k)
    if (problem.objectives[k].sense == Sense::maximize) front.reference[k] = -turned[k];
}

}  // namespace twum::inline v0_1::optim
