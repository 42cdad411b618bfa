// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"
#include "exit_status.hpp"
#include "formats.hpp"
#include "interrupt.hpp"
#include "json_parts.hpp"
#include "message.hpp"
#include "model_comparison.hpp"
#include "notes.hpp"
#include "options.hpp"
#include "output.hpp"
#include "plot/curve_plot.hpp"
#include "text_table.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>

namespace twum::inline v0_1::cli {
namespace {

using studies::CurveColumn;
using studies::MotorFile;

constexpr const char* kCurveExamples = R"text(Examples:
  twum curve examples/motors/ring-60.yaml
  twum curve ring-60.yaml --points 200 --format csv -o curve.csv
  twum curve ring-60.yaml --speeds "0 rpm, 50 rpm, 10 rad/s" --format json
  twum curve ring-60.yaml --set "amplitude=2 um" --set "preload=140 N"
  twum curve ring-60.yaml --plot curve.svg
  twum curve ring-60.yaml --compare-slices
  twum curve plate-60.yaml --compare-radial)text";

struct CurveOptions {
  MotorOptions motor;
  std::string points;
  std::string speeds;
  std::string plot;
  bool compare_slices{false};
  bool compare_radial{false};
  OutputOptions output;
};

struct Curve {
  MotorFile file;
  std::vector<CurveColumn> columns;
  std::vector<studies::MetricExpression> metrics;
  std::vector<MetricValue> values;
  std::vector<OperatingPoint> points;
  std::vector<std::vector<Zone>> zones;
  std::vector<std::optional<bool>> squeals;       // nothing where it is unknown
  std::optional<ModelComparison> slices, radial;  // if they were asked for
};

std::vector<double> speeds_of(const CurveOptions& options, const Motor& motor) {
  if (!options.speeds.empty() && !options.points.empty())
    throw InputError("--speeds and --points exclude each other; give one of them");
  if (!options.speeds.empty()) {
    std::vector<double> speeds;
    for (const std::string_view one : studies::split_list(options.speeds))
      speeds.push_back(parse_speed("--speeds", one));
    return speeds;
  }
  const std::size_t points =
      options.points.empty() ? 51 : parse_count("--points", options.points, 2, 1000000);
  return studies::curve_speeds(motor, points);
}

Curve compute(const CurveOptions& options) {
  Curve curve;
  curve.file = load_motor(options.motor);
  const Motor motor(curve.file.design);
  const std::vector<double> speeds = speeds_of(options, motor);
  curve.columns = studies::curve_columns(curve.file.design);
  curve.metrics = studies::plain_metrics(curve.file.design);
  curve.values.resize(curve.metrics.size());
  studies::ExpressionEvaluator(curve.metrics).evaluate(motor, curve.values);
  for (const double speed : speeds) {
    if (interrupted()) break;
    curve.points.push_back(motor.operating_point(speed));
    curve.zones.push_back(motor.zones(speed));
    curve.squeals.push_back(studies::squeals(curve.file.design, motor.backward_wave(speed)));
  }
  if (options.compare_slices) curve.slices = compare_slices(curve.file.design);
  if (options.compare_radial) curve.radial = compare_radial(curve.file.design);
  return curve;
}

Json point_json(const Curve& curve, std::size_t i) {
  const OperatingPoint& point = curve.points[i];
  Json json;
  for (const CurveColumn& column : curve.columns)
    json[column.name] = number_json(column.value(point));
  json["zones"] = zones_json(curve.zones[i]);
  json["squeals"] = curve.squeals[i] ? Json(*curve.squeals[i]) : Json(nullptr);
  if (point.status != PointStatus::ok) json["status"] = to_string(point.status);
  return json;
}

std::string as_json(const Curve& curve) {
  Json json = motor_json(curve.file);
  json["metrics"] = Json::object();
  json["units"] = parameter_units_json(curve.file);
  for (std::size_t i = 0; i < curve.metrics.size(); ++i) {
    json["metrics"][curve.metrics[i].text] = number_json(curve.values[i].value);
    json["units"][curve.metrics[i].text] = curve.metrics[i].unit();
  }
  for (const CurveColumn& column : curve.columns) json["units"][column.name] = column.unit;
  json["units"]["from"] = json["units"]["to"] = "rad";
  if (curve.slices) json["slices"] = comparison_json(*curve.slices);
  if (curve.radial) json["radial"] = comparison_json(*curve.radial);
  json["curve"] = Json::array();
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    json["curve"].push_back(point_json(curve, i));
  return json_text(json);
}

std::string as_csv(const Curve& curve) {
  std::vector<std::string> cells;
  for (const CurveColumn& column : curve.columns)
    cells.push_back(std::string(column.name) + " [" + column.unit + "]");
  cells.insert(cells.end(), {"squeals", "status"});
  std::string text = csv_line(cells);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const OperatingPoint& point = curve.points[i];
    cells.clear();
    for (const CurveColumn& column : curve.columns) cells.push_back(cell_of(column.value(point)));
    cells.emplace_back(!curve.squeals[i] ? "" : *curve.squeals[i] ? "yes" : "no");
    cells.emplace_back(to_string(point.status));
    text += csv_line(cells);
  }
  return text;
}

