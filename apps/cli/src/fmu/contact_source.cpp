// SPDX-License-Identifier: Apache-2.0
#include "fmu/contact_source.hpp"

#include <twum/io/number.hpp>

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr std::array kTables{"torque", "reactive", "active"};

void add_array(std::string& text, const std::string& name, const std::vector<float>& values) {
  constexpr std::size_t kInALine = 12;
  auto end = std::back_inserter(text);
  fmt::format_to(end, "static const float {}[] = {{", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    fmt::format_to(end, "{}{:.6e}f,", i % kInALine == 0 ? "\n" : "", values[i]);
  text += "};\n";
}

void add_side(std::string& text, const std::string& name, const PlantMotor::Side& side) {
  for (std::size_t i = 0; i < kTables.size(); ++i)
    add_array(text, name + "_" + kTables[i], side[i]);
}

std::string side_members(std::string_view name) {
  return fmt::format("{{{0}_torque, {0}_reactive, {0}_active}}", name);
}

std::string number(double value) { return studies::number_text(value); }

std::string initialized(std::string_view type, std::string_view name,
                        const std::vector<std::string>& members) {
  return fmt::format("extern const {0} {1};\nconst {0} {1} = {{\n  {2}}};\n", type, name,
                     fmt::join(members, ",\n  "));
}

std::vector<std::string> members(const PlantData& d) {
  return {number(d.modal_mass),
          number(d.modal_damping),
          number(d.modal_stiffness),
          number(d.force_factor),
          number(d.blocked_capacitance),
          number(d.loss_tangent),
          number(d.frequency),
          number(d.opening_amplitude),
          number(d.holding_torque),
          number(d.crest_per_amplitude),
          std::to_string(d.has_sensor),
          number(d.sensor_force_factor),
          number(d.sensor_capacitance),
          number(d.sensor_conductance),
          std::to_string(d.amplitudes),
          std::to_string(d.speed_ratios),
          number(d.largest_amplitude),
          side_members("along"),
          side_members("against"),
          "0",
          "0"};  // nothing is missing in the tables
}

std::vector<std::string> members(const PlantInputs& in) {
  return {number(in.voltage), number(in.frequency), number(in.load_torque),
          std::to_string(in.enabled), std::to_string(in.direction)};
}

std::vector<std::string> members(const PlantParameters& p) {
  return {number(p.rotor_inertia), number(p.load_inertia), number(p.load_damping),
          number(p.load_friction), number(p.off_resistance)};
}

}  // namespace

std::string contact_source(const PlantMotor& motor, const std::string& guid) {
  std::string text =
      "/* Numbers of one motor, written by twum. SI units; members as in plant.h. */\n"
      "#include \"plant.h\"\n\n";
  add_side(text, "along", motor.along());
  add_side(text, "against", motor.against());
  text += "\n" + initialized("PlantData", "twum_motor", members(motor.data()));
  text += initialized("PlantInputs", "twum_first_inputs", members(motor.first_inputs()));
  text += initialized("PlantParameters", "twum_first_parameters", members(motor.parameters()));
  return text +
         fmt::format("extern const char twum_guid[];\nconst char twum_guid[] = \"{}\";\n", guid);
}

}  // namespace twum::inline v0_1::cli
