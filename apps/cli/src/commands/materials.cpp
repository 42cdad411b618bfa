// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "listing.hpp"
#include "output.hpp"

#include <twum/io/number.hpp>
#include <twum/motors/catalogue.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kMaterialsText =
    "Names for the entry `material` of a motor file, in `substrate`, `ceramic`, `contact_layer` "
    "and "
    "`friction`.\n"
    "`twum materials NAME` shows all values of a material with their sources. This page is the "
    "output of\n"
    "`twum materials --format markdown`.";

struct MaterialsOptions {
  std::string name;
  OutputOptions output;
};

std::string typed_value(const studies::Material& material, const char* property) {
  const studies::MaterialValue* found = material.find(property);
  return found == nullptr ? "" : found->typed;
}

Listing all_materials() {
  Listing listing{"Materials",
                  kMaterialsText,
                  {"name", "kind", "youngs_modulus", "poisson_ratio", "density", "d31",
                   "kinetic_friction", "text"},
                  {}};
  for (const studies::Material& one : studies::material_catalogue())
    listing.rows.push_back({one.name, one.kind, typed_value(one, "youngs_modulus"),
                            typed_value(one, "poisson_ratio"), typed_value(one, "density"),
                            typed_value(one, "d31"), typed_value(one, "kinetic_friction"),
                            one.text});
  return listing;
}

Listing one_material(const studies::Material& material) {
  Listing listing{
      material.name, material.text, {"name", "value", "si_value", "unit", "source"}, {}};
  for (const studies::MaterialValue& one : material.values)
    listing.rows.push_back(
        {one.name, one.typed, studies::number_text(one.value), one.unit, one.source});
  return listing;
}

// Values in SI units, with the source of each; the units stand in `units`.
Json material_json(const studies::Material& material) {
  Json json{{"name", material.name}, {"kind", material.kind}, {"text", material.text}};
  for (const studies::MaterialValue& one : material.values) json[one.name] = number_json(one.value);
  for (const studies::MaterialValue& one : material.values) json["sources"][one.name] = one.source;
  return json;
}

void add_units(const studies::Material& material, Json& units) {
  for (const studies::MaterialValue& one : material.values) units[one.name] = one.unit;
}

std::string as_json(const std::string& name) {
  Json json, units = Json::object();
  if (name.empty()) {
    json["materials"] = Json::array();
    for (const studies::Material& one : studies::material_catalogue()) {
      json["materials"].push_back(material_json(one));
      add_units(one, units);
    }
  } else {
    const studies::Material& material = studies::find_material(name);
    json = material_json(material);
    add_units(material, units);
  }
  json["units"] = units;
  return json_text(json);
}

std::string as_text(const MaterialsOptions& options) {
  if (options.output.format == "json") return as_json(options.name);
  if (options.name.empty())
    return to_text(all_materials(), options.output.format, options.output.table_width());
  const Listing listing = one_material(studies::find_material(options.name));
  const bool table = options.output.format == "table";
  return (table ? listing.text + "\n\n" : "") +
         to_text(listing, options.output.format, options.output.table_width());
}

int run_materials(const MaterialsOptions& options) {
  Output output(options.output.path);
  output.write(as_text(options));
  output.finish();
  return kDone;
}

}  // namespace

void add_materials(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MaterialsOptions>();
  CLI::App* command =
      app.add_subcommand("materials", "Lists the catalogue of materials, or one with its sources");
  command
      ->add_option("MATERIAL", options->name, "Material to list with all values and their sources")
      ->type_name("");
  add_output_options(*command, options->output, {"table", "csv", "json", "markdown"});
  command->footer(
      "Examples:\n  twum materials\n  twum materials apc-840\n"
      "  twum materials apc-840 --format json");
  command->callback([options, &action] { action = [options] { return run_materials(*options); }; });
}

}  // namespace twum::inline v0_1::cli
