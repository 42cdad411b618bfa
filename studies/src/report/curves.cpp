// SPDX-License-Identifier: Apache-2.0
#include "report/curves.hpp"

#include "report/encode.hpp"
#include "report/track.hpp"

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace twum::studies {
namespace {

// Enough points for a smooth curve of some 700 pixels.
constexpr std::size_t kCurvePoints = 161;
// A field every 2 % of the speed, 100 places across the contact.
constexpr std::size_t kFieldSpeeds = 51;
constexpr double kFieldPlaces = 100;

using Numbers = std::vector<double>;
using Floats = std::vector<float>;

std::optional<Motor> motor_of(const MotorDesign& base, const DesignValues& values) {
  std::vector<ParameterValue> replaced;
  for (const auto& [name, value] : values) {
    if (const auto parameter = find_parameter(name)) replaced.emplace_back(*parameter, value);
  }
  try {
    return Motor(with(base, replaced));
  } catch (const InputError&) {
    return {};  // a design that is not admissible has no curve
  }
}

// Half the width of the window over the contact that is shown [rad].
double window_of(const Motor& motor) {
  return std::min(std::numbers::pi, 1.25 * motor.contact().half_angle);
}

// The samples of fields() are equally spaced over the wave; those within the window.
std::vector<FieldSample> in_window(const ContactFields& fields, double window) {
  std::vector<FieldSample> samples;
  for (const FieldSample& sample : fields.samples) {
    if (std::abs(sample.phase) <= window) samples.push_back(sample);
  }
  return samples;
}

Json zones_json(const std::vector<Zone>& zones) {
  Json list = Json::array();
  for (const Zone& zone : zones) list.push_back({static_cast<int>(zone.state), zone.from, zone.to});
  return list;
}

Floats column(const std::vector<FieldSample>& samples, double FieldSample::*value) {
  Floats numbers;
  for (const FieldSample& sample : samples) numbers.push_back(static_cast<float>(sample.*value));
  return numbers;
}

// Pressure and stator velocity are the same at every speed.
Json fields_json(const Motor& motor) {
  const double window = window_of(motor);
  if (!(window > 0)) return nullptr;
  const int count =
      1 + static_cast<int>(std::min(kFieldPlaces * std::numbers::pi / window, 20000.0));
  Json json = Json::object();
  Json frames = Json::array();
  for (const double speed : curve_speeds(motor, kFieldSpeeds)) {
    const ContactFields fields = motor.fields(speed, count);
    if (fields.point.status != PointStatus::ok) continue;
    const std::vector<FieldSample> samples = in_window(fields, window);
    if (frames.empty()) {
      json["phase"] = base64(column(samples, &FieldSample::phase));
      json["pressure"] = base64(column(samples, &FieldSample::pressure));
      json["stator_velocity"] = base64(column(samples, &FieldSample::stator_velocity));
    }
    frames.push_back({{"speed", speed},
                      {"traction", base64(column(samples, &FieldSample::traction))},
                      {"layer_velocity", base64(column(samples, &FieldSample::layer_velocity))},
                      {"zones", zones_json(fields.zones)}});
  }
  if (frames.empty()) return nullptr;
  json["kinetic"] = motor.design().friction.kinetic;
  json["static"] = motor.design().friction.threshold;
  json["frames"] = std::move(frames);
  return json;
}

// [[first, last], ...]: the speeds at which the motor squeals [rad/s].
Json squeals_json(const Motor& motor) {
  Json json = Json::array();
  for (const auto& [first, last] : squeal_ranges(motor, curve_speeds(motor, kFieldSpeeds)))
    json.push_back({first, last});
  return json;
}

Json metrics_json(const Motor& motor) {
  const std::vector<MetricExpression> metrics = plain_metrics(motor.design());
  std::vector<MetricValue> values(metrics.size());
  ExpressionEvaluator(metrics).evaluate(motor, values);
  Json json = Json::object();
  for (std::size_t i = 0; i < metrics.size(); ++i)
    json[metrics[i].text] = number_json(values[i].value);
  return json;
}

}  // namespace

DesignValues design_values(const std::vector<NamedValue>& values) {
  DesignValues numbers;
  for (const NamedValue& value : values) {
    if (std::isfinite(value.value)) numbers[value.name] = value.value;
  }
  return numbers;
}

Json curve_json(const MotorDesign& base, const DesignValues& values, const std::string& label,
                Detail detail) {
  const std::optional<Motor> motor = motor_of(base, values);
  if (!motor) return nullptr;
  const std::vector<double> speeds = curve_speeds(*motor, kCurvePoints);
  std::vector<OperatingPoint> points;
  for (const double speed : speeds) points.push_back(motor->operating_point(speed));
  Json json{{"label", label}, {"design", Json::object()}, {"metrics", metrics_json(*motor)}};
  for (const ParameterInfo& row : parameter_table()) {
    if (is_given(motor->design(), row.parameter))
      json["design"][std::string(row.name)] = get(motor->design(), row.parameter);
  }
  const auto add = [&](const char* name, auto value) {
    Numbers numbers;
    for (const OperatingPoint& point : points) numbers.push_back(value(point));
    json[name] = base64(numbers);
  };
  json["squeals"] = squeals_json(*motor);
  if (detail == Detail::torque) {
    add("speed", [](const OperatingPoint& p) { return p.speed; });
    add("torque", [](const OperatingPoint& p) { return p.torque; });
    return json;
  }
  for (const CurveColumn& one : curve_columns(motor->design())) add(one.name, one.value);
  add("efficiency", [](const OperatingPoint& p) { return p.efficiency(); });
  add("stator_loss", [](const OperatingPoint& p) { return p.stator_loss; });
  json["one_slice_torque"] = one_slice_torque_json(*motor, speeds);
  json["fields"] = fields_json(*motor);
  json["track"] = track_json(*motor);
  return json;
}

}  // namespace twum::studies
