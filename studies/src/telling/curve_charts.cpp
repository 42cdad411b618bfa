// SPDX-License-Identifier: Apache-2.0
#include "telling/curve_charts.hpp"

#include "telling/goal_parts.hpp"

#include <twum/core/metrics.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

using Curves = std::span<const MotorCurve>;

// Squeals change little from speed to speed, and each costs as much as a point of the curve.
constexpr std::size_t kSquealSpeeds = 51;

// A quantity of a curve, how it is called and explained.
struct Told {
  const char* column;
  const char* name;
  const char* note;
};

constexpr Told kTorque{"torque", "torque", ""};
constexpr Told kOutput{"output_power", "output power", "Peak power is marked."};
constexpr Told kFriction{"friction_power", "friction loss", "Power that wears the contact."};
constexpr Told kWear{"wear_intensity", "wear intensity", "Friction power per area of the track."};
constexpr Told kTerminals[] = {
    {"amplitude", "wave amplitude", "At the contact radius."},
    {"phase_current", "current of a phase", "Root mean square."},
    {"phase_lag", "phase lag", "Lag of the wave behind the voltage."},
    {"power_factor", "power factor", "Electrical power over apparent power of a phase."}};

constexpr EfficiencyKind kOverall{
    "overall efficiency", "overall_efficiency", "of the motor at its terminals",
    "Output power over electrical power, with all losses except that of the driver.",
    [](const OperatingPoint& p) { return p.overall_efficiency(); }};
constexpr EfficiencyKind kStatorToo{
    "efficiency", "efficiency", "with the stator's loss",
    "Output power over input power, with the losses of the contact and of the vibrating stator.",
    [](const OperatingPoint& p) { return p.efficiency(); }};
constexpr EfficiencyKind kContactAlone{
    "contact efficiency", "contact_efficiency", "of the contact",
    "Output power over the power to the contact; without modal damping the stator has no loss.",
    [](const OperatingPoint& p) { return p.contact_efficiency(); }};

bool at_terminals(const MotorCurve& curve) { return has_modal_data(curve.motor.design()); }
bool is_damped(const MotorCurve& curve) { return modal_damping(curve.motor.design()) > 0; }

CurveColumn column_of(const MotorCurve& curve, std::string_view name) {
  const std::vector<CurveColumn> columns = told_columns(curve.motor.design());
  return *std::ranges::find(columns, name, &CurveColumn::name);
}

Numbers numbers_of(const MotorCurve& curve, std::string_view name) {
  const CurveColumn column = column_of(curve, name);
  Numbers numbers;
  if (curve.whole || name == "speed" || name == "torque")
    numbers.where = "motors/" + std::to_string(curve.place) + "/" + column.name;
  for (const OperatingPoint& point : curve.points) numbers.values.push_back(column.value(point));
  return numbers;
}

// A single curve needs no name.
std::string key_name(Curves curves, std::size_t i) {
  return curves.size() > 1 ? curves[i].name : "";
}

Chart over_speed(Curves curves, const std::string& name, const std::string& unit) {
  Chart chart{name, {name}, {{"speed"}, "rad/s"}, {{name}, unit, true}};
  chart.x.low = chart.x.high = curves.front().points.front().speed;
  for (const MotorCurve& curve : curves)
    chart.x.high = std::max(chart.x.high, curve.points.back().speed);
  return chart;
}

Series series_of(Curves curves, std::size_t i, std::string_view column) {
  return {key_name(curves, i), i < 7 ? Stroke::line : Stroke::dashes,
          numbers_of(curves[i], "speed"), numbers_of(curves[i], column), colour_of(i)};
}

Chart column_chart(Curves curves, const Told& told, const std::vector<CurveLimit>& limits) {
  Chart chart = over_speed(curves, told.name, column_of(curves.front(), told.column).unit);
  for (std::size_t i = 0; i < curves.size(); ++i)
    chart.series.push_back(series_of(curves, i, told.column));
  chart.bounds = bounds_on(told.column, curves.back(), limits);
  return chart;
}

// The value of a metric without argument; NaN where it has none.
double metric_of(const MotorCurve& curve, Metric metric) {
  const MetricValue found = evaluate(curve.motor, {metric, Argument::none, 0});
  return found.status == MetricStatus::ok ? found.value : std::nan("");
}

Part torque_part(double torque) { return value_part(torque, "N.m", 3); }
Part speed_part(double speed) { return value_part(speed, "rad/s", 3); }

