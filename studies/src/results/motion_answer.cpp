// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"
#include "results/motion_notes.hpp"

namespace twum::inline v0_1::studies {
namespace {

Json event_json(const motion::MotionEvent& event) {
  return {{"time", event.time},
          {"event", to_string(event.kind)},
          {"speed", event.speed},
          {"angle", event.angle},
          {"amplitude", event.amplitude}};
}

Json loop_json(const MotionResult::Loop& loop) {
  Json poles = Json::array();
  for (const auto& pole : loop.plant.poles)
    poles.push_back({{"real", pole.real()}, {"imaginary", pole.imag()}});
  const bool by_voltage = loop.actuator == motion::Actuator::voltage;
  const std::string unit = by_voltage ? "V" : "Hz";
  return {{"gains",
           {{"kp", loop.gains.proportional},
            {"ki", loop.gains.integral},
            {"units", {{"kp", unit + ".s/rad"}, {"ki", unit + "/rad"}}}}},
          {"plant",
           {{by_voltage ? "voltage" : "frequency", loop.plant.output},
            {"speed", loop.plant.speed},
            {"gain", loop.plant.gain},
            {"time_constant", loop.plant.time_constant},
            {"poles", poles},
            {"units",
             {{by_voltage ? "voltage" : "frequency", unit},
              {"speed", "rad/s"},
              {"gain", "rad/s/" + unit},
              {"time_constant", "s"},
              {"poles", "1/s"}}}}},
          {"margins",
           {{"gain", number_json(loop.margins.gain)},
            {"phase", number_json(loop.margins.phase)},
            {"crossover", loop.margins.crossover},
            {"units", {{"gain", "1"}, {"phase", "rad"}, {"crossover", "Hz"}}}}}};
}

Json motion_json(const MotionResult& result, const MotionResult::Member& member) {
  Json json = Json::object();
  if (result.family) json[result.family->name] = number_json(member.value);
  json["status"] = member.motion.status;
  json["end"] = member.motion.end;
  json["contacts"] = member.motion.contacts;
  json["events"] = Json::array();
  for (const motion::MotionEvent& event : member.motion.events)
    json["events"].push_back(event_json(event));
  json["notes"] = Json::array();
  for (const MotionNote& note : motion_notes(member.motion))
    json["notes"].push_back({{"note", note.name}, {"text", note.text}});
  json["measures"] = Json::array();
  for (const MotionResult::Measure& one : member.measures) {
    json["measures"].push_back(
        {{"measure", one.text}, {"unit", one.unit}, {"value", number_json(one.value)}});
    if (one.step_error) json["measures"].back()["step_error"] = number_json(*one.step_error);
  }
  if (member.loop) json.update(loop_json(*member.loop));
  if (member.step_error)
    json["step_error"] = {{"speed", member.step_error->speed},
                          {"angle", member.step_error->angle},
                          {"amplitude", member.step_error->amplitude}};
  return json;
}

}  // namespace

// Of the motor alone its own entries; of a family a list of motors.
Json answer_json(const MotionResult& result) {
  Json motion = Json::object();
  if (result.family)
    motion["family"] = {{"parameter", result.family->name}, {"unit", result.family->unit}};
  if (result.engine == motion::MotionEngine::oscillating) {
    motion["engine"] = "oscillating";
    motion["accuracy"] = result.accuracy;
  }
  motion["duration"] = result.duration;
  motion["step"] = result.step;
  motion["units"] = {{"time", "s"},     {"speed", "rad/s"}, {"angle", "rad"}, {"amplitude", "m"},
                     {"duration", "s"}, {"step", "s"},      {"end", "s"}};
  if (result.reference) {
    motion["reference"] = result.reference->value;
    motion["units"]["reference"] =
        result.reference->kind == MotionControl::Kind::position ? "rad" : "rad/s";
  }
  if (result.family) {
    motion["units"][result.family->name] = result.family->unit;
    motion["motors"] = Json::array();
    for (const MotionResult::Member& member : result.members)
      motion["motors"].push_back(motion_json(result, member));
  } else if (!result.members.empty()) {
    motion.update(motion_json(result, result.members.front()));
  }
  return {{"motion", motion}};
}

}  // namespace twum::inline v0_1::studies
