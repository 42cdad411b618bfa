// SPDX-License-Identifier: Apache-2.0
#include "design/thermal_design.hpp"

#include "design/layer_properties.hpp"
#include "design/stator_heat.hpp"

#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twum::inline v0_1 {
namespace {

using P = Parameter;

constexpr std::array kOfMasses{P::stator_heat_capacity,       P::rotor_heat_capacity,
                               P::housing_heat_capacity,      P::conductance_stator_contact,
                               P::conductance_lining,         P::conductance_stator_housing,
                               P::conductance_rotor_housing,  P::conductance_housing_ambient,
                               P::conductance_stator_ambient, P::conductance_rotor_ambient};
constexpr std::size_t kNeededOfMasses = 7;  // the first of them
constexpr std::array kLimits{P::stator_temperature_limit, P::rotor_temperature_limit,
                             P::housing_temperature_limit, P::contact_temperature_limit};

std::string name_of(P parameter) { return std::string(info(parameter).name); }

std::string in_unit(double value, const char* unit) {
  char text[60];
  std::snprintf(text, sizeof text, "%.10g %s", value, unit);
  return text;
}

std::string of_one_node(const MotorDesign& design) {
  for (const P other : kOfMasses)
    if (in_use(design, other))
      return name_of(other) +
             " must be left out with one_node, which treats the whole motor as one mass, but is "
             "given";
  const OneNode& node = *design.thermal->one_node;
  if (!(node.rise > 0)) return "one_node_rise must be given with one_node, but is missing";
  if (!(node.time_constant > 0))
    return "one_node_time_constant must be given with one_node, but is missing";
  return {};
}

// Heat has to leave every mass: stator and rotor hang together, the housing may hang alone.
bool is_closed_off(const MotorDesign& design) {
  const ThermalConductances& g = design.thermal->conductances;
  const auto open = [](const std::optional<double>& path) { return path.value_or(0) > 0; };
  const bool ring = open(g.stator_ambient) || open(g.rotor_ambient),
             housing = open(g.housing_ambient);
  const bool joined = stator_housing_conductance(design) > 0 || open(g.rotor_housing);
  return joined ? !(ring || housing) : !(ring && housing);
}

std::string of_three_masses(const MotorDesign& design) {
  for (std::size_t i = 0; i < kNeededOfMasses; ++i)
    if (std::isnan(get(design, kOfMasses[i]))) {
      const bool of_geometry =
          design.stator.geometry && kOfMasses[i] == Parameter::stator_heat_capacity;
      return name_of(kOfMasses[i]) + " must be given with thermal, or " +
             (of_geometry ? "the specific heats of substrate and ceramic, or " : "") +
             "one_node with the rise and the time constant of a data sheet, but is missing";
    }
  if (is_closed_off(design))
    return "conductance_housing_ambient must be more than 0 W/K, or another path lead to the "
           "ambient, but the heat has no way out";
  return {};
}

// The parameter that states the same, which the motor gives.
std::string instead_of(P parameter) {
  const auto alternative = info(parameter).alternative;
  return alternative ? "; give drift_" + name_of(*alternative) : std::string();
}

bool has_parameter(const MotorDesign& design, P parameter) {
  const bool of_plate = design.stator.geometry &&
                        (parameter == P::resonance_frequency || parameter == P::force_factor ||
                         parameter == P::blocked_capacitance);
  return of_plate || in_use(design, parameter);
}

std::string of_drift(const MotorDesign& design) {
  for (const DriftRow& row : kDrifts)
    if (in_use(design, row.coefficient) && get(design, row.coefficient) != 0 &&
        !has_parameter(design, row.parameter))
      return name_of(row.coefficient) + " must be left out, but the motor is not given by " +
             name_of(row.parameter) + instead_of(row.parameter);
  return {};
}

std::string of_limits(const MotorDesign& design) {
  const double ambient = design.thermal->ambient;
  for (const P limit : kLimits)
    if (get(design, limit) < ambient)
      return name_of(limit) + " must be at least ambient_temperature = " + in_unit(ambient, "K") +
             ", but is " + in_unit(get(design, limit), "K");
  return {};
}

}  // namespace

Thermal& thermal_of(MotorDesign& design) {
  return design.thermal ? *design.thermal : design.thermal.emplace();
}

double reference_temperature(const MotorDesign& design) {
  if (!design.thermal) return kNoValue;
  return design.thermal->reference.value_or(design.thermal->ambient);
}

double lining_conductance(const MotorDesign& design) {
  if (!design.thermal) return kNoValue;
  if (const auto given = design.thermal->conductances.lining) return *given;
  if (design.thermal->one_node) return kNoValue;
  return lining_conductance_of(design.layer.conductivity.value_or(kNoValue),
                               design.stator.contact_radius, design.stator.contact_width,
                               design.layer.thickness);
}

bool drifts(const MotorDesign& design) {
  return std::any_of(kDrifts.begin(), kDrifts.end(), [&](const DriftRow& row) {
    return in_use(design, row.coefficient) && get(design, row.coefficient) != 0;
  });
}

std::string thermal_complaint(const MotorDesign& design) {
  if (!design.thermal) return {};
  std::string wrong = design.thermal->one_node ? of_one_node(design) : of_three_masses(design);
  if (wrong.empty()) wrong = of_limits(design);
  return wrong.empty() ? of_drift(design) : wrong;
}

std::string operation_complaint(const MotorDesign& design) {
  for (const LoadPhase& phase : design.operation) {
    if (!(phase.time > 0) || std::isinf(phase.time))
      return "operation must have phases with a time of more than 0 s, but one is " +
             in_unit(phase.time, "s");
    if (phase.voltage && !(*phase.voltage > 0))
      return "operation must have voltages of more than 0 V, but one is " +
             in_unit(*phase.voltage, "V");
    if (phase.load && phase.load->argument == Argument::both && !(phase.load->at > 0))
      return "operation must hold torques at speeds of more than 0 rad/s, but one is " +
             in_unit(phase.load->at, "rad/s");
  }
  return {};
}

}  // namespace twum::inline v0_1