// Places that a curve of torque is known by.
std::vector<Mark> torque_marks(const MotorCurve& curve) {
  const double stall = metric_of(curve, Metric::stall_torque);
  std::vector<Mark> marks{{0, stall, {"stall ", torque_part(stall)}}};
  const auto add = [&](double speed, double torque, const Phrase& text) {
    if (speed > 0) marks.push_back({speed, torque, text, "ink", true, true});
  };
  const double begin = curve.motor.first_speed();
  const double pull_out = metric_of(curve, Metric::pull_out_torque);
  add(begin, pull_out, {"pull-out ", torque_part(pull_out), " at ", speed_part(begin)});
  if (const double plateau = metric_of(curve, Metric::plateau_speed); plateau > 0)
    add(plateau, curve.motor.operating_point(plateau).torque, {"plateau to ", speed_part(plateau)});
  if (metric_of(curve, Metric::peak_power) > 0)
    add(metric_of(curve, Metric::speed_at_peak_power),
        metric_of(curve, Metric::torque_at_peak_power), {"peak power"});
  const double no_load = metric_of(curve, Metric::no_load_speed);
  add(no_load, 0, {"no load ", speed_part(no_load)});
  return marks;
}

std::vector<Mark> power_marks(const MotorCurve& curve) {
  const double peak = metric_of(curve, Metric::peak_power);
  const double speed = metric_of(curve, Metric::speed_at_peak_power);
  if (!(peak > 0)) return {};
  return {{speed, peak, {"peak power ", value_part(peak, "W", 3), " at ", speed_part(speed)}}};
}

// The marks of the curve asked for have texts and lines, unless there are many; those of the others are dots alone.
void add_marks(Chart& chart, Curves curves, std::vector<Mark> (*marks_of)(const MotorCurve&)) {
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (Mark& mark : marks_of(curves[i])) {
      if (!std::isfinite(mark.y) || mark.x < chart.x.low || mark.x > chart.x.high) continue;
      const bool told = curves.size() <= 2 && i + 1 == curves.size();
      if (!told) mark.text.clear();
      mark.line = mark.line && told;
      mark.colour = curves.size() > 1 ? colour_of(i) : "ink";
      chart.marks.push_back(std::move(mark));
    }
}

void add_squeals(Series& series, const Motor& motor) {
  for (const SquealRange& range : squeal_ranges(motor, curve_speeds(motor, kSquealSpeeds)))
    series.broad.push_back({range.first, range.last});
  if (!series.broad.empty()) series.state = "squeals";
}

// Motors whose track has width, with one slice as well; the numbers stand in the page alone.
void add_one_slice(Chart& chart, Curves curves) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i].whole || curves[i].motor.radial_slices() == 1) continue;
    Series series = series_of(curves, i, "speed");
    series.name = (curves.size() > 1 ? curves[i].name + ", " : "") + "one slice";
    series.stroke = Stroke::dashes;
    series.y = {"motors/" + std::to_string(curves[i].place) + "/one_slice_torque", {}};
    chart.more.push_back(std::move(series));
    chart.asked = "Compare with one slice";
  }
}

Series part_of(const MotorCurve& curve, const char* column, const char* name, const char* colour,
               Stroke stroke) {
  return {name, stroke, numbers_of(curve, "speed"), numbers_of(curve, column), colour};
}

// Where the electrical power goes (D4.2), up to no-load.
Chart terminals_chart(Curves curves) {
  const MotorCurve& curve = curves.front();
  Chart chart = over_speed(curves, "electrical power", "W");
  const auto add = [&](const char* column, const char* name, const char* colour) {
    chart.series.push_back(part_of(curve, column, name, colour, Stroke::stack));
  };
  add("output_power", "output", "c0");
  add("friction_power", "friction", "c1");
  add("layer_loss", "layer", "c2");
  add("stator_loss", "stator", "c3");
  add("dielectric_loss", "ceramic", "c6");
  if (curve.motor.design().driver.value_or(Driver{}).resistance != 0)
    add("driver_loss", "driver", "c5");
  return chart;
}

