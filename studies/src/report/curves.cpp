// SPDX-License-Identifier: Apache-2.0
#include "report/curves.hpp"

#include "report/encode.hpp"
#include "report/track.hpp"
#include "telling/curve_charts.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// A field every 2 % of the speed, 100 places across the contact.
constexpr std::size_t kFieldSpeeds = 51;
constexpr double kFieldPlaces = 100;

using Numbers = std::vector<double>;
using Floats = std::vector<float>;

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

Json metrics_json(const Motor& motor) {
  const std::vector<MetricExpression> metrics = plain_metrics(motor.design());
  std::vector<MetricValue> values(metrics.size());
  ExpressionEvaluator(metrics).evaluate(motor, values);
  Json json = Json::object();
  for (std::size_t i = 0; i < metrics.size(); ++i)
    json[metrics[i].text] = number_json(values[i].value);
  return json;
}

// What tables of points and charts need: all columns of a curve, or the torque alone over speeds that are equally spaced.
Json columns_json(const telling::MotorCurve& curve) {
  std::vector<CurveColumn> columns = telling::told_columns(curve.motor.design());
  if (!curve.whole) columns = {columns[1]};
  Json json = Json::array();
  for (const CurveColumn& column : columns) {
    Numbers numbers;
    for (const OperatingPoint& point : curve.points) numbers.push_back(column.value(point));
    json.push_back({{"name", column.name}, {"unit", column.unit}, {"values", base64(numbers)}});
  }
  return json;
}

}  // namespace

Json design_json(const MotorDesign& design) {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table())
    if (is_given(design, row.parameter)) json[std::string(row.name)] = get(design, row.parameter);
  return json;
}

Json curve_json(const telling::MotorCurve& curve) {
  const Motor& motor = curve.motor;
  Json json{{"label", curve.name},
            {"design", design_json(motor.design())},
            {"metrics", metrics_json(motor)},
            {"columns", columns_json(curve)}};
  if (!curve.whole) {
    json["last_speed"] = curve.points.back().speed;
    return json;
  }
  Numbers speeds;
  for (const OperatingPoint& point : curve.points) speeds.push_back(point.speed);
  json["one_slice_torque"] = one_slice_torque_json(motor, speeds);
  json["fields"] = fields_json(motor);
  json["track"] = track_json(motor);
  return json;
}

Json curves_json(const std::vector<telling::MotorCurve>& curves) {
  Json json = Json::array();
  for (const telling::MotorCurve& curve : curves) json[curve.place] = curve_json(curve);
  return json;
}

}  // namespace twum::inline v0_1::studies
