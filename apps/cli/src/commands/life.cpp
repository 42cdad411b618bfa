// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "options.hpp"
#include "study_command.hpp"

#include <twum/studies/study.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace twum::cli {
namespace {

constexpr const char* kLifeExamples = R"text(Examples:
  twum life examples/motors/worn-60.yaml --torque "0.5 N.m" --plot margins.svg
  twum life worn-60.yaml --torque "0.5 N.m" --speed "60 rpm"
  twum life worn-60.yaml --torque "0.5 N.m" --format csv -o life.csv
  twum life worn-60.yaml                               the operation of the motor file)text";

struct LifeOptions {
  StudyCommand study;
  std::string torque, speed;
  std::uint64_t points{studies::LifeStudy{}.points};
};

studies::LifeStudy asked_by(const LifeOptions& options) {
  studies::LifeStudy asked;
  asked.points = options.points;
  if (!options.torque.empty()) asked.torque = parse_torque("--torque", options.torque);
  if (!options.speed.empty()) asked.speed = parse_speed("--speed", options.speed);
  if (asked.torque && asked.speed) more_than_zero("--speed", *asked.speed, options.speed);
  return asked;
}

}  // namespace

void add_life(CLI::App& app, Action& action) {
  const auto options = std::make_shared<LifeOptions>();
  CLI::App* command = app.add_subcommand(
      "life", "How long the motor lives until its track has worn too far, and what changes");
  add_study_options(*command, options->study);
  command
      ->add_option("--torque", options->torque,
                   "Load torque (default: none; the motor's operation alone)")
      ->type_name("TORQUE");
  command
      ->add_option("--speed", options->speed,
                   "Speed of the rotor; with a torque the drive holds it as the track wears")
      ->type_name("SPEED");
  command->add_option("--points", options->points, "Number of depths (default: 51)")
      ->check(CLI::Range(2, 10000))
      ->type_name("N");
  command->footer(kLifeExamples);
  command->callback([options, &action] {
    action = [options] { return run_study_command(options->study, asked_by(*options)); };
  });
}

}  // namespace twum::cli
