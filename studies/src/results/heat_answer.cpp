// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

#include <array>

namespace twum::inline v0_1::studies {

Json load_json(const std::optional<LoadPoint>& load) {
  if (!load) return nullptr;
  Json json = Json::object();
  if (load->argument != Argument::speed)
    json["torque"] = load->argument == Argument::both ? load->torque : load->at;
  if (load->argument != Argument::torque) json["speed"] = load->at;
  return json;
}

namespace {

constexpr std::array kLimited{"stator", "rotor", "housing", "contact"};

Json temperatures_json(const PartTemperatures& t) {
  return {{"stator", number_json(t.stator)},
          {"rotor", number_json(t.rotor)},
          {"housing", number_json(t.housing)},
          {"contact", number_json(t.contact)},
          {"lining", number_json(t.lining)}};
}

Json losses_json(const HeatLosses& p) {
  return {{"friction", number_json(p.friction)},
          {"layer", number_json(p.layer)},
          {"stator", number_json(p.stator)},
          {"dielectric", number_json(p.dielectric)}};
}

Json steady_json(const HeatResult::Steady& steady) {
  const bool known = steady.status == "ok";
  Json json{
      {"status", steady.status},
      {"temperatures", known ? temperatures_json(steady.temperatures) : Json(nullptr)},
      {"losses", known ? losses_json(steady.losses) : Json(nullptr)},
      {"gain", known ? Json(steady.gain) : Json(nullptr)},
      {"time_constant", known ? number_json(steady.time_constant) : Json(nullptr)},
      {"lost_after", steady.lost_after > 0 ? number_json(steady.lost_after) : Json(nullptr)},
      {"on_time", {{"status", steady.on_time_status}, {"value", number_json(steady.on_time)}}},
      {"duty_limit",
       {{"status", steady.duty_limit_status}, {"value", number_json(steady.duty_limit)}}}};
  json["states"] = Json::array();
  for (const HeatResult::State& state : steady.states)
    json["states"].push_back({{"stable", state.stable},
                              {"temperatures", temperatures_json(state.temperatures)},
                              {"gain", state.gain}});
  Json balance{
      {"temperature", Json::array()}, {"losses", Json::array()}, {"leaving", Json::array()}};
  for (const HeatBalance& point : steady.balance) {
    balance["temperature"].push_back(point.temperature);
    balance["losses"].push_back(number_json(point.losses));
    balance["leaving"].push_back(number_json(point.leaving));
  }
  json["balance"] = balance;
  json["changes"] = Json::array();
  for (const HeatResult::Change& change : steady.changes)
    json["changes"].push_back({{"metric", change.metric},
                               {"unit", change.unit},
                               {"cold", number_json(change.cold)},
                               {"warm", number_json(change.warm)}});
  return json;
}

Json phase_json(const LoadPhase& phase) {
  Json json{{"load", load_json(phase.load)}, {"time", phase.time}};
  if (phase.voltage) json["voltage"] = *phase.voltage;
  return json;
}

Json cycle_json(const HeatResult::Cycle& cycle) {
  Json json{{"status", cycle.status}, {"phases", Json::array()}};
  for (const LoadPhase& phase : cycle.phases) json["phases"].push_back(phase_json(phase));
  if (cycle.status != "ok") return json;
  json["peak"] = temperatures_json(cycle.found.peak);
  json["mean"] = temperatures_json(cycle.found.mean);
  for (std::size_t i = 0; i < cycle.phases.size(); ++i) {
    json["phases"][i]["start"] = temperatures_json(cycle.found.states[i]);
    json["phases"][i]["losses"] = losses_json(cycle.found.losses[i]);
  }
  json["course"] = Json::array();
  for (const CyclePoint& point : cycle.found.course)
    json["course"].push_back(
        {{"time", point.time}, {"temperatures", temperatures_json(point.temperatures)}});
  return json;
}

Json network_json(const HeatNetwork& n) {
  if (n.one_node)
    return {{"one_node", true},
            {"heat_capacity", n.stator_capacity},
            {"conductance", n.stator_ambient}};
  return {{"one_node", false},
          {"stator_heat_capacity", n.stator_capacity},
          {"rotor_heat_capacity", n.rotor_capacity},
          {"housing_heat_capacity", n.housing_capacity},
          {"stator_contact", n.stator_contact},
          {"lining", n.lining},
          {"stator_housing", n.stator_housing},
          {"rotor_housing", n.rotor_housing},
          {"housing_ambient", n.housing_ambient},
          {"stator_ambient", n.stator_ambient},
          {"rotor_ambient", n.rotor_ambient}};
}

Json heated_json(const HeatResult& result, const HeatResult::Member& member) {
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  json["ambient"] = member.ambient;
  json["network"] = network_json(member.network);
  json["time_constants"] = member.time_constants;
  json["limits"] = Json::object();
  for (std::size_t i = 0; i < kLimited.size(); ++i)
    json["limits"][kLimited[i]] = member.limits[i] ? Json(*member.limits[i]) : Json(nullptr);
  json["steady"] = member.steady ? steady_json(*member.steady) : Json(nullptr);
  json["cycle"] = member.cycle ? cycle_json(*member.cycle) : Json(nullptr);
  return json;
}

}  // namespace

// Of the motor alone its own entries; of a family a list of motors.
Json answer_json(const HeatResult& result) {
  Json heat = Json::object();
  if (result.family)
    heat["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  heat["load"] = load_json(result.load);
  heat["time"] = number_json(result.time);
  heat["units"] = {{"temperatures", "K"}, {"losses", "W"},    {"leaving", "W"}, {"time", "s"},
                   {"torque", "N.m"},     {"speed", "rad/s"}, {"voltage", "V"}};
  if (result.family) {
    heat["units"][result.family->name] = result.family->unit;
    heat["motors"] = Json::array();
    for (const HeatResult::Member& member : result.members)
      heat["motors"].push_back(heated_json(result, member));
  } else if (!result.members.empty()) {
    heat.update(heated_json(result, result.members.front()));
  }
  return {{"heat", heat}};
}

}  // namespace twum::inline v0_1::studies
