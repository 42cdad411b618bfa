// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "driven_motor.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/io/publish.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kInitExamples = R"text(Examples:
  twum init motor                    prints the file
  twum init motor --driven           a motor under a voltage, its amplitude follows from the load
  twum init optimize -o study.yaml   a study: curve, sweep, sensitivity, optimize, pareto,
                                     size, uncertainty, calibrate or frequency
  twum init size --motor my-motor.yaml -o size.yaml
  twum init motor -o my-motor.yaml)text";

constexpr const char* kMotorHeading =
    "# A motor for twum. Values carry their unit; any unit of the right dimension is accepted.\n"
    "# Check it with 'twum check FILE'; compute its curve with 'twum curve FILE'.\n";

struct InitOptions {
  std::string kind;
  bool driven{false};
  std::string motor;
  std::string path;
};

std::vector<std::string> kinds() {
  std::vector<std::string> names{"motor"};
  for (const std::string_view kind : studies::study_kinds()) names.emplace_back(kind);
  return names;
}

// Of the motor that a study names, if that is there already and has one.
std::optional<double> voltage_of(const InitOptions& options) {
  if (options.motor.empty()) return {};
  const std::filesystem::path path =
      std::filesystem::path(options.path).parent_path() / options.motor;
  try {
    return studies::read_motor_file(path.string()).design.stator.voltage;
  } catch (const InputError&) {
    return {};
  }
}

std::string template_of(const InitOptions& options) {
  if (options.driven) {
    if (options.kind != "motor" || !options.motor.empty())
      throw InputError("init: --driven is for a motor file, as in 'twum init motor --driven'");
    return driven_motor_text();
  }
  if (const auto study = studies::find_study_kind(options.kind))
    return studies::study_template(*study, options.motor, voltage_of(options));
  if (!options.motor.empty())
    throw InputError("init: --motor is for a study; 'twum init motor' writes a motor file itself");
  return studies::yaml_template(studies::motor_file_shape().schema, kMotorHeading);
}

int run_init(const InitOptions& options) {
  require_ending(options.path, {"yaml", "yml"});
  std::error_code ignored;
  if (std::filesystem::is_regular_file(options.path, ignored)) {
    throw InputError(options.path + ": exists already; choose another name after -o");
  }
  Output output(options.path);
  output.write(template_of(options));
  output.finish();
  return kDone;
}

}  // namespace

void add_init(CLI::App& app, Action& action) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App* command =
      app.add_subcommand("init", "Writes a commented template of a motor or study file");
  command->add_option("KIND", options->kind, "motor, or a kind of study")
      ->required()
      ->check(one_of(kinds()))
      ->type_name(choices(kinds()));
  command
      ->add_option("--motor", options->motor,
                   "For a study: motor file that it names, as a path relative to the study's "
                   "folder (default: the "
                   "study file contains a motor)")
      ->type_name("FILE");
  command->add_flag("--driven", options->driven,
                    "For a motor: its wave follows from voltage, frequency and load");
  command->add_option("-o,--output", options->path, "Write the result to this new file")
      ->type_name("FILE");
  command->footer(kInitExamples);
  command->callback([options, &action] { action = [options] { return run_init(*options); }; });
}

}  // namespace twum::inline v0_1::cli
