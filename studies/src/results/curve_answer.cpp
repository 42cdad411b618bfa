// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

// Metrics that a family is compared by; the rest stands in summary.json.
constexpr std::string_view kShown[] = {"stall_torque",
                                       "max_torque",
                                       "no_load_speed",
                                       "peak_power",
                                       "contact_efficiency_at_peak_power",
                                       "contact_ratio",
                                       "max_pressure"};

Json member_json(const CurveResult& result, const CurveResult::Member& member) {
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  json["points"] = member.points;
  json["failed_points"] = member.failed;
  json["last_speed"] = number_json(member.last_speed);
  json["metrics"] = Json::object();
  for (const NamedValue& metric : member.metrics)
    json["metrics"][metric.name] = number_json(metric.value);
  Json missing = Json::object();
  for (std::size_t i = 0; i < member.metrics.size(); ++i) {
    if (member.statuses[i] != "ok") missing[member.metrics[i].name] = member.statuses[i];
  }
  if (!missing.empty()) json["missing"] = missing;
  return json;
}

std::string member_name(const CurveResult& result, const CurveResult::Member& member) {
  return result.family ? engineering(member.value, result.family->unit) : "motor";
}

// One row of the table: a metric of every member.
std::vector<std::string> metric_row(const CurveResult& result, std::size_t metric) {
  std::vector<std::string> row{result.members.front().metrics[metric].name};
  for (const CurveResult::Member& member : result.members) {
    const NamedValue& value = member.metrics[metric];
    row.push_back(member.statuses[metric] == "ok" ? engineering(value.value, value.unit)
                                                  : "- (" + member.statuses[metric] + ")");
  }
  return row;
}

std::string failed_points_text(const CurveResult& result) {
  std::string text;
  for (const CurveResult::Member& member : result.members) {
    if (member.failed == 0) continue;
    text += member_name(result, member) + ": " + std::to_string(member.failed) + " of " +
            std::to_string(member.points) + " points without an answer\n";
  }
  return text;
}

// Members that fit beside each other on a terminal; of a larger family the first ones.
constexpr std::size_t kMostMembers = 8;

}  // namespace

Json answer_json(const CurveResult& result) {
  Json json = Json::object();
  if (result.family) {
    json["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  }
  json["units"] = Json::object();
  if (result.family) json["units"][result.family->name] = result.family->unit;
  json["units"]["last_speed"] = "rad/s";
  if (!result.members.empty()) {
    for (const NamedValue& metric : result.members.front().metrics)
      json["units"][metric.name] = metric.unit;
  }
  json["curves"] = Json::array();
  for (const CurveResult::Member& member : result.members)
    json["curves"].push_back(member_json(result, member));
  return json;
}

std::string answer_text(const CurveResult& result) {
  if (result.members.empty()) return {};
  CurveResult shown = result;
  shown.members.resize(std::min(result.members.size(), kMostMembers));
  TextTable table;
  table.rows.push_back({result.family ? result.family->name : ""});
  for (const CurveResult::Member& member : shown.members)
    table.rows.front().push_back(member_name(result, member));
  for (std::size_t i = 0; i < shown.members.front().metrics.size(); ++i) {
    const std::string& name = shown.members.front().metrics[i].name;
    if (std::find(std::begin(kShown), std::end(kShown), name) != std::end(kShown))
      table.rows.push_back(metric_row(shown, i));
  }
  std::string text = aligned(table);
  if (shown.members.size() < result.members.size()) {
    text += "and " + counted(result.members.size() - shown.members.size(), "more curve") +
            ", see summary.json\n";
  }
  return text + failed_points_text(result);
}

}  // namespace twum::studies
