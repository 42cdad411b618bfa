// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

namespace twum::inline v0_1::studies {
namespace {

void add_values(Json& json, const MapResult& result, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    json[result.columns[i].name] = number_json(values[i]);
}

// Begins an entry with the motor that it is of.
Json of_motor(const MapResult& result, const MapResult::Member& member) {
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  return json;
}

Json point_json(const MapResult& result, const MapResult::Member& member,
                const MapResult::Point& point) {
  Json json = of_motor(result, member);
  json["torque"] = number_json(point.torque);
  json["speed"] = number_json(point.speed);
  json["status"] = point.status;
  add_values(json, result, point.values);
  return json;
}

Json corner_json(const MapResult& result, const MapResult::Member& member,
                 const MapResult::Corner& corner) {
  Json json = of_motor(result, member);
  json["speed"] = number_json(corner.speed);
  json["torque"] = number_json(corner.torque);
  return json;
}

Json duty_json(const MapResult& result, const MapResult::Member& member,
               const MapResult::Duty& duty) {
  Json json = point_json(result, member, duty.at);
  json["needed"] = number_json(duty.needed);
  json["needed_unit"] = duty.unit;
  json["torque_left"] = number_json(duty.torque_left);
  return json;
}

}  // namespace

Json answer_json(const MapResult& result) {
  Json json = Json::object();
  if (result.family)
    json["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  json["units"] = {{"speed", "rad/s"}, {"torque", "N.m"}, {"torque_left", "N.m"}};
  if (result.family) json["units"][result.family->name] = result.family->unit;
  for (const StoredColumn& column : result.columns) json["units"][column.name] = column.unit;
  Json& map = json["map"];
  map = {{"speed", number_json(result.speed)},
         {"torque", number_json(result.torque)},
         {"speeds", result.speeds},
         {"torques", result.torques},
         {"shown", result.columns[result.shown].name},
         {"points", Json::array()},
         {"envelope", Json::array()},
         {"largest_speeds", Json::array()},
         {"duty", Json::array()}};
  for (const MapResult::Member& member : result.members) {
    for (const MapResult::Point& point : member.points)
      map["points"].push_back(point_json(result, member, point));
    for (const MapResult::Corner& corner : member.envelope)
      map["envelope"].push_back(corner_json(result, member, corner));
    map["largest_speeds"].push_back(number_json(member.largest_speed));
    for (const MapResult::Duty& duty : member.duty)
      map["duty"].push_back(duty_json(result, member, duty));
  }
  return json;
}

}  // namespace twum::inline v0_1::studies
