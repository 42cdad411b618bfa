// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"

#include <twum/core/motor.hpp>
#include <twum/studies/designer.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kExploreExamples = R"text(Examples:
  twum explore ring-60.yaml                    writes ring-60.html, to be opened in a browser
  twum explore ring-60.yaml -o designer.html
  twum explore ring-60.yaml --set "preload=140 N" -o - > page.html

The page needs no network and can be passed on. It computes the motor with the same core as the other commands.)text";

struct ExploreOptions {
  MotorOptions motor;
  std::string page;
};

// The motor file's name with the extension .html, in the current directory; "motor.html" for standard input.
std::string page_of(const ExploreOptions& options) {
  if (!options.page.empty()) return options.page;
  if (options.motor.path == "-") return "motor.html";
  return std::filesystem::path(options.motor.path).stem().string() + ".html";
}

int run_explore(const ExploreOptions& options) {
  const std::string path = page_of(options);
  require_ending(path, {"html", "htm"});
  Output page(path, {options.motor.path});
  const studies::MotorFile motor = load_motor(options.motor);
  const Motor valid(motor.design);
  page.write(studies::designer_html(motor));
  page.finish();
  if (path != "-") {
    Output output("");
    output.say(path + "\n");
    output.finish();
  }
  if (!studies::has_designer())
    say("note: this build cannot compute in a page; the page says what is missing");
  print_model_notes(motor.design);
  return kDone;
}

}  // namespace

void add_explore(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ExploreOptions>();
  CLI::App* command = app.add_subcommand(
      "explore",
      "Writes an interactive page that computes the motor while you change its parameters");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  command
      ->add_option(
          "-o,--output", options->page,
          "Page to write (default: the motor file's name with .html; '-': standard output)")
      ->type_name("FILE");
  command->footer(kExploreExamples);
  command->callback([options, &action] { action = [options] { return run_explore(*options); }; });
}

}  // namespace twum::inline v0_1::cli
