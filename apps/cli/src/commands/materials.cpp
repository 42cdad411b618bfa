// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "listing.hpp"
#include "output.hpp"

#include <twum/studies/materials/catalogue.hpp>
#include <twum/studies/text/number.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::cli {
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

int run_materials(const MaterialsOptions& options) {
  const Listing listing =
      options.name.empty() ? all_materials() : one_material(studies::find_material(options.name));
  Output output(options.output.path);
  if (options.output.format == "table" && !options.name.empty())
    output.write(listing.text + "\n\n");
  output.write(to_text(listing, options.output.format));
  output.finish();
  return kDone;
}

}  // namespace

void add_materials(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MaterialsOptions>();
  CLI::App* command =
      app.add_subcommand("materials", "Lists the catalogue of materials, or one with its sources");
  command->add_option("name", options->name, "a material, to see all its values and their sources");
  add_output_options(*command, options->output, {"table", "csv", "json", "markdown"});
  command->footer(
      "Examples:\n  twum materials\n  twum materials apc-840\n"
      "  twum materials apc-840 --format json");
  command->callback([options, &action] { action = [options] { return run_materials(*options); }; });
}

}  // namespace twum::cli
