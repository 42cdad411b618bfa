// SPDX-License-Identifier: Apache-2.0
#include "plot/study/curve_pictures.hpp"

#include "plot/curve_plot.hpp"
#include "plot/fields_plot.hpp"
#include "plot/style.hpp"

#include <twum/base/error.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
namespace {

// A curve some 600 points of the page wide.
constexpr std::size_t kCurvePictures = 301;

struct Quantity {
  const char* name;
  const char* unit;
  double (*value)(const OperatingPoint&);
};

constexpr Quantity kTorquePanel{"torque", "N.m", [](const OperatingPoint& p) { return p.torque; }};
constexpr Quantity kPowerPanel{"output power", "W",
                               [](const OperatingPoint& p) { return p.output_power; }};
constexpr Quantity kFrictionPanel{"friction loss", "W",
                                  [](const OperatingPoint& p) { return p.friction_power; }};

// Where the rotor is driven from outside, there is no output: the efficiency is 0, and its line ends on the axis.
constexpr Quantity kOverallPanel{"overall efficiency", "%",
                                 [](const OperatingPoint& p) { return p.overall_efficiency(); }};
constexpr Quantity kEfficiencyPanel{"efficiency", "%", [](const OperatingPoint& p) {
                                      return p.output_power <= 0 ? 0 : p.efficiency();
                                    }};
constexpr Quantity kContactPanel{"contact efficiency", "%", [](const OperatingPoint& p) {
                                   return p.output_power <= 0 ? 0 : p.contact_efficiency();
                                 }};
constexpr Quantity kTerminalPanels[] = {
    {"wave amplitude", "m", [](const OperatingPoint& p) { return p.amplitude; }},
    {"current of a phase", "A", [](const OperatingPoint& p) { return p.phase_current; }},
    {"phase lag", "rad", [](const OperatingPoint& p) { return p.phase_lag; }},
    {"power factor", "1", [](const OperatingPoint& p) { return p.power_factor; }}};

bool at_terminals(const NamedMotor& one) { return has_modal_data(one.motor.design()); }
bool damped(const NamedMotor& one) { return modal_damping(one.motor.design()) > 0; }

Quantity efficiency_of(const std::vector<NamedMotor>& motors) {
  if (std::all_of(motors.begin(), motors.end(), at_terminals)) return kOverallPanel;
  return std::any_of(motors.begin(), motors.end(), damped) ? kEfficiencyPanel : kContactPanel;
}

// A motor with output power is not shown beyond its no-load speed, where it is driven from outside.
bool gives_any(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& series) {
    return std::any_of(series.rows.begin(), series.rows.end(),
                       [](const std::vector<double>& row) { return row[1] > 0; });
  });
}

Panel panel_of(const std::vector<NamedMotor>& motors, const Quantity& quantity, bool named) {
  const bool share = std::string_view(quantity.unit) == "%";
  Panel panel{{"speed", "rad/s", true}, {quantity.name, quantity.unit, true, 0.08}, {}};
  if (share) panel.y = {quantity.name, "%", true, 0, 0, 1};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    Series series{named ? motors[i].name : "",
                  (i / 7) % 2 == 0 ? Draw::line : Draw::dashes,
                  colour_of(i),
                  {}};
    for (const double speed : studies::curve_speeds(motors[i].motor, kCurvePictures))
      series.rows.push_back({speed, quantity.value(motors[i].motor.operating_point(speed))});
    panel.series.push_back(std::move(series));
  }
  if (gives_any(panel)) panel.y.low = 0;
  return panel;
}

// The parts of the torque at which a motor squeals, below the lines.
void add_squeals(Panel& panel, const std::vector<NamedMotor>& motors) {
  double largest = 0;
  for (const Series& series : panel.series)
    for (const std::vector<double>& row : series.rows) largest = std::max(largest, row[1]);
  std::vector<Series> bands;
  for (std::size_t i = 0; i < motors.size(); ++i) {
    const Motor& motor = motors[i].motor;
    Series band{bands.empty() ? "squeals" : "", Draw::band, colour_of(i), {}};
    bool any = false;
    for (const std::vector<double>& row : panel.series[i].rows) {
      const bool here =
          studies::squeals(motor.design(), motor.backward_wave(row[0])).value_or(false);
      const auto [below, above] = band_about(here ? row[1] : kNoValue, largest);
      band.rows.push_back({row[0], below, above});
      any = any || here;
    }
    if (any) bands.push_back(std::move(band));
  }
  panel.series.insert(panel.series.begin(), bands.begin(), bands.end());
}

