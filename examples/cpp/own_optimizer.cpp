// SPDX-License-Identifier: Apache-2.0
// Chooses the ratio of a gearbox with an optimizer of your own, here a golden section search. For each ratio it asks the
// motor for one metric at the duty, a torque at a speed. A motor that does not hold the duty is infeasible.
#include <twum/twum.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

namespace {

constexpr double kJointTorque = 2.0;  // [N m]
constexpr double kJointSpeed = 2.0;   // [rad/s]
constexpr double kGearLoss = 0.03;    // share of the torque, for each unit of the ratio's logarithm

// Electrical power with which the drive holds the duty of the joint through a gearbox [W].
double input_power(const twum::Motor& motor, double ratio) {
  const double torque = kJointTorque / ratio * (1 + kGearLoss * std::log(ratio));
  const double speed = kJointSpeed * ratio;
  const auto power = twum::evaluate(
      motor, {twum::Metric::electrical_power_at, twum::Argument::both, speed, torque});
  return power.status == twum::MetricStatus::ok ? power.value
                                                : std::numeric_limits<double>::infinity();
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string path = argc > 1 ? argv[1] : "examples/motors/drive-60.yaml";
  const twum::Motor motor(twum::studies::read_motor_file(path).design);
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kLow = 2.6, kHigh = 9;
  double low = kLow, high = kHigh;
  while (high - low > 1e-4) {
    const double a = high - kGolden * (high - low);
    const double b = low + kGolden * (high - low);
    (input_power(motor, a) < input_power(motor, b) ? high : low) =
        input_power(motor, a) < input_power(motor, b) ? b : a;
  }
  const double ratio = (low + high) / 2;
  std::printf("ratio %.3f, %.3f W for %.1f W of work\n", ratio, input_power(motor, ratio),
              kJointTorque * kJointSpeed);
  // Inside of the bracket: more and less both need more power.
  return ratio - kLow > 0.1 && kHigh - ratio > 0.1 ? 0 : 1;
} catch (const twum::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
