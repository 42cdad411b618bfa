// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "drive/driven_wave.hpp"
#include "held/holding.hpp"
#include "held/torque_law.hpp"
#include "random_contact.hpp"
#include "support/driven_motors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

using namespace twum;
using namespace twum::core;

namespace {

// Motors of many sizes, from stiff layers to soft ones whose contact is full at first; every other one has an elastic layer.
MotorDesign random_motor(test::Dice& dice, int index) {
  MotorDesign design = test::driven_motor_with_layer();
  Stator& s = design.stator;
  s.radial_slices = 1;
  s.wavelengths = std::floor(dice.uniform(2, 13));
  s.contact_radius = dice.log_uniform(5e-3, 45e-3), s.contact_width = dice.uniform(0.5e-3, 6e-3);
  s.neutral_plane_distance = dice.uniform(1e-3, 6e-3);
  s.frequency = dice.log_uniform(20e3, 95e3), s.resonance_frequency = 0.97 * s.frequency;
  design.layer.thickness = dice.log_uniform(0.05e-3, 2e-3);
  design.layer.youngs_modulus = dice.log_uniform(4e6, 5e9);
  design.layer.poisson_ratio = dice.uniform(0.25, 0.48);
  design.layer.density = dice.uniform(800, 2500);
  design.layer.loss_factor = dice.log_uniform(0.002, 0.4);
  if (index % 2 == 1) design.layer.given_inertia = design.layer.given_shear_viscosity = 0;
  design.friction.kinetic = design.friction.threshold = dice.uniform(0.08, 0.45);
  design.preload = dice.log_uniform(5, 900);
  return design;
}

// Of a rotor that waves of 20 nm to 4 um carry along.
double random_speed(test::Dice& dice, const DrivenWaves& waves) {
  return std::min(60.0, dice.log_uniform(2e-8, 4e-6) * waves.crest_speed_per_amplitude());
}

// The first of many small steps of ln A, from the crest as fast as the rotor on, behind which the torque has reached a load: its
// upper end. 0 if there is none.
double first_by_small_steps(const DrivenWaves& waves, double torque, double speed, double step) {
  const double crest = speed / waves.crest_speed_per_amplitude();
  WarmStart start;
  for (int i = 0; i * step < 9; ++i) {
    const double amplitude = crest * std::exp(i * step);
    const DrivenWave wave = waves.at(amplitude, speed, i > 0 ? &start : nullptr);
    if (wave.status != PointStatus::ok) return 0;
    if (wave.torque >= torque) return amplitude;
    start = wave.start;
  }
  return 0;
}

}  // namespace

TEST_CASE("the held wave of random motors is the first of many small steps (Y2.1)",
          "[core][held][property]") {
  constexpr double kStep = 0.02;
  test::Dice dice(11);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const MotorDesign design = random_motor(dice, i);
    const DrivenWaves waves(design, {});
    const double speed = random_speed(dice, waves);
    const double torque = dice.uniform(0, 0.98) * LoadedWaves(waves, speed).plateau();
    const double above = first_by_small_steps(waves, torque, speed, kStep);
    if (above == 0) continue;
    const HeldPoint held = Holding(design, {}, speed, DriveControl::amplitude).held(torque);
    CAPTURE(i, above, held.amplitude, to_string(held.status));
    REQUIRE(held.status == HeldStatus::ok);
    CHECK(held.amplitude <= above * (1 + 1e-12));
    CHECK(held.amplitude >= above * std::exp(-kStep) * (1 - 1e-12));
    CHECK(std::fabs(held.point.torque - torque) <= 1e-9 * LoadedWaves(waves, speed).plateau());
    ++compared;
  }
  CHECK(compared > 450);
}

TEST_CASE("torques held one after the other are those held alone, in any order (Y2.1)",
          "[core][held][identity]") {
  test::Dice dice(5);
  int held_points = 0;
  for (int i = 0; i < 40; ++i) {
    const MotorDesign design = random_motor(dice, i);
    const DrivenWaves waves(design, {});
    const double speed = dice.log_uniform(2e-8, 1e-6) * waves.crest_speed_per_amplitude();
    const double most = LoadedWaves(waves, speed).plateau();
    for (const DriveControl control :
         {DriveControl::amplitude, DriveControl::voltage, DriveControl::frequency}) {
      Holding line(design, {}, speed, control);
      for (const double share : {0.1, 0.2, 0.3, 0.6, 0.95, 1.2, 0.7, 0.65, -0.2}) {
        const HeldPoint one = line.held(share * most),
                        alone = Holding(design, {}, speed, control).held(share * most);
        CAPTURE(i, static_cast<int>(control), share, to_string(one.status));
        CHECK(one.status == alone.status);
        if (!(alone.amplitude > 0)) continue;
        // Where the voltage is just enough (Y2.3) is singular, and the wave right to the root of rounding.
        CHECK(one.amplitude == Approx(alone.amplitude).epsilon(1e-8));
        CHECK(one.frequency == Approx(alone.frequency).epsilon(1e-8));
        ++held_points;
      }
    }
  }
  CHECK(held_points > 500);
}

TEST_CASE("the torque law is close to the waves of usual elastic layers (Y2.7)", "[core][held]") {
  const MotorDesign design = test::driven_motor();
  const DrivenWaves waves(design, {});
  const double speed = 9, most = LoadedWaves(waves, speed).plateau();
  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 0.95}) {
    const HeldPoint held = Holding(design, {}, speed, DriveControl::amplitude).held(share * most);
    CAPTURE(share);
    CHECK(TorqueLaw(waves, speed).amplitude(share) == Approx(held.amplitude).epsilon(0.05));
  }
}

