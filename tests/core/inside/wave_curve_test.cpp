// SPDX-License-Identifier: Apache-2.0
#include "drive/drive.hpp"
#include "metrics/motor_curve.hpp"
#include "random_contact.hpp"
#include "random_ring.hpp"
#include "support/two_modes.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>

// Properties of the curves of waves of random driven motors.
namespace {

using namespace twum;
using namespace twum::core;
using namespace twum::test;

// Whether H is continuous between two amplitudes and has the drive's force there, by bisection.
bool holds_between(const DrivenWaves& waves, double speed, double low, double high) {
  DrivenWave wave;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    wave = waves.at(middle, speed);
    if (wave.status != PointStatus::ok) return false;
    (wave.force() < waves.drive() ? low : high) = middle;
  }
  // 1 % of the amplitude, over 2^30.
  return std::fabs(wave.force() / waves.drive() - 1) < 1e-8;
}

// The largest wave that drives the rotor, by a scan of the force over the amplitude in steps of 1 %: H rises through the drive's
// force there.
double largest_driving(const DrivenWaves& waves, double speed) {
  double found = 0, before = 0;
  for (double a = 0.1 * waves.full_contact_amplitude(); a < largest_amplitude(waves); a *= 1.01) {
    const DrivenWave wave = waves.at(a, speed);
    const double force = wave.status == PointStatus::ok ? wave.force() : 0;
    if (before > 0 && before < waves.drive() && force >= waves.drive() && wave.torque > 0 &&
        waves.stability(waves.in_amplitude(a, speed)).stable() &&
        holds_between(waves, speed, a / 1.01, a))
      found = a;
    before = force;
  }
  return found;
}

// The largest wave at a speed of the running branch or the dead one, which may drive as well; 0 without a wave.
double largest_followed(const Drive& running, const Drive& dead, double speed) {
  double largest = 0;
  for (const Drive* drive : {&running, &dead}) {
    const MotorPoint point = drive->at(speed);
    if (point.solved.status == PointStatus::ok)
      largest = std::fmax(largest, point.motor.mean.amplitude);
  }
  return largest;
}

// Returns the speeds at which a wave drives.
int no_wave_is_missed(MotorDesign design, int speeds) {
  const Drive drive(design);
  design.stator.branch = Branch::dead;
  const Drive dead(design);
  const DrivenWaves& waves = drive.waves();
  const double fastest = waves.crest_speed_per_amplitude() * largest_amplitude(waves);
  int driving = 0;
  for (int k = 1; k <= speeds; ++k) {
    const double speed = fastest * (k - 0.5) / speeds;
    const double scanned = largest_driving(waves, speed);
    if (scanned == 0) continue;
    CAPTURE(speed, scanned);
    // The scan finds an amplitude to 1 %.
    CHECK(largest_followed(drive, dead, speed) >= 0.98 * scanned);
    ++driving;
  }
  return driving;
}

// @param slices  of every tenth motor
void no_wave_of_motors_is_missed(int motors, int speeds, int slices) {
  Dice dice(641);
  int driving = 0;
  for (int i = 0; i < motors; ++i) {
    MotorDesign design = random_ring(dice, i);
    if (i % 10 == 9) design.stator.radial_slices = slices;
    INFO("motor " << i);
    driving += no_wave_is_missed(design, speeds);
  }
  CHECK(driving > motors);
}

// Between 0.4957 and 1.7 rad/s an edge of its track has no periodic state where its waves are.
MotorDesign motor_with_a_gap_of_speeds() {
  Dice dice(641);
  MotorDesign design;
  for (int i = 0; i < 690; ++i) design = random_ring(dice, i);
  design.stator.radial_slices = 8;
  return design;
}

}  // namespace

TEST_CASE("no wave that drives is missed by the curves (D2.8)", "[core][driven][brute_force]") {
  no_wave_of_motors_is_missed(30, 12, 1);
}

TEST_CASE("a branch goes on beyond speeds without a periodic state (D2.8)",
          "[core][driven][brute_force]") {
  CHECK(no_wave_is_missed(motor_with_a_gap_of_speeds(), 30) > 10);
}

// The amplitude at which two modes come to rest from a large wave, if they do and drive the rotor; else 0.
double integrated(const MotorDesign& design, double speed, double amplitude, double lag) {
  TwoModes modes(design, speed);
  modes.set_wave(amplitude, lag);
  modes.run(400);
  modes.run(50);
  const double before = std::abs(modes.wave());
  modes.run(50);
  const double after = std::abs(modes.wave());
  return std::fabs(after / before - 1) < 1e-3 && modes.torque() > 0 ? after : 0;
}

// Returns on how many waves the two modes settled.
int no_settled_wave_is_missed(int motors) {
  Dice dice(645);
  int settled = 0;
  for (int i = 0; i < motors; ++i) {
    MotorDesign design = random_ring(dice, 3 * i);  // elastic layers
    const Drive drive(design);
    design.stator.branch = Branch::dead;
    const Drive dead(design);
    const double largest = largest_amplitude(drive.waves());
    const double fastest = drive.waves().crest_speed_per_amplitude() * largest;
    for (const double part : {0.1, 0.3, 0.5, 0.8})
      for (const double lag : {1.8, 2.8}) {
        const double speed = part * fastest;
        const double found = integrated(design, speed, 0.9 * largest, lag);
        if (found == 0) continue;
        CAPTURE(i, speed, found, lag);
        // A step of the integration is 1e-3 of the amplitude, and what has not settled as much; ten times that.
        CHECK(largest_followed(drive, dead, speed) >= 0.98 * found);
        ++settled;
      }
  }
  return settled;
}

