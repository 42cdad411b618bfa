// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/motor_file.hpp>
#include <twum/motors/parameter_set.hpp>

#include "file/circuit_shape.hpp"
#include "file/geometry_shape.hpp"
#include "file/operation_shape.hpp"
#include "file/shape_rows.hpp"
#include "file/wear_shape.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/core/track_wear.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace twum::inline v0_1::motors {
namespace {

std::string_view first_step(std::string_view path) { return path.substr(0, path.find('.')); }

std::string_view last_step(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string value_text(double value, const ParameterInfo& row) {
  if (row.parameter == Parameter::radial_slices) return slices_text(static_cast<int>(value));
  return number_text(value) + (row.unit == "1" ? "" : " " + std::string(row.unit));
}

// A number of slices, or `auto`, alone or with the number of nodes that a search has chosen.
Shape<double> slices(const ParameterInfo& row) {
  Schema schema = parameter_schema(row);
  schema.min = 1;
  const Shape<double> count = number(schema);
  const Shape<double> automatic = shape_as<double, std::size_t>(
      choice("as many as needed for an accurate torque", {"auto"}),
      [](std::size_t) { return kAutoSlices; }, [](const double&) { return std::size_t{0}; });
  Shape<double> shape;
  shape.schema.kind = ValueKind::any_of;
  shape.schema.text = row.text;
  shape.schema.example = "auto";
  shape.schema.alternatives = {automatic.schema, count.schema};
  shape.schema.alternatives.own().front().pattern = "^auto +[1-9][0-9]*$";
  shape.read = [automatic, count](double& into, const YamlNode& node, const Spot& spot,
                                  Diagnostics& diagnostics) {
    if (const std::optional<int> nodes = automatic_slices(node.scalar)) {
      into = *nodes;
      return true;
    }
    const bool number =
        !node.scalar.empty() && std::isalpha(static_cast<unsigned char>(node.scalar.front())) == 0;
    if (number) return count.read(into, node, spot, diagnostics);
    diagnostics.add(node.mark, spot.path,
                    node.kind == YamlNode::Kind::scalar
                        ? quoted(node.scalar) + " is not a number of slices"
                        : "not a number of slices",
                    "expected 'auto', or a whole number such as '8'");
    return false;
  };
  shape.write = [&row](const double& value) { return scalar_node(value_text(value, row)); };
  return shape;
}

// An entry that a material of the same block may give.
bool is_of_material(const ParameterInfo& row) {
  const std::size_t dot = row.file_entry.rfind('.');
  return dot != std::string_view::npos && has_material(row.file_entry.substr(0, dot)) &&
         material_gives(row);
}

// The entry of a parameter.
Field<GivenMotor> field_of(const ParameterInfo& row) {
  const Shape<double> value = parameter_shape(row);
  Field<GivenMotor> field;
  field.entry.name = last_step(row.file_entry);
  field.entry.schema = value.schema;
  field.entry.required = row.required;
  if (row.alternative) field.entry.alternative_entry = last_step(info(*row.alternative).file_entry);
  if (row.parameter == Parameter::neutral_plane_distance)
    field.entry.alternative_entry = "geometry";
  if (is_of_material(row)) field.entry.spared_by = "material";
  field.entry.alias = row.name == field.entry.name ? row.symbol : row.name;
  field.entry.fallback = row.fallback;
  field.entry.shown = row.in_templates;
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

// Checks that mu_0 is not below mu; each entry by itself may be valid.
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

// Data of another file, which stands beside the motor's file or at an absolute path.
Field<GivenMotor> solid_field() {
  const Shape<std::string> name = path(
      "file with modal data of the geometry as a solid, from 'twum stator --solid -o'; they "
      "replace those of the plate model",
      "solid/solid.yaml");
  Field<GivenMotor> field;
  field.entry.name = "solid";
  field.entry.schema = name.schema;
  field.entry.shown = false;
  field.entry.fallback = "the plate model";
  field.read = [read = name.read](GivenMotor& into, const YamlNode& node, const Spot& spot,
                                  Diagnostics& diagnostics) {
    std::string typed;
    if (!read(typed, node, spot, diagnostics)) return false;
    const std::filesystem::path folder =
        std::filesystem::path(diagnostics.source().name()).parent_path();
    try {
      into.solid = read_solid_file((folder / typed).string());
    } catch (const InputError& error) {
      const std::string first = std::string(error.what());  // of several, each with its line
      diagnostics.add(node.mark, spot.path, first.substr(0, first.find('\n')),
                      "expected a file that 'twum stator MOTOR --solid -o FOLDER' wrote");
    }
    return into.solid.has_value();
  };
  field.write = [](const GivenMotor&) { return std::optional<YamlNode>(); };  // by its values
  return field;
}

// Data of a solid belong to the geometry beside them, as long as it is the same.
void check_solid(const GivenMotor& motor, const MotorDesign& design, const Given& given,
                 Diagnostics& diagnostics) {
  const YamlNode* solid = given.node().find("stator")->find("solid");
  const auto say = [&](const std::string& found, const std::string& expected) {
    diagnostics.add(solid->mark, given.path("stator") + ".solid", found, expected);
  };
  if (!design.stator.geometry) {
    say("modal data of a solid without its geometry",
        "must be given together with the 'geometry' that was solved");
    return;
  }
  std::string changes;
  for (const std::string& change : changes_since(*motor.solid, design))
    changes += (changes.empty() ? "" : "; ") + change;
  if (!changes.empty())
    say("the stator has changed since it was solved: " + changes,
        "solve it again with 'twum stator --solid', or leave the entry out");
}

Field<GivenMotor> branch_field() {
  return hidden(optional<GivenMotor>(
      "branch",
      word<Branch>(
          "stable wave of a motor under a voltage: running, or too small to turn the rotor (dead)",
          {Branch::running, Branch::dead}),
      &GivenMotor::branch, "running"));
}

Field<GivenMotor> control_field() {
  return hidden(optional<GivenMotor>(
      "control",
      word<DriveControl>("quantity that the drive adjusts to hold a torque at a speed",
                         {DriveControl::frequency, DriveControl::voltage}),
      &GivenMotor::control, "frequency"));
}

Field<GivenMotor> frequency_range_field() {
  return hidden(optional<GivenMotor>(
      "frequency_range",
      list("lowest and highest frequency of a drive that adjusts the frequency",
           quantity("a frequency", "Hz", "40 kHz"), 2, 2),
      &GivenMotor::frequency_range, "any frequency"));
}

Field<GivenMotor> radial_motion_field() {
  return hidden(optional<GivenMotor>(
      "radial_motion",
      word<bool>("whether the radial motion of the surface is included", {"false", "true"}),
      &GivenMotor::radial_motion, "false"));
}

bool check_frequency_range(const GivenMotor& motor, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* node = given.right("frequency_range");
  if (node == nullptr || !motor.frequency_range) return true;
  const std::vector<double>& range = *motor.frequency_range;
  if (range[0] > 0 && range[0] < range[1]) return true;
  diagnostics.add(node->mark, given.path("frequency_range"),
                  range[0] > 0 ? "its first frequency is not below its second one"
                               : "a frequency that is not more than 0",
                  "write the lowest and the highest frequency, such as [39 kHz, 45 kHz]");
  return false;
}

Field<GivenMotor> circuit_field() {
  return hidden(optional<GivenMotor>("equivalent_circuit", circuit_shape(), &GivenMotor::circuit,
                                     "the modal data"));
}

bool check_stator(GivenMotor& motor, const Given& given, Diagnostics& diagnostics) {
  const bool alone = check_geometry_alone(given, diagnostics);
  const bool range = check_frequency_range(motor, given, diagnostics);
  return check_circuit(motor.circuit, given, diagnostics) && alone && range;
}

// Fills in the values of the block's material, then runs the check of the block.
Check<GivenMotor> filled_check(std::string block,
                               bool (*check)(GivenMotor&, const Given&, Diagnostics&)) {
  return [block, check](GivenMotor& motor, const Given& given, Diagnostics& diagnostics) {
    fill_from_material(motor, block);
    return check == nullptr || check(motor, given, diagnostics);
  };
}

Field<GivenMotor> shape_table() {
  auto rows = list("measured or computed shape, instead of exponent and root", shape_row(), 4);
  rows.schema.example = "[[24.5 mm, 0.9], [26 mm, 0.98], [27 mm, 1.02], [28.5 mm, 1.1]]";
  auto field = optional<GivenMotor>("table", rows, &GivenMotor::shape_table, "no table");
  return hidden(std::move(field));
}

bool check_shape(GivenMotor& /*motor*/, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* table = given.find("table");
  for (const char* other : {"exponent", "root"}) {
    if (table == nullptr || given.find(other) == nullptr) continue;
    diagnostics.add(table->mark, given.path("table"),
                    "a second shape in addition to '" + std::string(other) + "'",
                    "give the table, or exponent and root");
    return false;
  }
  return true;
}

struct Section {
  std::string_view path, text;
  bool (*check)(GivenMotor&, const Given&, Diagnostics&){nullptr};
  bool shown{true};  // in templates
};

constexpr Section kSections[] = {
    {"stator", "the vibrating ring and its travelling wave", check_stator},
    {"contact_layer", "the layer between stator and rotor"},
    {"stator.radial_shape", "amplitude of the wave across the track, 1 at the contact radius",
     check_shape, false},
    {"stator.imbalance", "differences between the two phases and between the two modes", nullptr,
     false},
    {"stator.sensor", "an electrode that senses the wave", nullptr, false},
    {"friction", "Coulomb friction between stator and contact layer", check_friction},
    {"rotor", "the rotor's face", nullptr, false},
    {"thermal", "thermal model of the motor", nullptr, false},
    {"thermal.stator", "metal and ceramic of the stator", nullptr, false},
    {"thermal.rotor", "the rotor without the lining", nullptr, false},
    {"thermal.housing", "the housing and its mount", nullptr, false},
    {"thermal.contact", "sliding face between lining and stator", nullptr, false},
    {"thermal.conductances", "thermal conductances between the masses and to the ambient", nullptr,
     false},
    {"thermal.drift", "relative change per kelvin of the motor's parameters", nullptr, false},
    {"thermal.one_node",
     "the whole motor as one mass, from a data sheet, instead of the three masses", nullptr, false},
    {"wear", "wear of the contact track, and the end of its life", nullptr, false},
    {"load", "load on the shaft, for motions in time", nullptr, false},
    {"driver", "electronics that drive the phases", nullptr, false},
    {"stator.geometry",
     "geometry of the stator, instead of modal data, neutral plane distance and radial shape",
     nullptr, false},
    {"stator.geometry.substrate", "the metal plate"},
    {"stator.geometry.web", "thinner part of the metal plate from the clamp to the ring"},
    {"stator.geometry.teeth", "teeth on the metal plate, cut by radial slots"},
    {"stator.geometry.glue", "between metal and ceramic, as wide as the ceramic"},
    {"stator.geometry.ceramic", "the piezoceramic ring under the metal plate"},
    {"stator.geometry.electrodes", "electrodes of a phase: sectors of half a wavelength"}};

// Sections that may be left out although they have required entries, and their defaults.
constexpr std::pair<std::string_view, std::string_view> kMayLack[] = {
    {"stator.geometry", "modal data"},
    {"stator.geometry.web", "no web"},
    {"stator.geometry.teeth", "no teeth"}};

Field<GivenMotor> section_at(const std::string& path, const std::string& name,
                             const Fields<GivenMotor>& fields) {
  const auto* known = std::find_if(std::begin(kSections), std::end(kSections),
                                   [&](const Section& one) { return one.path == path; });
  TWUM_ASSERT(known != std::end(kSections));
  Field<GivenMotor> field =
      section(name, std::string(known->text), fields, filled_check(path, known->check));
  field.entry.shown = known->shown;
  for (const auto& [section, fallback] : kMayLack)
    if (section == path) field.entry.required = false, field.entry.fallback = fallback;
  if (path == "stator.geometry") field.entry.alternative_entry = "neutral_plane_distance";
  return field;
}

// Required content of a file: a complete motor, or some of its parameters.
enum class Extent : unsigned char { motor, part };

Field<GivenMotor> left_out_freely(Field<GivenMotor> field) {
  field.entry.required = false;
  field.entry.fallback = "the motor's";
  return field;
}

// The entries below a path, by the parameter table: parameters, and sections of them.
Fields<GivenMotor> fields_below(const std::string& path, Extent extent = Extent::motor) {
  Fields<GivenMotor> fields;
  for (const ParameterInfo& row : parameter_table()) {
    if (!row.file_entry.starts_with(path)) continue;
    const std::string_view rest = row.file_entry.substr(path.size());
    const std::string name(first_step(rest));
    if (name == rest) {
      fields.push_back(extent == Extent::motor ? field_of(row) : left_out_freely(field_of(row)));
    } else if (!fields.has(name)) {
      fields.push_back(section_at(path + name, name, fields_below(path + name + ".", extent)));
    }
  }
  if (!path.empty() && has_material(path.substr(0, path.size() - 1)))
    fields.push_back(material_field(path.substr(0, path.size() - 1)));
  if (path == "stator.") fields.push_back(circuit_field());
  if (extent == Extent::part) return fields;  // without what is no parameter
  if (path == "stator.geometry.") fields.push_back(support_field());
  if (path == "stator.radial_shape.") fields.push_back(shape_table());
  if (path == "wear.") {
    fields.push_back(optional<GivenMotor>("until", until_shape(), &GivenMotor::until, "none"));
    fields.push_back(
        optional<GivenMotor>("profile", wear_profile_shape(), &GivenMotor::wear_profile, "even"));
  }
  if (path == "stator.") {
    fields.push_back(branch_field());
    fields.push_back(control_field());
    fields.push_back(frequency_range_field());
    fields.push_back(radial_motion_field());
    fields.push_back(solid_field());
  }
  if (path.empty())
    fields.push_back(hidden(
        optional<GivenMotor>("operation", operation_shape(), &GivenMotor::operation, "none")));
  return fields;
}

bool wears(const GivenMotor& given) {
  return !given.until.empty() || given.wear_profile ||
         std::ranges::any_of(given.values, [](const ParameterValue& one) {
           return info(one.first).file_entry.starts_with("wear.");
         });
}

// Those of the file, and those that follow from an equivalent circuit or the wear of a lining.
std::vector<ParameterValue> all_values(const GivenMotor& given) {
  std::vector<ParameterValue> values = given.values;
  if (given.circuit)
    for (const ParameterValue& one : modal_data(*given.circuit)) values.push_back(one);
  if (given.lining_wear && wears(given) && !given.value(Parameter::specific_wear))
    values.emplace_back(Parameter::specific_wear, *given.lining_wear);
  return values;
}

MotorFile plate_motor_of(const GivenMotor& given) {
  // Entries that a valid file leaves out: mu_0 = mu, and no modal damping.
  MotorDesign blank;
  blank.stator.modal_damping = 0;
  blank.friction = {1, 1};
  // Set at the end, because exponent and root would replace a table.
  blank.stator.radial_shape.table = given.shape_table;
  blank.stator.branch = given.branch.value_or(Branch::running);
  blank.stator.control = given.control.value_or(DriveControl::frequency);
  blank.stator.radial_motion = given.radial_motion.value_or(false);
  if (given.frequency_range)
    blank.stator.frequency_range = {given.frequency_range->front(), given.frequency_range->back()};
  blank.stator.geometry = blank_geometry(given);
  blank.operation = given.operation;
  if (!given.until.empty() || given.wear_profile)
    blank.wear.emplace(
        Wear{.until = given.until, .profile = given.wear_profile.value_or(WearProfile::even)});
  return {given.name, with(blank, all_values(given))};
}

// With the modal data of a solid, these in place of the geometry.
MotorFile motor_of(const GivenMotor& given) {
  MotorFile motor = plate_motor_of(given);
  if (given.solid && motor.design.stator.geometry)
    motor.design = with_solid(motor.design, *given.solid);
  return motor;
}

void check_plate(const MotorDesign& design, const Given& given, Diagnostics& diagnostics) {
  for (const std::string& wrong : complaints(design)) say_of_motor(wrong, given, diagnostics);
  if (diagnostics.empty())
    plate_model(design, stator::OtherModes::none,
                stator::Derivatives::none);  // throws if there is no mode for the wave
}

bool check_motor(GivenMotor& motor, const Given& given, Diagnostics& diagnostics) {
  if (!diagnostics.empty()) return false;  // errors were added before; the motor is not made
  if (!check_operation(motor.operation, motor.value(Parameter::voltage).has_value(), given,
                       diagnostics))
    return false;
  try {
    const MotorDesign design = plate_motor_of(motor).design;
    if (wears_freely(design))
      if (const std::string wrong = free_profile_complaint(design); !wrong.empty())
        say_of_motor(wrong, given, diagnostics);
    if (motor.solid) check_solid(motor, design, given, diagnostics);
    if (!design.stator.geometry) return diagnostics.empty();
    if (!motor.solid) {
      check_plate(design, given, diagnostics);
    } else if (diagnostics.empty()) {
      for (const std::string& wrong : complaints(motor_of(motor).design))
        say_of_motor(wrong, given, diagnostics);
    }
  } catch (const EvaluationError& error) {
    say_of_motor(error.what(), given, diagnostics);
  } catch (const InputError& error) {
    say_of_motor(error.what(), given, diagnostics);
  }
  return diagnostics.empty();
}

GivenMotor given_by(const MotorFile& motor) {
  GivenMotor given{.name = motor.name, .shape_table = motor.design.stator.radial_shape.table};
  if (motor.design.stator.geometry) given.inner_edge = motor.design.stator.geometry->support;
  if (motor.design.stator.branch != Branch::running) given.branch = motor.design.stator.branch;
  if (motor.design.stator.control != DriveControl::frequency)
    given.control = motor.design.stator.control;
  if (motor.design.stator.radial_motion) given.radial_motion = true;
  given.operation = motor.design.operation;
  if (motor.design.wear) given.until = motor.design.wear->until;
  if (motor.design.wear && motor.design.wear->profile != WearProfile::even)
    given.wear_profile = motor.design.wear->profile;
  if (const auto& range = motor.design.stator.frequency_range)
    given.frequency_range = std::vector{range->first, range->second};
  for (const ParameterInfo& row : parameter_table())
    if (is_given(motor.design, row.parameter))
      given.values.emplace_back(row.parameter, get(motor.design, row.parameter));
  return given;
}

bool needs_parameter(GivenMotor& part, const Given& given, Diagnostics& diagnostics) {
  if (!part.values.empty() || part.circuit || !diagnostics.empty()) return true;
  diagnostics.add(given.node().mark, given.path(), "no parameter of a motor",
                  "expected at least one, such as 'contact_layer: {youngs_modulus: 3 GPa}'");
  return false;
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
  schema.absolute = parameter.absolute;
  return schema;
}

Shape<double> parameter_shape(const ParameterInfo& parameter) {
  return parameter.parameter == Parameter::radial_slices ? slices(parameter)
                                                         : number(parameter_schema(parameter));
}

const Shape<MotorFile>& motor_shape() {
  static const Shape<MotorFile> shape = [] {
    Fields<GivenMotor> fields = fields_below("");
    fields.insert(0, optional<GivenMotor>("name", path("name of the motor", "ring-60"),
                                          &GivenMotor::name, "no name"));
    return shape_as<MotorFile, GivenMotor>(mapping<GivenMotor>("one motor", fields, check_motor),
                                           motor_of, given_by);
  }();
  return shape;
}

const Shape<std::vector<ParameterValue>>& parameter_set_shape() {
  using Values = std::vector<ParameterValue>;
  static const Shape<Values> shape = [] {
    Fields<GivenMotor> fields = fields_below("", Extent::part);
    fields.insert(0, optional<GivenMotor>("name", path("name of the set", "PEEK"),
                                          &GivenMotor::name, "no name"));
    Field<GivenMotor> version = version_field<GivenMotor>();
    version.entry.required = false;
    fields.insert(0, version);
    return shape_as<Values, GivenMotor>(
        mapping<GivenMotor>("parameters of a motor that belong together", fields, needs_parameter),
        [](const GivenMotor& part) { return all_values(part); },
        [](const Values& values) {
          GivenMotor part;
          part.values = values;
          return part;
        });
  }();
  return shape;
}

const Shape<MotorFile>& motor_file_shape() {
  static const Shape<MotorFile> shape = mapping<MotorFile>(
      "a motor for twum", {version_field<MotorFile>(),
                           required<MotorFile>(
                               "motor", motor_shape(), [](auto& file) -> auto& { return file; })});
  return shape;
}

}  // namespace twum::inline v0_1::motors
