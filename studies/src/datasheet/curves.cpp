// SPDX-License-Identifier: Apache-2.0
#include "datasheet/parts.hpp"
#include "telling/curve_charts.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::studies::datasheet {
namespace {

constexpr std::size_t kSheetPoints = 241;
// The page of the chart, and the ends of its axes [units of the drawing].
constexpr double kChart = 720, kLeftEnd = 62, kRightEnd = 610, kUpper = 46, kLower = 248,
                 kSecond = 58;
// Number of steps of every axis, so that all axes share the grid lines.
constexpr int kSteps = 5;

// The least round number that is not smaller.
double round_up(double value) {
  if (!(value > 0)) return 1;
  const double size = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (factor * size >= value * (1 - 1e-9)) return factor * size;
  return 10 * size;
}

// One quantity with its axis.
struct SheetCurve {
  const char* look;
  std::string name;
  const char* unit;  // SI
  double (*value)(const OperatingPoint&);
  double axis;  // where it stands
  DisplayUnit shown{};
  double step{1};  // of the axis, in the unit shown
};

struct SheetChart {
  std::vector<OperatingPoint> points;
  double last_rpm;  // end of the horizontal axis
  std::array<SheetCurve, 3> curves;
};

double rpm(double speed) { return speed / display_unit(1, "rad/s").divisor; }

double across_of(const SheetChart& chart, double speed) {
  return kLeftEnd + (kRightEnd - kLeftEnd) * rpm(speed) / chart.last_rpm;
}

double up_of(const SheetCurve& curve, double value) {
  return kLower - (kLower - kUpper) * value / curve.shown.divisor / (kSteps * curve.step);
}

// A data sheet ends at the no-load speed, beyond which the rotor is driven from outside.
std::vector<OperatingPoint> driving_points(const Motor& motor) {
  std::vector<OperatingPoint> points;
  for (const double speed : curve_speeds(motor, kSheetPoints)) {
    const OperatingPoint point = motor.operating_point(speed);
    if (point.status == PointStatus::ok && point.torque >= 0) points.push_back(point);
  }
  return points;
}

SheetChart chart_of(const Motor& motor) {
  const telling::EfficiencyKind efficiency = telling::efficiency_kind(motor.design());
  SheetChart chart{
      driving_points(motor),
      1,
      {{{"torque", "torque", "N.m", [](const OperatingPoint& p) { return p.torque; }, kLeftEnd},
        {"power", "output power", "W", [](const OperatingPoint& p) { return p.output_power; },
         kRightEnd},
        {"efficiency", efficiency.name, "1", efficiency.value, kRightEnd + kSecond}}}};
  double last = 0;
  for (const OperatingPoint& point : chart.points) last = std::max(last, rpm(point.speed));
  chart.last_rpm = kSteps * round_up(last / kSteps);
  for (SheetCurve& curve : chart.curves) {
    double most = 0;
    for (const OperatingPoint& point : chart.points)
      if (std::isfinite(curve.value(point))) most = std::max(most, curve.value(point));
    curve.shown = std::string_view(curve.unit) == "1" ? DisplayUnit{"%", 0.01}
                                                      : display_unit(most, curve.unit);
    curve.step = round_up(most / curve.shown.divisor / kSteps);
  }
  return chart;
}

std::string text_at(double x, double y, const char* anchor, const std::string& look,
                    const std::string& text) {
  return element("text",
                 {{"class", look}, {"x", place(x)}, {"y", place(y)}, {"text-anchor", anchor}},
                 escaped(text));
}

std::string axis_title(const SheetCurve& curve, bool left) {
  const double x = curve.axis + (left ? -48 : 44), y = 0.5 * (kUpper + kLower);
  return element("text",
                 {{"class", curve.look + std::string(" title")},
                  {"text-anchor", "middle"},
                  {"transform", "translate(" + place(x) + " " + place(y) + ") rotate(-90)"}},
                 escaped(curve.name + " [" + printed_unit(curve.shown.text) + "]"));
}

std::string axes(const SheetChart& chart) {
  std::string drawing;
  for (int i = 0; i <= kSteps; ++i) {
    const double y = kLower - (kLower - kUpper) * i / kSteps,
                 x = kLeftEnd + (kRightEnd - kLeftEnd) * i / kSteps;
    drawing +=
        element("path", {{"class", i == 0 ? "base" : "grid"},
                         {"d", "M" + place(kLeftEnd) + " " + place(y) + "H" + place(kRightEnd)}});
    drawing +=
        text_at(x, kLower + 16, "middle", "tick", rounded_text(chart.last_rpm * i / kSteps, 4));
    for (const SheetCurve& curve : chart.curves) {
      const bool left = curve.axis < kRightEnd;
      drawing += text_at(curve.axis + (left ? -6 : 6), y + 4, left ? "end" : "start",
                         curve.look + std::string(" tick"), rounded_text(curve.step * i, 4));
    }
  }
  for (const SheetCurve& curve : chart.curves) {
    drawing += axis_title(curve, curve.axis < kRightEnd);
    drawing += element(
        "path", {{"class", "base"},
                 {"d", "M" + place(curve.axis) + " " + place(kUpper) + "V" + place(kLower)}});
  }
  return drawing +
         text_at(0.5 * (kLeftEnd + kRightEnd), kLower + 34, "middle", "title", "speed [rpm]");
}

std::string path_of(const SheetChart& chart, const SheetCurve& curve) {
  std::string d;
  for (const OperatingPoint& point : chart.points) {
    const double value = curve.value(point);
    if (!std::isfinite(value)) continue;
    d += (d.empty() ? "M" : "L") + place(across_of(chart, point.speed)) + " " +
         place(up_of(curve, value));
  }
  return d.empty() ? ""
                   : element("path", {{"class", curve.look + std::string(" curve")}, {"d", d}});
}

std::string samples(const SheetChart& chart) {
  std::string drawing;
  double x = kLeftEnd;
  for (const SheetCurve& curve : chart.curves) {
    drawing += element("path", {{"class", curve.look + std::string(" curve")},
                                {"d", "M" + place(x) + " 14H" + place(x + 30)}});
    drawing += text_at(x + 36, 18, "start", "name", curve.name);
    x += 66 + 7.2 * static_cast<double>(curve.name.size());
  }
  return drawing;
}

std::string rated_marks(const SheetChart& chart, const OperatingPoint& rated) {
  const double x = across_of(chart, rated.speed);
  if (rated.status != PointStatus::ok || x < kLeftEnd || x > kRightEnd || rated.torque < 0)
    return "";
  std::string drawing = element(
      "path",
      {{"class", "rated"}, {"d", "M" + place(x) + " " + place(kUpper) + "V" + place(kLower)}});
  for (const SheetCurve& curve : chart.curves) {
    const double value = curve.value(rated);
    if (std::isfinite(value))
      drawing += element("circle", {{"class", curve.look},
                                    {"cx", place(x)},
                                    {"cy", place(up_of(curve, value))},
                                    {"r", "3.5"}});
  }
  return drawing + text_at(x, kUpper - 4, "middle", "tick", "rated");
}

}  // namespace

std::string curves(const Motor& motor, const std::optional<OperatingPoint>& rated) {
  const SheetChart chart = chart_of(motor);
  if (chart.points.size() < 2)
    return "<p>This motor drives no load at any speed: it has no curve.</p>\n";
  std::string drawing = axes(chart) + samples(chart);
  for (const SheetCurve& curve : chart.curves) drawing += path_of(chart, curve);
  if (rated) drawing += rated_marks(chart, *rated);
  return "<div class=\"chart\">" +
         element("svg",
                 {{"viewBox", "0 0 " + place(kChart) + " 292"},
                  {"role", "img"},
                  {"aria-label", "Torque, output power and efficiency over speed"}},
                 drawing) +
         "</div>\n";
}

}  // namespace twum::studies::datasheet
