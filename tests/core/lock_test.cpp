// SPDX-License-Identifier: Apache-2.0
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// A rotor at rest that the wave cannot move: whether it is locked, asked place by place.
namespace {

using namespace twum;
using namespace twum::test;

// The constant tractions [Pa] with which a layer that follows the stator everywhere stays below the threshold of
// friction, at 20,000 places, and what its viscosity takes meanwhile.
struct Following {
  double least, most;
  double loss;  // [W], by the rectangle rule, which is exact here
  double mean;  // mu_0 times the mean pressure [Pa]
  double track_area;
};

Following following(const MotorDesign& d) {
  const Stator& s = d.stator;
  const double omega = 2 * std::numbers::pi * s.frequency, kappa = s.wavelengths / s.contact_radius;
  const double wave = d.layer.youngs_modulus * s.amplitude / d.layer.thickness;
  const double area = 2 * std::numbers::pi * s.contact_radius * s.contact_width;
  const double mean = d.preload / area;
  // h eps = (V0 / omega) sin theta: the surface moves as the stator does, eps' = V0 cos theta / (h omega).
  const double strain = kappa * s.neutral_plane_distance * s.amplitude / d.layer.thickness;
  const double stiff = shear_modulus(d) - inertia(d) * omega * omega;
  const double viscous = shear_viscosity(d) * omega;
  Following f{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0,
              d.friction.threshold * mean, area};
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const double theta = 2 * std::numbers::pi * i / kPlaces;
    const double threshold = d.friction.threshold * (wave * std::cos(theta) + mean);
    const double traction = strain * (stiff * std::sin(theta) + viscous * std::cos(theta));
    f.least = std::max(f.least, -threshold - traction);
    f.most = std::min(f.most, threshold - traction);
    const double rate = strain * omega * std::cos(theta);  // of the strain in time
    f.loss += shear_viscosity(d) * rate * rate * area * d.layer.thickness / kPlaces;
  }
  return f;
}

// Between two of the places the ends miss their extremes by less than (pi / 20,000)^2 of the amplitudes, some
// ten times the mean pressure at most.
constexpr double kMissed = 1e-5;

MotorDesign random_full_contact(Uniform& random) {
  MotorDesign design = ring_motor();
  design.friction.threshold = design.friction.kinetic * random(1, 1.5);
  design.layer.given_shear_modulus = random.logarithmic(3e7, 1e10);
  design.layer.loss_factor = random.chance(0.2) ? 0 : random.logarithmic(0.01, 3);
  if (random.chance(0.5)) design.layer.given_inertia = 0;
  design.preload = random(1.01, 8) * full_contact_load(design);
  return design;
}

}  // namespace

TEST_CASE("a motor is locked where some constant traction keeps to the threshold all round",
          "[core][edge][brute_force]") {
  Uniform random(31);
  int locked = 0, free = 0;
  for (int i = 0; i < 400; ++i) {
    const MotorDesign design = random_full_contact(random);
    const Following f = following(design);
    const double left = (f.most - f.least) / f.mean;
    if (std::abs(left) < kMissed) continue;
    CAPTURE(i, left);
    CHECK(Motor(design).locks_at_rest() == (left > 0));
    ++(left > 0 ? locked : free);
  }
  CHECK(locked > 50);
  CHECK(free > 50);
}

TEST_CASE("a motor of unit friction or unit preload locks like any other", "[core][edge][limit]") {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1e7;
  design.layer.given_inertia = 0;
  design.preload = 8 * full_contact_load(design);
  for (const double mu : {1.0, 1 - 1e-9}) {
    design.friction = {mu, mu};
    REQUIRE(following(design).most > following(design).least);
    CHECK(Motor(design).locks_at_rest());
  }
  // As narrow as 1 N asks for: pressures and tractions stay (C8.11).
  design.stator.contact_width /= design.preload;
  design.preload = 1;
  REQUIRE(following(design).most > following(design).least);
  CHECK(Motor(design).locks_at_rest());
}

TEST_CASE("without a wave friction locks a motor, and without friction or preload nothing does",
          "[core][edge][limit]") {
  MotorDesign still = ring_motor();
  still.stator.amplitude = 0;
  CHECK(Motor(still).locks_at_rest());
  MotorDesign unloaded = still;
  unloaded.preload = 0;
  CHECK_FALSE(Motor(unloaded).locks_at_rest());
  MotorDesign frictionless = still;
  frictionless.friction = {0, 0};
  CHECK_FALSE(Motor(frictionless).locks_at_rest());
  MotorDesign driven = ring_motor();
  driven.friction = {0, 0};
  CHECK_FALSE(Motor(driven).locks_at_rest());
  driven.preload = 8 * full_contact_load(driven);
  CHECK_FALSE(Motor(driven).locks_at_rest());
}

TEST_CASE("a locked layer follows the stator and takes its viscous loss (T7.4, T7.12)",
          "[core][edge][quadrature]") {
  Uniform random(32);
  int locked = 0;
  for (int i = 0; i < 400; ++i) {
    MotorDesign design = random_full_contact(random);
    design.friction.threshold = design.friction.kinetic;
    const Following f = following(design);
    if (!(f.most - f.least > kMissed * f.mean)) continue;
    ++locked;
    CAPTURE(i);
    const Motor motor(design);
    const OperatingPoint point = motor.operating_point(0);
    REQUIRE(point.status == PointStatus::ok);
    const double torque = f.track_area * design.stator.contact_radius * f.least;
    CHECK(std::abs(point.torque - torque) <= kMissed * motor.holding_torque());
    // Rounding of 20,000 terms.
    CHECK(std::abs(point.stator_power - f.loss) <= 1e-12 * f.loss);
    CHECK(std::abs(point.layer_loss - f.loss) <= 1e-12 * f.loss);
    CHECK(point.friction_power == 0);
    CHECK(point.output_power == 0);
    CHECK(point.stick_fraction == 1);
  }
  CHECK(locked > 50);
}

TEST_CASE("a motor that holds no load has no peak of power to speak of (T7.16)",
          "[core][edge][limit]") {
  MotorDesign without_friction = ring_motor();
  without_friction.friction = {0, 0};
  MotorDesign locked = ring_motor();
  locked.layer.given_shear_modulus = 1e7;
  locked.layer.given_inertia = 0;
  locked.preload = 8 * full_contact_load(locked);
  for (const MotorDesign& design : {without_friction, locked}) {
    const Motor motor(design);
    for (const Metric which : {Metric::peak_power, Metric::speed_at_peak_power})
      CHECK(evaluate(motor, MetricRequest{which}).value == 0);
    for (const Metric which :
         {Metric::torque_at_peak_power, Metric::contact_efficiency_at_peak_power})
      CHECK(evaluate(motor, MetricRequest{which}).status == MetricStatus::undefined);
  }
}
