// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"

#include <catch2/catch.hpp>

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <cmath>
#include <string>
#include <vector>

// Derivatives of a driven motor's metrics against differences of their values (D2.9, D3.3).
namespace {

using namespace twum;
using namespace twum::test;

void compare(const MotorDesign& design) {
  const std::vector<MetricRequest> asked = every_metric(11.3, 0.45);
  const std::vector<MetricDerivative> found = differentiate(Motor(design), asked);
  int compared = 0;
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(design, row.parameter) || row.integer) continue;
    const double x = get(design, row.parameter);
    if (x == 0) continue;
    // mu_0 alone has no derivative from below where it is mu.
    if (row.parameter == Parameter::static_friction) continue;
    // Near the resonance a relative change of the frequency counts 25 times: Richardson's extrapolation leaves (25 * 5e-6)^4,
    // and the values' own 1e-11 over 5e-6.
    const double d = 5e-6 * x;
    const auto at = [&](double step) {
      return values_of(with(design, row.parameter, x + step), asked);
    };
    const auto p1 = at(d), m1 = at(-d), p2 = at(2 * d), m2 = at(-2 * d);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (found[i].value.status != MetricStatus::ok || found[i].smoothness == Smoothness::undefined)
        continue;
      const double one = (p1[i] - m1[i]) / (2 * d), two = (p2[i] - m2[i]) / (4 * d);
      const double quotient = (4 * one - two) / 3;
      CAPTURE(row.name, info(asked[i].metric).name, found[i].value.value);
      const double scale = std::fabs(found[i].value.value) + std::fabs(quotient * x) + 1e-12;
      CHECK(std::fabs(found[i].gradient[index_of(row.parameter)] - quotient) * x <= 5e-6 * scale);
      ++compared;
    }
  }
  CHECK(compared > 500);
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
