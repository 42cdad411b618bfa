// SPDX-License-Identifier: Apache-2.0
#include "problem/load_out_of_reach.hpp"

#include "problem/metric_values.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace twum::studies {
namespace {

using M = Metric;

// Quotient P_out / P and its slope.
double quotient_slope(const SpeedDerivative& d, double power, double slope) {
  return (d.output_power * power - d.point.output_power * slope) / (power * power);
}

// Derivative of a point metric (T7.1, T7.6, T7.7, T7.9) with respect to speed.
double slope_in_speed(const Motor& motor, M metric, const SpeedDerivative& d) {
  const Stator& stator = motor.design().stator;
  switch (metric) {
    case M::speed_at: return 1;
    case M::output_power_at: return d.output_power;
    case M::stator_power_at: return d.stator_power;
    case M::friction_power_at: return d.friction_power;
    case M::layer_loss_at: return d.layer_loss;
    case M::efficiency_at:
      return quotient_slope(d, d.point.stator_power + d.point.stator_loss, d.stator_power);
    case M::contact_efficiency_at: return quotient_slope(d, d.point.stator_power, d.stator_power);
    case M::wear_intensity_at:
      return d.friction_power /
             (2 * std::numbers::pi * stator.contact_radius * stator.contact_width);
    case M::stick_fraction_at: return d.stick_fraction;
    default: return d.torque;
  }
}

}  // namespace

MetricDerivative out_of_reach(const Motor& motor, Metric metric, bool gradient,
                              bool fixed_static_friction) {
  const MetricValue largest = evaluate(motor, {M::max_torque, Argument::none, 0});
  if (largest.status != MetricStatus::ok || !(largest.value > 0))
    return {{std::numeric_limits<double>::quiet_NaN(), MetricStatus::unreachable}, {}, {}};
  const double load = kReachable * largest.value;
  const MetricRequest at_load{metric, Argument::torque, load};
  if (!gradient) return {evaluate(motor, at_load), {}, Smoothness::smooth};
  const std::array requests{at_load, MetricRequest{M::max_torque, Argument::none, 0},
                            MetricRequest{M::speed_at, Argument::torque, load}};
  std::vector<MetricDerivative> d = differentiate(motor, requests, fixed_static_friction);
  MetricDerivative result = d[0];
  if (result.value.status != MetricStatus::ok) return result;
  // The load moves too: dm / dp = dm / dp at a fixed load + dm / dOmega (dOmega / dT) dT / dp.
  const SpeedDerivative in_speed = differentiate_in_speed(motor, d[2].value.value);
  const double in_load = slope_in_speed(motor, metric, in_speed) / in_speed.torque;
  for (std::size_t i = 0; i < kParameterCount; ++i)
    result.gradient[i] += in_load * kReachable * d[1].gradient[i];
  for (const auto& part : {d[1], d[2]}) {
    if (result.smoothness < part.smoothness) result.smoothness = part.smoothness;
  }
  return result;
}

}  // namespace twum::studies
