// SPDX-License-Identifier: Apache-2.0
#include "axial_motions.hpp"
#include "command.hpp"
#include "options.hpp"
#include "study_command.hpp"

#include <twum/studies/study.hpp>

#include <CLI/CLI.hpp>

#include <array>
#include <memory>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kMoveExamples = R"text(Examples:
  twum move examples/motors/moving-60.yaml --plot move.svg
  twum move moving-60.yaml --time "60 ms" --torque "0.2 N.m" --inertia "1e-4 kg.m^2"
  twum move moving-60.yaml --voltage "130 V" --format csv -o move.csv
  twum move drive-60.yaml --set "rotor_inertia=7e-6 kg.m^2"
  twum move moving-60.yaml --engine oscillating --set radial_slices=1
A study of kind 'motion' changes drive and load over time ('twum init motion' writes one).)text";

constexpr std::array kEngines{motion::MotionEngine::averaged, motion::MotionEngine::oscillating};

struct MoveOptions {
  StudyCommand study;
  std::string time, voltage, frequency, torque, inertia, engine, axial;
};

// Starts at once, and is switched off at two thirds of the time.
studies::MotionStudy asked_by(const MoveOptions& options) {
  studies::MotionStudy asked;
  asked.duration = more_than_zero("--time", parse_time("--time", options.time), options.time);
  asked.drive.switched_off = {{2 * asked.duration / 3, asked.duration}};
  if (!options.voltage.empty()) asked.drive.voltage = parse_voltage("--voltage", options.voltage);
  if (!options.frequency.empty())
    asked.drive.frequency = parse_frequency("--frequency", options.frequency);
  if (!options.torque.empty()) asked.load.torque = parse_torque("--torque", options.torque);
  asked.engine = value_of(options.engine, kEngines);
  asked.axial = value_of(options.axial, kAxialMotions);
  if (!options.inertia.empty()) asked.load.inertia = parse_inertia("--inertia", options.inertia);
  return asked;
}

}  // namespace

void add_move(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MoveOptions>();
  options->time = "30 ms";
  CLI::App* command =
      app.add_subcommand("move", "Start and stop in time: speed, angle, wave and torque");
  add_study_options(*command, options->study);
  command
      ->add_option("--time,--duration", options->time,
                   "Duration of the motion; the drive is switched off after two thirds of it "
                   "(default: 30 ms)")
      ->type_name("TIME");
  command->add_option("--voltage", options->voltage, "Drive voltage (default: the motor's)")
      ->type_name("VOLTAGE");
  command->add_option("--frequency", options->frequency, "Drive frequency (default: the motor's)")
      ->type_name("FREQUENCY");
  command->add_option("--torque", options->torque, "Load torque (default: none)")
      ->type_name("TORQUE");
  command
      ->add_option("--inertia", options->inertia,
                   "Moment of inertia of the load (default: the motor's)")
      ->type_name("INERTIA");
  command
      ->add_option("--engine", options->engine,
                   "averaged: one wave; oscillating: every vibration of two waves, slower "
                   "(default: averaged)")
      ->check(one_of(words_of(kEngines)))
      ->type_name(choices(words_of(kEngines)));
  command
      ->add_option("--axial", options->axial,
                   "static: the rotor's axial position is in balance at each instant; dynamic: it "
                   "follows from the rotor's mass (default: static)")
      ->check(one_of(words_of(kAxialMotions)))
      ->type_name(choices(words_of(kAxialMotions)));
  command->footer(kMoveExamples);
  command->callback([options, &action] {
    action = [options] { return run_study_command(options->study, asked_by(*options)); };
  });
}

}  // namespace twum::inline v0_1::cli
