// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/frequency_points.hpp>

#include <twum/io/engineering.hpp>

#include <cmath>

namespace twum::inline v0_1::motors {
namespace {

using R = ResponsePoint;
constexpr FrequencyColumn kFrequencyColumns[] = {
    {"frequency", "Hz", [](const R& p) { return p.frequency; }},
    {"amplitude", "m", [](const R& p) { return p.point.amplitude; }},
    {"speed", "rad/s", [](const R& p) { return p.point.speed; }},
    {"torque", "N.m", [](const R& p) { return p.point.torque; }},
    {"output_power", "W", [](const R& p) { return p.point.output_power; }},
    {"electrical_power", "W", [](const R& p) { return p.point.electrical_power; }},
    {"phase_current", "A", [](const R& p) { return p.point.phase_current; }},
    {"first_current", "A", [](const R& p) { return p.backward.first_current; }, true},
    {"second_current", "A", [](const R& p) { return p.backward.second_current; }, true},
    {"backward_ratio", "1", [](const R& p) { return p.backward.ratio; }, true},
    {"standing_wave_ratio", "1", [](const R& p) { return p.backward.standing_wave_ratio; }, true},
    {"phase_lag", "rad", [](const R& p) { return p.point.phase_lag; }},
    {"overall_efficiency", "1", [](const R& p) { return p.point.overall_efficiency(); }},
    {"squeal_rate", "1/s", [](const R& p) { return p.backward.squeal_rate; }},
};

}  // namespace

std::span<const FrequencyColumn> frequency_columns() { return kFrequencyColumns; }

std::optional<ResponsePoint> running_point(const FrequencyResponse& response, double frequency) {
  std::optional<ResponsePoint> largest;
  for (const ResponsePoint& point : response.at(frequency))
    if (point.stable) largest = point;
  return largest;
}

std::string wave_text(const ResponsePoint& wave) {
  return engineering(wave.point.amplitude, "m") + ", " + engineering(wave.point.speed, "rad/s");
}

std::string squeal_text(const ResponsePoint& wave) {
  const double rate = wave.backward.squeal_rate;
  if (std::isnan(rate)) return "not known";
  return rate > 0 ? "by " + engineering(rate, "1/s") : "no";
}

}  // namespace twum::inline v0_1::motors
