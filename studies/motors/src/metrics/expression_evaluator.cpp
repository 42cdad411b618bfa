// SPDX-License-Identifier: Apache-2.0
// Values of expressions and their derivatives.
#include "metrics/own_metric.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::motors {
namespace {

template <typename... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

// Place of a metric in a list, to which it is added if it is new.
std::size_t place_of(std::vector<MetricRequest>& list, const MetricRequest& request) {
  const auto found = std::find(list.begin(), list.end(), request);
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(request);
  return place;
}

// Of an expression of parameters alone.
Parameter parameter_of(Parameter parameter) { return parameter; }
template <typename Other>
Parameter parameter_of(const Other&) {
  TWUM_ASSERT(false);
  return {};
}

// The value of a formula from those of its terms; the first failure of a term is passed on.
MetricValue value_of(const Formula& formula, std::span<const MetricValue> terms) {
  if (formula.is_name()) return terms[0];
  std::vector<double> values;
  for (const MetricValue& term : terms) {
    if (term.status != MetricStatus::ok) return term;
    values.push_back(term.value);
  }
  const double value = formula.value(values);
  return {value, std::isnan(value) ? MetricStatus::undefined : MetricStatus::ok};
}

// Smoothness of a sum of gradients: the worst of its terms; flat if all are flat.
Smoothness smoothness_of(const FormulaDerivative& formula,
                         std::span<const MetricDerivative> terms) {
  bool undefined = false;
  bool one_sided = formula.kinked;
  bool flat = true;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (formula.by_name[i] == 0) continue;
    const Smoothness term = terms[i].smoothness;
    undefined = undefined || term == Smoothness::undefined || std::isnan(formula.by_name[i]);
    one_sided = one_sided || term == Smoothness::one_sided;
    flat = flat && term == Smoothness::flat;
  }
  if (undefined) return Smoothness::undefined;
  if (one_sided) return Smoothness::one_sided;
  return flat && !terms.empty() ? Smoothness::flat : Smoothness::smooth;
}

// The chain rule: derivatives of the formula by its terms times those of the terms by the parameters.
MetricDerivative derivative_of(const Formula& formula, std::span<const MetricDerivative> terms) {
  if (formula.is_name()) return terms[0];
  MetricDerivative result;
  std::vector<MetricValue> values;
  std::vector<double> numbers;
  for (const MetricDerivative& term : terms) {
    values.push_back(term.value);
    numbers.push_back(term.value.value);
  }
  result.value = value_of(formula, values);
  result.gradient.fill(std::numeric_limits<double>::quiet_NaN());
  result.smoothness = Smoothness::undefined;
  if (result.value.status != MetricStatus::ok) return result;
  const FormulaDerivative derivative = formula.differentiate(numbers);
  result.smoothness = smoothness_of(derivative, terms);
  if (result.smoothness == Smoothness::undefined) return result;
  result.gradient.fill(0);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (derivative.by_name[i] == 0) continue;
    for (std::size_t p = 0; p < kParameterCount; ++p)
      result.gradient[p] += derivative.by_name[i] * terms[i].gradient[p];
  }
  return result;
}

}  // namespace

MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction) {
  return {{get(design, parameter), MetricStatus::ok},
          parameter_jacobian(design, fixed_static_friction)[index_of(parameter)],
          Smoothness::smooth};
}

ExpressionEvaluator::ExpressionEvaluator(std::span<const MetricExpression> expressions) {
  for (const MetricExpression& expression : expressions) {
    Asked asked{expression.formula, {}};
    const Overloaded place{
        [&](const MetricRequest& request) { return Place(place_of(requests_, request)); },
        [](const auto& other) { return Place(other); }};
    for (const Term& term : expression.terms) asked.places.push_back(std::visit(place, term));
    asked_.push_back(std::move(asked));
  }
}

void ExpressionEvaluator::evaluate(const Motor& motor, std::span<MetricValue> values) const {
  combine(motor, twum::evaluate(motor, requests_), values);
}

