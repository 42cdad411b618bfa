// SPDX-License-Identifier: Apache-2.0
#include "file/operation_shape.hpp"

#include <twum/io/words.hpp>

#include <optional>
#include <string>

namespace twum::inline v0_1::motors {
namespace {

constexpr const char* kExample = "such as {torque: 0.5 N.m, time: 60 s} or {idle: 100 s}";

// A phase as a file gives it.
struct GivenPhase {
  std::optional<double> torque{}, speed{}, time{}, voltage{}, idle{};
};

Shape<double> more_than_zero(std::string text, std::string unit, std::string example) {
  Schema schema = quantity(std::move(text), std::move(unit), std::move(example)).schema;
  schema.min = 0;
  schema.min_excluded = true;
  return number(std::move(schema));
}

bool refuse(const Given& given, const char* entry, std::string found, std::string right,
            Diagnostics& diagnostics) {
  const YamlNode* node = given.find(entry);
  diagnostics.add(node != nullptr ? node->mark : given.node().mark,
                  node != nullptr ? given.path(entry) : given.path(), std::move(found),
                  std::move(right));
  return false;
}

bool check_idle(const Given& given, Diagnostics& diagnostics) {
  for (const char* other : {"torque", "speed", "time", "voltage"})
    if (given.find(other) != nullptr)
      return refuse(given, other, "given together with 'idle', which is a phase without load",
                    "leave it out, or write 'time' in place of 'idle'", diagnostics);
  return true;
}

bool check_phase(GivenPhase& phase, const Given& given, Diagnostics& diagnostics) {
  if (given.find("idle") != nullptr) return check_idle(given, diagnostics);
  if (given.find("time") == nullptr)
    return refuse(given, "time", "the phase has no time", std::string("give it, ") + kExample,
                  diagnostics);
  if (given.find("torque") == nullptr && given.find("speed") == nullptr)
    return refuse(given, "torque", "the phase has neither torque nor speed",
                  std::string("expected a torque, a speed, or both, ") + kExample, diagnostics);
  if (phase.torque && phase.speed && !(*phase.speed > 0))
    return refuse(given, "speed", "a torque held at rest",
                  "expected a speed of more than 0 rpm; at rest friction holds without a wave",
                  diagnostics);
  return true;
}

LoadPhase load_phase(const GivenPhase& given) {
  if (given.idle) return {{}, *given.idle, {}};
  LoadPoint load{Argument::speed, given.speed.value_or(0), 0};
  if (given.torque && given.speed) load = {Argument::both, *given.speed, *given.torque};
  if (given.torque && !given.speed) load = {Argument::torque, *given.torque, 0};
  return {load, given.time.value_or(0), given.voltage};
}

GivenPhase as_given(const LoadPhase& phase) {
  GivenPhase given;
  if (!phase.load) {
    given.idle = phase.time;
    return given;
  }
  given.time = phase.time, given.voltage = phase.voltage;
  const LoadPoint& load = *phase.load;
  if (load.argument != Argument::torque) given.speed = load.at;
  if (load.argument != Argument::speed)
    given.torque = load.argument == Argument::both ? load.torque : load.at;
  return given;
}

Shape<LoadPhase> phase_shape() {
  using P = GivenPhase;
  return shape_as<LoadPhase, P>(
      mapping<P>(
          "a phase",
          {optional<P>("torque", quantity("load torque", "N.m", "0.5 N.m"), &P::torque, "none"),
           optional<P>(
               "speed",
               quantity("rotor speed; given with a torque: the drive is adjusted to hold both",
                        "rad/s", "60 rpm"),
               &P::speed, "the speed under the torque"),
           optional<P>("time", more_than_zero("duration of the phase", "s", "60 s"), &P::time,
                       "none; with 'idle' not needed"),
           optional<P>("voltage", more_than_zero("voltage of each phase, rms", "V", "90 V"),
                       &P::voltage, "the motor's"),
           optional<P>("idle", more_than_zero("duration with the motor off", "s", "100 s"),
                       &P::idle, "a phase with a load")},
          check_phase),
      load_phase, as_given);
}

}  // namespace

const Shape<std::vector<LoadPhase>>& operation_shape() {
  static const Shape<std::vector<LoadPhase>> shape = [] {
    auto phases = list("phases of the operation, repeated continuously", phase_shape());
    phases.schema.example = "[{torque: 0.5 N.m, time: 60 s}, {idle: 100 s}]";
    return phases;
  }();
  return shape;
}

bool check_operation(const std::vector<LoadPhase>& phases, bool has_voltage, const Given& motor,
                     Diagnostics& diagnostics) {
  const YamlNode* node = motor.right("operation");
  if (node == nullptr || has_voltage) return true;
  bool good = true;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (!phases[i].voltage) continue;
    diagnostics.add(node->items[i].mark,
                    motor.path("operation") + "[" + std::to_string(i) + "].voltage",
                    "the amplitude of this motor is given, so it has no voltage",
                    "leave it out, or give stator.voltage");
    good = false;
  }
  return good;
}

}  // namespace twum::inline v0_1::motors
