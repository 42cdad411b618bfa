// SPDX-License-Identifier: Apache-2.0
#include "telling/curve_limits.hpp"

#include "results/standings.hpp"
#include "telling/goal_parts.hpp"
#include "telling/limit_parts.hpp"

#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

bool is_broken(const Json& standing) {
  return standing["state"] == "broken" || standing["state"] == "unreachable";
}

// "≥ 0.5 N·m at 100 rpm", and by how much it is broken.
Phrase bound_phrase(const Json& standing, const MetricRequest& request) {
  Phrase phrase{request.metric == Metric::stall_torque    ? "stall "
                : request.metric == Metric::no_load_speed ? "no load "
                                                          : "",
                standing["side"] == "at least" ? "≥ " : "≤ ",
                value_part(standing["limit"], standing["unit"])};
  if (request.argument == Argument::speed)
    append(phrase, {" at ", value_part(request.at, "rad/s")});
  if (!is_broken(standing)) return phrase;
  append(phrase, {" ("});
  append(phrase, state_phrase(standing));
  append(phrase, {")"});
  return phrase;
}

// The speed at which a curve carries a torque, linear between its points.
double speed_at(const MotorCurve& curve, double torque) {
  for (std::size_t i = curve.points.size(); i-- > 1;) {
    const OperatingPoint &a = curve.points[i - 1], &b = curve.points[i];
    if (a.torque >= torque && b.torque <= torque && a.torque > b.torque)
      return std::lerp(a.speed, b.speed, (a.torque - torque) / (a.torque - b.torque));
  }
  return std::nan("");
}

// A place on a chart; NaN where a limit has none.
struct Place {
  double x, y;
  bool upright{false};
};

Place place_on(std::string_view column, const MotorCurve& curve, const CurveLimit& of) {
  const MetricRequest& request = of.request;
  const bool torque = column == "torque";
  if (torque && request.metric == Metric::stall_torque) return {0, of.limit};
  if (torque && request.metric == Metric::no_load_speed) return {of.limit, 0, true};
  if (torque && request.metric == Metric::speed_at) return {of.limit, request.at, true};
  if (info(request.metric).name != std::string(column) + "_at") return {std::nan(""), 0};
  if (request.argument == Argument::speed) return {request.at, of.limit};
  if (request.argument == Argument::torque) return {speed_at(curve, request.at), of.limit};
  return {std::nan(""), 0};
}

}  // namespace

std::vector<CurveLimit> curve_limits(const DesignReport& report, const std::vector<Goal>& goals) {
  std::vector<CurveLimit> limits;
  for (const Json& one : standings_json(report, goals)) {
    if (!one.contains("metric")) continue;
    const MetricExpression expression = parse_metric(one["metric"].get<std::string>());
    const MetricRequest* request = expression.request();
    if (request == nullptr) continue;
    limits.push_back(
        {*request,
         {0, 0, false, one["side"] == "at least", is_broken(one), bound_phrase(one, *request)},
         one["limit"]});
  }
  return limits;
}

std::vector<Bound> bounds_on(std::string_view column, const MotorCurve& curve,
                             const std::vector<CurveLimit>& limits) {
  std::vector<Bound> bounds;
  for (const CurveLimit& limit : limits) {
    const Place place = place_on(column, curve, limit);
    if (!std::isfinite(place.x)) continue;
    bounds.push_back(limit.bound);
    bounds.back().x = place.x;
    bounds.back().y = place.y;
    bounds.back().upright = place.upright;
  }
  return bounds;
}

}  // namespace twum::inline v0_1::studies::telling
