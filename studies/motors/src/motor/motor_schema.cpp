// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/motor_file.hpp>

#include <twum/base/error.hpp>
#include <twum/studies/text/number.hpp>
#include <twum/studies/text/words.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

// A motor as its file gives it, in SI.
struct GivenMotor {
  std::string name;
  std::vector<ParameterValue> values;

  std::optional<double> value(Parameter parameter) const {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [=](const auto& one) { return one.first == parameter; });
    return found == values.end() ? std::nullopt : std::optional<double>(found->second);
  }
};

std::string_view first_step(std::string_view path) { return path.substr(0, path.find('.')); }

std::string_view last_step(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string value_text(double value, const ParameterInfo& row) {
  return number_text(value) + (row.unit == "1" ? "" : " " + std::string(row.unit));
}

// The entry of a parameter.
Field<GivenMotor> field_of(const ParameterInfo& row) {
  const Shape<double> value = number(parameter_schema(row));
  Field<GivenMotor> field;
  field.entry.name = last_step(row.file_entry);
  field.entry.schema = value.schema;
  field.entry.required = row.required;
  if (row.twin) field.entry.twin = last_step(info(*row.twin).file_entry);
  field.entry.alias = row.name == field.entry.name ? row.symbol : row.name;
  if (row.parameter == Parameter::modal_damping) field.entry.fallback = "0";
  if (row.parameter == Parameter::static_friction) field.entry.fallback = "the kinetic one";
  field.read = [&row, read = value.read](GivenMotor& into, const YamlNode& node, const Spot& spot,
                                         Diagnostics& diagnostics) {
    double typed = 0;
    const bool right = read(typed, node, spot, diagnostics);
    if (right) into.values.emplace_back(row.parameter, typed);
    return right;
  };
  field.write = [&row](const GivenMotor& from) {
    const auto given = from.value(row.parameter);
    return given ? std::optional<YamlNode>(scalar_node(value_text(*given, row))) : std::nullopt;
  };
  return field;
}

// mu_0 below mu: no single entry is wrong, but the two together are.
bool check_friction(GivenMotor& motor, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* kinetic = given.right("kinetic");
  const YamlNode* threshold = given.right("static");
  if (kinetic == nullptr || threshold == nullptr) return true;
  const double mu = *motor.value(Parameter::kinetic_friction);
  if (*motor.value(Parameter::static_friction) >= mu) return true;
  diagnostics.add({threshold->mark, given.path("static"),
                   quoted(threshold->scalar) + " is less than the kinetic friction",
                   "must be at least " + number_text(mu), kinetic->mark,
                   "kinetic friction given here"});
  return false;
}

struct Section {
  std::string_view path, text;
  bool (*check)(GivenMotor&, const Given&, Diagnostics&){nullptr};
};

constexpr Section kSections[] = {
    {"stator", "the vibrating ring and its travelling wave"},
    {"contact_layer", "the layer between stator and rotor"},
    {"friction", "Coulomb friction between stator and contact layer", check_friction}};

// The entries below a path, by the parameter table: parameters, and sections of them.
std::vector<Field<GivenMotor>> fields_below(const std::string& path) {
  std::vector<Field<GivenMotor>> fields;
  for (const ParameterInfo& row : parameter_table()) {
    if (!row.file_entry.starts_with(path)) continue;
    const std::string_view rest = row.file_entry.substr(path.size());
    const std::string name(first_step(rest));
    if (name == rest) {
      fields.push_back(field_of(row));
    } else if (fields.empty() || fields.back().entry.name != name) {
      const auto* known = std::find_if(std::begin(kSections), std::end(kSections),
                                       [&](const Section& one) { return one.path == path + name; });
      TWUM_ASSERT(known != std::end(kSections));
      fields.push_back(section(name, std::string(known->text), fields_below(path + name + "."),
                               Check<GivenMotor>(known->check)));
    }
  }
  return fields;
}

MotorFile motor_of(const GivenMotor& given) {
  // What a valid file does not give follows from what it gives: mu_0 = mu, and no modal damping.
  MotorDesign blank;
  blank.stator.modal_damping = 0;
  blank.friction = {1, 1};
  return {given.name, with(blank, given.values)};
}

GivenMotor given_by(const MotorFile& motor) {
  GivenMotor given{motor.name, {}};
  for (const ParameterInfo& row : parameter_table())
    if (in_use(motor.design, row.parameter))
      given.values.emplace_back(row.parameter, get(motor.design, row.parameter));
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
    std::vector<Field<GivenMotor>> fields = fields_below("");
    fields.insert(fields.begin(),
                  optional<GivenMotor>("name", path("what the motor is called", "ring-60"),
                                       &GivenMotor::name, "no name"));
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
