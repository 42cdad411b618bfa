// SPDX-License-Identifier: Apache-2.0
#include "telling/sheet_sections.hpp"

#include "telling/curve_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"

#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/model_notes.hpp>

#include <cmath>
#include <string>

namespace twum::inline v0_1::studies::telling {
namespace {

// Straight lines between so many points cannot be seen.
constexpr std::size_t kSheetPoints = 241;

// Names and values without heads.
struct Sheet : Table {
  void add(const Phrase& name, const Phrase& value) { rows.push_back({name, value}); }
  void add(const std::string& name, double value, const std::string& unit) {
    const bool share = unit == "1" && name.find("efficiency") != std::string::npos;
    add({name_part(name)}, {share ? share_part(value) : named_part(name, value, unit)});
  }
};

Section half_section(const Phrase& heading, const Phrase& note, const Table& table) {
  Section section{heading, note};
  section.wide = false;
  if (!table.rows.empty()) section.tables = {table};
  return section;
}

// Time and revolutions until the end of the life, and what ends it; nothing for a motor without wear.
void add_life(Sheet& sheet, const MotorDesign& design, const std::optional<LoadPoint>& load) {
  if (!design.wear) return;
  const Phrase name{load ? "life at this load" : "life in the operation"};
  if (design.stator.radial_slices == 1) return sheet.add(name, {"not known with one slice"});
  const Life found = load ? life(design, *load) : life(design);
  if (found.status != MetricStatus::ok)
    return sheet.add(name, {reason_of(to_string(found.status))});
  const bool by_limit = found.end == EndOfLife::limit;
  sheet.add(name, {time_part(found.seconds)});
  sheet.add({"revolutions until then"}, {value_part(found.revolutions, "1")});
  sheet.add({"end of the life"},
            end_phrase(found.end, by_limit ? design.wear->until[found.limit].text : ""));
}

// The metrics of a motor but its life. One without a value has a row if the reason is informative, such as a motor that does not
// pull out, but not if it is undefined.
Sheet metrics_of(const Motor& motor, bool with_modes) {
  const std::vector<MetricExpression> metrics = plain_metrics(motor.design());
  const std::vector<MetricValue> values = ExpressionEvaluator(metrics).evaluate(motor);
  Sheet sheet;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const MetricInfo& row = info(metrics[i].request()->metric);
    if (row.needs_modes != with_modes || row.needs_wear ||
        values[i].status == MetricStatus::undefined)
      continue;
    if (values[i].status == MetricStatus::ok)
      sheet.add(metrics[i].text, values[i].value, std::string(row.unit));
    else
      sheet.add({name_part(metrics[i].text)}, {reason_of(to_string(values[i].status))});
  }
  return sheet;
}

Section performance_section(const Motor& motor) {
  Sheet sheet = metrics_of(motor, false);
  if (!motor.design().operation.empty()) add_life(sheet, motor.design(), {});
  return half_section({"Performance and limits"}, {}, sheet);
}

struct RatedPoint {
  Phrase told;
  std::optional<OperatingPoint> point{};
  std::optional<LoadPoint> held{};  // where the drive is adjusted to it
};

RatedPoint held_rating(const MotorDesign& design, const LoadPoint& load) {
  const HeldPoint held = held_point(design, load.torque, load.at);
  RatedPoint rated;
  if (held.status != HeldStatus::ok) {
    rated.told = {"There is none: the drive does not hold ",
                  value_part(load.torque, "N.m"),
                  " at ",
                  value_part(load.at, "rad/s"),
                  ", ",
                  to_string(held.status),
                  "."};
    return rated;
  }
  rated.told = {held.by_control_only ? "Held by a controlled drive alone" : "Held by the drive"};
  if (has_modal_data(design)) append(rated.told, {" at ", value_part(held.frequency, "Hz")});
  rated.told.emplace_back(".");
  rated.point = held.point;
  rated.held = load;
  return rated;
}

RatedPoint rated_point(const Motor& motor, const std::optional<LoadPoint>& given) {
  if (given && given->argument == Argument::both) return held_rating(motor.design(), *given);
  if (given) return {{"At the speed or load that was given."}, motor.operating_point(given->at)};
  const bool terminals = has_modal_data(motor.design());
  const Metric metric =
      terminals ? Metric::speed_at_max_overall_efficiency : Metric::speed_at_peak_power;
  const MetricValue at = evaluate(motor, {metric, Argument::none, 0});
  if (at.status != MetricStatus::ok) return {{"There is none: this motor drives no load."}};
  return {{"Where the ", terminals ? "overall efficiency" : "output power", " is largest."},
          motor.operating_point(at.value)};
}

Section rated_section(const MotorDesign& design, const RatedPoint& rated) {
  Sheet sheet;
  const auto section = [&] { return half_section({"Rated point"}, rated.told, sheet); };
  if (!rated.point) {
    Section none{{"Rated point"}};
    none.wide = false;
    none.sentences = {rated.told};
    return none;
  }
  const OperatingPoint& point = *rated.point;
  if (point.status != PointStatus::ok) {
    sheet.add({"no answer"}, {to_string(point.status)});
    return section();
  }
  const EfficiencyKind efficiency = efficiency_kind(design);
  for (const CurveColumn& column : curve_columns(design)) {
    const std::string name = column.name;
    const double value = column.value(point);
    if (name == "contact_efficiency" || name == "overall_efficiency" || !std::isfinite(value))
      continue;
    sheet.add(name, value, column.unit);
    if (name == "output_power" && std::isfinite(efficiency.value(point)))
      sheet.add({efficiency.name}, {share_part(efficiency.value(point))});
  }
  add_life(sheet, design, rated.held.value_or(LoadPoint{Argument::torque, point.torque}));
  return section();
}

// A data sheet ends at the no-load speed, beyond which the rotor is driven from outside.
MotorCurve driving_curve(const Motor& motor) {
  MotorCurve curve{"", motor};
  for (const double speed : curve_speeds(motor, kSheetPoints)) {
    const OperatingPoint point = motor.operating_point(speed);
    if (point.status == PointStatus::ok && point.torque >= 0) curve.points.push_back(point);
  }
  const MetricValue no_load = evaluate(motor, {Metric::no_load_speed, Argument::none, 0});
  const double last = curve.points.empty() ? 0 : curve.points.back().speed;
  if (no_load.status == MetricStatus::ok && no_load.value > last)
    curve.points.push_back(motor.operating_point(no_load.value));
  return curve;
}

Section curves_section(const Motor& motor, const RatedPoint& rated) {
  Section section{{"Torque, power and efficiency"}};
  const MotorCurve curve = driving_curve(motor);
  if (curve.points.size() < 2)
    section.sentences = {{"This motor drives no load at any speed: it has no curve."}};
  else
    section.charts = sheet_charts(curve, rated.point);
  const bool marked = !section.charts.empty() && !section.charts.front().marks.empty();
  if (marked) section.note = {"The dotted line is the rated point."};
  if (marked && rated.held)
    section.note = {"Curves and limits are those of the fixed drive. The dot is the rated point."};
  return section;
}

Section parameters_section(const MotorDesign& design) {
  Sheet sheet;
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(design, row.parameter)) continue;
    const std::string name(row.name);
    const std::string symbol = row.symbol.empty() ? "" : " " + std::string(row.symbol);
    sheet.add({name_part(name), symbol},
              {named_part(name, get(design, row.parameter), std::string(row.unit))});
  }
  Section section{{"Parameters"}};
  section.tables = {sheet};
  return section;
}

