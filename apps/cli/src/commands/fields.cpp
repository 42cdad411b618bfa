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
#include "plot/fields_plot.hpp"
#include "text_table.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kFieldsExamples = R"text(Examples:
  twum fields ring-60.yaml --speed "100 rpm"
  twum fields ring-60.yaml --torque "0.5 N.m"
  twum fields ring-60.yaml --speed "95 rpm" --samples 721 --format csv -o fields.csv
  twum fields ring-60.yaml --speed "130 rpm" --plot fields.svg)text";

struct FieldsOptions {
  MotorOptions motor;
  LoadOptions load;
  std::string samples;
  std::string plot;
  OutputOptions output;
};

struct FieldColumn {
  const char* name;
  const char* unit;
  double FieldSample::*value;
};

constexpr FieldColumn kColumns[] = {{"phase", "rad", &FieldSample::phase},
                                    {"pressure", "Pa", &FieldSample::pressure},
                                    {"traction", "Pa", &FieldSample::traction},
                                    {"displacement", "m", &FieldSample::displacement},
                                    {"stator_velocity", "m/s", &FieldSample::stator_velocity},
                                    {"layer_velocity", "m/s", &FieldSample::layer_velocity},
                                    {"radial_velocity", "m/s", &FieldSample::radial_velocity},
                                    {"radial_traction", "Pa", &FieldSample::radial_traction}};

struct Fields {
  studies::MotorFile file;
  std::vector<ContactFields> radii;  // one, or several across the track of a motor with slices

  bool sliced() const { return radii.size() > 1; }
  const OperatingPoint& point() const { return radii.front().point; }
};

// At the contact radius, or equally spaced over a track with slices.
std::vector<ContactFields> fields_over(const Motor& motor, double speed, int samples) {
  constexpr int kRadii = 9;
  if (motor.design().stator.radial_slices == 1) return {motor.fields(speed, samples)};
  const Stator& stator = motor.design().stator;
  std::vector<ContactFields> fields;
  for (int i = 0; i < kRadii; ++i) {
    const double radius = stator.contact_radius +
                          stator.contact_width * (static_cast<double>(i) / (kRadii - 1) - 0.5);
    fields.push_back(motor.fields(speed, samples, radius));
  }
  return fields;
}

// State of the contact at a phase: "slip+", "stick", "slip-", or "free".
const char* state_at(const std::vector<Zone>& zones, double phase) {
  for (const Zone& zone : zones) {
    if (phase >= zone.from && phase <= zone.to) return to_string(zone.state);
  }
  return "free";
}

std::string as_json(const Fields& fields) {
  Json json = motor_json(fields.file);
  const OperatingPoint& point = fields.point();
  json["units"] = parameter_units_json(fields.file);
  for (const FieldColumn& column : kColumns) json["units"][column.name] = column.unit;
  json["units"]["speed"] = "rad/s";
  json["units"]["torque"] = "N.m";
  json["units"]["from"] = json["units"]["to"] = "rad";
  if (fields.sliced()) json["units"]["radius"] = "m";
  json["speed"] = point.speed;
  json["torque"] = number_json(point.torque);
  json["zones"] = zones_json(fields.radii[fields.radii.size() / 2].zones);
  json["fields"] = Json::array();
  for (const ContactFields& at : fields.radii) {
    for (const FieldSample& sample : at.samples) {
      Json row;
      if (fields.sliced()) row["radius"] = at.radius;
      for (const FieldColumn& column : kColumns)
        row[column.name] = number_json(sample.*column.value);
      row["state"] = state_at(at.zones, sample.phase);
      json["fields"].push_back(std::move(row));
    }
  }
  return json_text(json);
}

