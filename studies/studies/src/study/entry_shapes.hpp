// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/schema/shape.hpp>
#include <twum/studies/study/study.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Entries that several kinds of study have; internal.
namespace twum::studies::shapes {

/// Variables in a template.
inline constexpr const char* kRanges =
    "amplitude: {min: 0.8 um, max: 2.2 um}\n"
    "preload: {min: 60 N, max: 300 N}\n"
    "thickness: {min: 0.1 mm, max: 1 mm, scale: log}";

/// `kind:` with the word for a study of type S.
template <typename S>
Field<S> kind_field() {
  return selector<S>("kind", "what the study asks", std::string(S::kName));
}

Shape<MetricExpression> metric(std::string text, std::string example = "peak_power");
Shape<std::vector<MetricExpression>> metrics();
Shape<std::vector<MotorLimit>> constraints();
Shape<std::uint64_t> samples();
Shape<std::uint64_t> seed();
Shape<std::string> folder();  ///< result directory of another study
Shape<double> value_of(const ParameterInfo& parameter);

/// A metric or a statistic to maximize or minimize.
Shape<DesignObjective> wanted(std::string text, bool maximize, std::string example = "peak_power");

/// {maximize: METRIC} or {minimize: METRIC}, or a statistic: two fields of which one is needed.
template <typename T>
std::vector<Field<T>> goal(DesignObjective T::*member) {
  const auto field = [member](const char* name, const char* text, const char* alternative,
                              bool maximize) {
    Field<T> one = required<T>(name, wanted(text, maximize), member);
    one.entry.required = maximize;
    one.entry.alternative_entry = alternative;
    one.write = [write = one.write, member, maximize](const T& from) {
      return (from.*member).maximize == maximize ? write(from) : std::nullopt;
    };
    return one;
  };
  return {field("maximize",
                "what to maximize: a metric, or under tolerances a statistic such as "
                "mean(peak_power) or yield",
                "minimize", true),
          field("minimize", "what to minimize: a metric, or under tolerances a statistic",
                "maximize", false)};
}

/// Adds errors on the number of parameters in a mapping.
using CountCheck = void (*)(const YamlNode& node, const Spot& spot, Diagnostics& diagnostics);
void needs_one(const YamlNode& node, const Spot& spot, Diagnostics& diagnostics);

/// A mapping from parameters, by name or symbol, to something whose shape depends on the parameter.
/// V has a member `parameter`.
/// @param sample  lines for a template
template <typename V>
Shape<std::vector<V>> by_parameter(std::function<Shape<V>(const ParameterInfo&)> shape_of,
                                   std::string text, std::string sample,
                                   CountCheck check_count = needs_one) {
  std::vector<Shape<V>> shapes;
  Shape<std::vector<V>> shape;
  shape.schema.kind = ValueKind::mapping;
  shape.schema.text = std::move(text);
  shape.schema.sample = std::move(sample);
  for (const ParameterInfo& row : parameter_table()) {
    shapes.push_back(shape_of(row));
    SchemaEntry entry;
    entry.name = row.name;
    entry.schema = shapes.back().schema;
    entry.alias = row.symbol;
    entry.alias_counts = true;
    if (row.alternative) entry.alternative_entry = info(*row.alternative).name;
    shape.schema.entries.push_back(std::move(entry));
  }
  shape.read = [schema = shape.schema, shapes, check_count](std::vector<V>& into,
                                                            const YamlNode& node, const Spot& spot,
                                                            Diagnostics& diagnostics) {
    into.clear();
    if (node.kind != YamlNode::Kind::mapping) {
      say_wrong_kind(node, schema, spot, diagnostics);
      return false;
    }
    if (check_count != nullptr) check_count(node, spot, diagnostics);
    for (const auto& [number, entry] : given_entries(node, schema, spot, diagnostics)) {
      const Spot place = spot.entry(entry->key, entry->key_mark);
      V value{};
      if (!shapes[number].read(value, entry->value, place, diagnostics)) continue;
      value.parameter = parameter_table()[number].parameter;
      into.push_back(std::move(value));
    }
    return !into.empty() && into.size() == node.entries.size();
  };
  shape.write = [shapes](const std::vector<V>& values) {
    YamlNode node;
    node.kind = YamlNode::Kind::mapping;
    for (const V& value : values) {
      const ParameterInfo& row = info(value.parameter);
      const auto number = static_cast<std::size_t>(&row - parameter_table().data());
      node.entries.push_back({std::string(row.name), {}, shapes[number].write(value)});
    }
    return node;
  };
  return shape;
}

/// {min, max, scale, start} of each parameter.
Shape<std::vector<DesignVariable>> variables(std::string text, std::string sample);

/// Parameters that follow from the variables, each as an expression.
Shape<std::vector<DerivedParameter>> derived();
/// The entry `derived` of a study S.
template <typename S>
Field<S> derived_field() {
  return hidden(optional<S>("derived", derived(), &S::derived, "none"));
}

/// A parameter and the value that replaces the motor's.
struct Override {
  Parameter parameter{};
  double value{0};
};
Shape<std::vector<Override>> overrides();

/// @name Checks of several entries, each of which says what it finds
/// @{
/// low < high, or low <= high where one of them is the mode; both right.
bool rising(const Given& given, const char* low, double low_value, const char* high,
            double high_value, Diagnostics& diagnostics);
/// A logarithmic scale needs min > 0.
void check_log(const Given& given, double min, Diagnostics& diagnostics);
/// Columns and limits may occur only once in a list.
void check_repeats(const Given& given, Diagnostics& diagnostics);
/// @}

}  // namespace twum::studies::shapes
