// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/catalogue.hpp>

#include "materials/embedded.hpp"

#include <twum/base/error.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>

#include <algorithm>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

// SI units of all properties but those without dimension.
constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
    {"youngs_modulus", "Pa"},     {"density", "kg/m^3"},      {"d31", "m/V"},
    {"permittivity", "F/m"},      {"specific_wear", "m^2/N"}, {"conductivity", "W/(m.K)"},
    {"specific_heat", "J/(kg.K)"}};

std::string unit_of_property(std::string_view name) {
  for (const auto& [property, unit] : kUnits)
    if (property == name) return std::string(unit);
  return "1";
}

const YamlNode& required_entry(const YamlNode& node, std::string_view key) {
  const YamlNode* found = node.find(key);
  TWUM_ASSERT(found != nullptr);  // the test house.materials looks at every file
  return *found;
}

// The comment at the top of a file.
std::string title_of(std::string_view text) {
  std::string title;
  while (text.starts_with("# ")) {
    const std::size_t end = text.find('\n');
    title += (title.empty() ? "" : " ") + std::string(text.substr(2, end - 2));
    text.remove_prefix(end + 1);
  }
  return title;
}

Material read_material(const EmbeddedFile& file) {
  const Source source(std::string(file.name), std::string(file.text));
  Diagnostics diagnostics(source);
  const YamlNode root = load_yaml(diagnostics);
  TWUM_ASSERT(diagnostics.empty());
  Material material{required_entry(root, "name").scalar,
                    required_entry(root, "kind").scalar,
                    title_of(file.text),
                    {}};
  const YamlNode* sources = root.find("sources");
  for (const YamlEntry& entry : required_entry(root, "values").entries) {
    const std::string typed = required_entry(entry.value, "value").scalar;
    const std::string key = required_entry(entry.value, "source").scalar;
    const YamlNode* published = sources == nullptr ? nullptr : sources->find(key);
    const std::string unit = unit_of_property(entry.key);
    material.values.push_back({entry.key, unit, parse_quantity(typed, Expected{unit, typed}), typed,
                               published == nullptr ? key : published->scalar});
  }
  return material;
}

}  // namespace

const MaterialValue* Material::find(std::string_view property) const {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [=](const MaterialValue& one) { return one.name == property; });
  return found == values.end() ? nullptr : &*found;
}

std::span<const Material> material_catalogue() {
  static const std::vector<Material> catalogue = [] {
    std::vector<Material> list;
    for (const EmbeddedFile& file : embedded_materials()) list.push_back(read_material(file));
    return list;
  }();
  return catalogue;
}

const Material& find_material(std::string_view name, std::span<const std::string_view> kinds) {
  std::vector<std::string_view> names;
  for (const Material& one : material_catalogue()) {
    const bool fits =
        kinds.empty() || std::find(kinds.begin(), kinds.end(), one.kind) != kinds.end();
    if (fits && one.name == name) return one;
    if (fits) names.push_back(one.name);
    if (one.name == name)
      throw ValueError(
          quoted(name) + " is a " + one.kind,
          "expected a " + std::string(kinds.front()) + "; 'twum materials' lists them");
  }
  throw ValueError("unknown material " + quoted(name), did_you_mean(name, names));
}

}  // namespace twum::inline v0_1::motors
