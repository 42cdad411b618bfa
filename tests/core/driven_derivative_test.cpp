// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <string>
#include <vector>

// Derivatives of a driven motor's metrics against differences of their values (D2.9, D3.3).
namespace {

using namespace twum;
using namespace twum::test;

void compare(const MotorDesign& design) {
  // Near the resonance a relative change of the frequency counts 25 times: Richardson's extrapolation leaves (25 * 5e-6)^4,
  // and the values' own 1e-11 over 5e-6.
  const GradientCheck check = against_differences(design, every_metric(11.3, 0.45), 5e-6);
  CAPTURE(check.where);
  CHECK(check.worst <= 5e-6);
  CHECK(check.compared > 500);
}

}  // namespace

TEST_CASE("gradients of a driven motor are the limits of differences (D2.9, D3.3, D6.3)",
          "[core][driven][derivative]") {
  SECTION("with an elastic layer") { compare(driven_motor()); }
  SECTION("with inertia and viscosity, where the viscosity follows the frequency") {
    compare(driven_motor_with_layer(105, 41e3));
  }
  SECTION("by quality factor and frequency ratio") {
    MotorDesign design = with(driven_motor_with_layer(), Parameter::frequency_ratio, 1.05);
    compare(with(design, Parameter::quality_factor, 150));
  }
  SECTION("where the running wave ends above rest") { compare(driven_motor_with_layer(50)); }
  SECTION("over a track with width") {
    MotorDesign design = driven_motor_with_layer();
    design.stator.radial_slices = 8;
    design.stator.radial_shape = {1.5, 13e-3, {}};
    design.rotor.taper = 5e-5;
    compare(design);
  }
  SECTION("with unequal phases and modes, a rotor's mass and a sensor") {
    compare(unequal_motor());
  }
  SECTION("the same over a track with width") {
    MotorDesign design = unequal_motor();
    design.stator.radial_slices = 5;
    design.stator.radial_shape = {1.5, 13e-3, {}};
    compare(design);
  }
  SECTION("with an amplitude") {
    compare(with(driven_motor_with_layer(), Parameter::amplitude, 1.7e-6));
  }
}
