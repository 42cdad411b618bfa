// SPDX-License-Identifier: Apache-2.0
// Estimates friction and stiffness from measured torque-speed points, by least squares with exact derivatives.
#include <twum/core.hpp>
#include <twum/optim.hpp>

#include <array>
#include <cstdio>
#include <vector>

namespace {

using twum::Parameter;

struct Measured {
  double speed;   // [rad/s]
  double torque;  // [N m]
};
// Readings of a bench, rounded to 5 mN.m.
constexpr std::array<Measured, 7> kPoints{
    {{9, 0.765}, {10, 0.765}, {11, 0.755}, {12, 0.720}, {13, 0.610}, {14, 0.355}, {14.5, 0.140}}};
constexpr std::array<Parameter, 2> kFitted{Parameter::kinetic_friction, Parameter::youngs_modulus};

twum::optim::Residuals residuals(std::span<const double> values) {
  const std::array<twum::ParameterValue, 2> changed{
      {{kFitted[0], values[0]}, {kFitted[1], values[1]}}};
  const twum::Motor motor(with(twum::MotorDesign{}, changed));
  std::vector<twum::MetricRequest> requests;
  for (const Measured& point : kPoints)
    requests.push_back({twum::Metric::torque_at, twum::Argument::speed, point.speed});
  const auto torques = differentiate(motor, requests);

  twum::optim::Residuals r;
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    if (torques[i].value.status != twum::MetricStatus::ok)
      return {{}, {}, to_string(torques[i].value.status)};
    r.values.push_back(torques[i].value.value - kPoints[i].torque);
    for (const Parameter parameter : kFitted)
      r.jacobian.push_back(torques[i].gradient[index_of(parameter)]);
  }
  return r;
}

}  // namespace

int main() {
  const auto fit = twum::optim::least_squares(
      {{.name = "kinetic_friction", .lower = 0.05, .upper = 0.5, .start = 0.2},
       {.name = "youngs_modulus",
        .lower = 5e8,
        .upper = 2e10,
        .start = 3e9,
        .scale = twum::optim::Scale::log}},
      residuals);
  for (const twum::optim::Estimate& estimate : fit.estimates)
    std::printf("%s %.4g (%.4g to %.4g)\n", estimate.name.c_str(), estimate.value, estimate.low,
                estimate.high);
  std::printf("residuals of %.2g N.m, %s\n", fit.residual_deviation, to_string(fit.outcome));
}
