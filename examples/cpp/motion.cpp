// SPDX-License-Identifier: Apache-2.0
// Follows a motor through a start and a stop under a load, and prints its speed over time and what happens.
#include <twum/motion.hpp>
#include <twum/twum.hpp>

#include <cstdio>

int main(int argc, char** argv) try {
  const std::string path = argc > 1 ? argv[1] : "examples/motors/moving-60.yaml";
  const auto [name, design] = twum::studies::read_motor_file(path);
  twum::motion::MotionTask task = twum::motion::steady_drive(design, 30e-3);
  task.load_torque = 0.2;
  task.switched_off = {{20e-3, 30e-3}};
  for (int i = 0; i <= 30; ++i) task.output_times.push_back(1e-3 * i);

  const twum::motion::Motion motion = twum::motion::simulate(design, task);
  std::printf("%s: %s\n", name.c_str(), motion.status.c_str());
  for (const twum::motion::MotionSample& at : motion.samples)
    std::printf("%5.1f ms %8.3f rad/s %8.2f mrad %6.3f um\n", 1e3 * at.time, at.speed,
                1e3 * at.angle, 1e6 * at.amplitude);
  for (const twum::motion::MotionEvent& event : motion.events)
    std::printf("%6.3f ms: %s\n", 1e3 * event.time, to_string(event.kind));
} catch (const twum::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
