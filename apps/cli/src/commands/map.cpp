// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "options.hpp"
#include "study_command.hpp"

#include <twum/core/metrics.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/study.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kMapExamples = R"text(Examples:
  twum map examples/motors/drive-60.yaml --plot map.svg
  twum map drive-60.yaml --duty "0.5 N.m, 100 rpm" --duty "0.1 N.m, 20 rpm"
  twum map drive-60.yaml --quantity electrical_power_at --torque "0.8 N.m" --speed "120 rpm" --plot power.png
  twum map drive-60.yaml --points 30x20 --format csv -o map.csv)text";

struct MapOptions {
  StudyCommand study;
  std::string torque, speed, points, quantity;
  std::vector<std::string> duty;
};

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Metric metric : studies::MapStudy::quantities()) names.emplace_back(info(metric).name);
  return names;
}

studies::DutyPoint duty_of(const std::string& text) {
  const std::vector<std::string_view> parts = studies::split_list(text);
  if (parts.size() != 2)
    throw InputError("--duty: " + studies::quoted(text) +
                     "; expected a torque and a speed, such as \"0.5 N.m, 100 rpm\"");
  studies::DutyPoint duty{parse_torque("--duty", parts[0]), parse_speed("--duty", parts[1])};
  more_than_zero("--duty", duty.speed, text);
  return duty;
}

studies::MapStudy asked_by(const MapOptions& options) {
  studies::MapStudy asked;
  if (!options.torque.empty())
    asked.torque =
        more_than_zero("--torque", parse_torque("--torque", options.torque), options.torque);
  if (!options.speed.empty())
    asked.speed = more_than_zero("--speed", parse_speed("--speed", options.speed), options.speed);
  if (!options.quantity.empty()) asked.quantity = find_metric(options.quantity);
  for (const std::string& text : options.duty) asked.duty.push_back(duty_of(text));
  if (options.points.empty()) return asked;
  try {
    asked.points = studies::MapStudy::Grid::parse(options.points);
  } catch (const studies::ValueError& error) {
    throw InputError(std::string("--points: ") + error.what());
  }
  return asked;
}

}  // namespace

void add_map(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand(
      "map", "Efficiency map over speed and torque, with the drive adjusted to each point");
  add_study_options(*command, options->study);
  command
      ->add_option("--torque", options->torque,
                   "Largest torque of the map (default: the largest that the drive holds)")
      ->type_name("TORQUE");
  command
      ->add_option("--speed", options->speed,
                   "Largest speed of the map (default: the largest that the drive holds)")
      ->type_name("SPEED");
  command
      ->add_option("--points", options->points, "Number of speeds and of torques (default: 60x40)")
      ->type_name("NxM");
  command
      ->add_option("--quantity", options->quantity,
                   "Metric that the picture shows, at a torque and a speed (default: "
                   "overall_efficiency_at, without modal data efficiency_at)")
      ->check(one_of(quantity_names()))
      ->type_name("METRIC");
  command
      ->add_option(
          "--duty", options->duty,
          "A duty point to mark and to report in full, such as \"0.5 N.m, 100 rpm\" (repeatable)")
      ->type_name("TORQUE,SPEED");
  command->footer(kMapExamples);
  command->callback([options, &action] {
    action = [options] { return run_study_command(options->study, asked_by(*options)); };
  });
}

}  // namespace twum::inline v0_1::cli
