// SPDX-License-Identifier: Apache-2.0
#include <twum/base/no_value.hpp>
#include <twum/io/formula.hpp>

#include "formula/operations.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

using Operation = Formula::Operation;

// Branches of min, max and abs that differ by less than this, relative to their arguments, count as equal. It is far
// above the rounding of a metric, and the same distance at which metrics report their own kinks.
constexpr double kTie = 1e-9;

struct Partials {
  double left{0};
  double right{0};
};

Partials power_partials(double base, double exponent, double value, bool constant_exponent) {
  const double by_base = exponent == 0 ? 0 : exponent * std::pow(base, exponent - 1);
  return {by_base, constant_exponent ? 0 : value * std::log(base)};
}

// Derivatives of one step's value by its operands a and b.
Partials partials(Operation operation, double a, double b, double value, bool constant_right) {
  switch (operation) {
    case Operation::number:
    case Operation::name: return {};
    case Operation::negate: return {-1, 0};
    case Operation::add: return {1, 1};
    case Operation::subtract: return {1, -1};
    case Operation::multiply: return {b, a};
    case Operation::divide: return {1 / b, -value / b};
    case Operation::power: return power_partials(a, b, value, constant_right);
    case Operation::sqrt: return {0.5 / value, 0};
    case Operation::abs: return {a < 0 ? -1.0 : 1.0, 0};
    case Operation::exp: return {value, 0};
    case Operation::log: return {1 / a, 0};
    case Operation::min: return a <= b ? Partials{1, 0} : Partials{0, 1};
    case Operation::max: return a >= b ? Partials{1, 0} : Partials{0, 1};
  }
  return {};
}

bool sums(Operation operation) {
  return operation == Operation::add || operation == Operation::subtract;
}

// Sizes of the terms of a value, relative to which their difference counts as zero.
std::vector<double> sizes(const std::vector<Formula::Step>& steps,
                          const std::vector<double>& values) {
  std::vector<double> sizes(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool passed_on = steps[i].operation == Operation::negate;
    sizes[i] = sums(steps[i].operation) ? sizes[steps[i].left] + sizes[steps[i].right]
               : passed_on              ? sizes[steps[i].left]
                                        : std::fabs(values[i]);
  }
  return sizes;
}

bool has_kink(const Formula::Step& step, const std::vector<double>& values,
              const std::vector<double>& sizes) {
  if (step.operation == Operation::abs)
    return std::fabs(values[step.left]) <= kTie * sizes[step.left];
  if (step.operation != Operation::min && step.operation != Operation::max) return false;
  return std::fabs(values[step.left] - values[step.right]) <=
         kTie * (sizes[step.left] + sizes[step.right]);
}

}  // namespace

double apply(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::number:
    case Operation::name: return kNoValue;  // have no operands
    case Operation::negate: return -a;
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::divide: return a / b;
    case Operation::power: return std::pow(a, b);
    case Operation::sqrt: return std::sqrt(a);
    case Operation::abs: return std::fabs(a);
    case Operation::exp: return std::exp(a);
    case Operation::log: return std::log(a);
    case Operation::min: return std::min(a, b);
    case Operation::max: return std::max(a, b);
  }
  return kNoValue;
}

Formula::Formula(std::vector<Step> steps, std::string text, Dimension dimension)
    : steps_(std::move(steps)), text_(std::move(text)), dimension_(dimension) {
  TWUM_ASSERT(!steps_.empty());
}

// Values of all steps; empty if one is NaN, which min and max would ignore.
std::vector<double> Formula::values(std::span<const double> names) const {
  std::vector<double> values(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.constant) {
      values[i] = step.value;
    } else if (step.operation == Operation::name) {
      values[i] = names[step.left];
    } else {
      values[i] = apply(step.operation, values[step.left], values[step.right]);
    }
    if (!std::isfinite(values[i])) return {};
  }
  return values;
}

double Formula::value(std::span<const double> names) const {
  if (is_name()) return names[steps_[0].left];
  const std::vector<double> all = values(names);
  return all.empty() ? kNoValue : all.back();
}

FormulaDerivative Formula::differentiate(std::span<const double> names) const {
  FormulaDerivative result{kNoValue, std::vector<double>(names.size(), kNoValue)};
  const std::vector<double> all = values(names);
  if (all.empty()) return result;
  result.value = all.back();
  std::fill(result.by_name.begin(), result.by_name.end(), 0.0);
  const std::vector<double> size = sizes(steps_, all);
  std::vector<double> slope(steps_.size());  // derivative of the result by each step
  slope.back() = 1;
  for (std::size_t i = steps_.size(); i-- > 0;) {
    const Step& step = steps_[i];
    if (step.constant || slope[i] == 0) continue;
    if (step.operation == Operation::name) {
      result.by_name[step.left] += slope[i];
      continue;
    }
    result.kinked = result.kinked || has_kink(step, all, size);
    const Partials by = partials(step.operation, all[step.left], all[step.right], all[i],
                                 steps_[step.right].constant);
    slope[step.left] += slope[i] * by.left;
    if (by.right != 0) slope[step.right] += slope[i] * by.right;
  }
  for (double& entry : result.by_name) {
    if (!std::isfinite(entry)) entry = kNoValue;
  }
  return result;
}

}  // namespace twum::inline v0_1::io
