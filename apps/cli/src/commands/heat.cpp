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

constexpr const char* kHeatExamples = R"text(Examples:
  twum heat examples/motors/warm-60.yaml --torque "0.5 N.m" --plot warm-up.svg
  twum heat warm-60.yaml --torque "0.5 N.m" --speed "60 rpm"
  twum heat warm-60.yaml --torque "0.5 N.m" --time "10 min" --format csv -o warm-up.csv
  twum heat warm-60.yaml                               the operation of the motor file)text";

struct HeatOptions {
  StudyCommand study;
  LoadOptions load;
  std::string time;
  std::uint64_t points{studies::HeatStudy{}.points};
};

studies::HeatStudy asked_by(const HeatOptions& options) {
  studies::HeatStudy asked;
  asked.points = options.points;
  set_load(asked, options.load);
  if (!options.time.empty())
    asked.time = more_than_zero("--time", parse_time("--time", options.time), options.time);
  return asked;
}

}  // namespace

void add_heat(CLI::App& app, Action& action) {
  const auto options = std::make_shared<HeatOptions>();
  CLI::App* command = app.add_subcommand(
      "heat", "Temperatures under a load and over the operation, and how long the motor may run");
  add_study_options(*command, options->study);
  add_held_load_options(*command, options->load);
  command
      ->add_option("--time", options->time,
                   "Duration of the warm-up (default: five times the slowest time constant)")
      ->type_name("TIME");
  command->add_option("--points", options->points, "Number of times (default: 101)")
      ->check(CLI::Range(2, 100000))
      ->type_name("N");
  command->footer(kHeatExamples);
  command->callback([options, &action] {
    action = [options] { return run_study_command(options->study, asked_by(*options)); };
  });
}

}  // namespace twum::inline v0_1::cli
