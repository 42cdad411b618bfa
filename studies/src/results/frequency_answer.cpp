// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

#include <twum/motors/frequency_points.hpp>

namespace twum::inline v0_1::studies {
namespace {

using Member = FrequencyResult::Member;

Json response_json(const ResponsePoint& wave) {
  Json json = Json::object();
  for (const FrequencyColumn& column : frequency_columns())
    json[column.name] = number_json(column.value(wave));
  return json;
}

Json response_json(const std::optional<ResponsePoint>& wave) {
  return wave ? response_json(*wave) : Json(nullptr);
}

// Each column a list: what a chart takes.
Json branch_json(const ResponseBranch& branch) {
  Json json{{"stable", branch.stable},
            {"first_end", to_string(branch.first_end)},
            {"last_end", to_string(branch.last_end)}};
  for (const FrequencyColumn& column : frequency_columns()) {
    Json& list = json[column.name] = Json::array();
    for (const ResponsePoint& point : branch.points)
      list.push_back(number_json(column.value(point)));
  }
  return json;
}

Json response_member_json(const FrequencyResult& result, const Member& member) {
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  json["drive_frequency"] = member.frequency;
  json["running"] = response_json(member.running);
  json["pull_out_below"] = member.pull_out_below ? Json(*member.pull_out_below) : Json(nullptr);
  json["jumps"] = Json::array();
  for (const FrequencyResult::Jumped& one : member.jumps)
    json["jumps"].push_back({{"sweep", one.rising ? "up" : "down"},
                             {"from", response_json(one.jump.from)},
                             {"to", response_json(one.jump.to)}});
  json["branches"] = Json::array();
  for (const ResponseBranch& branch : member.branches)
    json["branches"].push_back(branch_json(branch));
  return json;
}

}  // namespace

Json answer_json(const FrequencyResult& result) {
  Json json = Json::object();
  if (result.family)
    json["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  json["load"] = {
      {result.load.given == Argument::speed ? "speed" : "torque", number_json(result.load.value)}};
  json["from"] = result.from;
  json["to"] = result.to;
  json["units"] = {
      {"from", "Hz"}, {"to", "Hz"}, {"drive_frequency", "Hz"}, {"pull_out_below", "Hz"}};
  if (result.family) json["units"][result.family->name] = result.family->unit;
  for (const FrequencyColumn& column : frequency_columns())
    json["units"][column.name] = column.unit;
  json["responses"] = Json::array();
  for (const Member& member : result.members)
    json["responses"].push_back(response_member_json(result, member));
  return json;
}

}  // namespace twum::inline v0_1::studies
