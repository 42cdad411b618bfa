// SPDX-License-Identifier: Apache-2.0
#include "drive/drive.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace twum;
using namespace twum::core;
using namespace twum::test;

namespace {

// Driven motors with soft and stiff layers, near and far from the resonance.
MotorDesign random_driven(Dice& dice, int index) {
  MotorDesign d;
  d.stator.resonance_frequency = 40e3;
  d.stator.frequency = 40e3 * dice.uniform(0.99, 1.12);
  d.stator.modal_mass = dice.log_uniform(5e-3, 0.1);
  d.stator.quality_factor = dice.log_uniform(30, 1000);
  d.stator.force_factor = dice.uniform(0.2, 1);
  d.stator.voltage = dice.log_uniform(10, 300);
  d.layer.youngs_modulus = dice.log_uniform(2e8, 1e10);
  if (index % 2) d.layer.given_inertia = d.layer.given_shear_viscosity = 0;
  d.friction.kinetic = d.friction.threshold = dice.uniform(0.1, 0.4);
  d.preload = dice.log_uniform(20, 400);
  return d;
}

}  // namespace

TEST_CASE("no wave is missed below the largest there can be (D2.7, D2.8)",
          "[core][driven][brute_force]") {
  Dice dice(91);
  int several = 0, compared = 0;
  for (int i = 0; i < 60; ++i) {
    const MotorDesign design = random_driven(dice, i);
    const Drive drive(design);
    const DrivenWaves& waves = drive.waves();
    const double crest = waves.crest_speed_per_amplitude() * 1e-6;
    const double speed = i % 3 == 0 ? 0 : dice.uniform(0, 1.3) * crest;
    const Vector<WaveSolution> found = drive.solutions(speed);
    // Twice as many samples a decade as bends need, to beyond the largest solution.
    std::vector<double> places;
    bool below = true;
    for (double a = 1e-12; a < 1e-3; a *= 1.02) {
      const DrivenWave wave = waves.at(a, speed);
      if (wave.status != PointStatus::ok) continue;
      if ((wave.force() < waves.drive()) != below) places.push_back(a), below = !below;
    }
    CAPTURE(i, speed, found.size(), places.size());
    CHECK(found.size() % 2 == 1);
    // Two solutions between neighbouring samples are found by their extremum alone.
    REQUIRE(found.size() >= places.size());
    for (const double place : places) {
      bool there = false;
      for (const WaveSolution& s : found)
        there |= s.wave().amplitude <= place && s.wave().amplitude >= place / 1.0201;
      CHECK(there);
    }
    for (const WaveSolution& s : found) {
      // The search ends within a few roundings of the amplitude.
      CHECK(s.wave().force() == Approx(waves.drive()).epsilon(1e-9));
      ++compared;
    }
    several += found.size() > 1;
  }
  CHECK(several > 3);
  CHECK(compared > 60);
}

TEST_CASE("the branch passes through the solutions at each of its speeds (D2.9, D2.11)",
          "[core][driven][identity]") {
  Dice dice(92);
  int points = 0;
  for (int i = 0; i < 40; ++i) {
    MotorDesign design = random_driven(dice, i);
    if (i % 3 == 0) design.stator.radial_slices = 4;
    const Drive drive(design);
    if (!drive.branch().exists()) continue;
    const double first = drive.branch().first().amplitude;
    const double crest = drive.waves().crest_speed_per_amplitude() * first;
    // Zones of the contact begin and end between some neighbouring speeds of the branch, so that there are many points.
    for (int k = 0; k < 12; ++k) {
      const double speed = drive.begin() + dice.uniform(0.01, 1.1) * crest;
      const MotorPoint point = drive.at(speed);
      if (point.solved.status != PointStatus::ok) continue;
      double nearest = 1;
      for (const WaveSolution& s : drive.solutions(speed))
        nearest =
            std::fmin(nearest, std::fabs(s.wave().amplitude / point.motor.mean.amplitude - 1));
      CAPTURE(i, speed, point.motor.mean.amplitude);
      // Both searches end within rounding of H, which its slope makes 1e-12 or less of the amplitude away from folds.
      CHECK(nearest <= 1e-10);
      ++points;
    }
  }
  CHECK(points > 200);
}

TEST_CASE("one turn from a state nearby leads to the periodic state and its balance (E6.2, D2.9)",
          "[core][driven][limit]") {
  Dice dice(93);
  int turns = 0;
  for (int i = 0; i < 60; ++i) {
    const Drive drive(
        random_driven(dice, 2 * i));  // an elastic layer keeps nothing from turn to turn
    const DrivenWaves& waves = drive.waves();
    const double a = dice.log_uniform(3e-7, 2e-6),
                 speed = dice.uniform(0.1, 0.9) * waves.crest_speed_per_amplitude() * a;
    const DrivenWaves::LevelSlopes at = waves.slopes(a, speed);
    const SolvedPoint& point = at.solved;
    // A disturbance of 1e-3 must not make a zone vanish: there the state has a kink, and no second order.
    if (point.status != PointStatus::ok || at.states.empty() || point.shortest_zone() < 0.05)
      continue;
    const double force = at.in_amplitude.wave.force();
    // What a step leaves of a small disturbance goes with its square: a tenth of it leaves a hundredth, within what comes of the
    // next order, down to rounding.
    double left_before = 0, off_before = 0;
    bool followed = true;
    for (const double share : {1e-3, 1e-4}) {
      const WarmStart start = moved(point.start(), at.states, share * a);
      const auto turn = point.newton_turn(waves.motor(a), speed, start, at.states);
      if (!turn) {
        followed = false;
        break;
      }
      const auto again = point.newton_turn(waves.motor(a), speed, turn->next, at.states);
      REQUIRE(again);
      const double off = std::fabs(waves.balance(turn->numbers, a).force() - force) / force;
      CAPTURE(i, share, turn->gap, again->gap, off);
      if (left_before > 0) {
        CHECK(again->gap <= 0.02 * left_before + 1e-13);
        CHECK(off <= 0.02 * off_before + 1e-13);
        ++turns;
      }
      left_before = again->gap, off_before = off;
    }
    if (!followed) continue;
    // Where the slopes lead is the state of a neighbouring amplitude, solved by itself, up to the second order.
    double error_before = 0;
    for (const double step : {1e-4, 1e-5}) {
      const SolvedPoint beside = solve_point(waves.motor(a * (1 + step)), speed);
      const contact::LayerState<double>
          p = moved(point.start(), at.states, step * a).of_slice(0).layer,
          q = beside.start().of_slice(0).layer;
      const double error = std::hypot(q.e - p.e, q.rate - p.rate);
      CAPTURE(i, step, error);
      if (error_before > 0) CHECK(error <= 0.02 * error_before + 1e-12);
      error_before = error;
    }
  }
  CHECK(turns > 20);
}
