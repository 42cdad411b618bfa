// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metrics.hpp>

#include "metrics/differentiator.hpp"
#include "metrics/held_metrics.hpp"
#include "metrics/held_traps.hpp"

#include <limits>

namespace twum {

using namespace core;

SpeedDerivative differentiate_in_speed(const Motor& motor, double speed) {
  const HeldTraps traps;
  SpeedDerivative d;
  d.point = motor.operating_point(speed);
  if (d.point.status != PointStatus::ok) {
    d.torque = d.output_power = d.stator_power = d.friction_power = d.layer_loss =
        d.stick_fraction = std::numeric_limits<double>::quiet_NaN();
    d.smoothness = Smoothness::undefined;
    return d;
  }
  const DrivenMotor<double>& m = motor.model();
  const SolvedPoint solved = solve_point(m, speed);
  const auto n = solved.differentiated(m, contact::MotionDual::variable(speed, contact::kInSpeed));
  d.torque = n.torque.d[0];
  d.output_power = d.point.torque + speed * d.torque;
  d.stator_power = n.stator_power.d[0];
  d.friction_power = n.friction_power.d[0];
  d.layer_loss = n.layer_loss.d[0];
  d.stick_fraction = n.stick_fraction.d[0];
  d.smoothness = smoothness_of(m, solved, speed);
  return d;
}

std::vector<MetricValue> evaluate(const Motor& motor, std::span<const MetricRequest> requests) {
  const HeldTraps traps;
  std::optional<Evaluator> evaluator;
  HeldMetrics held(motor.design());
  std::vector<MetricValue> values;
  values.reserve(requests.size());
  for (const MetricRequest& request : requests) {
    if (is_held(request)) {
      values.push_back(held.evaluate(request));
      continue;
    }
    if (!evaluator) evaluator.emplace(motor);
    values.push_back(evaluator->evaluate(request));
  }
  return values;
}

MetricValue evaluate(const Motor& motor, const MetricRequest& request) {
  const HeldTraps traps;
  return is_held(request) ? HeldMetrics(motor.design()).evaluate(request)
                          : Evaluator(motor).evaluate(request);
}

MetricValue evaluate_at_share(const Motor& motor, Metric metric, double share) {
  const HeldTraps traps;
  return Evaluator(motor).evaluate_at_share(metric, share);
}

MetricDerivative differentiate(const Motor& motor, const MetricRequest& request,
                               bool fixed_static_friction) {
  return differentiate(motor, std::span(&request, 1), fixed_static_friction).front();
}

std::vector<MetricDerivative> differentiate(const Motor& motor,
                                            std::span<const MetricRequest> requests,
                                            bool fixed_static_friction) {
  const HeldTraps traps;
  std::optional<Differentiator> differentiator;
  HeldMetrics held(motor.design());
  std::vector<MetricDerivative> derivatives;
  derivatives.reserve(requests.size());
  for (const MetricRequest& request : requests) {
    if (is_held(request)) {
      derivatives.push_back(held.differentiate(request, fixed_static_friction));
      continue;
    }
    if (!differentiator) differentiator.emplace(motor, fixed_static_friction);
    derivatives.push_back(differentiator->differentiate(request));
  }
  return derivatives;
}

MetricValue evaluate_beyond_drive(const Motor& motor, const MetricRequest& request) {
  const HeldTraps traps;
  return HeldMetrics(motor.design(), true).evaluate(request);
}

MetricDerivative differentiate_beyond_drive(const Motor& motor, const MetricRequest& request,
                                            bool fixed_static_friction) {
  const HeldTraps traps;
  return HeldMetrics(motor.design(), true).differentiate(request, fixed_static_friction);
}

MetricDerivative differentiate_at_share(const Motor& motor, Metric metric, double share,
                                        bool fixed_static_friction) {
  const HeldTraps traps;
  return Differentiator(motor, fixed_static_friction).differentiate_at_share(metric, share);
}

}  // namespace twum