Chart losses_chart(Curves curves) {
  const MotorCurve& curve = curves.front();
  Chart chart = over_speed(curves, "power", "W");
  const auto add = [&](const char* column, const char* name, const char* colour) {
    chart.series.push_back(part_of(curve, column, name, colour, Stroke::dashes));
  };
  chart.series = {part_of(curve, "output_power", "output", "c0", Stroke::line)};
  add("friction_power", "friction loss", "c1");
  add("layer_loss", "layer loss", "c2");
  if (is_damped(curve)) add("stator_loss", "stator loss", "c3");
  add_marks(chart, curves, power_marks);
  return chart;
}

// An efficiency up to no-load, where nothing comes out; it falls to 0 in the last hundredth before.
Series efficiency_series(const MotorCurve& curve, double (*value)(const OperatingPoint&)) {
  Series series;
  const auto add = [&](double speed, double share) {
    series.x.values.push_back(speed);
    series.y.values.push_back(share);
  };
  const double no_load = metric_of(curve, Metric::no_load_speed);
  const double near = 0.99 * no_load;
  for (const OperatingPoint& point : curve.points)
    if (point.output_power >= 0 && !(point.speed > near)) add(point.speed, value(point));
  if (!(no_load > curve.points.front().speed && no_load <= curve.points.back().speed))
    return series;
  for (double below = 0.01; below > 1e-6; below /= 2) {
    const OperatingPoint point = curve.motor.operating_point(no_load * (1 - below));
    if (point.speed > curve.points.front().speed) add(point.speed, value(point));
  }
  add(no_load, 0);
  return series;
}

// Of a motor alone that of its contact, too.
bool shows_both(Curves curves, const EfficiencyKind& kind) {
  return curves.size() == 1 && kind.value != kContactAlone.value;
}

const char* efficiency_name(Curves curves, const EfficiencyKind& kind) {
  return shows_both(curves, kind) ? "efficiency" : kind.name;
}

Chart efficiency_chart(Curves curves, const EfficiencyKind& kind,
                       const std::vector<CurveLimit>& limits) {
  const bool both = shows_both(curves, kind);
  Chart chart = over_speed(curves, efficiency_name(curves, kind), "%");
  chart.y.low = 0;
  chart.y.high = 1;
  if (both) {
    chart.series.push_back(efficiency_series(curves.front(), kContactAlone.value));
    chart.series.back().name = kContactAlone.in_key;
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    chart.series.push_back(efficiency_series(curves[i], kind.value));
    chart.series.back().name = both ? kind.in_key : key_name(curves, i);
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) chart.series[i].colour = colour_of(i);
  chart.bounds = bounds_on(kind.quantity, curves.back(), limits);
  return chart;
}

// A chart in half a row of a page.
struct Card {
  Phrase title, note;
  Chart chart;
};

Card power_card(Curves curves, const std::vector<CurveLimit>& limits) {
  if (curves.size() > 1) {
    Card card{{"Output power"}, {kOutput.note}, column_chart(curves, kOutput, limits)};
    add_marks(card.chart, curves, power_marks);
    return card;
  }
  if (at_terminals(curves.front()))
    return {{"Electrical power"},
            {"Electrical power that the motor takes: output and losses, up to no-load."},
            terminals_chart(curves)};
  return {
      {"Power and losses"}, {"Output power of the rotor, and the losses."}, losses_chart(curves)};
}

Section half(Card card, const char* picture) {
  Section section{card.title, card.note};
  section.wide = false;
  section.hook = "speed";
  section.picture = picture;
  section.charts = {std::move(card.chart)};
  section.charts.front().title = card.title;
  return section;
}

Section half(Curves curves, const Told& told, const std::vector<CurveLimit>& limits,
             const char* picture) {
  return half({{told.name}, {told.note}, column_chart(curves, told, limits)}, picture);
}

bool has_fields(const MotorCurve& curve) {
  return curve.motor.contact().half_angle > 0 &&
         std::ranges::any_of(curve.points, [](const OperatingPoint& point) {
           return point.status == PointStatus::ok;
         });
}

Section fields_section() {
  Section section{{"In the contact"},
                  {"One contact zone of the wave at one speed: where the layer sticks to the "
                   "stator, where it slips, and the resulting stresses and velocities. The "
                   "background colour shows the zone."}};
  section.hook = "fields";
  section.charts = contact_charts();
  return section;
}

Section points_section() {
  Section section{{"Points of the curves"}};
  section.hook = "points";
  return section;
}

}  // namespace

std::vector<CurveColumn> told_columns(const MotorDesign& design) {
  std::vector<CurveColumn> columns = curve_columns(design);
  if (!has_modal_data(design))
    columns.push_back({"stator_loss", "W", [](const OperatingPoint& p) { return p.stator_loss; }});
  return columns;
}

