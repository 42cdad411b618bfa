// SPDX-License-Identifier: Apache-2.0
#include "drive/drive.hpp"
#include "random_contact.hpp"
#include "random_ring.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>

#include <cmath>

// Properties of the curves of waves of random driven motors.
namespace {

using namespace twum;
using namespace twum::core;
using namespace twum::test;

// The largest wave that drives the rotor, by a scan of the force over the amplitude in steps of 1 %: H rises through the drive's
// force there.
double largest_driving(const DrivenWaves& waves, double speed) {
  double found = 0, before = 0;
  for (double a = 0.1 * waves.full_contact_amplitude(); a < largest_amplitude(waves); a *= 1.01) {
    const DrivenWave wave = waves.at(a, speed);
    const double force = wave.status == PointStatus::ok ? wave.force() : 0;
    if (before > 0 && before < waves.drive() && force >= waves.drive() && wave.torque > 0 &&
        waves.stability(waves.in_amplitude(a, speed)).stable())
      found = a;
    before = force;
  }
  return found;
}

// @param slices  of every tenth motor
void no_wave_is_missed(int motors, int speeds, int slices) {
  Dice dice(641);
  int driving = 0;
  for (int i = 0; i < motors; ++i) {
    MotorDesign design = random_ring(dice, i);
    if (i % 10 == 9) design.stator.radial_slices = slices;
    const Drive drive(design);
    const DrivenWaves& waves = drive.waves();
    const double fastest = waves.crest_speed_per_amplitude() * largest_amplitude(waves);
    for (int k = 1; k <= speeds; ++k) {
      const double speed = fastest * (k - 0.5) / speeds;
      const double scanned = largest_driving(waves, speed);
      if (scanned == 0) continue;
      const MotorPoint point = drive.at(speed);
      CAPTURE(i, speed, scanned, point.motor.mean.amplitude);
      // The scan finds an amplitude to 1 %.
      CHECK(point.solved.status == PointStatus::ok);
      CHECK(point.motor.mean.amplitude >= 0.98 * scanned);
      ++driving;
    }
  }
  CHECK(driving > motors);
}

}  // namespace

TEST_CASE("no wave that drives is missed by the curves (D2.8)", "[core][driven][brute_force]") {
  no_wave_is_missed(30, 12, 1);
}

TEST_CASE("no wave that drives is missed by the curves of a thousand motors (D2.8)",
          "[.long][core][driven][brute_force]") {
  no_wave_is_missed(1000, 60, 8);
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