std::string metrics_table(const Curve& curve) {
  TextTable table;
  for (std::size_t i = 0; i < curve.metrics.size(); ++i) {
    const MetricValue& value = curve.values[i];
    table.rows.push_back(
        {curve.metrics[i].text, value.status == MetricStatus::ok
                                    ? studies::engineering(value.value, curve.metrics[i].unit())
                                    : std::string("- (") + to_string(value.status) + ")"});
  }
  return aligned(table);
}

// "slip+/stick/slip-" or "slip+, squeals"; or why there is no answer.
std::string zones_text(const Curve& curve, std::size_t i) {
  if (curve.points[i].status != PointStatus::ok) return to_string(curve.points[i].status);
  std::string text;
  for (const Zone& zone : curve.zones[i])
    text += (text.empty() ? "" : "/") + std::string(to_string(zone.state));
  return curve.squeals[i].value_or(false) ? text + ", squeals" : text;
}

ColumnScale scale_of(const CurveColumn& column, const std::vector<OperatingPoint>& points) {
  double largest = 0;
  for (const OperatingPoint& point : points) {
    const double size = std::abs(column.value(point));
    if (std::isfinite(size)) largest = std::max(largest, size);
  }
  return {studies::display_unit(largest, column.unit), largest};
}

// Columns of all points, and a last column of texts with a heading of its own.
using PointWords = std::function<std::string(std::size_t)>;
std::string points_table(const Curve& curve, std::span<const CurveColumn> columns,
                         const std::string& heading, const PointWords& last, std::size_t width) {
  TextTable table{{{}, {}}, true};
  std::vector<ColumnScale> scales;
  for (const CurveColumn& column : columns) {
    scales.push_back(scale_of(column, curve.points));
    table.rows[0].emplace_back(column.name);
    const std::string& unit = scales.back().unit.text;
    table.rows[1].push_back(unit.empty() ? "" : "[" + unit + "]");
  }
  table.rows[0].push_back(heading);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    std::vector<std::string> row;
    for (std::size_t c = 0; c < scales.size(); ++c)
      row.push_back(rounded_cell(columns[c].value(curve.points[i]), scales[c]));
    row.push_back(last(i));
    table.rows.push_back(std::move(row));
  }
  return aligned(table, width);
}

// Speed and torque again, the quantities at the terminals, and the losses that the other table does not have.
std::string terminals_table(const Curve& curve, std::size_t width) {
  const std::span<const CurveColumn> contact = studies::contact_columns();
  std::vector<CurveColumn> columns(contact.begin(), contact.begin() + 2);
  const std::span<const CurveColumn> terminals = studies::terminal_columns();
  columns.insert(columns.end(), terminals.begin(), terminals.end());
  return points_table(
      curve, columns, "status", [&](std::size_t i) { return to_string(curve.points[i].status); },
      width);
}

