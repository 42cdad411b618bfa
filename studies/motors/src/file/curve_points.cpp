// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/curve_points.hpp>

#include <twum/core/metrics.hpp>

#include <cmath>
#include <iterator>

namespace twum::inline v0_1::motors {
namespace {

constexpr CurveColumn kContact[] = {
    {"speed", "rad/s", [](const OperatingPoint& p) { return p.speed; }},
    {"torque", "N.m", [](const OperatingPoint& p) { return p.torque; }},
    {"output_power", "W", [](const OperatingPoint& p) { return p.output_power; }},
    {"stator_power", "W", [](const OperatingPoint& p) { return p.stator_power; }},
    {"friction_power", "W", [](const OperatingPoint& p) { return p.friction_power; }},
    {"layer_loss", "W", [](const OperatingPoint& p) { return p.layer_loss; }},
    {"contact_efficiency", "1", [](const OperatingPoint& p) { return p.contact_efficiency(); }},
    {"wear_intensity", "W/m^2", [](const OperatingPoint& p) { return p.wear_intensity; }},
    {"stick_fraction", "1", [](const OperatingPoint& p) { return p.stick_fraction; }},
};

constexpr CurveColumn kTerminals[] = {
    {"amplitude", "m", [](const OperatingPoint& p) { return p.amplitude; }},
    {"phase_lag", "rad", [](const OperatingPoint& p) { return p.phase_lag; }},
    {"voltage", "V", [](const OperatingPoint& p) { return p.voltage; }},
    {"phase_current", "A", [](const OperatingPoint& p) { return p.phase_current; }},
    {"power_factor", "1", [](const OperatingPoint& p) { return p.power_factor; }},
    {"electrical_power", "W", [](const OperatingPoint& p) { return p.electrical_power; }},
    {"overall_efficiency", "1", [](const OperatingPoint& p) { return p.overall_efficiency(); }},
    {"dielectric_loss", "W", [](const OperatingPoint& p) { return p.dielectric_loss; }},
    {"stator_loss", "W", [](const OperatingPoint& p) { return p.stator_loss; }},
};

#ifndef __wasm__
constexpr CurveColumn kBehindDriver[] = {
    {"driver_loss", "W", [](const OperatingPoint& p) { return p.driver_loss; }},
    {"terminal_voltage", "V", [](const OperatingPoint& p) { return p.terminal_voltage; }},
};
#endif

}  // namespace

std::span<const CurveColumn> contact_columns() { return kContact; }

std::span<const CurveColumn> terminal_columns() { return kTerminals; }

std::vector<CurveColumn> curve_columns(const MotorDesign& design) {
  std::vector<CurveColumn> columns(std::begin(kContact), std::end(kContact));
  if (!has_modal_data(design)) return columns;
  columns.insert(columns.end(), std::begin(kTerminals), std::end(kTerminals));
#ifndef __wasm__  // a page has an ideal driver
  if (design.driver && (design.driver->inductance != 0 || design.driver->resistance != 0))
    columns.insert(columns.end(), std::begin(kBehindDriver), std::end(kBehindDriver));
#endif
  return columns;
}

std::optional<bool> squeals(const MotorDesign& design, const BackwardWave& wave) {
  if (std::isnan(wave.fed_damping)) return {};
  if (!std::isnan(wave.squeal_rate)) return wave.squeal_rate > 0;
  const double damping = modal_damping(design);
  return wave.fed_damping > (damping > 0 ? damping : 0);
}

std::vector<SquealRange> squeal_ranges(const Motor& motor, std::span<const double> speeds) {
  std::vector<SquealRange> ranges;
  bool before = false;
  for (const double speed : speeds) {
    const bool now = squeals(motor.design(), motor.backward_wave(speed)).value_or(false);
    if (now && !before) ranges.push_back({speed, speed});
    if (now) ranges.back().last = speed;
    before = now;
  }
  return ranges;
}

double last_curve_speed(const Motor& motor) {
  const MetricValue no_load =
      evaluate(motor, MetricRequest{Metric::no_load_speed, Argument::none, 0});
  if (no_load.status == MetricStatus::ok && no_load.value > 0) return 1.05 * no_load.value;
  return motor.crest_speed() > 0 ? 1.2 * motor.crest_speed() : 10;
}

double curve_speed(double last, std::uint64_t index, std::uint64_t points) {
  return last * static_cast<double>(index) / static_cast<double>(points - 1);
}

std::vector<double> curve_speeds(const Motor& motor, std::size_t points) {
  const double last = last_curve_speed(motor);
  std::vector<double> speeds(points);
  for (std::size_t i = 0; i < points; ++i) speeds[i] = curve_speed(last, i, points);
  return speeds;
}

}  // namespace twum::inline v0_1::motors