TEST_CASE("no wave on which two modes settle in time is missed by the curves (D2.1, D2.8)",
          "[core][driven][brute_force]") {
  CHECK(no_settled_wave_is_missed(3) > 5);
}

TEST_CASE("no wave on which two modes of twenty motors settle is missed by the curves (D2.1, D2.8)",
          "[.long][core][driven][brute_force]") {
  CHECK(no_settled_wave_is_missed(20) > 40);
}

TEST_CASE("no wave that drives is missed by the curves of a thousand motors (D2.8)",
          "[.long][core][driven][brute_force]") {
  no_wave_of_motors_is_missed(1000, 60, 8);
}

namespace {

// Points of the whole curve come from Motor::operating_point(). Motors with mu_0 > mu are always followed as a whole.
void one_speed_tells_what_the_curve_does(int motors) {
  Dice dice(644);
  int from_rest = 0, others = 0;
  for (int i = 0; i < motors; ++i) {
    MotorDesign design = random_ring(dice, i);
    if (i % 10 == 9) design.stator.radial_slices = 8;
    if (design.friction.threshold > design.friction.kinetic) continue;
    const Motor motor(design);
    const DrivenWaves waves = Drive::waves_of(design);
    const double fastest = waves.crest_speed_per_amplitude() * largest_amplitude(waves);
    const bool at_rest = motor.operating_point(0.0).status == PointStatus::ok;
    for (int k = 0; k < 8; ++k) {
      const double speed = fastest * (k - 0.2) / 6;
      const MetricValue one = evaluate(motor, {Metric::torque_at, Argument::speed, speed});
      const OperatingPoint of_curve = motor.operating_point(speed);
      CAPTURE(i, speed);
      CHECK(one.status == metric_status(of_curve.status));
      if (one.status != MetricStatus::ok) continue;
      // The amplitude is right to 1e-12, and the torque of a motor is at most some hundred times as sensitive.
      CHECK(one.value ==
            Approx(of_curve.torque).epsilon(1e-9).margin(1e-10 * motor.holding_torque()));
      ++(at_rest ? from_rest : others);
    }
  }
  CHECK(from_rest > motors / 2);
  CHECK(others > motors / 2);
}

}  // namespace

TEST_CASE("a point metric of one speed is that of the whole curve (D2.8)",
          "[core][driven][identity]") {
  one_speed_tells_what_the_curve_does(120);
}

TEST_CASE("a point metric of one speed is that of the whole curve, for a thousand motors (D2.8)",
          "[.long][core][driven][identity]") {
  one_speed_tells_what_the_curve_does(1000);
}

TEST_CASE("thresholds put back give the voltage (D3.2, D3.4)", "[core][driven][identity]") {
  Dice dice(642);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = random_ring(dice, i % 3 == 2 ? 3 * i : i);
    const double voltage = *design.stator.voltage;
    for (const auto& [frequency, volts] :
         {std::pair{Metric::start_frequency, Metric::start_voltage},
          std::pair{Metric::pull_out_frequency, Metric::hold_voltage}}) {
      const MetricValue f = evaluate(Motor(design), {frequency});
      if (f.status != MetricStatus::ok) continue;
      MotorDesign there = design;
      there.stator.frequency = f.value;
      CAPTURE(i, info(frequency).name, f.value);
      // Newton's method leaves 1e-9 of the distance to the resonance; H follows it by a power near one.
      CHECK(evaluate(Motor(there), {volts}).value == Approx(voltage).epsilon(1e-7));
      ++compared;
    }
  }
  CHECK(compared > 40);
}

TEST_CASE("the pull-out torque is smooth over the voltage (D2.9)", "[core][driven][limit]") {
  Dice dice(643);
  int compared = 0;
  for (int i = 0; i < 120 && compared < 12; ++i) {
    MotorDesign design = random_ring(dice, i % 3 == 2 ? 3 * i : i);
    double torque[4];
    bool pulls_out = true;
    for (int k = 0; k < 4; ++k) {
      MotorDesign there = design;
      there.stator.voltage = *design.stator.voltage + 1e-5 * k;
      const MetricValue found = evaluate(Motor(there), {Metric::pull_out_torque});
      pulls_out = pulls_out && found.status == MetricStatus::ok;
      torque[k] = found.value;
    }
    if (!pulls_out) continue;
    const double first = torque[1] - torque[0], second = torque[2] - 2 * torque[1] + torque[0],
                 next = torque[3] - 2 * torque[2] + torque[1];
    CAPTURE(i, first, second, next);
    // Rounding leaves 1e-14 of the torque's scale, a step 1e-6 of it.
    CHECK(std::fabs(second) <= 1e-4 * std::fabs(first) + 1e-13);
    CHECK(std::fabs(next) <= 1e-4 * std::fabs(first) + 1e-13);
    ++compared;
  }
  CHECK(compared == 12);
}
