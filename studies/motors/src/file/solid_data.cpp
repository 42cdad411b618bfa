// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/solid_data.hpp>

#include "file/shape_rows.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>
#include <twum/motors/motor_file.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace twum::inline v0_1::motors {
namespace {

constexpr Parameter kNumbers[] = {Parameter::resonance_frequency, Parameter::modal_mass,
                                  Parameter::force_factor, Parameter::blocked_capacitance,
                                  Parameter::neutral_plane_distance};

// Values are written to the last digit; a typed length in millimetres may round once more.
constexpr double kSame = 1e-12;

bool is_drawing(const ParameterInfo& row) {
  const Parameter p = row.parameter;
  return p == Parameter::wavelengths || p == Parameter::contact_radius ||
         (row.file_entry.starts_with("stator.geometry.") && p != Parameter::teeth_stiffness_share);
}

std::optional<double> value_in(const std::vector<ParameterValue>& values, Parameter parameter) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [=](const auto& one) { return one.first == parameter; });
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

// An entry named as the parameter.
Field<SolidData> value_field(const ParameterInfo& row,
                             std::vector<ParameterValue> SolidData::*values, bool required) {
  const Shape<double> shape = number(parameter_schema(row));
  Field<SolidData> field;
  field.entry.name = row.name;
  field.entry.schema = shape.schema;
  field.entry.required = required;
  field.entry.fallback = "none";
  field.read = [&row, values, read = shape.read](SolidData& into, const YamlNode& node,
                                                 const Spot& spot, Diagnostics& diagnostics) {
    double typed = 0;
    const bool right = read(typed, node, spot, diagnostics);
    if (right) (into.*values).emplace_back(row.parameter, typed);
    return right;
  };
  field.write = [&row, values](const SolidData& from) {
    const auto value = value_in(from.*values, row.parameter);
    if (!value) return std::optional<YamlNode>();
    const std::string unit = row.unit == "1" ? "" : " " + std::string(row.unit);
    return std::optional(scalar_node(number_text(*value) + unit));
  };
  return field;
}

Field<SolidData> drawing_field() {
  Fields<SolidData> fields;
  for (const ParameterInfo& row : parameter_table())
    if (is_drawing(row)) fields.push_back(value_field(row, &SolidData::drawing, false));
  fields.push_back(required<SolidData>(
      "inner_edge",
      word<stator::InnerEdge>(
          "support of the inner edge",
          {stator::InnerEdge::free, stator::InnerEdge::clamped, stator::InnerEdge::supported}),
      &SolidData::inner_edge));
  return section<SolidData>("drawing", "the stator for which the solid was solved", fields);
}

const Shape<SolidData>& solid_file_shape() {
  static const Shape<SolidData> shape = [] {
    Fields<SolidData> fields;
    for (const Parameter parameter : kNumbers)
      fields.push_back(value_field(info(parameter), &SolidData::numbers, true));
    fields.push_back(
        required<SolidData>("shape", list("radius and R", shape_row(), 4), &SolidData::shape));
    fields.push_back(drawing_field());
    return mapping<SolidData>(
        "modal data of a stator as a solid",
        {version_field<SolidData>(),
         required<SolidData>(
             "solid", mapping<SolidData>("results of the solid model", fields),
             [](auto& file) -> auto& { return file; })});
  }();
  return shape;
}

std::string shown(const std::optional<double>& value, const ParameterInfo& row) {
  return value ? engineering(*value, row.unit, 6) : "left out";
}

bool same(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::abs(*a - *b) <= kSame * std::abs(*a);
}

}  // namespace

std::vector<ParameterValue> drawing_of(const MotorDesign& design) {
  std::vector<ParameterValue> values;
  for (const ParameterInfo& row : parameter_table())
    if (is_drawing(row) && in_use(design, row.parameter))
      values.emplace_back(row.parameter, get(design, row.parameter));
  return values;
}

std::string solid_text(const SolidData& data, const std::string& name) {
  const YamlNode file = solid_file_shape().write(data);
  std::string text = "# Modal data of the stator of " + printable(name) +
                     " as a solid, from 'twum stator --solid'. A motor file with the same\n"
                     "# geometry uses them through the entry 'solid', together with 'geometry'.\n";
  return text + yaml_text(file, 0);
}

SolidData read_solid_file(const std::string& path) {
  const Source source = read_source(path);
  Diagnostics diagnostics(source);
  const YamlNode root = load_yaml(diagnostics);
  SolidData data;
  solid_file_shape().read(data, root, {{}, {1, 1}}, diagnostics);
  diagnostics.throw_if_any();
  return data;
}

std::vector<std::string> changes_since(const SolidData& data, const MotorDesign& design) {
  std::vector<std::string> changes;
  const std::vector<ParameterValue> now = drawing_of(design);
  for (const ParameterInfo& row : parameter_table()) {
    if (!is_drawing(row)) continue;
    const auto before = value_in(data.drawing, row.parameter), after = value_in(now, row.parameter);
    if (!same(before, after))
      changes.push_back(std::string(row.name) + " is " + shown(after, row) + ", but was " +
                        shown(before, row));
  }
  const stator::InnerEdge edge = design.stator.geometry->support;
  if (edge != data.inner_edge)
    changes.push_back(std::string("inner_edge is ") + stator::to_string(edge) + ", but was " +
                      stator::to_string(data.inner_edge));
  return changes;
}

MotorDesign with_solid(MotorDesign design, const SolidData& data) {
  design.stator.geometry.reset();
  design.stator.plate = {};
  design = with(design, data.numbers);
  design.stator.radial_shape = {.table = data.shape};
  return design;
}

}  // namespace twum::inline v0_1::motors