// The metrics, or the comparisons that were asked for in their place.
std::string comparisons_text(const Curve& curve) {
  std::string text;
  for (const auto* one : {&curve.slices, &curve.radial})
    if (*one) text += (text.empty() ? "" : "\n") + comparison_text(**one);
  return text.empty() ? metrics_table(curve) : text;
}

std::string as_table(const Curve& curve, std::size_t width) {
  const std::string name = curve.file.name.empty() ? "motor" : studies::printable(curve.file.name);
  const std::string contact = points_table(
      curve, studies::contact_columns(), "zones",
      [&](std::size_t i) { return zones_text(curve, i); }, width);
  const std::string metrics = comparisons_text(curve);
  const std::string text = name + "\n\n" + metrics + "\n" + contact;
  return has_modal_data(curve.file.design) ? text + "\n" + terminals_table(curve, width) : text;
}

// The range of the curve's speeds; for a single speed, the default range of a curve.
Picture picture(const Curve& curve) {
  const auto [first, last] = std::minmax_element(
      curve.points.begin(), curve.points.end(),
      [](const OperatingPoint& a, const OperatingPoint& b) { return a.speed < b.speed; });
  if (first->speed < last->speed) return curve_picture(curve.file, first->speed, last->speed);
  return curve_picture(curve.file, 0, studies::last_curve_speed(Motor(curve.file.design)));
}

// does_not_pull_out is the normal case of a motor and needs no note.
std::set<std::string> reasons_in(const Curve& curve) {
  std::set<std::string> reasons;
  for (const MetricValue& value : curve.values) reasons.insert(to_string(value.status));
  for (const OperatingPoint& point : curve.points) reasons.insert(to_string(point.status));
  reasons.erase(to_string(MetricStatus::does_not_pull_out));
  return reasons;
}

int run_curve(const CurveOptions& options) {
  if ((options.compare_slices || options.compare_radial) && options.output.format == "csv")
    throw InputError(std::string(options.compare_slices ? "--compare-slices" : "--compare-radial") +
                     " compares metrics, which a CSV file does not contain; use --format json");
  Output output(options.output.path, {options.motor.path});
  const std::optional<PlotFile> plot =
      plot_file(options.plot, {options.motor.path, options.output.path});
  const Curve curve = compute(options);
  if (plot && !interrupted()) {
    const Picture drawn = picture(curve);
    plot->draw(drawn.size, drawn.script);
  }
  output.write(options.output.format == "json"  ? as_json(curve)
               : options.output.format == "csv" ? as_csv(curve)
                                                : as_table(curve, options.output.table_width()));
  output.finish();
  print_model_notes(curve.file.design);
  explain_reasons(reasons_in(curve));
  if (interrupted()) return kInterrupted;
  const bool any = std::any_of(curve.points.begin(), curve.points.end(),
                               [](const OperatingPoint& p) { return p.status == PointStatus::ok; });
  if (any) return kDone;
  say(std::string("twum: no point of the curve has an answer: ") +
      (curve.points.empty() ? "no speeds" : to_string(curve.points.front().status)));
  return kNoAnswer;
}

}  // namespace

void add_curve(CLI::App& app, Action& action) {
  const auto options = std::make_shared<CurveOptions>();
  CLI::App* command = app.add_subcommand("curve", "Torque-speed curve and metrics of a motor");
  add_motor_options(*command, options->motor);
  add_branch_option(*command, options->motor);
  command
      ->add_option("--points", options->points,
                   "Number of points from rest to a little beyond no-load (default: 51)")
      ->type_name("N");
  command
      ->add_option("--speeds", options->speeds,
                   "Rotor speeds separated by commas, instead of --points")
      ->type_name("SPEEDS");
  add_output_options(*command, options->output, {"table", "csv", "json"});
  add_plot_option(*command, options->plot);
  command->add_flag("--compare-slices", options->compare_slices,
                    "Show how the width of the contact track changes each metric");
  command->add_flag("--compare-radial", options->compare_radial,
                    "Show how the radial motion of the surface changes each metric");
  command->footer(kCurveExamples);
  command->callback([options, &action] { action = [options] { return run_curve(*options); }; });
}

}  // namespace twum::inline v0_1::cli
