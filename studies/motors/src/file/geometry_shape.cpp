// SPDX-License-Identifier: Apache-2.0
#include "file/geometry_shape.hpp"

#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/catalogue.hpp>

#include <array>

namespace twum::inline v0_1::motors {
namespace {

// A block that may name a material, and the kind of material that goes there.
struct MaterialBlock {
  std::string_view path, kind, example;
};

constexpr MaterialBlock kMaterialBlocks[] = {
    {"stator.geometry.substrate", "metal", "phosphor-bronze-c51000"},
    {"stator.geometry.ceramic", "piezoceramic", "apc-840"},
    {"contact_layer", "lining", "ptfe-peek"},
    {"friction", "lining", "ptfe-peek"}};

const MaterialBlock* block_at(std::string_view path) {
  for (const MaterialBlock& one : kMaterialBlocks)
    if (one.path == path) return &one;
  return nullptr;
}

// The friction properties of a lining have the names of the parameters, all other properties those of the entries.
std::string_view property_of(const ParameterInfo& row) {
  const bool friction = row.file_entry.starts_with("friction.");
  return friction ? row.name : row.file_entry.substr(row.file_entry.rfind('.') + 1);
}

bool any_given(const GivenMotor& given, std::string_view prefix) {
  return std::any_of(given.values.begin(), given.values.end(), [=](const ParameterValue& one) {
    return info(one.first).file_entry.starts_with(prefix);
  });
}

// The entry of a motor file, or of its blocks the innermost that is given.
const YamlNode& nearest_node(const YamlNode& motor, std::string_view entry) {
  const YamlNode* nearest = &motor;
  for (std::string_view rest = entry; !rest.empty();) {
    const std::string_view step = rest.substr(0, rest.find('.'));
    const YamlNode* next = nearest->find(step);
    if (next == nullptr) break;
    nearest = next;
    rest.remove_prefix(std::min(step.size() + 1, rest.size()));
  }
  return *nearest;
}

}  // namespace

Field<GivenMotor> support_field() {
  auto edge = required<GivenMotor>(
      "inner_edge",
      word<stator::InnerEdge>(
          "support of the inner edge of the plate",
          {stator::InnerEdge::free, stator::InnerEdge::clamped, stator::InnerEdge::supported}),
      &GivenMotor::inner_edge);
  return section<GivenMotor>("support", "support of the plate", {std::move(edge)});
}

bool has_material(std::string_view block) { return block_at(block) != nullptr; }

Field<GivenMotor> material_field(std::string_view path) {
  const MaterialBlock& block = *block_at(path);
  Field<GivenMotor> field;
  field.entry.name = "material";
  field.entry.schema.kind = ValueKind::text;
  field.entry.schema.text =
      "name of a " + std::string(block.kind) +
      " in the catalogue ('twum materials'); its values replace entries that are left out";
  field.entry.schema.example = block.example;
  field.entry.shown = false;
  field.entry.fallback = "the entries that it would give";
  field.read = [&block, schema = kept(field.entry.schema)](GivenMotor& into, const YamlNode& node,
                                                           const Spot& spot,
                                                           Diagnostics& diagnostics) {
    return says_no_error(node, *schema, spot, diagnostics, [&](const std::string& typed) {
      into.material = find_material(typed, std::span(&block.kind, 1)).name;
    });
  };
  field.write = [](const GivenMotor&) { return std::optional<YamlNode>(); };  // by its values
  return field;
}

bool material_gives(const ParameterInfo& row) {
  const MaterialBlock* block = block_at(row.file_entry.substr(0, row.file_entry.rfind('.')));
  if (block == nullptr) return false;
  const auto catalogue = material_catalogue();
  return std::any_of(catalogue.begin(), catalogue.end(), [&](const Material& one) {
    return one.kind == block->kind && one.find(property_of(row)) != nullptr;
  });
}

void say_of_motor(const std::string& text, const Given& motor, Diagnostics& diagnostics) {
  const std::string name = text.substr(0, text.find(' '));
  const std::size_t but = text.find(", but ");
  const bool named = but != std::string::npos;
  const auto parameter = find_parameter(name);
  const std::string entry = parameter ? std::string(info(*parameter).file_entry)
                                      : "stator." + (named ? name : "geometry");
  const YamlNode& node = nearest_node(motor.node(), entry);
  const std::string found = named ? text.substr(but + 6) : text;
  const bool typed = !node.scalar.empty() && found.starts_with("is ");
  diagnostics.add(node.mark, motor.path(entry),
                  typed ? quoted(node.scalar) + " does not fit" : found,
                  named ? text.substr(name.size() + 1, but - name.size() - 1) : "");
}

void fill_from_material(GivenMotor& motor, std::string_view block) {
  if (motor.material.empty()) return;
  const Material& material = find_material(motor.material);
  motor.material.clear();
  const MaterialValue* wear = material.find("specific_wear");
  if (block == "contact_layer" && wear != nullptr) motor.lining_wear = wear->value;
  const std::string prefix = std::string(block) + ".";
  for (const ParameterInfo& row : parameter_table()) {
    const bool alternative_given = row.alternative && motor.value(*row.alternative);
    if (!row.file_entry.starts_with(prefix) || motor.value(row.parameter) || alternative_given)
      continue;
    if (const MaterialValue* found = material.find(property_of(row)))
      motor.values.emplace_back(row.parameter, found->value);
  }
}

bool check_geometry_alone(const Given& stator, Diagnostics& diagnostics) {
  const YamlNode* geometry = stator.find("geometry");
  if (geometry == nullptr) return true;
  bool good = true;
  for (const char* other : {"resonance_frequency", "modal_mass", "force_factor",
                            "blocked_capacitance", "equivalent_circuit", "radial_shape"}) {
    const YamlNode* beside = stator.find(other);
    if (beside == nullptr) continue;
    diagnostics.add({beside->mark, stator.path(other), "follows from 'geometry' already",
                     "leave it out, or the geometry", geometry->mark, "geometry given here"});
    good = false;
  }
  return good;
}

std::optional<stator::StatorGeometry> blank_geometry(const GivenMotor& given) {
  if (!given.inner_edge) return {};
  stator::StatorGeometry geometry;
  geometry.support = *given.inner_edge;
  if (any_given(given, "stator.geometry.web.")) geometry.web.emplace();
  if (any_given(given, "stator.geometry.teeth.")) geometry.teeth.emplace();
  return geometry;
}

}  // namespace twum::inline v0_1::motors
