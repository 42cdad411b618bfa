// SPDX-License-Identifier: Apache-2.0
#include "plant_metrics.hpp"

#include "model_slopes.hpp"
#include "without_value.hpp"

#include <twum/base/no_value.hpp>
#include <twum/motion/linear_plant.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace twum::inline v0_1::motion {
namespace {

using M = Metric;
using P = Parameter;

// Relative, of a central difference: its error is the square of that, and Jacobians are exact to 1e-13 or so.
constexpr double kStep = 1e-5;
// Relative change of a number that tells its slope to 1e-6.
constexpr double kFelt = 1e-6;

double steady_gain(const LinearPlant& plant, std::string_view input) {
  const auto speed = std::ranges::find(plant.outputs, "speed", &Signal::name);
  const auto column = std::ranges::find(plant.inputs, input, &Signal::name);
  // The angle, which has no steady gain, is the last of the states.
  return plant.gains[static_cast<std::size_t>(speed - plant.outputs.begin())]
                    [static_cast<std::size_t>(column - plant.inputs.begin())];
}

bool is_of_layer(P parameter) { return parameter >= P::thickness && parameter <= P::inertia; }

// By a step that the number feels; steps rise from one that no unit makes large.
double slope_at_zero(double here, const std::function<double(double)>& at) {
  double slope = 0;
  for (double step = 1e-10; step < 1; step *= 10) {
    const double change = at(step) - here;
    slope = change / step;
    if (std::fabs(change) > kFelt * std::fabs(here)) break;
  }
  return slope;
}

double slope(const MotorDesign& design, const MetricRequest& request, P parameter, double here) {
  const double q = get(design, parameter), step = kStep * std::fabs(q);
  const auto at = [&](double value) {
    return plant_number(with(design, parameter, value), request);
  };
  const bool of_series = parameter == P::driver_inductance || parameter == P::driver_resistance;
  if (of_series && get(design, P::blocked_capacitance) == 0) return kNoValue;  // no such plant
  if (q == 0) return is_of_layer(parameter) ? kNoValue : slope_at_zero(here, at);
  const double above = at(q + step);
  // There is no static friction below the kinetic one.
  if (parameter == P::static_friction && q - step < design.friction.kinetic)
    return (above - here) / step;
  return (above - at(q - step)) / (2 * step);
}

}  // namespace

bool is_of_plant(Metric metric) {
  return metric == M::settling_rate_at || metric == M::bounce_rate_at ||
         metric == M::speed_per_frequency_at || metric == M::speed_per_voltage_at;
}

double plant_number(const MotorDesign& design, const MetricRequest& request) {
  require_running(design, request.at);
  if (request.metric == M::bounce_rate_at) return bounce_rate(design, request.at);
  const LinearPlant plant = linearize(design, request.at);
  if (request.metric == M::settling_rate_at) return -plant.poles.front().real();
  return steady_gain(plant, request.metric == M::speed_per_frequency_at ? "frequency" : "voltage");
}

std::array<double, kParameterCount> plant_gradient(const MotorDesign& design,
                                                   const MetricRequest& request) {
  std::array<double, kParameterCount> gradient{};
  const double here = plant_number(design, request);
  for (const ParameterInfo& row : parameter_table())
    if (!row.integer && in_use(design, row.parameter) && counts_in_motion(row.parameter))
      gradient[index_of(row.parameter)] = slope(design, request, row.parameter, here);
  return gradient;
}

}  // namespace twum::inline v0_1::motion