TEST_CASE("the force of the traction is close to that of usual elastic layers (Y2.8)",
          "[core][held]") {
  const MotorDesign design = test::driven_motor();
  for (const double speed : {3.0, 9.0, 15.0})
    for (const double share : {0.05, 0.2, 0.4, 0.6, 0.8}) {
      const double torque = share * LoadedWaves(DrivenWaves(design, {}), speed).plateau();
      const HeldPoint held = Holding(design, {}, speed, DriveControl::frequency).held(torque);
      const DrivenMotor<double> motor = DrivenWaves(design, {})
                                            .at_frequency(2 * std::numbers::pi * held.frequency)
                                            .motor(held.amplitude);
      const double stuck = likely_traction(motor, speed, 0);
      CAPTURE(speed, share);
      CHECK(held.point.reactive_force - motor.mean.pressure_force ==
            Approx(likely_traction(motor, speed, share)).margin(0.1 * stuck));
    }
}

TEST_CASE("the torque of a layer that does not ring rises with the amplitude in a partial contact",
          "[core][held][property]") {
  constexpr double kStep = 0.02;
  test::Dice dice(23);
  int risen = 0;
  for (int i = 0; i < 1500; ++i) {
    MotorDesign design = random_motor(dice, 0);
    design.layer.loss_factor = dice.log_uniform(0.02, 0.4);
    const DrivenWaves waves(design, {});
    const double speed = random_speed(dice, waves);
    const double at_crest = speed / waves.crest_speed_per_amplitude();
    const LoadedWaves loaded(waves, speed);
    if (loaded.rings(waves.omega()) || at_crest <= waves.full_contact_amplitude()) continue;
    CAPTURE(i, speed);
    // Far above rounding, and far below a ripple, which is a wave of the layer's own.
    const double noise = 1e-10 * loaded.plateau();
    double last = -HUGE_VAL;
    for (double x = 0; x < 4 && last < (1 - 1e-9) * loaded.plateau(); x += kStep) {
      const LoadedWave wave = loaded.found(at_crest * std::exp(x), waves.omega());
      if (!wave.ok()) break;
      CHECK(wave.torque >= last - noise);
      last = wave.torque;
    }
    ++risen;
  }
  CHECK(risen > 100);
}

namespace {

// Motors under a voltage whose layers ring, every third one with mu_0 > mu.
MotorDesign random_ringing_motor(test::Dice& dice, int index) {
  MotorDesign design = test::driven_motor_with_layer();
  Stator& s = design.stator;
  s.radial_slices = 1;
  s.resonance_frequency = dice.log_uniform(25e3, 70e3);
  s.frequency = dice.uniform(1.005, 1.06) * *s.resonance_frequency;
  s.modal_damping = dice.uniform(15, 80), s.voltage = dice.uniform(60, 300);
  design.layer.thickness = dice.log_uniform(0.2e-3, 2e-3);
  design.layer.youngs_modulus = dice.log_uniform(1e8, 3e9);
  design.layer.density = dice.uniform(700, 3000);
  design.layer.loss_factor = dice.log_uniform(0.01, 0.1);
  const double kinetic = dice.uniform(0.08, 0.4);
  design.friction = {kinetic, index % 3 == 2 ? dice.uniform(1.05, 1.5) * kinetic : kinetic};
  design.preload = dice.log_uniform(20, 400);
  return design;
}

// (Y2.3) by its own iteration, from an omega nearby; nothing where the voltage is too low.
std::optional<DrivenWave> on_flank(const DrivenWaves& waves, double amplitude, double& omega,
                                   double speed) {
  for (int i = 0; i < 60; ++i) {
    const DrivenWave wave = waves.at_frequency(omega).at(amplitude, speed);
    const double drive = waves.drive(), reactive = wave.balance.imaginary;
    if (wave.status != PointStatus::ok || std::fabs(reactive) > drive) return {};
    const double gap = wave.balance.real + std::sqrt(drive * drive - reactive * reactive);
    const double next = std::sqrt(omega * omega + gap / (waves.modes().mass * amplitude));
    if (std::fabs(next - omega) <= 1e-11 * omega) return wave;
    omega = next;
  }
  return {};
}

}  // namespace

TEST_CASE("a drive that follows by frequency holds the first wave of its flank (Y2.1, Y2.3)",
          "[core][held][property]") {
  constexpr double kStep = 0.02, kBelow = 0.25;
  test::Dice dice(41);
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    const MotorDesign design = random_ringing_motor(dice, i);
    const DrivenWaves waves(design, {});
    const double speed = dice.log_uniform(1, 20);
    const double plateau = LoadedWaves(waves, speed).plateau();
    const double torque = dice.uniform(0.02, 0.95) * plateau;
    const HeldPoint held = Holding(design, {}, speed, DriveControl::frequency).held(torque);
    if (held.status != HeldStatus::ok) continue;
    CAPTURE(i, speed, torque, held.amplitude, held.frequency);
    double omega = 2 * std::numbers::pi * held.frequency;
    const auto there = on_flank(waves, held.amplitude, omega, speed);
    REQUIRE(there);
    CHECK(omega == Approx(2 * std::numbers::pi * held.frequency).epsilon(1e-9));
    CHECK(std::fabs(there->torque - torque) <= 1e-9 * plateau);
    omega *= 1.3;
    for (double part = kBelow; part < 1 - 1e-6; part *= std::exp(kStep)) {
      const auto wave = on_flank(waves, part * held.amplitude, omega, speed);
      if (wave) CHECK(wave->torque < torque);
      if (!wave) omega = 2.2 * std::numbers::pi * held.frequency;
    }
    ++compared;
  }
  CHECK(compared > 500);
}
