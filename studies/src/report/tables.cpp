// SPDX-License-Identifier: Apache-2.0
#include "report/tables.hpp"

#include "telling/goal_parts.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/catalogue.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/motors/plain_name.hpp>
#include <twum/motors/reasons.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace twum::inline v0_1::studies {
namespace {

// Units that a page shows besides those of its tables.
constexpr const char* kShownUnits[] = {"1", "%", "rad/s", "m/s", "Hz", "1/s", "ohm", "H"};
// Further units offered to users, besides those shown; each is tried for every dimension.
constexpr const char* kOtherUnits[] = {
    "rpm",    "deg",    "cm",     "in",     "lbf",  "bar",  "psi", "kgf.cm", "ozf.in", "%",
    "g/cm^3", "W/cm^2", "W/mm^2", "N/mm^2", "N.mm", "pC/N", "%/K", "ppm/K",  "min",    "h"};

void add_unit(Json& units, const std::string& text, std::string_view si_unit) {
  try {
    units[text] = parse_unit(text, {si_unit, ""}).factor();
  } catch (const ValueError&) {
    return;  // of another dimension
  }
}

Json units_of(std::string_view si_unit) {
  Json units = Json::object();
  add_unit(units, std::string(si_unit), si_unit);
  for (const DisplayUnit& shown : display_units(si_unit)) add_unit(units, shown.text, si_unit);
  if (si_unit == "kg") add_unit(units, "g", si_unit), add_unit(units, "mg", si_unit);
  for (const char* other : kOtherUnits) add_unit(units, other, si_unit);
  return units;
}

// Units of parameters and metrics.
std::set<std::string> units_of_tables() {
  std::set<std::string> units;
  for (const ParameterInfo& row : parameter_table()) units.emplace(row.unit);
  for (const MetricInfo& row : metric_table())
    if (row.metric != Metric::apparent_power_at) units.emplace(row.unit);  // no other has V.A
  return units;
}

// The values of every entry "unit" of a page, and of those in every object "units".
void add_units_in(const Json& json, std::set<std::string>& units) {
  for (const auto& [key, value] : json.items()) {
    if (key == "unit" && value.is_string()) units.insert(value.get<std::string>());
    if (key == "units" && value.is_object())
      for (const Json& unit : value)
        if (unit.is_string()) units.insert(unit.get<std::string>());
    if (value.is_structured()) add_units_in(value, units);
  }
}

// Whether a motor file of the design would state the parameter, including the parameters of a wide contact if there
// is one slice.
bool stated(const MotorDesign& design, const MotorDesign& wide, Parameter parameter) {
  return parameter == Parameter::radial_slices || in_use(design, parameter) ||
         in_use(wide, parameter);
}

// Without entries that are false or null, for which the page takes those that are missing.
Json only_true(Json row) {
  for (auto entry = row.begin(); entry != row.end();)
    entry = entry->is_null() || *entry == false ? row.erase(entry) : std::next(entry);
  return row;
}

// What a motor file gives for temperatures, wear, axial and radial motion, the circuit of a driver and a drive that follows: a page
// keeps it as it is.
bool is_kept(std::string_view entry) {
  constexpr std::array<std::string_view, 9> kKept{"thermal.",
                                                  "wear.",
                                                  "operation",
                                                  "stator.control",
                                                  "stator.frequency_range",
                                                  "rotor.axial_damping",
                                                  "driver.inductance",
                                                  "driver.resistance",
                                                  "stator.radial_motion"};
  return std::ranges::any_of(kKept, [&](std::string_view one) { return entry.starts_with(one); });
}

void add_kept(const YamlNode& node, const std::string& path, Json& kept) {
  for (const YamlEntry& entry : node.entries) {
    const std::string here = path + entry.key;
    if (entry.value.kind == YamlNode::Kind::mapping)
      add_kept(entry.value, here + ".", kept);
    else if (is_kept(here))
      kept[here] = inline_text(entry.value);
  }
}

Json kept_json(const std::string& name, const MotorDesign& design) {
  Json kept = Json::object();
  add_kept(motor_shape().write({name, design}), "", kept);
  return kept;
}

bool names(std::string_view text, std::string_view name) {
  return text.find(name) != std::string_view::npos;
}

}  // namespace

Json parameters_json(std::string_view text) {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    if (is_kept(row.file_entry) && !names(text, row.name)) continue;
    json[std::string(row.name)] = only_true(
        {{"symbol", row.symbol.empty() ? Json(nullptr) : Json(row.symbol)},
         {"unit", row.unit},
         {"text", row.text},
         {"integer", row.integer},
         {"absolute", row.absolute},
         {"entry", row.file_entry},
         {"min", row.min},
         {"max", row.max},
         {"required", row.required && row.file_entry.find("geometry") == std::string_view::npos},
         {"alternative",
          row.alternative ? Json(std::string(info(*row.alternative).name)) : Json(nullptr)}});
  }
  return json;
}

