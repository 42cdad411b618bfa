// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "interrupt.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "plot/study/told_pictures.hpp"

#include <twum/core/metrics.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/run_options.hpp>
#include <twum/studies/study_file.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace twum::cli {
namespace {

constexpr const char* kMapExamples = R"text(Examples:
  twum map examples/motors/drive-60.yaml --plot map.svg
  twum map drive-60.yaml --duty "0.5 N.m, 100 rpm" --duty "0.1 N.m, 20 rpm"
  twum map drive-60.yaml --quantity electrical_power_at --torque "0.8 N.m" --speed "120 rpm" --plot power.png
  twum map drive-60.yaml --points 30x20 --format csv -o map.csv)text";

struct MapOptions {
  MotorOptions motor;
  std::string torque, speed, points, quantity, plot;
  std::vector<std::string> duty;
  OutputOptions output;
};

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Metric metric : studies::MapStudy::quantities()) names.emplace_back(info(metric).name);
  return names;
}

double upper_end(const char* option, double value, const std::string& text) {
  if (value > 0) return value;
  throw InputError(std::string(option) + ": " + studies::quoted(text) +
                   "; expected the upper end of the axis, more than 0");
}

studies::DutyPoint duty_of(const std::string& text) {
  const std::vector<std::string_view> parts = studies::split_list(text);
  if (parts.size() != 2)
    throw InputError("--duty: " + studies::quoted(text) +
                     "; expected a torque and a speed, such as \"0.5 N.m, 100 rpm\"");
  studies::DutyPoint duty{parse_torque("--duty", parts[0]), parse_speed("--duty", parts[1])};
  upper_end("--duty", duty.speed, text);
  return duty;
}

studies::MapStudy asked_by(const MapOptions& options) {
  studies::MapStudy asked;
  if (!options.torque.empty())
    asked.torque = upper_end("--torque", parse_torque("--torque", options.torque), options.torque);
  if (!options.speed.empty())
    asked.speed = upper_end("--speed", parse_speed("--speed", options.speed), options.speed);
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

std::string text_of(const studies::StudyResult& result, const std::string& format) {
  if (format == "json") return studies::summary_json(result);
  if (format == "csv") return studies::results_csv(result);
  return studies::summary_text(result);
}

// The entries of the study have the names of the options.
studies::StudyResult result_of(const studies::StudyFile& file, const studies::RunOptions& run) {
  try {
    return studies::run_study(file, run);
  } catch (const InputError& error) {
    const std::string_view text = error.what(), entry = "study.";
    if (!text.starts_with(entry)) throw;
    throw InputError("--" + std::string(text.substr(entry.size())));
  }
}

int run_map(const MapOptions& options) {
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const StopOnInterrupt stop;
  studies::RunOptions run;
  run.stop = stop.token();
  studies::StudyFile file;
  file.motor = load_motor(options.motor);
  file.path = options.motor.path;
  file.asked = asked_by(options);
  const studies::StudyResult result = result_of(file, run);
  if (result.outcome == studies::StudyOutcome::interrupted) return kInterrupted;
  const std::vector<Picture> pictures = plot && result.outcome == studies::StudyOutcome::done
                                            ? told_pictures({file, result, *result.rows})
                                            : std::vector<Picture>{};
  if (!pictures.empty()) plot->draw(pictures.front().size, pictures.front().script);
  output.write(text_of(result, options.output.format));
  output.finish();
  print_model_notes(file.motor.design);
  return result.outcome == studies::StudyOutcome::done ? kDone : kNoAnswer;
}

}  // namespace

void add_map(CLI::App& app, Action& action) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand(
      "map", "Efficiency map: what a drive that follows needs and gives over speed and torque");
  add_motor_options(*command, options->motor);
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
                   "What the picture shows: a metric at a torque and a speed (default: "
                   "overall_efficiency_at, without modal data efficiency_at)")
      ->check(one_of(quantity_names()))
      ->type_name("METRIC");
  command
      ->add_option("--duty", options->duty,
                   "A point that is marked and told in full, such as \"0.5 N.m, 100 rpm\"; may be "
                   "given several times")
      ->type_name("TORQUE,SPEED");
  add_output_options(*command, options->output, {"table", "csv", "json"});
  add_plot_option(*command, options->plot);
  command->footer(kMapExamples);
  command->callback([options, &action] { action = [options] { return run_map(*options); }; });
}

}  // namespace twum::cli
