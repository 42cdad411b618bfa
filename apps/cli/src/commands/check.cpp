// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/core/performance/motor.hpp>
#include <twum/studies/study/study_file.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  twum check ring-60.yaml
  twum check study.yaml
  twum check ring-60.yaml --set "thickness=0.2 mm")text";

// One line about a file that is right; throws what is wrong with it.
std::string verdict(const MotorOptions& options) {
  if (options.path != "-" && studies::is_study(studies::read_source(options.path))) {
    const studies::StudyFile study = studies::read_study_file(options.path, options.settings);
    const Motor motor(study.motor.design);
    return "a valid study file (" + std::string(studies::to_string(study.kind)) + ")";
  }
  const Motor motor(load_motor(options).design);
  return "a valid motor file";
}

int run_check(const MotorOptions& options) {
  const std::string found = verdict(options);
  Output output("");
  output.write(options.path + ": " + found + "\n");
  output.finish();
  return kDone;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MotorOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Says everything that is wrong with a file, without running it");
  command->add_option("FILE", options->path, "File to check ('-': standard input)")
      ->required()
      ->type_name("FILE");
  add_set_option(*command, options->settings);
  command->footer(kExamples);
  command->callback([options, &action] { action = [options] { return run_check(*options); }; });
}

}  // namespace twum::cli
