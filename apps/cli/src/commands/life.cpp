// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "options.hpp"
#include "study_command.hpp"

#include <twum/studies/study.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kLifeExamples = R"text(Examples:
  twum life examples/motors/worn-60.yaml --torque "0.5 N.m" --plot margins.svg
  twum life worn-60.yaml --torque "0.5 N.m" --speed "60 rpm"
  twum life worn-60.yaml --torque "0.5 N.m" --format csv -o life.csv
  twum life worn-60.yaml                               the operation of the motor file)text";

struct LifeOptions {
  StudyCommand study;
  LoadOptions load;
  std::uint64_t points{studies::LifeStudy{}.points};
};

studies::LifeStudy asked_by(const LifeOptions& options) {
  studies::LifeStudy asked;
  asked.points = options.points;
  set_load(asked, options.load);
  return asked;
}

}  // namespace

void add_life(CLI::App& app, Action& action) {
  const auto options = std::make_shared<LifeOptions>();
  CLI::App* command = app.add_subcommand(
      "life",
      "Life of the motor until its contact track is worn too far, and the changes until then");
  add_study_options(*command, options->study);
  add_held_load_options(*command, options->load);
  command->add_option("--points", options->points, "Number of wear depths (default: 51)")
      ->check(CLI::Range(2, 10000))
      ->type_name("N");
  command->footer(kLifeExamples);
  command->callback([options, &action] {
    action = [options] { return run_study_command(options->study, asked_by(*options)); };
  });
}

}  // namespace twum::inline v0_1::cli
