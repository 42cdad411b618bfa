// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "load.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/base/error.hpp>
#include <twum/core/held_point.hpp>
#include <twum/io/engineering.hpp>
#include <twum/studies/datasheet.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kDatasheetExamples = R"text(Examples:
  twum datasheet ring-60.yaml                        writes ring-60-datasheet.html
  twum datasheet ring-60.yaml --torque "0.5 N.m"     rated at this load
  twum datasheet drive-60.yaml --torque "0.5 N.m" --speed "60 rpm"
                                                     rated at this duty, to which the drive is adjusted
  twum datasheet results/study -o sheet.html         of the motor that a study found

The page needs no other file and prints on one sheet of A4. Without --speed and --torque the rated point is that of the largest
overall efficiency, or of the largest output power where the motor file has no electrical data.)text";

struct SheetOptions {
  MotorOptions motor;
  LoadOptions load;
  std::string page;
};

// For a result directory, the file of the motor that the study found; any other path unchanged.
std::string motor_of(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  for (const char* name : {"best.yaml", "fitted.yaml"}) {
    const fs::path motor = fs::path(path) / name;
    if (fs::exists(motor, ignored)) return motor.string();
  }
  const fs::path front = fs::path(path) / "front";
  throw InputError(path +
                   ": this directory has no best.yaml and no fitted.yaml; give a motor file" +
                   (fs::is_directory(front, ignored) ? ", such as one in " + front.string() : ""));
}

// The name of the motor file, or of the directory of the study that found it.
std::string sheet_of(const SheetOptions& options, const std::string& motor) {
  if (!options.page.empty()) return options.page;
  if (motor == "-") return "motor-datasheet.html";
  const std::filesystem::path given = std::filesystem::path(options.motor.path).lexically_normal();
  const std::filesystem::path name = given.has_filename() ? given : given.parent_path();
  return (motor == options.motor.path ? name.stem() : name.filename()).string() + "-datasheet.html";
}

// False if the drive does not hold the point; the reason is then on standard error.
bool set_held(studies::DatasheetOptions& sheet, const LoadOptions& load,
              const MotorDesign& design) {
  sheet.held_torque = parse_torque("--torque", load.torque);
  sheet.rated_speed = more_than_zero("--speed", parse_speed("--speed", load.speed), load.speed);
  const HeldPoint held = held_point(design, *sheet.held_torque, *sheet.rated_speed);
  if (held.status == HeldStatus::ok) return true;
  const std::string_view unit = needed_unit(held.status);
  say("twum: the drive does not hold this torque at this speed: " +
      std::string(to_string(held.status)) +
      (unit.empty() ? "" : " (what would do: " + studies::engineering(held.needed, unit) + ")"));
  explain_reasons({to_string(held.status)});
  return false;
}

// False if the motor has no such point; the reason is then on standard error.
bool set_rated(studies::DatasheetOptions& sheet, const LoadOptions& load,
               const MotorDesign& design) {
  if (!load.given()) return true;
  if (!load.torque.empty() && !load.speed.empty()) return set_held(sheet, load, design);
  sheet.rated_speed = speed_of(load, Motor(design));
  return sheet.rated_speed.has_value();
}

int run_datasheet(const SheetOptions& options) {
  if (!options.page.empty()) require_ending(options.page, {"html", "htm"});
  MotorOptions of = options.motor;
  of.path = motor_of(of.path);
  const std::string path = sheet_of(options, of.path);
  Output page(path, {of.path});
  const studies::MotorFile motor = load_motor(of);
  studies::DatasheetOptions sheet{{}, {}, of.path == "-" ? "" : of.path};
  if (!set_rated(sheet, options.load, motor.design)) return kNoAnswer;
  page.write(studies::datasheet_html(motor, sheet));
  page.finish();
  if (path == "-") return kDone;
  Output output("");
  output.say(path + "\n");
  output.finish();
  return kDone;
}

}  // namespace

void add_datasheet(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SheetOptions>();
  CLI::App* command = app.add_subcommand("datasheet", "A data sheet of a motor on one page");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  command
      ->add_option("--torque", options->load.torque,
                   "Load torque of the rated point, such as \"0.5 N.m\"")
      ->type_name("TORQUE");
  command
      ->add_option("--speed", options->load.speed,
                   "Rotor speed of the rated point, such as \"100 rpm\"; with a torque, the drive "
                   "is adjusted to hold both")
      ->type_name("SPEED");
  command
      ->add_option("-o,--output", options->page,
                   "Page to write (default: the motor file's name with -datasheet.html; '-': "
                   "standard output)")
      ->type_name("FILE");
  command->footer(kDatasheetExamples);
  command->callback([options, &action] { action = [options] { return run_datasheet(*options); }; });
}

}  // namespace twum::inline v0_1::cli
