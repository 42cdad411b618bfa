// SPDX-License-Identifier: Apache-2.0
// Sizes a gearbox and a motor together with an optimizer of your own, here a golden section search. For the motor it
// evaluates one metric; a motor that cannot carry the torque is infeasible.
#include <twum/core.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

namespace {

constexpr double kJointTorque = 2.0;  // [N m]
constexpr double kJointSpeed = 2.0;   // [rad/s]
constexpr double kGearLoss = 0.03;    // share of the torque, for each unit of the ratio's logarithm

// Stator power for the duty of the joint through a gearbox [W].
double input_power(const twum::Motor& motor, double ratio) {
  const double torque = kJointTorque / ratio * (1 + kGearLoss * std::log(ratio));
  const double speed = kJointSpeed * ratio;
  const auto carried =
      twum::evaluate(motor, {twum::Metric::torque_at, twum::Argument::speed, speed});
  if (carried.status != twum::MetricStatus::ok || carried.value < torque)
    return std::numeric_limits<double>::infinity();
  const twum::MetricRequest at{twum::Metric::stator_power_at, twum::Argument::torque, torque};
  return twum::evaluate(motor, at).value;
}

}  // namespace

int main() {
  const twum::Motor motor{twum::MotorDesign{}};
  constexpr double kGolden = 0.6180339887498949;
  double low = 2.8;
  double high = 6;
  while (high - low > 1e-6) {
    const double a = high - kGolden * (high - low);
    const double b = low + kGolden * (high - low);
    (input_power(motor, a) < input_power(motor, b) ? high : low) =
        input_power(motor, a) < input_power(motor, b) ? b : a;
  }
  std::printf("ratio %.4f, %.3f W for %.1f W of work\n", low, input_power(motor, low),
              kJointTorque * kJointSpeed);
}
