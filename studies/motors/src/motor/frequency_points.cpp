// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/motor/frequency_points.hpp>

#include <twum/studies/units/engineering.hpp>

namespace twum::studies {
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
    {"phase_lag", "rad", [](const R& p) { return p.point.phase_lag; }},
    {"overall_efficiency", "1", [](const R& p) { return p.point.overall_efficiency(); }},
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

}  // namespace twum::studies
