// SPDX-License-Identifier: Apache-2.0
#include "fmu/model_description.hpp"

#include <twum/base/version.hpp>
#include <twum/io/number.hpp>

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

// Units of the variables, as powers of SI base units.
constexpr const char* kUnits = R"xml(  <UnitDefinitions>
    <Unit name="V"><BaseUnit kg="1" m="2" s="-3" A="-1"/></Unit>
    <Unit name="Hz"><BaseUnit s="-1"/></Unit>
    <Unit name="N.m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
    <Unit name="N.m.s"><BaseUnit kg="1" m="2" s="-1"/></Unit>
    <Unit name="kg.m2"><BaseUnit kg="1" m="2"/></Unit>
    <Unit name="Ohm"><BaseUnit kg="1" m="2" s="-3" A="-2"/></Unit>
    <Unit name="rad"><BaseUnit rad="1"/></Unit>
    <Unit name="rad/s"><BaseUnit s="-1" rad="1"/></Unit>
    <Unit name="m"><BaseUnit m="1"/></Unit>
    <Unit name="A"><BaseUnit A="1"/></Unit>
    <Unit name="W"><BaseUnit kg="1" m="2" s="-3"/></Unit>
  </UnitDefinitions>
)xml";

// A variable; its reference is that of fmi2.c.
struct Variable {
  int reference;
  const char* name;
  const char* description;
  const char* type;   // an element of FMI
  const char* unit;   // of a real variable
  std::string start;  // of an input or a parameter; empty for an output
  bool parameter{false};
};

std::string element(const Variable& v) {
  const bool output = v.start.empty();
  const char* causality = output ? "output" : v.parameter ? "parameter" : "input";
  const bool real = std::string_view(v.type) == "Real";
  const char* variability = v.parameter ? "fixed" : real ? "continuous" : "discrete";
  std::string text = fmt::format(
      "    <ScalarVariable name=\"{}\" valueReference=\"{}\" causality=\"{}\" variability=\"{}\"{} "
      "description=\"{}\">",
      v.name, v.reference, causality, variability,
      output        ? " initial=\"calculated\""
      : v.parameter ? " initial=\"exact\""
                    : "",
      escaped(v.description));
  text += fmt::format("<{}", v.type);
  if (real) text += fmt::format(" unit=\"{}\"", v.unit);
  if (!output) text += fmt::format(" start=\"{}\"", v.start);
  return text + "/></ScalarVariable>\n";
}

std::vector<Variable> variables(const PlantMotor& motor) {
  const PlantInputs& first = motor.first_inputs();
  const PlantParameters& p = motor.parameters();
  const auto number = [](double value) { return studies::number_text(value); };
  std::vector<Variable> all{
      {1, "voltage", "Voltage of each phase, rms", "Real", "V", number(first.voltage)},
      {2, "frequency", "Frequency of the drive", "Real", "Hz", number(first.frequency)},
      {3, "load_torque", "Torque of the load against positive motion", "Real", "N.m", "0"},
      {4, "enabled", "The drive is on; else the phases lie on off_resistance", "Boolean", "",
       "true"},
      {5, "direction", "Direction of the wave: 1, or -1 with swapped phases", "Integer", "", "1"},
      {11, "rotor_inertia", "Moment of inertia of rotor and shaft", "Real", "kg.m2",
       number(p.rotor_inertia), true},
      {12, "load_inertia", "Moment of inertia of the load", "Real", "kg.m2", number(p.load_inertia),
       true},
      {13, "load_damping", "Viscous friction of the load", "Real", "N.m.s", number(p.load_damping),
       true},
      {14, "load_friction", "Coulomb friction of the load", "Real", "N.m", number(p.load_friction),
       true},
      {15, "off_resistance", "Across each phase while the drive is off; 0 for shorted phases",
       "Real", "Ohm", number(p.off_resistance), true},
      {21, "speed", "Speed of the rotor", "Real", "rad/s", ""},
      {22, "angle", "Angle of the rotor", "Real", "rad", ""},
      {23, "amplitude", "Amplitude of the wave", "Real", "m", ""},
      {24, "phase_lag", "Phase of the wave behind the voltage", "Real", "rad", ""},
      {25, "torque", "Torque of the contact on the rotor; at rest, what holds the load", "Real",
       "N.m", ""},
      {26, "phase_current", "Current in each phase, rms", "Real", "A", ""},
      {27, "electrical_power", "Power into both phases", "Real", "W", ""}};
  if (motor.data().has_sensor != 0)
    all.push_back({28, "sensor_voltage", "Voltage of the sensor, rms", "Real", "V", ""});
  all.push_back({29, "held", "The contact holds the rotor at rest", "Boolean", "", ""});
  return all;
}

// Outputs by their place in the list of variables, which counts from 1.
std::string structure(const std::vector<Variable>& all) {
  std::string unknowns;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].start.empty()) unknowns += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
  return "  <ModelStructure>\n    <Outputs>\n" + unknowns +
         "    </Outputs>\n    <InitialUnknowns>\n" + unknowns +
         "    </InitialUnknowns>\n  </ModelStructure>\n";
}

}  // namespace

std::string model_description(const PlantMotor& motor, const FmuIdentity& identity) {
  std::string text = fmt::format(
      R"xml(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="{}" guid="{}" description="Travelling wave ultrasonic motor: wave, rotor and load in time" generationTool="twum {}" variableNamingConvention="flat" numberOfEventIndicators="0">
  <CoSimulation modelIdentifier="{}" canHandleVariableCommunicationStepSize="true" canGetAndSetFMUstate="true" canSerializeFMUstate="true">
    <SourceFiles><File name="plant.c"/><File name="fmi2.c"/><File name="contact_table.c"/></SourceFiles>
  </CoSimulation>
)xml",
      escaped(identity.name), identity.guid, version(), identity.identifier);
  text += kUnits;
  text +=
      "  <LogCategories>\n    <Category name=\"logStatusWarning\"/>\n    <Category "
      "name=\"logStatusError\"/>\n  </LogCategories>\n";
  text += "  <DefaultExperiment startTime=\"0\" stopTime=\"0.03\" stepSize=\"0.0001\"/>\n";
  text += "  <ModelVariables>\n";
  const std::vector<Variable> all = variables(motor);
  for (const Variable& v : all) text += element(v);
  text += "  </ModelVariables>\n" + structure(all);
  return text + "</fmiModelDescription>\n";
}

}  // namespace twum::inline v0_1::cli
