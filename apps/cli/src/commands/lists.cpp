// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "listing.hpp"
#include "output.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/schema.hpp>
#include <twum/motors/motor_file.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kParametersText =
    R"text(Names as in studies, CSV headers and `--set`; the symbol is an alias. A parameter name may stand wherever a
metric may. Values carry a unit of the same dimension as the one below. If the column "needed" says "instead of",
the two parameters describe the same property: a motor file gives one of them, and an override of one replaces
the other. This page is the output of `twum parameters --format markdown`.)text";

constexpr const char* kMetricsText =
    R"text(Names as in studies and `twum evaluate --metrics`. The argument of a point metric, such as a rotor speed or a
load torque, is recognized by its unit: `efficiency_at(100 rpm)`, `efficiency_at(0.5 N.m)`. With a time, a
temperature is that of a motor which took up the load so long ago: `stator_temperature_at(0.5 N.m, 10 min)`.
This page is the output of `twum metrics --format markdown`.)text";

std::string range_text(const ParameterInfo& row) {
  const auto limit = [&](double value) {
    return value == 0 ? std::string("0") : studies::engineering(value, row.unit, 10);
  };
  return limit(row.min) + " to " + limit(row.max) + (row.integer ? ", whole" : "");
}

std::string need_text(const ParameterInfo& row) {
  const std::string alternative = row.alternative ? std::string(info(*row.alternative).name) : "";
  const studies::SchemaEntry* entry = studies::find_path(studies::motor_file_shape().schema,
                                                         "motor." + std::string(row.file_entry));
  const bool in_geometry = row.file_entry.starts_with("stator.geometry.");
  if (row.required && in_geometry)
    return entry->spared_by.empty() ? "in its block" : "in its block, or " + entry->spared_by;
  std::string others = entry->alternative_entry;
  if (!entry->spared_by.empty()) others += (others.empty() ? "" : ", ") + entry->spared_by;
  if (row.required) return others.empty() ? "yes" : "or " + others;
  if (!alternative.empty()) return "instead of " + alternative;
  return "no; default: " + entry->fallback;
}

Listing parameters() {
  Listing listing{"Parameters of a motor",
                  kParametersText,
                  {"name", "symbol", "unit", "range", "needed", "entry", "text", "why this range"},
                  {}};
  for (const ParameterInfo& row : parameter_table()) {
    listing.rows.push_back({std::string(row.name), std::string(row.symbol), std::string(row.unit),
                            range_text(row), need_text(row), std::string(row.file_entry),
                            std::string(row.text), std::string(row.reason)});
  }
  return listing;
}

std::string argument_text(Argument argument) {
  switch (argument) {
    case Argument::none: return "";
    case Argument::speed: return "speed";
    case Argument::torque: return "torque";
    case Argument::both: return "torque and speed";
    case Argument::angle: return "angle";
    case Argument::periods: return "number of periods";
    case Argument::either: return "speed or torque";
    case Argument::speed_or_torque: break;
  }
  return "speed or torque, or both";
}

Listing metrics() {
  Listing listing{"Metrics of a motor", kMetricsText, {"name", "unit", "at", "text"}, {}};
  for (const MetricInfo& row : metric_table()) {
    listing.rows.push_back({std::string(row.name), std::string(row.unit),
                            argument_text(row.argument) + (row.timed ? "; a time" : ""),
                            std::string(row.text)});
  }
  return listing;
}

int print(const Listing& listing, const OutputOptions& options) {
  Output output(options.path);
  output.write(to_text(listing, options.format, options.table_width()));
  output.finish();
  return kDone;
}

void add_list(CLI::App& app, Action& action, const std::string& name, const char* text,
              Listing (*list)()) {
  const auto options = std::make_shared<OutputOptions>();
  CLI::App* command = app.add_subcommand(name, text);
  add_output_options(*command, *options, {"table", "csv", "json", "markdown"});
  command->footer("Examples:\n  twum " + name + "\n  twum " + name + " --format json");
  command->callback(
      [options, list, &action] { action = [options, list] { return print(list(), *options); }; });
}

}  // namespace

void add_metrics(CLI::App& app, Action& action) {
  add_list(app, action, "metrics", "Lists the metrics, with units and one line each", metrics);
}

void add_parameters(CLI::App& app, Action& action) {
  add_list(app, action, "parameters", "Lists the parameters of a motor, with units and ranges",
           parameters);
}

}  // namespace twum::inline v0_1::cli