// A limit as a point in the plane of speed and torque; nothing if it is none.
std::vector<double> point_of(const MetricRequest& request, double limit) {
  switch (request.metric) {
    case Metric::torque_at: return {request.at, limit};
    case Metric::speed_at: return {limit, request.at};
    case Metric::stall_torque: return {0, limit};
    case Metric::no_load_speed: return {limit, 0};
    default: return {};
  }
}

void add_limits(Panel& panel, const std::vector<studies::MotorLimit>& limits) {
  Series least{"at least", Draw::rises, "#000000", {}};
  Series most{"at most", Draw::falls, "#000000", {}};
  for (const studies::MotorLimit& limit : limits) {
    const MetricRequest* request = limit.metric.request();
    if (request == nullptr) continue;
    const auto add = [&](Series& series, double at) {
      if (!std::isfinite(at)) return;
      if (std::vector<double> point = point_of(*request, at); !point.empty())
        series.rows.push_back(std::move(point));
    };
    add(least, limit.lower);
    add(most, limit.upper);
  }
  for (Series* series : {&least, &most})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
}

// A single motor gets the full curve, and the contact at its peak power.
void add_alone(std::vector<Picture>& pictures, const std::string& title, const Motor& motor) {
  const studies::MotorFile file{title, motor.design()};
  pictures.push_back(
      {"curve", kCurvePlotSize, curve_plot(file, 0, studies::last_curve_speed(motor))});
  const MetricValue speed = evaluate(motor, {Metric::speed_at_peak_power, Argument::none, 0});
  if (speed.status != MetricStatus::ok ||
      motor.fields(speed.value, 2).point.status != PointStatus::ok)
    return;
  const studies::MotorFile at{title + ", at peak power", motor.design()};
  pictures.push_back(
      {"fields", kFieldsPlotSize,
       motor.radial_slices() != 1 ? fields_map(at, speed.value) : fields_plot(at, speed.value)});
}

}  // namespace

void add_motor(std::vector<NamedMotor>& motors, const std::string& name, const MotorDesign& base,
               const std::vector<studies::NamedValue>& values) {
  std::vector<ParameterValue> replaced;
  for (const studies::NamedValue& value : values) {
    if (const auto parameter = find_parameter(value.name); parameter && std::isfinite(value.value))
      replaced.emplace_back(*parameter, value.value);
  }
  try {
    motors.push_back({name, Motor(with(base, replaced))});
  } catch (const InputError&) {
    // A design that is not admissible has no curve.
  }
}

void add_curve_pictures(std::vector<Picture>& pictures, const std::string& title,
                        const std::vector<NamedMotor>& motors,
                        const std::vector<studies::MotorLimit>& limits) {
  if (motors.empty()) return;
  if (motors.size() == 1 && limits.empty()) return add_alone(pictures, title, motors.front().motor);
  Chart curves{title, {panel_of(motors, kTorquePanel, true)}, true};
  add_squeals(curves.panels.front(), motors);
  add_limits(curves.panels.front(), limits);
  for (const Quantity& quantity : {kPowerPanel, efficiency_of(motors), kFrictionPanel})
    curves.panels.push_back(panel_of(motors, quantity, false));
  pictures.push_back(picture_of("curves", curves));
  if (!std::all_of(motors.begin(), motors.end(), at_terminals)) return;
  Chart terminals{title, {}, true};
  for (const Quantity& quantity : kTerminalPanels)
    terminals.panels.push_back(panel_of(motors, quantity, terminals.panels.empty()));
  pictures.push_back(picture_of("terminals", terminals));
}

}  // namespace twum::cli
