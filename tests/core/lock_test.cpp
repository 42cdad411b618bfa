// SPDX-License-Identifier: Apache-2.0
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/motor.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// A rotor at rest that the wave cannot move: whether it is locked, asked place by place.
namespace {

using namespace twum;
using namespace twum::test;

// What is left between the largest and the smallest constant traction with which a layer that follows the
// stator everywhere stays below the threshold of friction, at 20,000 places, in units of mu_0 times the
// mean pressure; negative: there is none.
double room(const MotorDesign& d) {
  const Stator& s = d.stator;
  const double omega = 2 * std::numbers::pi * s.frequency, kappa = s.wavelengths / s.contact_radius;
  const double wave = d.layer.youngs_modulus * s.amplitude / d.layer.thickness;
  const double mean = d.preload * kappa / (2 * std::numbers::pi * s.wavelengths * s.contact_width);
  // h eps = (V0 / omega) sin theta: the surface moves as the stator does, eps' = V0 cos theta / (h omega).
  const double strain = kappa * s.neutral_plane_distance * s.amplitude / d.layer.thickness;
  const double stiff = shear_modulus(d) - inertia(d) * omega * omega;
  const double viscous = shear_viscosity(d) * omega;
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const double theta = 2 * std::numbers::pi * i / kPlaces;
    const double threshold = d.friction.static_ * (wave * std::cos(theta) + mean);
    const double traction = strain * (stiff * std::sin(theta) + viscous * std::cos(theta));
    least = std::max(least, -threshold - traction);
    most = std::min(most, threshold - traction);
  }
  return (most - least) / (d.friction.static_ * mean);
}

}  // namespace

TEST_CASE("a motor is locked where some constant traction keeps to the threshold all round",
          "[core][edge][brute_force]") {
  Uniform random(31);
  int locked = 0, free = 0;
  for (int i = 0; i < 400; ++i) {
    MotorDesign design = ring_motor();
    design.friction.static_ = design.friction.kinetic * random(1, 1.5);
    design.layer.given_shear_modulus = random.logarithmic(3e7, 1e10);
    design.layer.loss_factor = random.chance(0.2) ? 0 : random.logarithmic(0.01, 3);
    if (random.chance(0.5)) design.layer.given_inertia = 0;
    design.preload = random(1.01, 8) * full_contact_load(design);
    const double left = room(design);
    // Between two of the places the ends miss their extremes by less than (pi / 20,000)^2 of the amplitudes, some
    // ten times the mean pressure at most.
    if (std::abs(left) < 1e-5) continue;
    CAPTURE(i, left);
    CHECK(Motor(design).locks_at_rest() == (left > 0));
    ++(left > 0 ? locked : free);
  }
  CHECK(locked > 50);
  CHECK(free > 50);
}
