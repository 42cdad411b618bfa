// SPDX-License-Identifier: Apache-2.0
#include "report/names.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/reasons.hpp>
#include <twum/studies/telling.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// What a metric at a point measures: {"metric"}.
void add_request(Json& json, const std::string& name) {
  try {
    const MetricExpression expression = parse_metric(name);
    const MetricRequest* request = expression.request();
    if (request != nullptr && request->argument != Argument::none)
      json["metric"] = info(request->metric).name;
  } catch (const ValueError&) {
    return;  // such as a parameter, or a column of words
  }
}

const Reason* find_reason(std::string_view word) {
  const auto found = std::ranges::find_if(
      reasons(), [&](const Reason& reason) { return to_string(reason.status) == word; });
  return found == reasons().end() ? nullptr : &*found;
}

// The meaning of each word in "speed_at(0.9 N.m): unreachable; stall_torque: undefined", each once.
std::string meaning_of(std::string_view reason) {
  std::vector<const Reason*> told;
  for (std::size_t from = 0; from < reason.size();) {
    const std::size_t end = std::min(reason.find("; ", from), reason.size());
    const std::string_view one = reason.substr(from, end - from);
    const std::size_t colon = one.rfind(": ");
    const Reason* known = find_reason(colon == one.npos ? one : one.substr(colon + 2));
    if (known != nullptr && std::ranges::find(told, known) == told.end()) told.push_back(known);
    from = end + 2;
  }
  std::string text;
  for (const Reason* known : told) text += (text.empty() ? "" : "; ") + std::string(known->meaning);
  return text;
}

}  // namespace

Json names_json(const Json& columns) {
  using namespace telling;
  Json names = Json::object();
  const auto add = [&](const std::string& name) {
    Json& json = names[name];
    json["text"] = written(name_part(name), Writing::page);
    add_request(json, name);
  };
  for (const ParameterInfo& row : parameter_table()) add(std::string(row.name));
  for (const MetricInfo& row : metric_table()) add(std::string(row.name));
  for (const Json& column : columns) add(column["name"]);
  return names;
}

Json failures_json(const Json& summary) {
  Json json = Json::object();
  for (const Json& region : summary["failure_regions"]) {
    const std::string reason = region["reason"];
    json[reason] = meaning_of(reason);
  }
  return json;
}

}  // namespace twum::inline v0_1::studies
