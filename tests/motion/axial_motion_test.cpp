// SPDX-License-Identifier: Apache-2.0
// Motions of the averaged engine in which the rotor moves along its axis by its mass (M4.5).
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

MotorDesign with_mass(double inertia, double mass, double damping) {
  MotorDesign d = elastic_60(inertia);
  d.rotor.mass = mass, d.rotor.axial_damping = damping;
  return d;
}

MotionTask start_of(const MotorDesign& d, double duration, AxialMotion axial) {
  MotionTask task = steady_drive(d, duration);
  task.axial = axial;
  task.output_times = times_to(duration, 400);
  return task;
}

double largest_difference(const Motion& a, const Motion& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.samples.size(); ++k)
    largest = std::max(largest, std::abs(a.samples[k].speed - b.samples[k].speed));
  return largest;
}

TEST_CASE(
    "a start with an axial mass is nearer to the oscillating engine than a balanced one (M4.5)",
    "[motion][axial][differential]") {
  // motion.md: within 0.35 rad/s of 0.1 kg and 0.38 of 0.3 kg, in place of 0.55 to 0.82 and 1.26, at 1,000 to 1,600 contacts.
  struct Rotor {
    double mass, damping, dynamic, balanced;  // [kg, N s/m, rad/s]
  };
  for (const Rotor& rotor :
       {Rotor{0.1, 300, 0.35, 0.5}, Rotor{0.1, 1000, 0.35, 0.7}, Rotor{0.3, 1000, 0.38, 1.2}}) {
    CAPTURE(rotor.mass);
    const MotorDesign d = with_mass(7e-6, rotor.mass, rotor.damping);
    MotionTask task = start_of(d, 0.004, AxialMotion::dynamic);
    const Motion dynamic = simulate(d, task);
    task.axial = AxialMotion::balanced;
    const Motion balanced = simulate(d, task);
    task.engine = MotionEngine::oscillating, task.accuracy = 2;
    const Motion oscillating = simulate(d, task);
    REQUIRE(dynamic.status == "ok");
    REQUIRE(oscillating.status == "ok");
    const double near = largest_difference(dynamic, oscillating),
                 far = largest_difference(balanced, oscillating);
    CAPTURE(near, far, dynamic.contacts);
    CHECK(near < rotor.dynamic);
    CHECK(far > rotor.balanced);
    CHECK(dynamic.contacts < 1700);
  }
}

TEST_CASE("a motion with an axial mass ends in the balanced steady state (M4.5)",
          "[motion][axial][identity]") {
  const MotorDesign d = with_mass(1e-4, 0.1, 1000);
  for (const bool steady : {false, true}) {
    MotionTask task = start_of(d, 0.03, AxialMotion::dynamic);
    task.initial.steady = steady, task.load_torque = 0.2;
    const Motion m = simulate(d, task);
    REQUIRE(m.status == "ok");
    const Motor motor(d);
    const double speed = evaluate(motor, {Metric::speed_at, Argument::torque, 0.2}).value;
    const OperatingPoint p = motor.operating_point(speed);
    CHECK(m.last.speed == Approx(speed).epsilon(1e-6));  // the integration's tolerance
    CHECK(m.last.amplitude == Approx(p.amplitude).epsilon(1e-6));
    CHECK(m.last.torque == Approx(0.2).epsilon(1e-5));
  }
}

TEST_CASE("an undamped rotor hops out of its steady state at its rate (M4.5)",
          "[motion][axial][linear]") {
  const MotorDesign d = with_mass(1e-4, 0.1, 0);
  const double rate = bounce_rate(d, 0);
  const LinearPlant plant = linearize(d, 0, AxialMotion::dynamic);
  REQUIRE(plant.states.size() == 6);
  CHECK(plant.states[4].name == "height");
  CHECK(plant.states[5].name == "rise");
  const auto pole =
      std::ranges::max_element(plant.poles, {}, [](const auto& p) { return std::abs(p.imag()); });
  CHECK(pole->real() == Approx(rate).epsilon(1e-9));
  // Gains do not know of the height.
  const LinearPlant balanced = linearize(d, 0);
  for (std::size_t input = 0; input < 3; ++input)
    CHECK(plant.gains[2][input] == Approx(balanced.gains[2][input]).epsilon(1e-9));
  // From a small step of the load the hops grow e-fold in 1 / rate: the torque swings around its mean.
  MotionTask task = steady_drive(d, 4.2e-3);
  task.axial = AxialMotion::dynamic;
  task.initial.steady = true;
  task.load_torque = Profile({{0, 0}, {0, 1e-3}});
  task.output_times = times_to(4.2e-3, 8400);
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const auto swing = [&](double from, double to) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const MotionSample& s : m.samples)
      if (s.time >= from && s.time < to)
        low = std::min(low, s.torque), high = std::max(high, s.torque);
    return high - low;
  };
  // Ten hops each; the slow poles have died away to e^-1.7 of a step that moves the torque by 1e-3 N m, and evenly.
  const double grown = std::log(swing(4e-3, 4.2e-3) / swing(3e-3, 3.2e-3)) / 1e-3;
  CHECK(grown == Approx(rate).epsilon(0.05));
}

TEST_CASE("the height of a balanced rotor is that of the edge of its contact (C21.7)",
          "[motion][axial][identity]") {
  for (const double voltage : {90.0, 140.0, 300.0}) {
    MotorDesign d = with_mass(1e-4, 0.1, 300);
    d.stator.voltage = voltage;
    const LinearPlant plant = linearize(d, 0, AxialMotion::dynamic);
    const double amplitude = plant.states[0].steady;
    d.stator.voltage.reset(), d.stator.amplitude = amplitude;
    const double half_length =
        evaluate(Motor(d), {Metric::contact_half_length}).value;  // theta_L r / n
    CHECK(plant.states[4].steady ==
          Approx(amplitude * std::cos(half_length * 9 / 0.0265)).epsilon(1e-10));
  }
}

TEST_CASE("an axial motion needs a mass and one contact radius", "[motion][axial][errors]") {
  MotorDesign d = elastic_60(1e-4);
  CHECK_THROWS_WITH(simulate(d, start_of(d, 1e-3, AxialMotion::dynamic)),
                    Catch::Matchers::Contains("rotor_mass is missing"));
  CHECK_THROWS_WITH(linearize(d, 0, AxialMotion::dynamic),
                    Catch::Matchers::Contains("rotor_mass is missing"));
  d.rotor.mass = 0.1, d.stator.radial_slices = 4;
  CHECK_THROWS_WITH(simulate(d, start_of(d, 1e-3, AxialMotion::dynamic)),
                    Catch::Matchers::Contains("radial_slices must be 1"));
}

}  // namespace
