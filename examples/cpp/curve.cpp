// SPDX-License-Identifier: Apache-2.0
// Reads a motor file and prints its torque-speed curve with the zones of stick and slip.
#include <twum/twum.hpp>

#include <cstdio>

int main(int argc, char** argv) try {
  const std::string path = argc > 1 ? argv[1] : "examples/motors/ring-60.yaml";
  const auto [name, design] = twum::studies::read_motor_file(path);
  const twum::Motor motor(design);
  const double no_load = twum::evaluate(motor, {twum::Metric::no_load_speed}).value;

  std::printf("%s: torque, power and zones over speed\n", name.c_str());
  for (int i = 0; i <= 10; ++i) {
    const twum::OperatingPoint point = motor.operating_point(0.1 * i * no_load);
    std::printf("%6.2f rad/s %7.4f N.m %6.3f W ", point.speed, point.torque, point.output_power);
    for (const twum::Zone& zone : motor.zones(point.speed))
      std::printf(" %s", to_string(zone.state));
    std::printf("\n");
  }
} catch (const twum::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
