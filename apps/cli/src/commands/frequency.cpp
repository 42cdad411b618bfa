// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "load.hpp"
#include "message.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "plot/style.hpp"
#include "plot/told_panel.hpp"
#include "text_table.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/frequency_points.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace twum::inline v0_1::cli {
namespace {

using studies::engineering;
using studies::frequency_columns;
using studies::FrequencyColumn;

constexpr const char* kFrequencyExamples = R"text(Examples:
  twum frequency examples/motors/drive-60.yaml
  twum frequency drive-60.yaml --torque "0.5 N.m" --direction down
  twum frequency drive-60.yaml --speed "0 rpm" --from "39 kHz" --to "45 kHz" --points 200 -o sweep.csv
  twum frequency drive-60.yaml --set "voltage=65 V" --plot sweep.svg)text";

struct FrequencyOptions {
  MotorOptions motor;
  LoadOptions load;
  std::string from, to, points;
  std::string direction{"both"};
  std::string plot;
  OutputOptions output;
};

struct DirectedSweep {
  const char* direction;  // "up" or "down"
  std::vector<double> frequencies;
  FrequencySweep sweep;
};

struct FrequencyAnswer {
  studies::MotorFile file;
  RotorLoad load;
  double from, to, operating;
  std::vector<ResponseBranch> branches;
  std::vector<DirectedSweep> sweeps;
  std::optional<ResponsePoint> running;  // at the drive's own frequency
  std::optional<double> pull_out;        // frequency at the lower end of its branch
};

RotorLoad load_of(const LoadOptions& options) {
  if (!options.speed.empty()) return {Argument::speed, parse_speed("--speed", options.speed)};
  if (options.torque.empty()) return {};
  return {Argument::torque, parse_torque("--torque", options.torque)};
}

// A stator that no rotor touches: the wave is the same at every speed, and there is no torque.
bool has_no_rotor(const MotorDesign& design) { return design.preload == 0; }

RotorLoad free_load(const RotorLoad& asked) {
  if (asked.given == Argument::torque && asked.value != 0)
    throw InputError("--torque: " + engineering(asked.value, "N.m") +
                     " cannot be carried with a preload of 0 N; leave it out to see the stator "
                     "without rotor");
  return {Argument::speed, asked.given == Argument::speed ? asked.value : 0};
}

// The given ends; an end that is not given is that of the response itself.
std::optional<std::pair<double, double>> range_of(const FrequencyOptions& options,
                                                  const MotorDesign& design,
                                                  const RotorLoad& load) {
  if (options.from.empty() && options.to.empty()) return {};
  std::optional<double> from, to;
  if (!options.from.empty()) from = parse_frequency("--from", options.from);
  if (!options.to.empty()) to = parse_frequency("--to", options.to);
  if (!from || !to) {
    const FrequencyResponse whole(design, load);
    if (!from) from = std::min(whole.from(), 0.9 * *to);
    if (!to) to = std::max(whole.to(), 1.1 * *from);
  }
  if (!(*from > 0 && *from < *to))
    throw InputError("--from has to be a positive frequency below --to; found " +
                     engineering(*from, "Hz") + " and " + engineering(*to, "Hz"));
  return std::pair{*from, *to};
}

FrequencyAnswer compute_frequency(const FrequencyOptions& options) {
  FrequencyAnswer answer;
  answer.file = load_motor(options.motor);
  const MotorDesign& design = answer.file.design;
  if (!design.stator.voltage)
    throw InputError(options.motor.path +
                     ": a frequency sweep needs a motor with a voltage; give voltage and the modal "
                     "data of its stator in place of amplitude");
  const std::size_t points =
      options.points.empty() ? 41 : parse_count("--points", options.points, 2, 100000);
  answer.load = load_of(options.load);
  if (has_no_rotor(design)) answer.load = free_load(answer.load);
  const FrequencyResponse response(design, answer.load, range_of(options, design, answer.load));
  answer.from = response.from(), answer.to = response.to();
  answer.operating = drive_frequency(design);
  answer.branches = response.branches();
  std::vector<double> frequencies = spaced_frequencies(answer.from, answer.to, points);
  if (options.direction != "down")
    answer.sweeps.push_back({"up", frequencies, response.sweep(frequencies)});
  std::reverse(frequencies.begin(), frequencies.end());
  if (options.direction != "up")
    answer.sweeps.push_back({"down", frequencies, response.sweep(frequencies)});
  answer.running = studies::running_point(response, answer.operating);
  if (answer.running) answer.pull_out = response.pull_out_below(*answer.running);
  return answer;
}

Json wave_json(const ResponsePoint& wave) {
  Json json;
  for (const FrequencyColumn& column : frequency_columns())
    json[column.name] = number_json(column.value(wave));
  return json;
}

Json wave_json(const std::optional<ResponsePoint>& wave) {
  return wave ? wave_json(*wave) : Json(nullptr);
}

