// SPDX-License-Identifier: Apache-2.0
#include "json_parts.hpp"

#include <twum/base/version.hpp>

#include <cmath>

namespace twum::inline v0_1::cli {

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json motor_json(const studies::MotorFile& motor) {
  Json json{{"twum", version()}, {"name", motor.name}};
  for (const ParameterInfo& row : parameter_table()) {
    if (is_given(motor.design, row.parameter))
      json["motor"][std::string(row.name)] = get(motor.design, row.parameter);
  }
  return json;
}

Json parameter_units_json(const studies::MotorFile& motor) {
  Json units = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    if (is_given(motor.design, row.parameter)) units[std::string(row.name)] = row.unit;
  }
  return units;
}

Json zones_json(const std::vector<Zone>& zones) {
  Json list = Json::array();
  for (const Zone& zone : zones) {
    list.push_back({{"state", to_string(zone.state)}, {"from", zone.from}, {"to", zone.to}});
  }
  return list;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twum::inline v0_1::cli
