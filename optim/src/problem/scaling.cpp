// SPDX-License-Identifier: Apache-2.0
#include "problem/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

double range(const Variable& v) {
  return v.scale == Scale::log ? std::log(v.upper / v.lower) : v.upper - v.lower;
}

}  // namespace

Scaling::Scaling(const Problem& problem)
    : variables_(problem.variables), factors_(problem.responses(), 1.0) {
  for (const Objective& o : problem.objectives)
    senses_.push_back(o.sense == Sense::maximize ? -1.0 : 1.0);
  for (std::size_t j = 0; j < variables_.size(); ++j) {
    fixed_.push_back(variables_[j].lower);
    if (!(variables_[j].lower < variables_[j].upper)) continue;
    free_.push_back(j);
    origin_.push_back(variables_[j].lower);
    size_.push_back(range(variables_[j]));
  }
  set_bounds();
}

Scaling::Scaling(const Problem& problem, const std::vector<double>& sizes) : Scaling(problem) {
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const Variable& v = variables_[free_[k]];
    size_[k] = sizes[free_[k]];
    // The point of the range nearest to zero: numbers are densest there.
    if (v.scale == Scale::linear) origin_[k] = std::clamp(0.0, v.lower, v.upper);
  }
  set_bounds();
}

void Scaling::set_bounds() {
  lower_.clear();
  upper_.clear();
  for (std::size_t k = 0; k < free_.size(); ++k) {
    lower_.push_back(scaled(k, variables_[free_[k]].lower));
    upper_.push_back(scaled(k, variables_[free_[k]].upper));
  }
}

double Scaling::scaled(std::size_t k, double x) const {
  const Variable& v = variables_[free_[k]];
  return (v.scale == Scale::log ? std::log(x / origin_[k]) : x - origin_[k]) / size_[k];
}

void Scaling::scale_responses(std::span<const double> design, const Evaluation& evaluation) {
  // A response with zero gradient is scaled by its value instead. The limits prevent an unusual start from making
  // later numbers underflow.
  constexpr double kLeast = 1e-20;
  constexpr double kMost = 1e20;
  for (std::size_t r = 0; r < factors_.size(); ++r) {
    factors_[r] = 1.0;
    double size = 0.0;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      if (!std::isfinite(evaluation.jacobian[r * variables_.size() + free_[k]])) continue;
      size = std::max(size, std::abs(derivative(evaluation, r, k, design)));
    }
    if (size <= 1e-12 * std::abs(evaluation.values[r])) size = std::abs(evaluation.values[r]);
    if (size == 0.0) size = 1.0;
    factors_[r] = std::clamp(1.0 / size, kLeast, kMost);
  }
}

std::vector<double> Scaling::to_unit(std::span<const double> design) const {
  std::vector<double> unit(free_.size());
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const Variable& v = variables_[free_[k]];
    const double x = std::clamp(design[free_[k]], v.lower, v.upper);
    unit[k] = std::clamp(scaled(k, x), lower_[k], upper_[k]);
  }
  return unit;
}

std::vector<double> Scaling::to_design(std::span<const double> unit) const {
  std::vector<double> design = fixed_;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const Variable& v = variables_[free_[k]];
    const double u = unit[k];
    if (u <= lower_[k]) continue;  // fixed_ holds the lower bound, exactly
    double x = v.upper;            // and the upper bound is met exactly too
    if (u < upper_[k]) {
      x = v.scale == Scale::log ? origin_[k] * std::exp(u * size_[k]) : origin_[k] + u * size_[k];
      x = std::clamp(x, v.lower, v.upper);
    }
    design[free_[k]] = x;
  }
  return design;
}

std::vector<double> Scaling::from_range(std::span<const double> part) const {
  std::vector<double> unit(free_.size());
  for (std::size_t k = 0; k < free_.size(); ++k)
    unit[k] = std::clamp(lower_[k] + part[k] * (upper_[k] - lower_[k]), lower_[k], upper_[k]);
  return unit;
}

double Scaling::slope(std::size_t k, std::span<const double> design) const {
  const Variable& v = variables_[free_[k]];
  return v.scale == Scale::log ? design[free_[k]] * size_[k] : size_[k];
}

double Scaling::derivative(const Evaluation& e, std::size_t response, std::size_t k,
                           std::span<const double> design) const {
  const double d = e.jacobian[response * variables_.size() + free_[k]];
  if (std::isinf(d) && holds(d, response, k, design)) return std::copysign(kSteep, d);
  return factors_[response] * d * slope(k, design);
}

bool Scaling::holds(double slope, std::size_t response, std::size_t k,
                    std::span<const double> design) const {
  if (response >= senses_.size()) return false;
  const Variable& v = variables_[free_[k]];
  const double x = design[free_[k]];
  return senses_[response] * slope > 0.0 ? x <= v.lower : x >= v.upper;
}

namespace {

// Magnitudes below `least` units count as one unit.
double magnitude(const Variable& v, double x, double least) {
  if (!(v.lower < v.upper)) return 1.0;
  if (v.scale == Scale::log) return std::min(range(v), 1.0);
  const double unit = std::min(range(v), 1.0);
  return std::min(range(v), std::abs(x) < least * unit ? unit : std::abs(x));
}

}  // namespace

std::vector<double> search_sizes(const Problem& problem, std::span<const double> design) {
  std::vector<double> sizes;
  for (std::size_t j = 0; j < design.size(); ++j) {
    const Variable& v = problem.variables[j];
    const double size = magnitude(v, design[j], 1.0);
    sizes.push_back(v.scale == Scale::log ? size : std::exp2(std::round(std::log2(size))));
  }
  return sizes;
}

std::vector<double> sizes_at(const Problem& problem, std::span<const double> design) {
  constexpr double kLeast = 1e-3;
  std::vector<double> sizes;
  for (std::size_t j = 0; j < design.size(); ++j)
    sizes.push_back(magnitude(problem.variables[j], design[j], kLeast));
  return sizes;
}

}  // namespace twum::inline v0_1::optim