std::vector<MetricDerivative> ExpressionEvaluator::differentiate(const Motor& motor,
                                                                 bool fixed_static_friction) const {
  return combine(motor, twum::differentiate(motor, requests_, fixed_static_friction),
                 fixed_static_friction);
}

// Calls combine(i, terms) with the terms of each expression.
template <typename Value, typename Find, typename Combine>
void ExpressionEvaluator::combine_terms(const Find& find, const Combine& combine) const {
  std::vector<Value> terms;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    terms.clear();
    for (const Place& place : asked_[i].places) terms.push_back(std::visit(find, place));
    combine(i, terms);
  }
}

void ExpressionEvaluator::combine(const Motor& motor, std::span<const MetricValue> metrics,
                                  std::span<MetricValue> values) const {
  const Overloaded find{[&](std::size_t metric) { return metrics[metric]; },
                        [&](Parameter p) {
                          return MetricValue{get(motor.design(), p), MetricStatus::ok};
                        },
                        [&](const OwnTerm& own) { return own_value(*own, motor); }};
  combine_terms<MetricValue>(find, [&](std::size_t i, std::span<const MetricValue> terms) {
    values[i] = value_of(asked_[i].formula, terms);
  });
}

std::vector<MetricDerivative> ExpressionEvaluator::combine(
    const Motor& motor, std::span<const MetricDerivative> metrics,
    bool fixed_static_friction) const {
  std::vector<MetricDerivative> result;
  const Overloaded find{
      [&](std::size_t metric) { return metrics[metric]; },
      [&](Parameter p) { return parameter_value(motor.design(), p, fixed_static_friction); },
      [&](const OwnTerm& own) { return own_derivative(*own, motor, fixed_static_friction); }};
  combine_terms<MetricDerivative>(find,
                                  [&](std::size_t i, std::span<const MetricDerivative> terms) {
                                    result.push_back(derivative_of(asked_[i].formula, terms));
                                  });
  return result;
}

void ExpressionEvaluator::combine(const MotorDesign& design, std::span<MetricValue> values) const {
  const auto find = [&](const auto& place) {
    return MetricValue{get(design, parameter_of(place)), MetricStatus::ok};
  };
  combine_terms<MetricValue>(find, [&](std::size_t i, std::span<const MetricValue> terms) {
    values[i] = value_of(asked_[i].formula, terms);
  });
}

std::vector<MetricDerivative> ExpressionEvaluator::combine(const MotorDesign& design,
                                                           bool fixed_static_friction) const {
  std::vector<MetricDerivative> result;
  const auto find = [&](const auto& place) {
    return parameter_value(design, parameter_of(place), fixed_static_friction);
  };
  combine_terms<MetricDerivative>(find,
                                  [&](std::size_t i, std::span<const MetricDerivative> terms) {
                                    result.push_back(derivative_of(asked_[i].formula, terms));
                                  });
  return result;
}

std::vector<MetricValue> ExpressionEvaluator::evaluate(const Motor& motor) const {
  std::vector<MetricValue> values(size());
  evaluate(motor, values);
  return values;
}

namespace {

template <typename Chosen>
std::string statuses(std::span<const MetricExpression> expressions,
                     std::span<const MetricValue> values, Chosen chosen) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!chosen(values[i].status)) continue;
    text += (text.empty() ? "" : "; ") + expressions[i].text + ": " + to_string(values[i].status);
  }
  return text;
}

}  // namespace

std::string unanswered(std::span<const MetricExpression> expressions,
                       std::span<const MetricValue> values) {
  return statuses(expressions, values, [](MetricStatus status) {
    return status != MetricStatus::ok && !is_endless(status);
  });
}

std::string without_number(std::span<const MetricExpression> expressions,
                           std::span<const MetricValue> values) {
  return statuses(expressions, values,
                  [](MetricStatus status) { return status != MetricStatus::ok; });
}

}  // namespace twum::inline v0_1::motors
