// SPDX-License-Identifier: Apache-2.0
// Prints the stall torque of the motor that a default design is.
#include <twum/core.hpp>

#include <cstdio>

int main() {
  const twum::Motor motor{twum::MotorDesign{}};
  std::printf("%.17g\n", twum::evaluate(motor, {twum::Metric::stall_torque}).value);
}
