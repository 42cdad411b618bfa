// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <functional>

// The averaged engine beside the oscillating one. They share the motor's numbers, and neither equations nor contact.
namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

struct TwoEngines {
  const char* name;
  MotorDesign motor;
  MotionTask task;
  double amplitude, speed, angle;  // allowed: of the largest, of the largest, [rad]
};

MotionTask changed(MotionTask task, const std::function<void(MotionTask&)>& change) {
  change(task);
  return task;
}

MotorDesign with_resistor(MotorDesign d) {
  d.driver = Driver{459};
  return d;
}

// Averaging and the periodic contact leave 4 % of the amplitude, 1.5 % of the speed and 0.5 mrad in most motions. It is more where the
// contact is full, whose memory is longer than a turn: there the motions are a few microseconds apart in time, which counts while a
// wave that does not start overshoots, and where a rotor is caught.
std::vector<TwoEngines> ten_motions() {
  const MotorDesign d = elastic_60(1e-4), bare = elastic_60(7e-6);
  const MotorDesign weak = elastic_60(1e-4, 108), swept = elastic_60(1e-4, 100, 44e3),
                    burst = elastic_60(1e-4, 120, 43.6e3);
  const auto steady = [](MotionTask& t) { t.initial.steady = true; };
  const auto off = [&](MotionTask& t) { steady(t), t.switched_off = {{0, t.duration}}; };
  return {{"start", d, steady_drive(d, 0.012), 0.04, 0.015, 5e-4},
          {"start of the bare rotor", bare, steady_drive(bare, 0.01), 0.04, 0.02, 5e-4},
          {"start against 0.4 N m", d,
           changed(steady_drive(d, 0.01), [](MotionTask& t) { t.load_torque = 0.4; }), 0.04, 0.015,
           5e-4},
          {"108 V, which do not start it", weak, steady_drive(weak, 0.01), 0.1, 0.13, 5e-4},
          {"start by a sweep from 44 to 40 kHz at 100 V", swept,
           changed(steady_drive(swept, 0.02),
                   [](MotionTask& t) {
                     t.frequency = Profile({{0, 44e3}, {0.02, 40e3}});
                   }),
           0.04, 0.015, 5e-4},
          {"stop, phases shorted", d, changed(steady_drive(d, 0.012), off), 0.04, 0.03, 5e-4},
          {"stop with 459 ohm", with_resistor(d), changed(steady_drive(d, 0.008), off), 0.04, 0.015,
           5e-4},
          {"load of 0.5 N m", d,
           changed(steady_drive(d, 0.012),
                   [&](MotionTask& t) {
                     steady(t), t.load_torque = Profile({{0.002, 0}, {0.002, 0.5}});
                   }),
           0.04, 0.015, 5e-4},
          {"frequency from 40.8 to 41.2 kHz", d,
           changed(steady_drive(d, 0.012),
                   [&](MotionTask& t) {
                     steady(t), t.frequency = Profile({{0.002, 40.8e3}, {0.002, 41.2e3}});
                   }),
           0.04, 0.015, 5e-4},
          {"burst of 64 periods at 43.6 kHz", burst,
           changed(steady_drive(burst, 0.008),
                   [](MotionTask& t) {
                     t.switched_off = {{64 / 43.6e3, t.duration}};
                   }),
           0.04, 0.03, 5e-4}};
}

struct Differences {
  double amplitude, speed, angle;  // the first two of the largest
};

Differences differences(const Motion& a, const Motion& b) {
  double amplitude = 0, speed = 0;
  Differences most{0, 0, 0};
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const MotionSample &p = a.samples[i], &q = b.samples[i];
    amplitude = std::max(amplitude, q.amplitude), speed = std::max(speed, std::abs(q.speed));
    most.amplitude = std::max(most.amplitude, std::abs(p.amplitude - q.amplitude));
    most.speed = std::max(most.speed, std::abs(p.speed - q.speed));
    most.angle = std::max(most.angle, std::abs(p.angle - q.angle));
  }
  return {most.amplitude / amplitude, most.speed / speed, most.angle};
}

TEST_CASE("the averaged engine follows the oscillating one in ten motions (M2.1, M9.1, M9.3)",
          "[motion][oscillating]") {
  for (const TwoEngines& one : ten_motions()) {
    CAPTURE(one.name);
    MotionTask task = one.task;
    task.output_times = times_to(task.duration, 1000);
    const Motion averaged = simulate(one.motor, task);
    task.engine = MotionEngine::oscillating;
    const Motion direct = simulate(one.motor, task);
    REQUIRE(averaged.status == "ok");
    REQUIRE(direct.status == "ok");
    REQUIRE(averaged.samples.size() == direct.samples.size());
    const Differences found = differences(averaged, direct);
    CHECK(found.amplitude < one.amplitude);
    CHECK(found.speed < one.speed);
    CHECK(found.angle < one.angle);
  }
}

}  // namespace
