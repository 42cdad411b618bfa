// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/core/performance/motor.hpp>

#include <CLI/CLI.hpp>

#include <memory>

namespace twum::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  twum check ring-60.yaml
  twum check ring-60.yaml --set "thickness=0.2 mm")text";

int run_check(const MotorOptions& options) {
  const Motor motor(load_motor(options).design);
  Output output("");
  output.write(options.path + ": a valid motor file\n");
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
