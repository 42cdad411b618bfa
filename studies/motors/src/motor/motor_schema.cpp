// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

struct Section {
  std::string_view name;
  const char* text;
};

constexpr Section kSections[] = {{"stator", "the vibrating ring and its travelling wave"},
                                 {"contact_layer", "the layer between stator and rotor"},
                                 {"friction", "Coulomb friction between stator and contact layer"}};

std::string_view last_step(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

SchemaEntry entry_of(const ParameterInfo& row) {
  SchemaEntry entry;
  entry.name = last_step(row.file_entry);
  entry.schema = parameter_schema(row);
  entry.required = row.required;
  if (row.twin) entry.twin = last_step(info(*row.twin).file_entry);
  entry.alias = row.name == entry.name ? row.symbol : row.name;
  if (row.parameter == Parameter::modal_damping) entry.fallback = "0";
  if (row.parameter == Parameter::static_friction) entry.fallback = "the kinetic one";
  return entry;
}

// The mapping that an entry such as "stator.amplitude" belongs into.
Schema& section_of(Schema& motor, std::string_view path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string_view::npos) return motor;
  const std::string_view name = path.substr(0, dot);
  for (SchemaEntry& entry : motor.entries) {
    if (entry.name == name) return entry.schema;
  }
  const Section* section = std::find_if(std::begin(kSections), std::end(kSections),
                                        [&](const Section& s) { return s.name == name; });
  SchemaEntry entry;
  entry.name = name;
  entry.schema.kind = ValueKind::mapping;
  if (section != std::end(kSections)) entry.schema.text = section->text;
  entry.required = true;
  motor.entries.push_back(std::move(entry));
  return motor.entries.back().schema;
}

SchemaEntry version_entry() {
  SchemaEntry entry;
  entry.name = "twum";
  entry.schema.kind = ValueKind::word;
  entry.schema.text = "version of the file format";
  entry.schema.example = std::to_string(kFileVersion);
  entry.schema.words = {entry.schema.example};
  entry.required = true;
  return entry;
}

}  // namespace

Schema parameter_schema(const ParameterInfo& parameter) {
  Schema schema;
  schema.kind = ValueKind::quantity;
  schema.text = parameter.text;
  schema.example = parameter.example;
  schema.unit = parameter.unit;
  schema.min = parameter.min;
  schema.max = parameter.max;
  schema.whole = parameter.integer;
  return schema;
}

Schema motor_schema() {
  Schema motor;
  motor.kind = ValueKind::mapping;
  motor.text = "one motor";
  SchemaEntry name;
  name.name = "name";
  name.schema.text = "what the motor is called";
  name.schema.example = "ring-60";
  name.fallback = "no name";
  motor.entries.push_back(std::move(name));
  for (const ParameterInfo& row : parameter_table()) {
    section_of(motor, row.file_entry).entries.push_back(entry_of(row));
  }
  return motor;
}

const Schema& motor_file_schema() {
  static const Schema schema = [] {
    Schema file;
    file.kind = ValueKind::mapping;
    file.text = "a motor for twum";
    file.entries.push_back(version_entry());
    SchemaEntry motor;
    motor.name = "motor";
    motor.schema = motor_schema();
    motor.required = true;
    file.entries.push_back(std::move(motor));
    return file;
  }();
  return schema;
}

}  // namespace twum::studies
