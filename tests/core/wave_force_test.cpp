// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/contact_problem.hpp"
#include "support/deviations.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>

#include <cmath>
#include <vector>

// The contact's force on the wave against its definition, taken from the fields sample by sample, and in limits.
namespace {

using namespace twum;
using namespace twum::test;

// a kappa
double tilt_of(const MotorDesign& design) {
  const Stator& s = design.stator;
  return s.neutral_plane_distance * s.wavelengths / s.contact_radius;
}

MotorDesign loaded(MotorDesign design, double load) {
  design.preload = load * full_contact_load(design);
  return design;
}

MotorDesign with_threshold(MotorDesign design) {
  design.friction.threshold = 1.4 * design.friction.kinetic;
  return design;
}

// Full contact and soft in shear: at rest the layer follows the wave all round.
MotorDesign locked_motor() {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1e7;
  design.layer.loss_factor = 0.3;
  return loaded(design, 8);
}

// Re F of (D1.1) by the trapezoidal rule over samples from -pi to pi.
double reactive_force(const Motor& motor, const ContactFields& fields) {
  const ContactProblem problem = contact_problem(motor.design(), fields.point.speed);
  const double tilt = tilt_of(motor.design());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < fields.samples.size(); ++i) {
    const FieldSample& s = fields.samples[i];  // both ends are the same place of the wave
    sum += s.pressure * std::cos(s.phase) + tilt * s.traction * std::sin(s.phase);
  }
  return problem.track_area * sum / static_cast<double>(fields.samples.size() - 1);
}

}  // namespace

TEST_CASE("the reactive force is the mean of pressure and traction over the wave (D1.1, D1.6)",
          "[core][wave_force][quadrature]") {
  constexpr int kSamples = 400001;
  Deviation force("reactive force by quadrature of the fields, in units of the error bound", 1);
  for (const MotorDesign& design :
       {ring_motor(), elastic(ring_motor()), damped(ring_motor()), loaded(ring_motor(), 0.4),
        with_threshold(loaded(damped(ring_motor()), 0.3)), loaded(ring_motor(), 1.5),
        loaded(elastic(ring_motor()), 3)}) {
    const Motor motor(design);
    for (const double share : {-0.2, 0.1, 0.8, 0.93, 1.1}) {
      const ContactFields fields = motor.fields(share * motor.crest_speed(), kSamples);
      REQUIRE(fields.point.status == PointStatus::ok);
      // As for torque and powers: a jump of tau at a border costs at most half of it in one of the intervals.
      const double borders = static_cast<double>(fields.zones.size()) + 2;
      const double peak = design.friction.threshold * tilt_of(design) *
                          motor.contact().max_pressure * contact_problem(design, 0).track_area;
      force.add(reactive_force(motor, fields), fields.point.reactive_force,
                borders * peak / kSamples);
    }
  }
  CHECK(force.holds());
}

TEST_CASE(
    "the pressure's force tends to the preload in small contacts (D1.3) and is K_c A in full ones "
    "(D1.4)",
    "[core][wave_force][limit]") {
  MotorDesign design = ring_motor();
  design.friction = {0, 0};  // no traction: Re F is the pressure's alone
  const auto at_load = [&](double load) {
    const Motor motor(loaded(design, load));
    const double angle = motor.contact().half_angle;
    return std::pair{motor.operating_point(0).reactive_force / motor.design().preload, angle};
  };
  for (const double load : {1e-12, 1e-9, 1e-6}) {
    const auto [share, angle] = at_load(load);
    // What is left out is of order theta_L^4; rounding of a difference of numbers of order one.
    CHECK(std::fabs(share - (1 - angle * angle / 10)) <= std::pow(angle, 4) + 1e-15);
  }
  // (D1.5): at half load per K_c A the contact is just full.
  for (const double load : {1.0 + 1e-12, 2.0, 5.0}) {
    const auto [share, angle] = at_load(load);
    CHECK(angle == kPi);
    CHECK(share == Approx(0.5 / load).epsilon(1e-14));  // a few roundings
  }
  // Continuous where the contact becomes full: pi - theta_L is of order the root of what is missing.
  CHECK(at_load(1 - 1e-12).first == Approx(0.5).epsilon(1e-11));
}

TEST_CASE("a contact that slips one way acts on the wave along 1 +- i mu a kappa (C20.2)",
          "[core][wave_force][closed_form]") {
  for (const MotorDesign& design :
       {ring_motor(), loaded(elastic(ring_motor()), 0.5), loaded(ring_motor(), 1.5)}) {
    const Motor motor(design);
    MotorDesign smooth = design;
    smooth.friction = {0, 0};
    const double pressure = Motor(smooth).operating_point(0).reactive_force;
    const double velocity = 2 * kPi * design.stator.frequency * design.stator.amplitude;  // omega A
    int one_way = 0;
    for (const double share : {0.001, 0.1, 0.3, 1.6, 3.0}) {
      const double speed = share * motor.crest_speed();
      const OperatingPoint point = motor.operating_point(speed);
      const std::vector<Zone> zones = motor.zones(speed);
      if (zones.size() != 1 || zones.front().state == ZoneState::stick) continue;
      ++one_way;
      const double way = static_cast<double>(zones.front().state);
      // Roundings of a mean of terms of order one; the pressure's force is at least half of the preload's scale.
      CHECK(point.reactive_force == Approx(pressure).epsilon(1e-13));
      CHECK(point.stator_power / velocity ==
            Approx(way * design.friction.kinetic * tilt_of(design) * pressure)
                .epsilon(1e-12));  // (D1.2)
    }
    CHECK(one_way > 0);
  }
}

TEST_CASE("a locked motor at rest acts on the wave as springs and a damper (C20.3)",
          "[core][wave_force][closed_form]") {
  const MotorDesign design = locked_motor();
  const Motor motor(design);
  REQUIRE(motor.locks_at_rest());
  const OperatingPoint point = motor.operating_point(0);
  const Stator& s = design.stator;
  const double omega = 2 * kPi * s.frequency, tilt = tilt_of(design);
  const double track = kPi * s.contact_radius * s.contact_width / design.layer.thickness;
  const double shear = track * tilt * tilt;
  const double stiffness = track * design.layer.youngs_modulus +
                           shear * (shear_modulus(design) - inertia(design) * omega * omega);
  // Sums of two products.
  CHECK(point.reactive_force == Approx(stiffness * s.amplitude).epsilon(1e-13));
  CHECK(point.stator_power / (omega * s.amplitude) ==
        Approx(shear * shear_viscosity(design) * omega * s.amplitude).epsilon(1e-13));
}

TEST_CASE("preload and friction bound the force on the wave (C20.4)",
          "[core][wave_force][property]") {
  Uniform random(2025);
  int points = 0;
  for (int i = 0; i < 3000; ++i) {
    const BoxPoint at = random_box_point(random);
    const Motor motor(at.design);
    const OperatingPoint point = motor.operating_point(at.speed);
    if (point.status != PointStatus::ok) continue;
    ++points;
    const double bound = at.design.friction.threshold * tilt_of(at.design) * at.design.preload;
    const double velocity = 2 * kPi * at.design.stator.frequency * at.design.stator.amplitude;
    CAPTURE(i);
    // Powers are trusted to 1e-9 of their scale.
    CHECK(std::fabs(point.stator_power / velocity) <= bound * (1 + 1e-9));
    CHECK(point.reactive_force <= (at.design.preload + bound) * (1 + 1e-9));
    CHECK(point.reactive_force >= -bound * (1 + 1e-9));
  }
  CHECK(points > 2000);
}
