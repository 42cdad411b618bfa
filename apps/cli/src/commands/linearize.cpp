// SPDX-License-Identifier: Apache-2.0
#include "axial_motions.hpp"
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "json_parts.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "text_table.hpp"

#include <twum/core/frequency_response.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/motion/control.hpp>
#include <twum/motion/linear_plant.hpp>

#include <CLI/CLI.hpp>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

using motion::LinearPlant;
using motion::Signal;

constexpr const char* kLinearizeExamples = R"text(Examples:
  twum linearize examples/motors/moving-60.yaml
  twum linearize moving-60.yaml --torque "0.3 N.m" --inertia "1e-4 kg.m^2"
  twum linearize moving-60.yaml --format matlab -o plant.m
  twum linearize moving-60.yaml --format json -o plant.json
  twum linearize moving-60.yaml --from "40.2 kHz" --to "43 kHz" --points 8
The last one writes a gain schedule: a plant and the gains of a loop of the speed for each frequency.)text";

struct LinearizeOptions {
  MotorOptions motor;
  OutputOptions output;
  std::string torque, inertia, axial;
  std::string from, to, points, sample_time, delay;  // of a gain schedule
};

std::array<std::pair<const char*, const LinearPlant::Matrix*>, 4> matrices(const LinearPlant& p) {
  return {{{"A", &p.a}, {"B", &p.b}, {"C", &p.c}, {"D", &p.d}}};
}

// Without the angle, which follows no input in the steady state.
std::vector<Signal> steady_outputs(const LinearPlant& plant) {
  std::vector<Signal> outputs = plant.outputs;
  std::erase_if(outputs, [](const Signal& one) { return one.name == "angle"; });
  return outputs;
}

std::string unit_of_gain(const Signal& output, const Signal& input) {
  return output.unit + "/(" + input.unit + ")";
}

// "-2790 - 3330 i": to four digits.
std::string pole_text(const std::complex<double>& pole) {
  const auto rounded = [](double value) { return studies::engineering(value, "1/s"); };
  if (pole.imag() == 0) return rounded(pole.real());
  return rounded(pole.real()) + (pole.imag() < 0 ? " - i " : " + i ") +
         rounded(std::abs(pole.imag()));
}

std::string as_table(const studies::MotorFile& file, const LinearPlant& plant) {
  TextTable state{{{"steady state", ""}}};
  for (const std::vector<Signal>* signals : {&plant.inputs, &plant.outputs})
    for (const Signal& one : *signals)
      if (one.name != "angle")
        state.rows.push_back({one.name, studies::engineering(one.steady, one.unit)});
  TextTable poles{{{"pole", "time constant"}}};
  for (const auto& pole : plant.poles)
    poles.rows.push_back(
        {pole_text(pole), pole.real() < 0 ? studies::engineering(-1 / pole.real(), "s") : "grows"});
  TextTable gains{{{"gain"}}};
  for (const Signal& input : plant.inputs)
    gains.rows[0].push_back("per " + input.name + " [" + input.unit + "]");
  const std::vector<Signal> outputs = steady_outputs(plant);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    gains.rows.push_back({outputs[i].name + " [" + outputs[i].unit + "]"});
    for (const double gain : plant.gains[i])
      gains.rows.back().push_back(studies::engineering(gain, "1"));
  }
  const std::string name = file.name.empty() ? "motor" : studies::printable(file.name);
  return name + "\n\n" + aligned(state) + "\n" + aligned(poles) + "\n" + aligned(gains) +
         "\nThe angle integrates the speed. '--format json', 'matlab' and 'csv' have the "
         "matrices.\n";
}

Json signals_json(const std::vector<Signal>& signals) {
  Json json = Json::array();
  for (const Signal& one : signals)
    json.push_back({{"name", one.name}, {"unit", one.unit}, {"steady", number_json(one.steady)}});
  return json;
}

std::string as_json(const studies::MotorFile& file, const LinearPlant& plant) {
  Json json = motor_json(file);
  json["states"] = signals_json(plant.states);
  json["inputs"] = signals_json(plant.inputs);
  json["outputs"] = signals_json(plant.outputs);
  for (const auto& [name, matrix] : matrices(plant)) json[name] = *matrix;
  json["poles"] = Json::array();
  for (const auto& pole : plant.poles)
    json["poles"].push_back({{"real", pole.real()}, {"imaginary", pole.imag()}});
  json["gains"] = Json::object();
  const std::vector<Signal> outputs = steady_outputs(plant);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    for (std::size_t j = 0; j < plant.inputs.size(); ++j)
      json["gains"][outputs[i].name][plant.inputs[j].name] = {
          {"value", number_json(plant.gains[i][j])},
          {"unit", unit_of_gain(outputs[i], plant.inputs[j])}};
  return json_text(json);
}

