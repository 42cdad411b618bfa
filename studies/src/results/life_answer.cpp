// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

namespace twum::inline v0_1::studies {
namespace {

std::string ended_by(const LifeResult::Member& member) {
  for (const LifeResult::Limit& limit : member.limits)
    if (limit.ended) return limit.text;
  return to_string(member.life.end);
}

Json profile_json(const std::vector<LifeResult::AtRadius>& profile) {
  Json list = Json::array();
  for (const LifeResult::AtRadius& one : profile)
    list.push_back({{"radius", one.radius}, {"wear_rate", number_json(one.rate)}});
  return list;
}

Json worn_in_json(const WornIn& state) {
  Json slices = Json::array();
  for (const WornInSlice& slice : state.slices)
    slices.push_back({{"radius", slice.radius}, {"load", slice.load}, {"worn", slice.worn}});
  return {{"speed", state.speed},
          {"torque", state.torque},
          {"wear_intensity", state.intensity},
          {"slices", slices}};
}

Json track_json(const LifeResult::TrackState& state) {
  Json nodes = Json::array();
  for (const LifeResult::AtNode& node : state.nodes)
    nodes.push_back({{"radius", node.radius},
                     {"depth", node.depth},
                     {"pressure", node.pressure},
                     {"load_share", node.share}});
  return {{"seconds", state.seconds},
          {"speed", state.speed},
          {"torque", state.torque},
          {"friction_power", state.friction_power},
          {"nodes", nodes}};
}

Json free_json(const LifeResult::FreeTrack& track) {
  return {{"new", track_json(track.fresh)},
          {"run_in", track.run_in ? track_json(*track.run_in) : Json(nullptr)},
          {"last", track_json(track.last)},
          {"largest_share", track.largest_share}};
}

Json living_json(const LifeResult& result, const LifeResult::Member& member) {
  const bool known = member.status == "ok";
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  json["status"] = member.status;
  json["end"] = {{"limit", known ? Json(ended_by(member)) : Json(nullptr)},
                 {"cause", to_string(member.life.end)},
                 {"depth", known ? number_json(member.life.depth) : Json(nullptr)},
                 {"seconds", number_json(member.life.seconds)},
                 {"revolutions", number_json(member.life.revolutions)}};
  if (!known && member.status != "does-not-wear")
    json["end"]["seconds"] = json["end"]["revolutions"] = nullptr;
  json["limits"] = Json::array();
  for (const LifeResult::Limit& limit : member.limits) json["limits"].push_back(limit.text);
  json["course"] = Json::array();
  for (const LifeResult::Point& point : member.points) {
    Json row{{"depth", point.wear.depth},
             {"seconds", number_json(point.wear.seconds)},
             {"revolutions", number_json(point.wear.revolutions)},
             {"wear_rate", number_json(point.wear.rate)},
             {"thickness", point.wear.thickness},
             {"preload", point.wear.preload},
             {"contact_temperature", number_json(point.wear.contact_temperature)}};
    for (std::size_t i = 0; i < result.columns.size(); ++i)
      row[result.columns[i].name] = number_json(point.metrics[i]);
    row["margins"] = Json::array();
    for (const double margin : point.margins) row["margins"].push_back(number_json(margin));
    json["course"].push_back(std::move(row));
  }
  json["profile"] = {{"new", profile_json(member.profile_new)},
                     {"worn", profile_json(member.profile_worn)}};
  json["wear_stability"] = to_string(member.stability);
  json["worn_in"] = member.worn_in ? worn_in_json(*member.worn_in) : Json(nullptr);
  if (member.free) json["free"] = free_json(*member.free);
  return json;
}

}  // namespace

// Of the motor alone its own entries; of a family a list of motors.
Json answer_json(const LifeResult& result) {
  Json life = Json::object();
  if (result.family)
    life["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  life["load"] = load_json(result.load);
  life["units"] = {
      {"depth", "m"},  {"seconds", "s"}, {"wear_rate", "m/s"},         {"thickness", "m"},
      {"radius", "m"}, {"preload", "N"}, {"contact_temperature", "K"}, {"pressure", "Pa"}};
  for (const StoredColumn& column : result.columns) life["units"][column.name] = column.unit;
  if (result.family) {
    life["units"][result.family->name] = result.family->unit;
    life["motors"] = Json::array();
    for (const LifeResult::Member& member : result.members)
      life["motors"].push_back(living_json(result, member));
  } else if (!result.members.empty()) {
    life.update(living_json(result, result.members.front()));
  }
  return {{"life", life}};
}

}  // namespace twum::inline v0_1::studies
