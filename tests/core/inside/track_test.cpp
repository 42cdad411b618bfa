// SPDX-License-Identifier: Apache-2.0
#include "model/track.hpp"
#include "metrics/motor_parts.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/gauss_rule.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <numbers>

using namespace twum;
using namespace twum::core;
using namespace twum::test;

namespace {

MotorDesign annulus_of(Uniform& random, int index) {
  MotorDesign design = realistic_design(random);
  Stator& stator = design.stator;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width;
  stator.radial_slices = 2 + index % 15;
  stator.radial_shape = {random(-3, 5), random(0, 0.95) * inner, {}};
  design.rotor.taper = random(-5, 5) * stator.amplitude / stator.contact_width;
  design.preload = full_contact_load(design) * random.logarithmic(1e-8, 5);
  return design;
}

}  // namespace

TEST_CASE("slices carry the preload together (W2.3, W4.3)", "[core][annulus][identity]") {
  Uniform random(5);
  int parts = 0, full = 0;
  for (int i = 0; i < 300; ++i) {
    const MotorDesign design = annulus_of(random, i);
    const Motor motor(design);
    const DrivenMotor<double>& m = MotorParts::model(motor);
    double load = 0, moment = 0, share = 0, width = 0;
    for (const Slice<double>& s : m.slices()) {
      load += s.load, moment += s.load * s.radius, share += s.share, width += s.width;
      full += s.contact.full;
      // the load is the integral of (T3.1), or of (T3.3), over the slice
      const double P = s.contact.pressure_amplitude, theta = s.contact.half_angle;
      const double mean = s.contact.full ? std::numbers::pi * P * (s.peak - 1)
                                         : P * (std::sin(theta) - theta * std::cos(theta));
      if (theta > 0.1)  // below, the two terms cancel
        CHECK(s.load == Approx(2 * s.radius * s.width * mean).epsilon(1e-12));
    }
    CAPTURE(i, m.slices().size(), design.rotor.taper);
    CHECK(std::abs(load - design.preload) <= 1e-12 * design.preload);
    CHECK(m.lever * load == Approx(moment).epsilon(1e-12));
    CHECK(share == Approx(1).epsilon(1e-13));
    parts += width < 0.999 * design.stator.contact_width;
  }
  CHECK(parts > 30);  // tracks that lift off in part
  CHECK(full > 30);   // slices in full contact
}

// Without the change of variable at radii of lift-off eight nodes would leave 1e-4.
TEST_CASE("pieces that end where the contact begins or closes need few nodes (W4.1)",
          "[core][annulus][accuracy]") {
  for (const double load : {0.01, 0.3, 1.0, 1.3}) {
    MotorDesign design = ring_motor();
    design.stator.radial_shape = {4, 20e-3, {}};
    design.preload = load * full_contact_load(design);
    const auto lever = [&](int slices) {
      design.stator.radial_slices = slices;
      return MotorParts::model(Motor(design)).lever / design.stator.contact_radius - 1;
    };
    CAPTURE(load, lever(8), lever(64));
    CHECK(std::abs(lever(8) - lever(64)) <= 1e-7);
    CHECK(std::abs(lever(16) - lever(64)) <= 1e-11);
  }
}

TEST_CASE("a Gauss rule of N nodes integrates polynomials of degree 2 N - 1",
          "[core][annulus][identity]") {
  for (const int nodes : {1, 2, 5, 16, 128, 256}) {
    const GaussRule& rule = gauss_rule(nodes);
    REQUIRE(rule.nodes.size() == static_cast<std::size_t>(nodes));
    CHECK(&rule == &gauss_rule(nodes));
    for (const int degree : {0, nodes, 2 * nodes - 1}) {
      double sum = 0, before = 0;
      for (const GaussRule::Node& node : rule.nodes) {
        CHECK(node.place > before);
        before = node.place, sum += node.weight * std::pow(node.place, degree);
      }
      CHECK(sum == Approx(1.0 / (degree + 1)).epsilon(1e-13 * nodes));  // rounding of so many terms
    }
  }
}
