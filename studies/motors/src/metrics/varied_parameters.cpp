// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/varied_parameters.hpp>

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

std::string name_of(Parameter parameter) { return std::string(info(parameter).name); }

// A motor without zeros among its parameters, so that every dependence has a nonzero derivative.
MotorDesign ordinary(const MotorDesign& base, const std::vector<Parameter>& given) {
  std::vector<ParameterValue> values;
  const auto add = [&](const ParameterInfo& row) {
    values.emplace_back(row.parameter, parse_quantity(row.example, {row.unit, "", row.absolute}));
  };
  for (const ParameterInfo& row : parameter_table()) {
    const bool replaced = std::any_of(given.begin(), given.end(), [&](Parameter parameter) {
      return row.parameter == parameter || row.alternative == parameter;
    });
    if (!replaced && in_use(base, row.parameter)) add(row);
  }
  for (const Parameter parameter : given) add(info(parameter));
  MotorDesign start;
  // takes the blocks of the geometry; their numbers are among the values
  start.stator.geometry = base.stator.geometry;
  return with(start, values);
}

// Whether a rule depends on the parameter that another one sets, or on one that follows from it, as G from E.
bool reads(const DerivedParameter& rule, const DerivedParameter& other,
           const ParameterJacobian& follows) {
  return std::any_of(rule.value.terms.begin(), rule.value.terms.end(), [&](const Term& term) {
    const Parameter read = std::get<Parameter>(term);
    return read == other.parameter || follows[index_of(read)][index_of(other.parameter)] != 0;
  });
}

// Throws with the names of rules that depend on each other in a circle.
[[noreturn]] void refuse_circle(const std::vector<DerivedParameter>& rules,
                                const ParameterJacobian& follows) {
  std::vector<const DerivedParameter*> path{&rules.front()};
  for (;;) {
    const auto next = std::find_if(rules.begin(), rules.end(), [&](const DerivedParameter& other) {
      return reads(*path.back(), other, follows);
    });
    TWUM_ASSERT(next != rules.end());
    const auto met = std::find(path.begin(), path.end(), &*next) - path.begin();
    path.push_back(&*next);
    if (met + 1 == std::ssize(path)) continue;  // not met before
    std::string text = name_of(next->parameter) + " follows from itself";
    for (auto one = path.begin() + met; one + 1 != path.end(); ++one)
      text += (one == path.begin() + met ? ": " : ", ") + name_of((*one)->parameter) + " from " +
              name_of((*(one + 1))->parameter);
    throw ValueError(text, "leave out one of these rules");
  }
}

}  // namespace

DerivedParameter parse_derived(Parameter parameter, std::string_view text) {
  const ParameterInfo& row = info(parameter);
  DerivedParameter derived{parameter, parse_side(text)};
  for (const Term& term : derived.value.terms) {
    const auto* request = std::get_if<MetricRequest>(&term);
    if (request != nullptr)
      throw ValueError(
          quoted(info(request->metric).name) + " is a metric",
          "a derived parameter follows from parameters, such as '0.15 * contact_radius'",
          std::min(text.find(info(request->metric).name), text.size()));
  }
  if (!(derived.value.formula.dimension() == Dimension(row.unit)))
    throw ValueError(quoted(derived.value.text) + " is " + dimension_phrase(derived.value.unit()),
                     "expected " + dimension_phrase(row.unit) + " such as " + quoted(row.example));
  return derived;
}

std::vector<MetricExpression> with_derived(std::vector<MetricExpression> metrics,
                                           const std::vector<DerivedParameter>& derived) {
  for (const DerivedParameter& rule : derived) {
    const bool known = std::any_of(metrics.begin(), metrics.end(), [&](const auto& metric) {
      return metric.parameter() != nullptr && *metric.parameter() == rule.parameter;
    });
    if (!known) metrics.push_back(expression_of(rule.parameter));
  }
  return metrics;
}

