// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

namespace twum::inline v0_1::studies {
namespace {

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

}  // namespace twum::inline v0_1::studies