// Of heat, wear and driver what the motor file does not give.
Phrase left_out(const MotorDesign& design) {
  std::vector<Part> parts;
  if (!design.thermal) parts.emplace_back("heat and its effect on resonance and friction");
  if (!design.wear) parts.emplace_back("wear");
  parts.emplace_back("running in");
  parts.emplace_back("a rotor that bends");
  const Driver driver = design.driver.value_or(Driver{});
  if (driver.inductance == 0 && driver.resistance == 0)
    parts.emplace_back("the driver's electronics");
  Phrase phrase{"Not in the model: "};
  append(phrase, listed(parts));
  phrase.emplace_back(".");
  return phrase;
}

Section notes_section(const MotorDesign& design) {
  Section section{{"What to know"}};
  section.sentences = {left_out(design)};
  for (const ModelNote& note : model_notes_at_length(design))
    section.remarks.push_back(capitalized({note.text + "."}));
  return section;
}

}  // namespace

Phrase motor_phrase(const MotorDesign& design) {
  const Stator& s = design.stator;
  return {"Travelling wave ultrasonic motor with ",
          value_part(s.wavelengths, "1"),
          s.voltage ? " wavelengths, driven by " : " wavelengths, with a wave of ",
          s.voltage ? value_part(*s.voltage, "V") : value_part(s.amplitude, "m"),
          s.voltage ? " rms at " : " at ",
          value_part(drive_frequency(design), "Hz")};
}

std::vector<Section> sheet_sections(const Motor& motor, const std::optional<LoadPoint>& given) {
  const MotorDesign& design = motor.design();
  const RatedPoint rated = rated_point(motor, given);
  std::vector<Section> sections{curves_section(motor, rated), cross_section(design),
                                performance_section(motor), rated_section(design, rated)};
  if (const Sheet electrical = metrics_of(motor, true); !electrical.rows.empty())
    sections.push_back(half_section({"Electrical"}, {}, electrical));
  sections.push_back(parameters_section(design));
  sections.push_back(notes_section(design));
  return sections;
}

}  // namespace twum::inline v0_1::studies::telling
