// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "load.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "plate_parts.hpp"
#include "plot/stator_plot.hpp"
#include "solid/solid_command.hpp"
#include "text_table.hpp"

#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <optional>

namespace twum::inline v0_1::cli {
namespace {

constexpr std::size_t kListedModes = 6, kMostModes = 41;

constexpr const char* kStatorExamples = R"text(Examples:
  twum stator examples/motors/drive-60.yaml
  twum stator drive-60.yaml --torque "0.5 N.m"
  twum stator plate-60.yaml --modes 10 --plot modes.svg
  twum stator plate-60.yaml --solid --write -o solid
  twum stator drive-60.yaml --set "preload=140 N" --format json -o stator.json)text";

struct StatorOptions {
  MotorOptions motor;
  LoadOptions load;
  OutputOptions output;
  std::string modes;
  std::string plot;
  bool solid{false};
  std::string mesh;
  bool write{false};
};

struct StatorAnswer {
  studies::MotorFile file;
  std::size_t modes{kListedModes};  // of the plate
  std::optional<EquivalentCircuit> free;
  std::optional<OperatingPoint> point;  // under load, if it has an answer
  ContactCircuit contact{};
};

constexpr Parameter kModalData[] = {Parameter::resonance_frequency, Parameter::modal_mass,
                                    Parameter::modal_damping,       Parameter::quality_factor,
                                    Parameter::force_factor,        Parameter::blocked_capacitance,
                                    Parameter::loss_tangent,        Parameter::frequency_ratio};

template <typename T>
struct Quantity {
  const char* name;
  const char* unit;
  double (*value)(const T&);
};

using C = EquivalentCircuit;
constexpr Quantity<C> kCircuit[] = {
    {"motional_resistance", "ohm", [](const C& c) { return c.motional_resistance; }},
    {"motional_inductance", "H", [](const C& c) { return c.motional_inductance; }},
    {"motional_capacitance", "F", [](const C& c) { return c.motional_capacitance; }},
    {"blocked_capacitance", "F", [](const C& c) { return c.blocked_capacitance; }},
    {"series_resonance", "Hz", [](const C& c) { return series_resonance(c); }},
    {"parallel_resonance", "Hz", [](const C& c) { return parallel_resonance(c); }},
    {"capacitance_ratio", "1", [](const C& c) { return capacitance_ratio(c); }},
    {"coupling_factor", "1", [](const C& c) { return coupling_factor(c); }}};

using P = OperatingPoint;
constexpr Quantity<P> kPoint[] = {
    {"speed", "rad/s", [](const P& p) { return p.speed; }},
    {"torque", "N.m", [](const P& p) { return p.torque; }},
    {"voltage", "V", [](const P& p) { return p.voltage; }},
    {"amplitude", "m", [](const P& p) { return p.amplitude; }},
    {"phase_lag", "rad", [](const P& p) { return p.phase_lag; }},
    {"phase_current", "A", [](const P& p) { return p.phase_current; }},
    {"electrical_power", "W", [](const P& p) { return p.electrical_power; }},
    {"overall_efficiency", "1", [](const P& p) { return p.overall_efficiency(); }}};

constexpr Quantity<P> kFreePoint[] = {
    {"voltage", "V", [](const P& p) { return p.voltage; }},
    {"amplitude", "m", [](const P& p) { return p.amplitude; }},
    {"phase_lag", "rad", [](const P& p) { return p.phase_lag; }},
    {"phase_current", "A", [](const P& p) { return p.phase_current; }},
    {"electrical_power", "W", [](const P& p) { return p.electrical_power; }}};

constexpr Quantity<ContactCircuit> kContact[] = {
    {"contact_resistance", "ohm", [](const ContactCircuit& c) { return c.resistance; }},
    {"contact_capacitance", "F", [](const ContactCircuit& c) { return c.capacitance; }}};

// A stator that no rotor touches: the wave is the same at every speed.
bool without_rotor(const MotorDesign& design) { return design.preload == 0; }

// The speed asked for, or that of the largest overall efficiency. If there is none, prints a message and returns
// nothing.
std::optional<double> loaded_speed(const StatorOptions& options, const Motor& motor) {
  if (options.load.given()) return speed_of(options.load, motor);
  if (without_rotor(motor.design())) return 0;
  const MetricValue best = evaluate(motor, {Metric::speed_at_max_overall_efficiency});
  if (best.status == MetricStatus::ok) return best.value;
  say(std::string("note: no operating point under load: ") + to_string(best.status));
  explain_reasons({to_string(best.status)});
  return {};
}

StatorAnswer compute_stator(const StatorOptions& options) {
  StatorAnswer answer;
  answer.file = load_motor(options.motor);
  const bool plate = answer.file.design.stator.geometry.has_value();
  if (!plate && !(options.modes.empty() && options.plot.empty()))
    throw InputError(
        options.motor.path +
        ": --modes and --plot need a stator given by its geometry; this one has no such block");
  if (!options.modes.empty()) answer.modes = parse_count("--modes", options.modes, 1, kMostModes);
  answer.free = equivalent_circuit(answer.file.design);
  if (!answer.free && plate) return answer;  // without damping
  if (!answer.free)
    throw InputError(
        options.motor.path +
        ": this motor has no modal data; give resonance_frequency, modal_mass, force_factor and "
        "quality_factor of its stator, or equivalent_circuit, or geometry");
  const Motor motor(answer.file.design);
  const std::optional<double> speed = loaded_speed(options, motor);
  if (!speed) return answer;
  const OperatingPoint point = motor.operating_point(*speed);
  if (point.status == PointStatus::ok) {
    answer.point = point;
    answer.contact = contact_circuit(motor, point);
  } else {
    say(std::string("twum: no answer at this speed: ") + to_string(point.status));
    explain_reasons({to_string(point.status)});
  }
  return answer;
}

template <typename T, std::size_t n>
void add_json(Json& json, Json& units, const Quantity<T> (&quantities)[n], const T& from) {
  for (const Quantity<T>& one : quantities) {
    json[one.name] = number_json(one.value(from));
    units[one.name] = one.unit;
  }
}

std::string as_json(const StatorAnswer& answer) {
  Json json = motor_json(answer.file);
  Json units = parameter_units_json(answer.file);
  for (const Parameter parameter : kModalData) {
    const ParameterInfo& row = info(parameter);
    json["modal_data"][std::string(row.name)] = number_json(get(answer.file.design, parameter));
    units[std::string(row.name)] = row.unit;
  }
  if (answer.file.design.stator.geometry)
    json["plate"] = plate_json(answer.file.design, answer.modes, units);
  json["equivalent_circuit"] = nullptr;
  if (answer.free) add_json(json["equivalent_circuit"], units, kCircuit, *answer.free);
  json["under_load"] = nullptr;
  if (answer.point) {
    const bool free = without_rotor(answer.file.design);
    Json& loaded = json[free ? "without_rotor" : "under_load"];
    if (free) {
      add_json(loaded, units, kFreePoint, *answer.point);
      json["units"] = units;
      return json_text(json);
    }
    add_json(loaded, units, kPoint, *answer.point);
    add_json(loaded, units, kContact, answer.contact);
    add_json(loaded["equivalent_circuit"], units, kCircuit,
             with_contact(*answer.free, answer.contact));
  }
  json["units"] = units;
  return json_text(json);
}

std::string shown(double value, const char* unit) {
  return std::isfinite(value) ? studies::engineering(value, unit) : "-";
}

template <typename T, std::size_t n>
void add_rows(TextTable& table, const Quantity<T> (&quantities)[n], const T& from) {
  for (const Quantity<T>& one : quantities)
    table.rows.push_back({one.name, shown(one.value(from), one.unit)});
}

std::string modal_text(const MotorDesign& design) {
  TextTable table;
  for (const Parameter parameter : kModalData)
    table.rows.push_back({std::string(info(parameter).name),
                          shown(get(design, parameter), info(parameter).unit.data())});
  return aligned(table);
}

std::string circuits_text(const StatorAnswer& answer) {
  TextTable table{{{"circuit of a phase", "free"}}};
  const bool loaded_too = answer.point && !without_rotor(answer.file.design);
  if (loaded_too) table.rows[0].emplace_back("under load");
  const EquivalentCircuit loaded = with_contact(*answer.free, answer.contact);
  for (const Quantity<C>& one : kCircuit) {
    table.rows.push_back({one.name, shown(one.value(*answer.free), one.unit)});
    if (loaded_too) table.rows.back().push_back(shown(one.value(loaded), one.unit));
  }
  return aligned(table);
}

std::string as_table(const StatorAnswer& answer) {
  const std::string name =
      answer.file.name.empty() ? "motor" : studies::printable(answer.file.name);
  std::string text = name + "\n\n" + modal_text(answer.file.design) + "\n";
  if (answer.file.design.stator.geometry)
    text += plate_text(answer.file.design, answer.modes) + "\n";
  if (answer.free) text += circuits_text(answer);
  if (!answer.point) return text;
  if (without_rotor(answer.file.design)) {
    TextTable point{{{"without rotor", ""}}};
    add_rows(point, kFreePoint, *answer.point);
    return text + "\n" + aligned(point);
  }
  TextTable point{{{"under load", ""}}};
  add_rows(point, kPoint, *answer.point);
  add_rows(point, kContact, answer.contact);
  return text + "\n" + aligned(point);
}

// Options that only one of the two ways to compute a stator has.
void check_options(const StatorOptions& options) {
  if (!options.solid && (!options.mesh.empty() || options.write))
    throw InputError("--mesh and --write belong to --solid, which is not given");
  if (options.solid && options.load.given())
    throw InputError("--solid has no operating point: leave out --torque and --speed");
}

int run_as_solid(const StatorOptions& options) {
  const std::size_t modes =
      options.modes.empty() ? kListedModes : parse_count("--modes", options.modes, 1, kMostModes);
  return run_solid_stator({options.motor, options.output.format, options.output.path, options.mesh,
                           modes, options.plot, options.write});
}

int run_stator(const StatorOptions& options) {
  check_options(options);
  if (options.solid) return run_as_solid(options);
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const StatorAnswer answer = compute_stator(options);
  if (options.load.given() && !answer.point) return kNoAnswer;
  output.write(options.output.format == "json" ? as_json(answer) : as_table(answer));
  output.finish();
  if (plot) plot->draw(kStatorPlotSize, stator_plot(answer.file));
  print_model_notes(answer.file.design);
  return kDone;
}

}  // namespace

void add_stator(CLI::App& app, Action& action) {
  const auto options = std::make_shared<StatorOptions>();
  CLI::App* command = app.add_subcommand("stator",
                                         "Modal data and equivalent circuit of the stator, free "
                                         "and under load; from its geometry also "
                                         "its modes");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  add_load_options(*command, options->load, 0);
  command
      ->add_option(
          "--modes", options->modes,
          "Number of modes of the geometry to list, those nearest to the drive's mode (default: 6)")
      ->type_name("N");
  add_output_options(*command, options->output, {"table", "json"});
  add_plot_option(*command, options->plot);
  command->add_flag(
      "--solid", options->solid,
      "Compute the geometry also as a solid with CalculiX; -o then names a folder for its files");
  command
      ->add_option("--mesh", options->mesh,
                   "With --solid: elements through the plate (default: 5, about a minute)")
      ->type_name("N");
  command->add_flag("--write", options->write,
                    "With --solid: write a copy of the motor file, MOTOR-solid.yaml, whose "
                    "stiffness_share gives the plate the solid's frequency");
  command->footer(kStatorExamples);
  command->callback([options, &action] { action = [options] { return run_stator(*options); }; });
}

}  // namespace twum::inline v0_1::cli
