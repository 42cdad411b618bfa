// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include <twum/studies/schema/validate.hpp>
#include <twum/studies/text/number.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/yaml/loader.hpp>

namespace twum::studies {
namespace {

const YamlNode* parameter_node(const YamlNode& motor, Parameter parameter) {
  return find_path(motor, info(parameter).file_entry);
}

// mu_0 below mu: no single entry is wrong, but the two together are.
void check_friction(const YamlNode& motor, const std::string& path, Diagnostics& diagnostics) {
  const YamlNode* kinetic = parameter_node(motor, Parameter::kinetic_friction);
  const YamlNode* threshold = parameter_node(motor, Parameter::static_friction);
  if (kinetic == nullptr || threshold == nullptr) return;
  const auto mu = quantity_of(*kinetic, parameter_schema(info(Parameter::kinetic_friction)));
  const auto mu_0 = quantity_of(*threshold, parameter_schema(info(Parameter::static_friction)));
  if (!mu || !mu_0 || *mu_0 >= *mu) return;
  diagnostics.add(
      {threshold->mark, path + "." + std::string(info(Parameter::static_friction).file_entry),
       quoted(threshold->scalar) + " is less than the kinetic friction",
       "must be at least " + number_text(*mu), kinetic->mark, "kinetic friction given here"});
}

bool refuse_study(const YamlNode& root, Diagnostics& diagnostics) {
  if (root.find("study") == nullptr) return false;
  diagnostics.add({1, 1}, "study", "a study file",
                  "expected a motor file; a study is run with 'twum run'");
  return true;
}

}  // namespace

std::optional<MotorFile> motor_from(const YamlNode& motor, const std::string& path,
                                    Diagnostics& diagnostics) {
  check_friction(motor, path, diagnostics);
  if (!diagnostics.empty()) return {};
  std::vector<ParameterValue> values;
  for (const ParameterInfo& row : parameter_table()) {
    const YamlNode* node = parameter_node(motor, row.parameter);
    if (node == nullptr) continue;
    const auto value = quantity_of(*node, parameter_schema(row));
    TWUM_ASSERT(value.has_value());
    values.emplace_back(row.parameter, *value);
  }
  // What a valid file does not give follows from what it gives: mu_0 = mu, and no modal damping.
  MotorDesign blank;
  blank.stator.modal_damping = 0;
  blank.friction = {1, 1};
  const YamlNode* name = motor.find("name");
  return MotorFile{name == nullptr ? "" : name->scalar, with(blank, values)};
}

MotorFile read_motor(const Source& source) {
  Diagnostics diagnostics(source);
  const YamlNode root = load_yaml(diagnostics);
  if (!refuse_study(root, diagnostics)) validate(root, motor_file_schema(), diagnostics);
  std::optional<MotorFile> motor;
  if (const YamlNode* node = root.find("motor")) motor = motor_from(*node, "motor", diagnostics);
  diagnostics.throw_if_any();
  TWUM_ASSERT(motor.has_value());
  return *motor;
}

MotorFile read_motor_file(const std::string& path) { return read_motor(read_source(path)); }

}  // namespace twum::studies
