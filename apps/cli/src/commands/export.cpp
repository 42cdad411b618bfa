// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "fmu/fmu.hpp"
#include "fmu/plant_motor.hpp"
#include "formats.hpp"
#include "interrupt.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/motion/plant_table.hpp>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

using motion::ContactTable;
using motion::PlantTable;

constexpr const char* kExportExamples = R"text(Examples:
  twum export examples/motors/moving-60.yaml --as fmu -o moving-60.fmu
  twum export moving-60.yaml --as fmu --inertia "1e-4 kg.m^2" -o moving-60.fmu
  twum export moving-60.yaml --as tables -o contact.csv
An FMU is a file that Simulink, Modelica tools and the Python package FMPy read.)text";

struct ExportOptions {
  MotorOptions motor;
  std::string as, path, inertia;
};

std::optional<PlantTable> table_of(const MotorDesign& design) {
  Progress progress;
  motion::PlantTableOptions options;
  options.go_on = [&](double share) {
    progress.show({.fraction = share, .stage = "contact"});
    return !interrupted();
  };
  return motion::tabulate(design, options);
}

void add_rows(std::string& text, const PlantTable& t, const ContactTable& side, const char* sign) {
  for (std::size_t i = 0; i < t.speed_ratios.size(); ++i) {
    for (std::size_t j = 0; j < t.amplitudes.size(); ++j) {
      const std::size_t k = i * t.amplitudes.size() + j;
      text += csv_line({sign, cell_of(t.speed_ratios[i]), cell_of(t.amplitudes[j]),
                        cell_of(side.torque[k]), cell_of(side.reactive_stiffness[k]),
                        cell_of(side.active_stiffness[k])});
    }
  }
}

std::string as_csv(const PlantTable& t) {
  std::string text = csv_line({"side [1]", "speed_ratio [1]", "amplitude [m]", "torque [N.m]",
                               "reactive_stiffness [N/m]", "active_stiffness [N/m]"});
  add_rows(text, t, t.along, "1");
  add_rows(text, t, t.against, "-1");
  return text;
}

// How good the tables are, by a motion that has both.
std::string told(const PlantCheck& check) {
  if (!check.missing.empty())
    return "It is not compared with the exact contact ('twum move'): " + check.missing + ".\n";
  return fmt::format(
      "Start and stop, 20 ms each, compared with the exact contact ('twum move'): the speed "
      "differs by at most {:.2g} % of its peak, the angle in which the rotor stops by {:.2g} %.\n",
      100 * check.speed_error, 100 * check.angle_error);
}

std::string name_of(const studies::MotorFile& file, const std::string& path) {
  return file.name.empty() ? std::filesystem::path(path).stem().string()
                           : studies::printable(file.name);
}

void write_fmu(const ExportOptions& options, const studies::MotorFile& file,
               const PlantTable& table) {
  const PlantMotor motor(file.design, table);
  const Fmu fmu = make_fmu(motor, name_of(file, options.motor.path));
  Output output(options.path, {options.motor.path});
  output.write(fmu.bytes);
  output.finish();
  Output terminal("-");
  terminal.say(
      fmt::format("{}: FMI 2.0 for co-simulation, {} kB, sources in C{}.\nThe contact at {} "
                  "amplitudes up to {} "
                  "and {} speeds to each side.\n{}",
                  options.path, (fmu.bytes.size() + 500) / 1000,
                  fmu.platform.empty() ? "" : " and a binary for " + fmu.platform,
                  table.amplitudes.size(), studies::engineering(table.amplitudes.back(), "m"),
                  table.speed_ratios.size(), told(check_plant(file.design, motor))));
  terminal.finish();
  if (!fmu.problem.empty())
    say("note: the FMU has no binary, and the tool that reads it must compile its sources: " +
        fmu.problem);
}

int run_export(const ExportOptions& options) {
  const bool as_fmu = options.as == "fmu";
  if (as_fmu && (options.path.empty() || options.path == "-"))
    throw InputError("an FMU is a file; say where it goes, such as -o motor.fmu");
  require_ending(options.path, {as_fmu ? "fmu" : "csv"});
  studies::MotorFile file = load_motor(options.motor);
  if (!options.inertia.empty())
    file.design =
        with(file.design, Parameter::load_inertia, parse_inertia("--inertia", options.inertia));
  const std::optional<PlantTable> table = table_of(file.design);
  if (!table) return kInterrupted;
  if (as_fmu) {
    write_fmu(options, file, *table);
  } else {
    Output output(options.path, {options.motor.path});
    output.write(as_csv(*table));
    output.finish();
  }
  print_model_notes(file.design);
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand(
      "export", "The motor for models in other tools: an FMU, or tables of its contact");
  add_motor_options(*command, options->motor);
  command
      ->add_option("--as", options->as,
                   "An FMU for Simulink, Modelica and Python, or the contact's tables as CSV")
      ->required()
      ->check(one_of({"fmu", "tables"}))
      ->type_name(choices({"fmu", "tables"}));
  command
      ->add_option("-o,--output", options->path, "File to write (tables: default is the terminal)")
      ->type_name("FILE");
  command
      ->add_option("--inertia", options->inertia,
                   "Moment of inertia of the load (default: the motor's)")
      ->type_name("INERTIA");
  command->footer(kExportExamples);
  command->callback([options, &action] { action = [options] { return run_export(*options); }; });
}

}  // namespace twum::inline v0_1::cli
