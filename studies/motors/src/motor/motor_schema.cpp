// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include <twum/studies/text/number.hpp>
#include <twum/studies/text/words.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

// The entries of one section of a motor file, in SI.
using Values = std::vector<ParameterValue>;

// A motor as its file gives it.
struct GivenMotor {
  std::string name;
  Values stator, contact_layer, friction, rotor, others;
};

// The mapping that an entry stands in, such as "stator.radial_shape"; empty for one of the motor itself.
std::string_view section_of(const ParameterInfo& row) {
  const std::size_t dot = row.file_entry.rfind('.');
  return row.file_entry.substr(0, dot == std::string_view::npos ? 0 : dot);
}

// The first step of that, the section of the motor.
std::string_view outer_section_of(const ParameterInfo& row) {
  const std::string_view section = section_of(row);
  return section.substr(0, section.find('.'));
}

std::string_view entry_name(const ParameterInfo& row) {
  return row.file_entry.substr(row.file_entry.rfind('.') + 1);
}

std::string value_text(double value, const ParameterInfo& row) {
  return number_text(value) + (row.unit == "1" ? "" : " " + std::string(row.unit));
}

// The entry of a parameter, whose value goes to a list of them.
template <typename T>
Field<T> field_of(const ParameterInfo& row, Values T::*values) {
  const Shape<double> value = number(parameter_schema(row));
  Field<T> field;
  field.entry.name = entry_name(row);
  field.entry.schema = value.schema;
  field.entry.required = row.required;
  if (row.twin) field.entry.twin = entry_name(info(*row.twin));
  field.entry.alias = row.name == entry_name(row) ? row.symbol : row.name;
  if (row.parameter == Parameter::modal_damping) field.entry.fallback = "0";
  if (row.parameter == Parameter::static_friction) field.entry.fallback = "the kinetic one";
  if (row.parameter == Parameter::radial_slices) field.entry.fallback = "1";
  if (row.parameter == Parameter::shape_exponent) field.entry.fallback = "0";
  if (row.parameter == Parameter::shape_root) field.entry.fallback = "0 m";
  if (row.parameter == Parameter::rotor_taper) field.entry.fallback = "0 rad";
  field.read = [&row, values, read = value.read](T& into, const YamlNode& node, const Spot& spot,
                                                 Diagnostics& diagnostics) {
    double typed = 0;
    const bool right = read(typed, node, spot, diagnostics);
    if (right) (into.*values).emplace_back(row.parameter, typed);
    return right;
  };
  field.write = [&row, values](const T& from) -> std::optional<YamlNode> {
    const Values& given = from.*values;
    const auto own = std::find_if(given.begin(), given.end(),
                                  [&](const auto& one) { return one.first == row.parameter; });
    if (own == given.end()) return {};
    return scalar_node(value_text(own->second, row));
  };
  return field;
}

struct Section {
  Values values;
};

using Check = std::function<bool(Section&, const Given&, Diagnostics&)>;

// The parameters of a mapping and, if it has one, the mapping nested in it.
std::vector<Field<Section>> fields_of(std::string_view section) {
  std::vector<Field<Section>> fields;
  for (const ParameterInfo& row : parameter_table())
    if (section_of(row) == section) fields.push_back(field_of(row, &Section::values));
  return fields;
}

// A mapping that may be left out, its values among those of the mapping around it.
template <typename T>
Field<T> group(std::string_view section, std::string text, Values T::*values) {
  const Shape<Section> shape = mapping<Section>(std::move(text), fields_of(section));
  Field<T> field;
  field.entry.name = section.substr(section.rfind('.') + 1);
  field.entry.schema = shape.schema;
  field.entry.fallback = "its own defaults";
  field.read = [values, read = shape.read](T& into, const YamlNode& node, const Spot& spot,
                                           Diagnostics& diagnostics) {
    Section given;
    const bool right = read(given, node, spot, diagnostics);
    Values& all = into.*values;
    all.insert(all.end(), given.values.begin(), given.values.end());
    return right;
  };
  field.write = [section, values, write = shape.write](const T& from) -> std::optional<YamlNode> {
    Section own;
    for (const ParameterValue& value : from.*values)
      if (section_of(info(value.first)) == section) own.values.push_back(value);
    if (own.values.empty()) return {};
    return write(own);
  };
  return field;
}