std::string as_csv(const Fields& fields) {
  std::vector<std::string> cells;
  if (fields.sliced()) cells.emplace_back("radius [m]");
  for (const FieldColumn& column : kColumns)
    cells.push_back(std::string(column.name) + " [" + column.unit + "]");
  cells.emplace_back("state");
  std::string text = csv_line(cells);
  for (const ContactFields& at : fields.radii) {
    for (const FieldSample& sample : at.samples) {
      cells.clear();
      if (fields.sliced()) cells.push_back(cell_of(at.radius));
      for (const FieldColumn& column : kColumns) cells.push_back(cell_of(sample.*column.value));
      cells.emplace_back(state_at(at.zones, sample.phase));
      text += csv_line(cells);
    }
  }
  return text;
}

ColumnScale scale_of(const FieldColumn& column, const Fields& fields) {
  double largest = 0;
  for (const ContactFields& at : fields.radii)
    for (const FieldSample& sample : at.samples)
      largest = std::max(largest, std::abs(sample.*column.value));
  if (std::string_view(column.unit) == "rad") return {{"rad", 1}, largest};
  return {studies::display_unit(largest, column.unit), largest};
}

std::string as_table(const Fields& fields, std::size_t width) {
  TextTable table{{{}, {}}, true};
  const ColumnScale radius{{"mm", 1e-3}, fields.radii.back().radius};
  if (fields.sliced()) table.rows = {{"radius"}, {"[mm]"}};
  std::vector<ColumnScale> scales;
  for (const FieldColumn& column : kColumns) {
    scales.push_back(scale_of(column, fields));
    table.rows[0].emplace_back(column.name);
    table.rows[1].push_back("[" + scales.back().unit.text + "]");
  }
  table.rows[0].emplace_back("state");
  for (const ContactFields& at : fields.radii) {
    for (const FieldSample& sample : at.samples) {
      std::vector<std::string> row;
      if (fields.sliced()) row.push_back(rounded_cell(at.radius, radius));
      for (std::size_t c = 0; c < scales.size(); ++c)
        row.push_back(rounded_cell(sample.*kColumns[c].value, scales[c]));
      row.emplace_back(state_at(at.zones, sample.phase));
      table.rows.push_back(std::move(row));
    }
  }
  const std::string name =
      fields.file.name.empty() ? "motor" : studies::printable(fields.file.name);
  return name + " at " + studies::engineering(fields.point().speed, "rad/s") + ", " +
         studies::engineering(fields.point().torque, "N.m") + "\n\n" + aligned(table, width);
}

int run_fields(const FieldsOptions& options) {
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const std::size_t samples =
      options.samples.empty() ? 181 : parse_count("--samples", options.samples, 2, 1000000);
  Fields fields;
  fields.file = load_motor(options.motor);
  const Motor motor(fields.file.design);
  const std::optional<double> speed = speed_of(options.load, motor);
  if (!speed) return kNoAnswer;
  fields.radii = fields_over(motor, *speed, static_cast<int>(samples));
  if (fields.point().status != PointStatus::ok) {
    say(std::string("twum: no answer at this speed: ") + to_string(fields.point().status));
    explain_reasons({to_string(fields.point().status)});
    return kNoAnswer;
  }
  if (plot)
    plot->draw(kFieldsPlotSize, fields.sliced() ? fields_map(fields.file, *speed)
                                                : fields_plot(fields.file, *speed));
  const std::string& format = options.output.format;
  output.write(format == "json"  ? as_json(fields)
               : format == "csv" ? as_csv(fields)
                                 : as_table(fields, options.output.table_width()));
  output.finish();
  print_model_notes(fields.file.design);
  return kDone;
}

}  // namespace

void add_fields(CLI::App& app, Action& action) {
  const auto options = std::make_shared<FieldsOptions>();
  CLI::App* command =
      app.add_subcommand("fields", "Pressure, traction, velocities and zones along one wave");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  add_load_options(*command, options->load, 1);
  command
      ->add_option("--samples", options->samples, "Number of phases along the wave (default: 181)")
      ->type_name("N");
  add_output_options(*command, options->output, {"table", "csv", "json"});
  add_plot_option(*command, options->plot);
  command->footer(kFieldsExamples);
  command->callback([options, &action] { action = [options] { return run_fields(*options); }; });
}

}  // namespace twum::inline v0_1::cli
