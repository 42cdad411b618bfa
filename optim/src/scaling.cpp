// SPDX-License-Identifier: Apache-2.0
#include "scaling.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {

Scaling::Scaling(const Problem& problem)
    : variables_(problem.variables),
      factors_(problem.responses(), 1.0),
      flat_(problem.responses(), false) {
  for (std::size_t j = 0; j < variables_.size(); ++j) {
    fixed_.push_back(variables_[j].lower);
    if (variables_[j].lower < variables_[j].upper) free_.push_back(j);
  }
}

void Scaling::scale_responses(std::span<const double> design, const Evaluation& evaluation) {
  // A response with zero gradient at the start is scaled by its value instead. The limits prevent an unusual start
  // from making later numbers underflow.
  constexpr double kLeast = 1e-10;
  constexpr double kMost = 1e10;
  for (std::size_t r = 0; r < factors_.size(); ++r) {
    factors_[r] = 1.0;
    double size = 0.0;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const double d = std::abs(derivative(evaluation, r, k, design));
      if (std::isfinite(d)) size = std::max(size, d);
    }
    flat_[r] = size <= 1e-12 * std::abs(evaluation.values[r]);
    if (flat_[r]) size = std::abs(evaluation.values[r]);
    if (size == 0.0) size = 1.0;
    factors_[r] = std::clamp(1.0 / size, kLeast, kMost);
  }
}

std::vector<double> Scaling::to_unit(std::span<const double> design) const {
  std::vector<double> unit(free_.size());
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const Variable& v = variables_[free_[k]];
    const double x = std::clamp(design[free_[k]], v.lower, v.upper);
    unit[k] = v.scale == Scale::log ? std::log(x / v.lower) / std::log(v.upper / v.lower)
                                    : (x - v.lower) / (v.upper - v.lower);
    unit[k] = std::clamp(unit[k], 0.0, 1.0);
  }
  return unit;
}

std::vector<double> Scaling::to_design(std::span<const double> unit) const {
  std::vector<double> design = fixed_;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const Variable& v = variables_[free_[k]];
    const double u = unit[k];
    if (u <= 0.0) continue;  // fixed_ holds the lower bound, exactly
    double x = v.upper;      // and the upper bound is met exactly too
    if (u < 1.0) {
      x = v.scale == Scale::log ? v.lower * std::exp(u * std::log(v.upper / v.lower))
                                : v.lower + u * (v.upper - v.lower);
      x = std::clamp(x, v.lower, v.upper);
    }
    design[free_[k]] = x;
  }
  return design;
}

double Scaling::slope(std::size_t k, std::span<const double> design) const {
  const Variable& v = variables_[free_[k]];
  return v.scale == Scale::log ? design[free_[k]] * std::log(v.upper / v.lower) : v.upper - v.lower;
}

double Scaling::derivative(const Evaluation& e, std::size_t response, std::size_t k,
                           std::span<const double> design) const {
  const double d = e.jacobian[response * variables_.size() + free_[k]];
  return factors_[response] * d * slope(k, design);
}

}  // namespace twum::optim