// An entry of a matrix a line, with the names of its row and its column.
std::string as_csv(const LinearPlant& plant) {
  std::string text = csv_line({"matrix", "row", "column", "value"});
  const auto add = [&](const char* name, const LinearPlant::Matrix& matrix,
                       const std::vector<Signal>& rows, const std::vector<Signal>& columns) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < columns.size(); ++j)
        text += csv_line({name, rows[i].name, columns[j].name, cell_of(matrix[i][j])});
  };
  add("A", plant.a, plant.states, plant.states);
  add("B", plant.b, plant.states, plant.inputs);
  add("C", plant.c, plant.outputs, plant.states);
  add("D", plant.d, plant.outputs, plant.inputs);
  return text;
}

std::string names_matlab(const char* variable, const std::vector<Signal>& signals) {
  std::string text = std::string(variable) + " = {";
  for (const Signal& one : signals) text += (&one == signals.data() ? "'" : ", '") + one.name + "'";
  return text + "};\n";
}

std::string steady_matlab(const char* variable, const std::vector<Signal>& signals) {
  std::string text = std::string(variable) + " = [";
  for (const Signal& one : signals)
    text += (&one == signals.data() ? "" : "; ") + studies::number_text(one.steady);
  return text + "];\n";
}

// Runs in MATLAB and in Octave; 'plant' needs the control toolbox of either.
std::string as_matlab(const studies::MotorFile& file, const LinearPlant& plant) {
  std::string text = "% " + studies::printable(file.name) +
                     " near a steady state, SI units; written by twum\n"
                     "% x' = A (x - x0) + B (u - u0),  y - y0 = C (x - x0) + D (u - u0)\n";
  for (const auto& [name, matrix] : matrices(plant)) {
    text += std::string(name) + " = [";
    for (const std::vector<double>& row : *matrix) {
      text += &row == matrix->data() ? "" : "; ...\n     ";
      for (const double& value : row)
        text += (&value == row.data() ? "" : ", ") + studies::number_text(value);
    }
    text += "];\n";
  }
  text += steady_matlab("x0", plant.states) + steady_matlab("u0", plant.inputs) +
          steady_matlab("y0", plant.outputs) + names_matlab("states", plant.states) +
          names_matlab("inputs", plant.inputs) + names_matlab("outputs", plant.outputs);
  return text +
         "if exist('ss')\n"
         "  plant = ss(A, B, C, D);\n"
         "  plant.StateName = states;  plant.InputName = inputs;  plant.OutputName = outputs;\n"
         "end\n";
}

std::vector<double> schedule_frequencies(const LinearizeOptions& options) {
  if (options.from.empty() || options.to.empty())
    throw InputError("a gain schedule needs both --from and --to");
  const double from = parse_frequency("--from", options.from);
  const double to = parse_frequency("--to", options.to);
  if (!(from < to)) throw InputError("--from has to be below --to");
  return spaced_frequencies(from, to, parse_count("--points", options.points, 2, 10000));
}

// "rad/s/Hz" and the other units of a schedule in the order of its columns.
constexpr std::array<std::pair<const char*, const char*>, 8> kScheduleColumns{
    {{"frequency", "Hz"},
     {"speed", "rad/s"},
     {"gain", "rad/s/Hz"},
     {"time_constant", "s"},
     {"slowest_pole_real", "1/s"},
     {"slowest_pole_imaginary", "1/s"},
     {"kp", "Hz.s/rad"},
     {"ki", "Hz/rad"}}};

// Numbers of a row; NaN where the motor does not run.
std::array<double, 8> schedule_numbers(const motion::ScheduleRow& row) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!row.plant) return {row.output, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  const motion::LoopPlant& p = *row.plant;
  return {row.output,
          p.speed,
          p.gain,
          p.time_constant,
          p.poles.front().real(),
          std::abs(p.poles.front().imag()),
          row.gains.proportional,
          row.gains.integral};
}

std::string schedule_csv(const std::vector<motion::ScheduleRow>& rows) {
  std::vector<std::string> cells;
  for (const auto& [name, unit] : kScheduleColumns)
    cells.push_back(std::string(name) + " [" + unit + "]");
  std::string text = csv_line(cells);
  for (const motion::ScheduleRow& row : rows) {
    cells.clear();
    for (const double value : schedule_numbers(row)) cells.push_back(cell_of(value));
    text += csv_line(cells);
  }
  return text;
}

std::string schedule_json(const studies::MotorFile& file,
                          const std::vector<motion::ScheduleRow>& rows) {
  Json json = motor_json(file);
  json["units"] = Json::object();
  for (const auto& [name, unit] : kScheduleColumns) json["units"][name] = unit;
  json["schedule"] = Json::array();
  for (const motion::ScheduleRow& row : rows) {
    Json entry = Json::object();
    const auto numbers = schedule_numbers(row);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      entry[kScheduleColumns[i].first] = number_json(numbers[i]);
    json["schedule"].push_back(entry);
  }
  return json_text(json);
}