Json sweep_json(const DirectedSweep& one) {
  Json json{{"points", Json::array()}, {"jumps", Json::array()}};
  for (std::size_t i = 0; i < one.frequencies.size(); ++i) {
    Json point = one.sweep.points[i] ? wave_json(*one.sweep.points[i]) : Json::object();
    point["frequency"] = number_json(one.frequencies[i]);
    point["steady"] = one.sweep.points[i].has_value();
    json["points"].push_back(point);
  }
  for (const Jump& jump : one.sweep.jumps)
    json["jumps"].push_back({{"from", wave_json(jump.from)}, {"to", wave_json(jump.to)}});
  return json;
}

std::string as_json(const FrequencyAnswer& answer) {
  Json json = motor_json(answer.file);
  const bool at_speed = answer.load.given == Argument::speed;
  json["load"] = {{at_speed ? "speed" : "torque", answer.load.value}};
  json["from"] = answer.from, json["to"] = answer.to;
  json["running"] = wave_json(answer.running);
  json["pull_out_below"] = answer.pull_out ? Json(*answer.pull_out) : Json(nullptr);
  json["branches"] = Json::array();
  for (const ResponseBranch& branch : answer.branches) {
    Json one{{"stable", branch.stable},
             {"first_end", to_string(branch.first_end)},
             {"last_end", to_string(branch.last_end)},
             {"points", Json::array()}};
    for (const ResponsePoint& point : branch.points) one["points"].push_back(wave_json(point));
    json["branches"].push_back(one);
  }
  for (const DirectedSweep& one : answer.sweeps) json["sweeps"][one.direction] = sweep_json(one);
  json["units"] = parameter_units_json(answer.file);
  json["units"]["from"] = json["units"]["to"] = json["units"]["pull_out_below"] = "Hz";
  for (const FrequencyColumn& column : frequency_columns())
    json["units"][column.name] = column.unit;
  return json_text(json);
}

std::string as_csv(const FrequencyAnswer& answer) {
  std::vector<std::string> cells{"sweep"};
  for (const FrequencyColumn& column : frequency_columns())
    cells.push_back(std::string(column.name) + " [" + column.unit + "]");
  cells.emplace_back("status");
  std::string text = csv_line(cells);
  for (const DirectedSweep& one : answer.sweeps) {
    for (std::size_t i = 0; i < one.frequencies.size(); ++i) {
      const auto& wave = one.sweep.points[i];
      cells = {one.direction, cell_of(one.frequencies[i])};
      for (const FrequencyColumn& column : frequency_columns().subspan(1))
        cells.push_back(wave ? cell_of(column.value(*wave)) : "");
      cells.emplace_back(wave ? "ok" : "no-steady-wave");
      text += csv_line(cells);
    }
  }
  return text;
}

std::string headline(const FrequencyAnswer& answer) {
  const std::string name =
      answer.file.name.empty() ? "motor" : studies::printable(answer.file.name);
  if (has_no_rotor(answer.file.design)) return name + ", stator without rotor";
  const bool at_speed = answer.load.given == Argument::speed;
  return name + ", rotor " + (at_speed ? "at " : "under ") +
         engineering(answer.load.value, at_speed ? "rad/s" : "N.m");
}

std::string findings(const FrequencyAnswer& answer) {
  TextTable table;
  const std::string own = engineering(answer.operating, "Hz");
  table.rows.push_back({"at " + own + ", the drive's frequency",
                        answer.running ? studies::wave_text(*answer.running) : "no steady wave"});
  if (answer.running && !has_no_rotor(answer.file.design))
    table.rows.push_back(
        {"  a backward wave grows (squeal)", studies::squeal_text(*answer.running)});
  if (answer.pull_out) {
    const double margin = answer.operating - *answer.pull_out;
    table.rows.push_back({"  this wave pulls out below", engineering(*answer.pull_out, "Hz")});
    table.rows.push_back({"  margin", engineering(margin, "Hz") + ", " +
                                          engineering(100 * margin / answer.operating, "1", 3) +
                                          " %"});
  }
  for (const DirectedSweep& one : answer.sweeps)
    for (const Jump& jump : one.sweep.jumps)
      table.rows.push_back({std::string("jump of the sweep ") + one.direction + " at " +
                                engineering(jump.from.frequency, "Hz"),
                            studies::wave_text(jump.from) + "  ->  " +
                                (jump.to ? studies::wave_text(*jump.to) : "no steady wave")});
  return aligned(table);
}

ColumnScale scale_of_waves(const FrequencyColumn& column, const FrequencyAnswer& answer) {
  double largest = 0;
  for (const DirectedSweep& one : answer.sweeps)
    for (const auto& wave : one.sweep.points)
      if (wave && std::isfinite(column.value(*wave)))
        largest = std::max(largest, std::abs(column.value(*wave)));
  return {studies::display_unit(largest, column.unit), largest};
}

