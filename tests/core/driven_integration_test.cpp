// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/two_modes.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>

// The waves of a driven motor against an integration in time of its two modes with Coulomb's law at each place (D2.1, D2.5).
namespace {

using namespace twum;
using namespace twum::test;

// A place that begins to slip does so up to a step late, pi / 400 = 8e-3 of a radian in the mean: that much of the traction's part of the
// forces, a fifth of them, 1.6e-3 in phase; halving the step halves it. Torque and power feel it twofold.
constexpr double kAmplitude = 1e-3, kPhase = 3e-3, kTorque = 4e-3;

// Long enough for a disturbance that dies away with 2000 / s to fall to 1e-4, and what starts from a percent beside.
constexpr int kSettling = 250;

TwoModes settled(const MotorDesign& design, double speed, const WaveState& from, double share) {
  TwoModes motor(design, speed);
  motor.set_wave(share * from.amplitude, from.phase_lag);
  motor.run(kSettling);
  motor.run(100);  // the mean of these
  return motor;
}

// The voltage of one of the two phases leads by phi: the phase of Z is minus its lag.
void check_same(const TwoModes& found, const OperatingPoint& point, double torque_scale) {
  CHECK(std::abs(found.wave()) == Approx(point.amplitude).epsilon(kAmplitude));
  CHECK(std::remainder(-std::arg(found.wave()) - point.phase_lag, 6.283185307179586) ==
        Approx(0).margin(kPhase));
  CHECK(found.torque() == Approx(point.torque).margin(kTorque * torque_scale));
  CHECK(found.stator_power() ==
        Approx(point.stator_power).margin(2 * kTorque * point.stator_power));
}

}  // namespace

TEST_CASE("two modes settle on the wave of a running motor (D2.1)", "[core][driven][brute_force]") {
  const MotorDesign design = driven_motor();
  const Motor motor(design);
  for (const double speed : {8.0, 12.5}) {
    const TwoModes modes = settled(design, speed, motor.wave_states(speed).back(), 1.05);
    check_same(modes, motor.operating_point(speed), motor.holding_torque());
  }
}

TEST_CASE("below the free resonance two modes settle on the only wave (D2.1)",
          "[core][driven][brute_force]") {
  const MotorDesign design = driven_motor(120, 38.5e3);
  const Motor motor(design);
  const std::vector<WaveState> states = motor.wave_states(0.3);
  REQUIRE(states.size() == 1);
  const TwoModes found = settled(design, 0.3, states[0], 0.9);
  const OperatingPoint point = motor.operating_point(0.3);
  CHECK(std::abs(found.wave()) == Approx(point.amplitude).epsilon(kAmplitude));
  CHECK(-std::arg(found.wave()) == Approx(point.phase_lag).margin(kPhase));
  CHECK(found.torque() == Approx(point.torque).margin(kTorque * motor.holding_torque()));
}

TEST_CASE("two modes at rest keep the branch that they begin on (D2.1)",
          "[core][driven][brute_force]") {
  MotorDesign design = driven_motor(100);
  const std::vector<WaveState> states = Motor(design).wave_states(0);
  REQUIRE(states.size() == 3);
  check_same(settled(design, 0, states.back(), 1.02), Motor(design).operating_point(0),
             Motor(design).holding_torque());
  const TwoModes dead = settled(design, 0, states.front(), 1.1);
  CHECK(std::abs(dead.wave()) == Approx(states.front().amplitude).epsilon(kAmplitude));
  CHECK(-std::arg(dead.wave()) == Approx(states.front().phase_lag).margin(kPhase));
}

TEST_CASE("two modes start above the start voltage and stop below the hold voltage (D3.2)",
          "[core][driven][brute_force]") {
  const Motor motor(driven_motor());
  const double start = evaluate(motor, {Metric::start_voltage}).value,
               hold = evaluate(motor, {Metric::hold_voltage}).value;
  const auto ends_at = [](double from, double to, bool large) {
    const std::vector<WaveState> states = Motor(driven_motor(from)).wave_states(0);
    TwoModes modes(driven_motor(from), 0);
    const WaveState& begin = large ? states.back() : states.front();
    modes.set_wave(begin.amplitude, begin.phase_lag);
    modes.run(60);
    modes.set_voltage(to);
    modes.run(500);  // beside a fold things are slow
    modes.run(10);
    return std::abs(modes.wave());
  };
  // A static fold, passed in a small step; two percent beside it are far more than the integration's error.
  CHECK(ends_at(0.96 * start, 0.98 * start, false) < 0.3e-6);
  CHECK(ends_at(0.98 * start, 1.02 * start, false) > 1e-6);
  CHECK(ends_at(1.04 * hold, 1.02 * hold, true) > 0.9e-6);
  CHECK(ends_at(1.02 * hold, 0.98 * hold, true) < 0.3e-6);
}

TEST_CASE("two modes leave the dead wave under a turning rotor (D2.5)",
          "[core][driven][brute_force]") {
  const MotorDesign design = driven_motor(100);
  const std::vector<WaveState> states = Motor(design).wave_states(5);
  const WaveState& dead = states.front();
  REQUIRE(dead.determinant > 0);
  REQUIRE(dead.trace > 0);
  TwoModes modes(design, 5);
  modes.set_wave(1.01 * dead.amplitude, dead.phase_lag);
  modes.run(200);
  modes.run(1);
  CHECK(std::abs(std::abs(modes.wave()) - dead.amplitude) > 0.2 * dead.amplitude);
}