VariedParameters::VariedParameters(const MotorDesign& base, std::vector<Parameter> varied,
                                   std::vector<DerivedParameter> derived)
    : base_(base), varied_(std::move(varied)), derived_(std::move(derived)) {
  refuse_twice();
  fixed_static_friction_ =
      std::find(varied_.begin(), varied_.end(), Parameter::static_friction) != varied_.end() ||
      std::any_of(derived_.begin(), derived_.end(), [](const DerivedParameter& rule) {
        return rule.parameter == Parameter::static_friction;
      });
  if (!derived_.empty()) put_in_order(base);
  for (const DerivedParameter& rule : derived_) values_.emplace_back(std::span(&rule.value, 1));
}

void VariedParameters::refuse_twice() const {
  std::vector<Parameter> set = varied_;
  for (const DerivedParameter& rule : derived_) {
    for (const Parameter other : set) {
      if (other == rule.parameter)
        throw ValueError(name_of(other) + " is varied or derived already",
                         "leave out one of the two");
      if (info(other).alternative == rule.parameter)
        throw ValueError(name_of(rule.parameter) + " and " + name_of(other) + " exclude each other",
                         "leave out one of the two");
    }
    set.push_back(rule.parameter);
  }
}

// Orders the rules such that each comes after those on which it depends.
void VariedParameters::put_in_order(const MotorDesign& base) {
  std::vector<Parameter> given = varied_;
  for (const DerivedParameter& rule : derived_) given.push_back(rule.parameter);
  const ParameterJacobian follows =
      parameter_jacobian(ordinary(base, given), fixed_static_friction_);
  std::vector<DerivedParameter> ordered;
  while (!derived_.empty()) {
    const auto next = std::find_if(derived_.begin(), derived_.end(), [&](const auto& rule) {
      return std::none_of(derived_.begin(), derived_.end(),
                          [&](const auto& other) { return reads(rule, other, follows); });
    });
    if (next == derived_.end()) refuse_circle(derived_, follows);
    ordered.push_back(std::move(*next));
    derived_.erase(next);
  }
  derived_ = std::move(ordered);
}

namespace {

// Throws if the plate has no suitable mode. Other errors of a geometry are reported by Motor.
void require_wave(const MotorDesign& design) {
  if (!design.stator.geometry) return;
  try {
    plate_model(design, stator::OtherModes::none, stator::Derivatives::none);
  } catch (const InputError&) {
  }
}

}  // namespace

MotorDesign VariedParameters::motor(std::span<const double> values) const {
  TWUM_ASSERT(values.size() == varied_.size());
  std::vector<ParameterValue> list;
  for (std::size_t j = 0; j < values.size(); ++j) list.emplace_back(varied_[j], values[j]);
  for (std::size_t k = 0; k < derived_.size(); ++k) {
    const Parameter parameter = derived_[k].parameter;
    MetricValue value;
    values_[k].combine(with(base_, list), std::span(&value, 1));
    if (value.status != MetricStatus::ok)
      throw EvaluationError(name_of(parameter) + ": " + to_string(value.status),
                            "a derived parameter has no value");
    if (!complaint(parameter, value.value).empty())
      throw EvaluationError(name_of(parameter) + ": " + to_string(MetricStatus::out_of_range),
                            name_of(parameter) + " " + complaint(parameter, value.value));
    list.emplace_back(parameter, value.value);
  }
  MotorDesign design = with(base_, list);
  require_wave(design);
  return design;
}

VariedParameters::Slopes VariedParameters::slopes(const MotorDesign& design) const {
  Slopes slopes;
  for (const ExpressionEvaluator& value : values_) {
    const auto derivative = value.combine(design, fixed_static_friction_);
    slopes.push_back(derivatives(derivative.front().gradient, slopes));
  }
  return slopes;
}

std::vector<double> VariedParameters::derivatives(
    const std::array<double, kParameterCount>& gradient, const Slopes& slopes) const {
  std::vector<double> by;
  for (const Parameter parameter : varied_) by.push_back(gradient[index_of(parameter)]);
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const double partial = gradient[index_of(derived_[k].parameter)];
    if (partial == 0) continue;  // also where the slope is none
    for (std::size_t j = 0; j < by.size(); ++j) by[j] += partial * slopes[k][j];
  }
  return by;
}

}  // namespace twum::inline v0_1::motors