// The columns of the table. A motor with equal phases and modes has no forced backward wave, so its columns are left
// out.
std::vector<FrequencyColumn> shown_columns(const FrequencyAnswer& answer) {
  std::vector<FrequencyColumn> columns(frequency_columns().begin(), frequency_columns().end());
  if (!answer.file.design.stator.imbalance)
    std::erase_if(columns, [](const FrequencyColumn& one) { return one.of_imbalance; });
  return columns;
}

std::string sweeps_table(const FrequencyAnswer& answer, std::size_t width) {
  TextTable table{{{"sweep"}, {""}}, true, 2};
  std::vector<ColumnScale> scales;
  const std::vector<FrequencyColumn> columns = shown_columns(answer);
  for (const FrequencyColumn& column : columns) {
    scales.push_back(scale_of_waves(column, answer));
    table.rows[0].emplace_back(column.name);
    const std::string& unit = scales.back().unit.text;
    table.rows[1].push_back(unit.empty() ? "" : "[" + unit + "]");
  }
  scales.front() = {studies::display_unit(answer.to, "Hz"), answer.to};
  table.rows[1][1] = "[" + scales.front().unit.text + "]";
  for (const DirectedSweep& one : answer.sweeps) {
    for (std::size_t i = 0; i < one.frequencies.size(); ++i) {
      std::vector<std::string> row{one.direction, rounded_cell(one.frequencies[i], scales[0])};
      for (std::size_t c = 1; c < scales.size(); ++c) {
        const auto& wave = one.sweep.points[i];
        row.push_back(wave ? rounded_cell(columns[c].value(*wave), scales[c]) : "-");
      }
      table.rows.push_back(std::move(row));
    }
  }
  return aligned(table, width);
}

std::string as_table(const FrequencyAnswer& answer, std::size_t width) {
  return headline(answer) + "\n\n" + findings(answer) + "\n" + sweeps_table(answer, width);
}

// The response of a study of this motor.
Picture picture_of_response(const FrequencyAnswer& answer) {
  studies::FrequencyResult::Member member{
      std::nan(""), answer.operating, answer.running, answer.pull_out, {}, answer.branches};
  for (const DirectedSweep& one : answer.sweeps)
    for (const Jump& jump : one.sweep.jumps)
      member.jumps.push_back({std::string_view(one.direction) == "up", jump});
  studies::StudyResult result;
  result.answer = studies::FrequencyResult{{}, answer.load, answer.from, answer.to, {member}};
  const std::vector<telling::Section> sections = telling::sections(result);
  const auto drawn = std::ranges::find_if(
      sections, [](const telling::Section& section) { return !section.charts.empty(); });
  return picture_of("response", told_chart(motor_title(answer.file), drawn->charts));
}

int run_frequency(const FrequencyOptions& options) {
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const FrequencyAnswer answer = compute_frequency(options);
  if (plot && !answer.branches.empty()) {
    const Picture drawn = picture_of_response(answer);
    plot->draw(drawn.size, drawn.script);
  }
  output.write(options.output.format == "json"  ? as_json(answer)
               : options.output.format == "csv" ? as_csv(answer)
                                                : as_table(answer, options.output.table_width()));
  output.finish();
  print_model_notes(answer.file.design);
  const bool any = std::any_of(answer.branches.begin(), answer.branches.end(),
                               [](const ResponseBranch& branch) { return branch.stable; });
  if (any) return kDone;
  say("twum: no steady wave at any frequency: the load is more than the motor carries, or every "
      "wave is unstable; try less torque or another speed");
  return kNoAnswer;
}

}  // namespace

void add_frequency(CLI::App& app, Action& action) {
  const auto options = std::make_shared<FrequencyOptions>();
  CLI::App* command = app.add_subcommand(
      "frequency", "Frequency sweep of a motor under a voltage: branches, jumps, margin");
  add_motor_options(*command, options->motor);
  add_load_options(*command, options->load, 0);
  command
      ->add_option("--from", options->from,
                   "Lowest frequency, such as \"39 kHz\" (default: below jumps and resonance)")
      ->type_name("FREQUENCY");
  command->add_option("--to", options->to, "Highest frequency (default: above all jumps)")
      ->type_name("FREQUENCY");
  command
      ->add_option("--points", options->points,
                   "Number of frequencies in each direction (default: 41)")
      ->type_name("N");
  command->add_option("--direction", options->direction, "Direction of the sweep (default: both)")
      ->check(one_of({"up", "down", "both"}))
      ->type_name("up|down|both");
  add_output_options(*command, options->output, {"table", "csv", "json"});
  add_plot_option(*command, options->plot);
  command->footer(kFrequencyExamples);
  command->callback([options, &action] { action = [options] { return run_frequency(*options); }; });
}

}  // namespace twum::inline v0_1::cli
