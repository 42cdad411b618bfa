// SPDX-License-Identifier: Apache-2.0
#include "study/entries.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/text/number.hpp>
#include <twum/studies/units/units.hpp>

#include <cmath>

namespace twum::studies::entries {
namespace {

double value_of(const YamlNode& node, const ParameterInfo& parameter) {
  return parse_quantity(node.scalar, {parameter.unit, parameter.example});
}

Range range_of(const YamlEntry& entry) {
  const auto parameter = find_parameter(entry.key);
  TWUM_ASSERT(parameter);
  const ParameterInfo& row = info(*parameter);
  const YamlNode* scale = entry.value.find("scale");
  const YamlNode* start = entry.value.find("start");
  Range range{*parameter, value_of(*entry.value.find("min"), row),
              value_of(*entry.value.find("max"), row), scale != nullptr && scale->scalar == "log"};
  if (start != nullptr) range.start = value_of(*start, row);
  return range;
}

}  // namespace

std::vector<Range> ranges(const YamlNode& study) {
  std::vector<Range> result;
  for (const YamlEntry& entry : study.find("variables")->entries) result.push_back(range_of(entry));
  return result;
}

std::vector<MetricExpression> metrics(const YamlNode& study, std::string_view name) {
  std::vector<MetricExpression> result;
  const YamlNode* list = study.find(name);
  if (list == nullptr) return result;
  for (const YamlNode& item : list->items) result.push_back(parse_metric(item.scalar));
  return result;
}

std::vector<Constraint> constraints(const YamlNode& study, std::string_view name) {
  std::vector<Constraint> result;
  const YamlNode* list = study.find(name);
  if (list == nullptr) return result;
  for (const YamlNode& item : list->items) result.push_back(parse_constraint(item.scalar));
  return result;
}

std::uint64_t count(const YamlNode& study, std::string_view name, std::uint64_t fallback) {
  const YamlNode* node = study.find(name);
  return node == nullptr
             ? fallback
             : static_cast<std::uint64_t>(std::llround(parse_quantity(node->scalar, {"1", "100"})));
}

double quantity(const YamlNode& study, std::string_view name, std::string_view unit,
                double fallback) {
  const YamlNode* node = study.find(name);
  return node == nullptr ? fallback : parse_quantity(node->scalar, {unit, ""});
}

std::string word(const YamlNode& study, std::string_view name, std::string_view fallback) {
  const YamlNode* node = study.find(name);
  return std::string(node == nullptr ? fallback : node->scalar);
}

}  // namespace twum::studies::entries