// Metrics that the core of a page does not compute, and which stand in a page only if it names them.
bool left_out_of_pages(const MetricInfo& row) {
  return row.needs_thermal || row.needs_wear || row.needs_motion ||
         row.metric == Metric::radial_motion_ratio || row.metric == Metric::terminal_voltage_at ||
         row.metric == Metric::driver_loss_at;
}

// One slice leaves out sliding, so that it is not valid for wear.
Json left_out_metrics_json(const MotorDesign& design) {
  std::vector<MetricRequest> requests;
  const bool wears = design.stator.radial_slices != 1;
  for (const MetricInfo& row : metric_table())
    if ((row.needs_thermal || (row.needs_wear && wears)) && row.argument == Argument::none)
      requests.push_back({row.metric});
  const std::vector<MetricValue> values = evaluate(Motor(design), requests);
  Json json = Json::array();
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const MetricInfo& row = info(requests[i].metric);
    if (values[i].status != MetricStatus::ok) continue;
    json.push_back(
        {{"name", plain_name(std::string(row.name))},
         {"text", row.text},
         {"shown", telling::written(telling::named_part(std::string(row.name), values[i].value,
                                                        std::string(row.unit)),
                                    telling::Writing::page)}});
  }
  return json;
}

Json metrics_json(std::string_view text) {
  Json json = Json::object();
  for (const MetricInfo& row : metric_table()) {
    const bool absent = left_out_of_pages(row);
    if (absent && !names(text, row.name)) continue;
    json[std::string(row.name)] = only_true(
        {{"unit", row.unit},
         {"text", row.text},
         {"argument", to_string(row.argument)},
         {"share", row.unit == "1" && row.name.find("efficiency") != std::string_view::npos},
         {"modes", row.needs_modes},
         {"geometry", row.needs_geometry},
         {"absent", absent}});
  }
  return json;
}

Json reasons_json() {
  Json json = Json::object();
  for (const Reason& reason : reasons()) json[to_string(reason.status)] = reason.meaning;
  return json;
}

Json efficiencies_json() {
  return {
      {"contact_efficiency", "output power over the power from the stator to the contact"},
      {"efficiency",
       "output power over the sum of that power and the loss of the vibrating stator"},
      {"overall_efficiency",
       "output power over electrical power; all losses are included except that of the driver"}};
}

Json units_json() {
  std::set<std::string> si_units = units_of_tables();
  si_units.insert({"ohm", "H"});  // of an equivalent circuit
  Json json = Json::object();
  for (const std::string& unit : si_units)
    if (unit != "1") json[unit] = units_of(unit);
  return json;
}

Json display_units_json(const Json& page) {
  std::set<std::string> si_units = units_of_tables();
  si_units.insert(std::begin(kShownUnits), std::end(kShownUnits));
  add_units_in(page, si_units);
  Json json = Json::object();
  for (const std::string& si_unit : si_units) {
    json[si_unit] = Json::array();
    for (const DisplayUnit& unit : display_units(si_unit))
      json[si_unit].push_back(
          {{"text", printed_unit(unit.text)}, {"typed", unit.text}, {"divisor", unit.divisor}});
  }
  return json;
}

Json materials_json() {
  Json json = Json::object();
  for (const Material& material : material_catalogue())
    for (const MaterialValue& value : material.values)
      json[material.name][value.name] = value.value;
  return json;
}

Json stated_motor_json(const std::string& name, const MotorDesign& design) {
  MotorDesign wide = design;
  wide.stator.radial_slices = kAutoSlices;
  Json values = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    const double value = get(design, row.parameter);
    if (is_kept(row.file_entry)) continue;
    if (stated(design, wide, row.parameter) && std::isfinite(value))
      values[std::string(row.name)] = value;
  }
  const Stator& stator = design.stator;
  Json table = Json::array();
  for (const auto& [radius, shape] : stator.radial_shape.table) table.push_back({radius, shape});
  return {
      {"name", name},
      {"values", std::move(values)},
      {"branch", stator.branch == Branch::dead ? "dead" : "running"},
      {"inner_edge", stator.geometry ? Json(to_string(stator.geometry->support)) : Json(nullptr)},
      {"table", std::move(table)},
      {"besides", kept_json(name, design)}};
}

}  // namespace twum::inline v0_1::studies