std::string schedule_table(const studies::MotorFile& file,
                           const std::vector<motion::ScheduleRow>& rows) {
  TextTable table{{{"frequency", "speed", "K [rad/s/Hz]", "tau", "slowest pole", "kp [Hz.s/rad]",
                    "ki [Hz/rad]"}}};
  for (const motion::ScheduleRow& row : rows) {
    table.rows.push_back({studies::engineering(row.output, "Hz", 5)});
    if (!row.plant) {
      table.rows.back().insert(table.rows.back().end(), {"does not run", "", "", "", "", ""});
      continue;
    }
    const motion::LoopPlant& p = *row.plant;
    table.rows.back().insert(
        table.rows.back().end(),
        {studies::engineering(p.speed, "rad/s"), studies::rounded_text(p.gain, 4),
         studies::engineering(p.time_constant, "s"), pole_text(p.poles.front()),
         studies::rounded_text(row.gains.proportional, 4),
         studies::rounded_text(row.gains.integral, 4)});
  }
  const std::string name = file.name.empty() ? "motor" : studies::printable(file.name);
  return name + "\n\n" + aligned(table);
}

int write_schedule(const LinearizeOptions& options, const studies::MotorFile& file, double torque,
                   Output& output) {
  if (!options.axial.empty())
    throw InputError(
        "--axial: a gain schedule has the rotor's axial position in balance; leave --axial out");
  const double sample = parse_time("--sample-time", options.sample_time);
  const auto delay = static_cast<int>(parse_count("--delay", options.delay, 0, 100));
  const auto rows = motion::gain_schedule(
      file.design, torque, motion::Actuator::frequency, schedule_frequencies(options),
      more_than_zero("--sample-time", sample, options.sample_time), delay);
  const std::string& format = options.output.format;
  if (format == "matlab")
    throw InputError("a gain schedule is written as a table, CSV or JSON, not for MATLAB");
  output.write(format == "json"  ? schedule_json(file, rows)
               : format == "csv" ? schedule_csv(rows)
                                 : schedule_table(file, rows));
  output.finish();
  return kDone;
}

int run_linearize(const LinearizeOptions& options) {
  Output output(options.output.path, {options.motor.path});
  studies::MotorFile file = load_motor(options.motor);
  if (!options.inertia.empty())
    file.design =
        with(file.design, Parameter::load_inertia, parse_inertia("--inertia", options.inertia));
  const double torque = options.torque.empty() ? 0 : parse_torque("--torque", options.torque);
  if (!options.from.empty() || !options.to.empty())
    return write_schedule(options, file, torque, output);
  const LinearPlant plant =
      motion::linearize(file.design, torque, value_of(options.axial, kAxialMotions));
  const std::string& format = options.output.format;
  output.write(format == "json"     ? as_json(file, plant)
               : format == "csv"    ? as_csv(plant)
               : format == "matlab" ? as_matlab(file, plant)
                                    : as_table(file, plant));
  output.finish();
  print_model_notes(file.design);
  return kDone;
}

}  // namespace

void add_linearize(CLI::App& app, Action& action) {
  const auto options = std::make_shared<LinearizeOptions>();
  options->points = "11", options->sample_time = "1 ms", options->delay = "1";
  CLI::App* command = app.add_subcommand(
      "linearize", "Linear model of the motor near a steady state: matrices, poles, gains");
  add_motor_options(*command, options->motor);
  add_output_options(*command, options->output, {"table", "csv", "json", "matlab"});
  command->add_option("--torque", options->torque, "Load torque (default: none)")
      ->type_name("TORQUE");
  command
      ->add_option("--inertia", options->inertia,
                   "Moment of inertia of the load (default: the motor's)")
      ->type_name("INERTIA");
  command
      ->add_option("--axial", options->axial,
                   "dynamic: with two more states, the rotor's axial position and its rate "
                   "(default: static)")
      ->check(one_of(words_of(kAxialMotions)))
      ->type_name(choices(words_of(kAxialMotions)));
  command->add_option("--from", options->from, "Lowest frequency of a gain schedule")
      ->type_name("FREQUENCY");
  command->add_option("--to", options->to, "Highest frequency of a gain schedule")
      ->type_name("FREQUENCY");
  command->add_option("--points", options->points, "Rows of a gain schedule (default: 11)")
      ->type_name("N");
  command
      ->add_option("--sample-time", options->sample_time,
                   "Time between samples of the loop, for gains (default: 1 ms)")
      ->type_name("TIME");
  command->add_option("--delay", options->delay, "Delay of the loop in samples (default: 1)")
      ->type_name("N");
  command->footer(kLinearizeExamples);
  command->callback([options, &action] { action = [options] { return run_linearize(*options); }; });
}

}  // namespace twum::inline v0_1::cli