Field<GivenMotor> section(const std::string& name, std::string text, Values GivenMotor::*values,
                          std::vector<Field<Section>> fields, const Check& check = {}) {
  const auto shape = as<Values, Section>(
      mapping<Section>(std::move(text), std::move(fields), check),
      [](Section given) { return std::move(given.values); },
      [](const Values& given) { return Section{given}; });
  return needed<GivenMotor>(name, shape, values);
}

std::vector<Field<Section>> stator_fields() {
  std::vector<Field<Section>> fields = fields_of("stator");
  fields.push_back(group<Section>("stator.radial_shape",
                                  "shape of the wave across the contact track", &Section::values));
  return fields;
}

double value_in(const Values& values, Parameter parameter) {
  return std::find_if(values.begin(), values.end(),
                      [=](const ParameterValue& one) { return one.first == parameter; })
      ->second;
}

// mu_0 below mu: no single entry is wrong, but the two together are.
bool check_friction(Section& section, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* kinetic = given.right("kinetic");
  const YamlNode* threshold = given.right("static");
  if (kinetic == nullptr || threshold == nullptr) return true;
  const double mu = value_in(section.values, Parameter::kinetic_friction);
  if (value_in(section.values, Parameter::static_friction) >= mu) return true;
  diagnostics.add({threshold->mark, given.path("static"),
                   quoted(threshold->scalar) + " is less than the kinetic friction",
                   "must be at least " + number_text(mu), kinetic->mark,
                   "kinetic friction given here"});
  return false;
}

MotorFile motor_of(const GivenMotor& given) {
  // What a valid file does not give follows from what it gives: mu_0 = mu, and no modal damping.
  MotorDesign blank;
  blank.stator.modal_damping = 0;
  blank.friction = {1, 1};
  Values values;
  for (const Values* part :
       {&given.stator, &given.contact_layer, &given.friction, &given.rotor, &given.others})
    values.insert(values.end(), part->begin(), part->end());
  return {given.name, with(blank, values)};
}

GivenMotor given_by(const MotorFile& motor) {
  GivenMotor given;
  given.name = motor.name;
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(motor.design, row.parameter)) continue;
    const std::string_view name = outer_section_of(row);
    Values& values = name == "stator"          ? given.stator
                     : name == "contact_layer" ? given.contact_layer
                     : name == "friction"      ? given.friction
                     : name == "rotor"         ? given.rotor
                                               : given.others;
    values.emplace_back(row.parameter, get(motor.design, row.parameter));
  }
  return given;
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

const Shape<MotorFile>& motor_shape() {
  static const Shape<MotorFile> shape = [] {
    std::vector<Field<GivenMotor>> fields{
        optional<GivenMotor>("name", path("what the motor is called", "ring-60"), &GivenMotor::name,
                             "no name"),
        section("stator", "the vibrating ring and its travelling wave", &GivenMotor::stator,
                stator_fields()),
        section("contact_layer", "the layer between stator and rotor", &GivenMotor::contact_layer,
                fields_of("contact_layer")),
        section("friction", "Coulomb friction between stator and contact layer",
                &GivenMotor::friction, fields_of("friction"), check_friction),
        group<GivenMotor>("rotor", "the rotor's face", &GivenMotor::rotor)};
    for (const ParameterInfo& row : parameter_table())
      if (section_of(row).empty()) fields.push_back(field_of(row, &GivenMotor::others));
    return as<MotorFile, GivenMotor>(mapping<GivenMotor>("one motor", std::move(fields)), motor_of,
                                     given_by);
  }();
  return shape;
}

const Shape<MotorFile>& motor_file_shape() {
  static const Shape<MotorFile> shape = mapping<MotorFile>(
      "a motor for twum", {version_field<MotorFile>(),
                           needed<MotorFile>(
                               "motor", motor_shape(), [](auto& file) -> auto& { return file; })});
  return shape;
}

}  // namespace twum::studies
