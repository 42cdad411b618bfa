// SPDX-License-Identifier: Apache-2.0
// Metrics that a program computes.
#include "metrics/own_metric.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

void require_own_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const bool word = !name.empty() && letter(name.front()) && std::ranges::all_of(name, [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
  if (!word)
    throw InputError(
        quoted(name) +
        " cannot be the name of a metric; use letters, digits and '_', a letter first");
  if (find_metric(name) || find_parameter(name))
    throw InputError(quoted(name) + " is a metric or parameter of twum; use another name");
}

// Those that KnownMetrics has made known, the newest first.
OwnMetrics& known() {
  thread_local OwnMetrics metrics;
  return metrics;
}

OwnMetrics shared(const std::vector<OwnMetric>& metrics) {
  OwnMetrics list;
  for (const OwnMetric& own : metrics)
    list.push_back(std::get<OwnTerm>(expression_of(own).terms.front()));
  return list;
}

}  // namespace

const OwnMetrics& known_metrics() { return known(); }

OwnTerm find_known(std::string_view name) {
  const auto found =
      std::ranges::find_if(known(), [&](const OwnTerm& own) { return own->name == name; });
  return found == known().end() ? nullptr : *found;
}

KnownMetrics::KnownMetrics(const std::vector<OwnMetric>& metrics) : KnownMetrics(shared(metrics)) {}

KnownMetrics::KnownMetrics(OwnMetrics metrics) : before_(known()) {
  metrics.insert(metrics.end(), before_.begin(), before_.end());
  known() = std::move(metrics);
}

KnownMetrics::~KnownMetrics() { known() = std::move(before_); }

Dimension dimension_of_own(const OwnMetric& own) {
  if (own.unit == "1") return {};
  const Measure one = parse_measure("1 " + own.unit);
  if (one.value != 1)
    throw InputError(own.name + ": its unit " + quoted(own.unit) + " is not an SI unit");
  return one.dimension;
}

MetricValue own_value(const OwnMetric& own, const Motor& motor) {
  try {
    const double value = own.value(motor);
    return {value, std::isfinite(value) ? MetricStatus::ok : MetricStatus::undefined};
  } catch (const EvaluationError&) {
    return {kNoValue, MetricStatus::undefined};
  }
}

MetricDerivative own_derivative(const OwnMetric& own, const Motor& motor,
                                bool fixed_static_friction) {
  MetricDerivative result;
  result.value = own_value(own, motor);
  result.smoothness = Smoothness::undefined;
  result.gradient.fill(kNoValue);
  if (result.value.status != MetricStatus::ok || !own.gradient) return result;
  result.gradient = own.gradient(motor);
  result.smoothness = Smoothness::smooth;
  if (!fixed_static_friction) return result;
  const Friction& f = motor.design().friction;
  if (f.kinetic > 0)
    result.gradient[index_of(Parameter::kinetic_friction)] -=
        f.threshold / f.kinetic * result.gradient[index_of(Parameter::static_friction)];
  return result;
}

MetricExpression expression_of(OwnMetric metric) {
  require_own_name(metric.name);
  if (!metric.value) throw InputError(metric.name + ": a metric without a function for its value");
  MetricExpression expression;
  expression.text = metric.name;
  expression.formula =
      Formula({{Formula::Operation::name, 0, 0, 0, false}}, metric.name, dimension_of_own(metric));
  expression.terms = {std::make_shared<const OwnMetric>(std::move(metric))};
  return expression;
}

}  // namespace twum::inline v0_1::motors
