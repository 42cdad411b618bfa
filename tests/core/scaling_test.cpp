// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

// Exact scaling laws of theory section 8. Tolerance for all of them: rounding of the scaled inputs is
// 1e-16 relative, and no torque depends on an input more than 1e4 times as strongly as on its own
// scale (realistic designs, loss factors above 0.02), so 1e-11 of mu_0 F_N r is safe.
namespace {

using namespace twum;
using namespace twum::test;

// Torques of a design and of the scaled design at a dozen speeds; all layer kinds take turns.
template <typename Scale>
void check_scaling(const char* name, double torque_factor, double speed_factor, Scale scale) {
  Deviation deviation(name, 1e-11);
  Uniform random(4711);
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    if (i % 3 == 1) design = damped(design);
    if (i % 3 == 2) design = elastic(design);
    const Motor motor(outright(design));
    const Motor scaled_motor(scale(outright(design)));
    for (int k = 0; k < 12; ++k) {
      const double speed = motor.crest_speed() * (0.12 * k - 0.1);
      const auto point = motor.operating_point(speed);
      const auto scaled = scaled_motor.operating_point(speed * speed_factor);
      CAPTURE(name, i, speed / motor.crest_speed());
      CHECK(point.status == scaled.status);
      if (point.status != PointStatus::ok) continue;
      CHECK(deviation.add(scaled.torque, torque_factor * point.torque,
                          torque_factor * torque_scale(design)) <= 1e-11);
      CHECK(deviation.add(scaled.friction_power,
                          torque_factor * speed_factor * point.friction_power,
                          torque_factor * speed_factor * power_scale(motor, speed)) <= 1e-11);
    }
  }
  CHECK(deviation.holds());
}

}  // namespace

TEST_CASE("stresses and forces scaled alike scale the torque (C8.9)", "[core][point][scaling]") {
  const double c = 3.7;
  check_scaling("scaling of stresses", c, 1, [c](MotorDesign d) {
    d.layer.youngs_modulus *= c;
    d.layer.given_shear_modulus = c * *d.layer.given_shear_modulus;
    d.layer.given_shear_viscosity = c * *d.layer.given_shear_viscosity;
    d.layer.given_inertia = c * *d.layer.given_inertia;
    d.preload *= c;
    return d;
  });
}

TEST_CASE("time scaled alike leaves the torque (C8.10)", "[core][point][scaling]") {
  const double c = 0.6;
  check_scaling("scaling of time", 1, c, [c](MotorDesign d) {
    d.stator.frequency *= c;
    d.layer.given_shear_viscosity = *d.layer.given_shear_viscosity / c;
    d.layer.given_inertia = *d.layer.given_inertia / (c * c);
    return d;
  });
}

TEST_CASE("speeds sought scale with time, to the bit in powers of two (C8.10)",
          "[core][metrics][scaling]") {
  // G, gamma and m given outright: every number in the search is a power of two times the other's, and such factors
  // bring no rounding, so that a search free of units takes the same steps.
  int sought = 0;
  Uniform random(4712);
  for (int i = 0; i < 24; ++i) {
    MotorDesign design = realistic_design(random);
    design.stator.modal_damping = 20;
    if (i % 4 != 0) design.friction.threshold = design.friction.kinetic;
    if (i % 3 == 1) design = damped(design);
    if (i % 3 == 2) design = elastic(design);
    design = outright(design);
    const Motor motor(design);
    for (const double c : {0x1p-14, 0x1p13}) {
      MotorDesign timed = design;
      timed.stator.frequency *= c;
      timed.layer.given_shear_viscosity = *design.layer.given_shear_viscosity / c;
      timed.layer.given_inertia = *design.layer.given_inertia / (c * c);
      timed.stator.modal_damping /= c;
      const Motor scaled_motor(timed);
      const double load = 0.3 * motor.holding_torque();
      for (const MetricRequest& request :
           {MetricRequest{Metric::no_load_speed}, MetricRequest{Metric::plateau_speed},
            MetricRequest{Metric::speed_at_peak_power},
            MetricRequest{Metric::speed_at_max_efficiency},
            MetricRequest{Metric::speed_at, Argument::torque, load}}) {
        const MetricValue value = evaluate(motor, request),
                          scaled = evaluate(scaled_motor, request);
        CAPTURE(i, c, info(request.metric).name);
        CHECK(scaled.status == value.status);
        if (value.status != MetricStatus::ok) continue;
        ++sought;
        CHECK(scaled.value == c * value.value);
      }
    }
  }
  CHECK(sought > 200);
}

TEST_CASE("a wider track with as much more preload scales the torque (C8.11)",
          "[core][point][scaling]") {
  const double c = 2.3;
  check_scaling("scaling of the width", c, 1, [c](MotorDesign d) {
    d.stator.contact_width *= c;
    d.preload *= c;
    return d;
  });
}

TEST_CASE("a motor built larger of the same material gives torque as its volume (C8.12)",
          "[core][point][scaling]") {
  const double c = 1.9;
  check_scaling("scaling of lengths", c * c * c, 1 / c, [c](MotorDesign d) {
    d.stator.contact_radius *= c;
    d.stator.contact_width *= c;
    d.stator.neutral_plane_distance *= c;
    d.stator.amplitude *= c;
    d.layer.thickness *= c;
    d.preload *= c * c;
    d.stator.frequency /= c;
    // the material's G stays; gamma = loss_factor G / omega and m = rho h^2 / 3 follow (T1.2, T1.3, T1.4)
    d.layer.given_shear_viscosity = c * *d.layer.given_shear_viscosity;
    d.layer.given_inertia = c * c * *d.layer.given_inertia;
    return d;
  });
}

TEST_CASE("the layer's constants follow the material unless given (T1.2, T1.3, T1.4)",
          "[core][design][closed_form]") {
  MotorDesign design = ring_motor();
  design.layer = {0.4e-3, 5e9, 0.25, 1500, 0.1, {}, {}, {}};
  design.stator.frequency = 50e3;
  CHECK(shear_modulus(design) == Approx(2e9).epsilon(1e-15));
  CHECK(shear_viscosity(design) == Approx(0.1 * 2e9 / 314159.26535897932).epsilon(1e-14));
  CHECK(inertia(design) == Approx(8e-5).epsilon(1e-15));
  design.layer.given_shear_modulus = 1e9;
  CHECK(shear_modulus(design) == 1e9);
  CHECK(shear_viscosity(design) == Approx(0.1 * 1e9 / 314159.26535897932).epsilon(1e-14));
  design.layer.given_shear_viscosity = 0;
  design.layer.given_inertia = 0;
  CHECK(shear_viscosity(design) == 0);
  CHECK(inertia(design) == 0);
}

TEST_CASE("drive velocities of the ring motor (T1.1, T2.1, T2.2)", "[core][point][closed_form]") {
  const Motor motor(ring_motor());
  // n = 9, r = 26.5 mm, a = 3 mm, A = 1.6 um, f = 40 kHz: V0 = kappa a A omega
  const double omega = 251327.41228718346;
  CHECK(motor.crest_speed() * 0.0265 == Approx(9 / 0.0265 * 3e-3 * 1.6e-6 * omega).epsilon(1e-14));
  CHECK(motor.wave_speed() == Approx(omega / 9).epsilon(1e-14));
}