EfficiencyKind efficiency_kind(const MotorDesign& design) {
  if (has_modal_data(design)) return kOverall;
  return modal_damping(design) > 0 ? kStatorToo : kContactAlone;
}

EfficiencyKind efficiency_kind(Curves curves) {
  if (std::ranges::all_of(curves, at_terminals)) return kOverall;
  return std::ranges::any_of(curves, is_damped) ? kStatorToo : kContactAlone;
}

Chart torque_chart(Curves curves, const std::vector<CurveLimit>& limits) {
  Chart chart = column_chart(curves, kTorque, limits);
  for (std::size_t i = 0; i < curves.size(); ++i) add_squeals(chart.series[i], curves[i].motor);
  add_marks(chart, curves, torque_marks);
  add_one_slice(chart, curves);
  return chart;
}

std::vector<Chart> contact_charts() {
  const Axis phase{{"phase of the wave, crest at 0"}, "rad"};
  Chart pressure{"pressure", {"pressure"}, phase, {{"pressure"}, "Pa", true}};
  pressure.series = {{"pressure"}};
  Chart traction{"traction", {"traction"}, phase, {{"traction"}, "Pa"}};
  traction.series = {{"friction bound", Stroke::dashes, {}, {}, "soft"},
                     {"traction", Stroke::line, {}, {}, "c1"}};
  Chart velocity{"velocity", {"velocity"}, phase, {{"surface velocity"}, "m/s"}};
  velocity.series = {{"stator"}, {"layer", Stroke::dashes, {}, {}, "c1"}};
  return {pressure, traction, velocity};
}

std::vector<Chart> curve_charts(Curves curves) {
  return {torque_chart(curves), power_card(curves, {}).chart,
          efficiency_chart(curves, efficiency_kind(curves), {})};
}

std::vector<Chart> sheet_charts(const MotorCurve& curve, const std::optional<OperatingPoint>& at) {
  const Curves curves{&curve, 1};
  const EfficiencyKind kind = efficiency_kind(curves);
  std::vector<Chart> charts{column_chart(curves, kTorque, {}), column_chart(curves, kOutput, {}),
                            efficiency_chart(curves, kind, {})};
  for (Chart& chart : charts) chart.title.clear();  // the axis has the name
  if (!at || at->status != PointStatus::ok || at->torque < 0) return charts;
  const double values[] = {at->torque, at->output_power, kind.value(*at)};
  for (std::size_t i = 0; i < charts.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    // A drive that follows also holds points beyond the curve of the fixed drive.
    charts[i].x.high = std::max(charts[i].x.high, at->speed);
    charts[i].marks.push_back({at->speed, values[i], {}, "ink", true, true});
  }
  return charts;
}

std::vector<Section> torque_sections(const Phrase& title, const Sources& sources,
                                     const std::vector<CurveLimit>& limits) {
  if (sources.curves == nullptr || sources.curves->empty()) return {};
  Section section{title};
  section.hook = "speed";
  section.picture = "curves";
  section.charts = {torque_chart(*sources.curves, limits)};
  section.charts.front().title = title;
  return {section};
}

std::vector<Section> curve_sections(const Sources& sources, const std::vector<CurveLimit>& limits) {
  if (sources.curves == nullptr || sources.curves->empty()) return {};
  const Curves curves = *sources.curves;
  const EfficiencyKind kind = efficiency_kind(curves);
  std::vector<Section> list{
      half(power_card(curves, limits), "curves"),
      half({{efficiency_name(curves, kind)}, {kind.note}, efficiency_chart(curves, kind, limits)},
           "curves")};
  if (curves.size() > 1) list.push_back(half(curves, kFriction, limits, "curves"));
  list.push_back(half(curves, kWear, limits, "curves"));
  if (std::ranges::all_of(curves, at_terminals))
    for (const Told& told : kTerminals) list.push_back(half(curves, told, limits, "terminals"));
  if (!curves.front().whole) return list;
  if (std::ranges::any_of(curves, has_fields)) list.push_back(fields_section());
  list.push_back(points_section());
  return list;
}

std::vector<Section> motor_sections(const Sources& sources) {
  std::vector<Section> list = torque_sections({"The motor"}, sources);
  for (Section& section : curve_sections(sources)) list.push_back(std::move(section));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
