// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// A contact with width: against the one-slice model summed over narrow rings here, and against limits and closed forms.
namespace {
using namespace twum;
using namespace twum::test;
using P = Parameter;

MotorDesign sliced(MotorDesign design, int slices) {
  design.stator.radial_slices = slices;
  return design;
}

MotorDesign shaped(MotorDesign design, double exponent, double root) {
  design.stator.radial_shape = {exponent, root, {}};
  return design;
}

MotorDesign tapered(MotorDesign design, double taper) {
  design.rotor.taper = taper;
  return design;
}

MotorDesign pressed(MotorDesign design, double preload) {
  design.preload = preload;
  return design;
}

MotorDesign with_threshold(MotorDesign design, double ratio) {
  design.friction.threshold = ratio * design.friction.kinetic;
  return design;
}

double inner_of(const MotorDesign& d) {
  return d.stator.contact_radius - 0.5 * d.stator.contact_width;
}

// ---- the annulus as narrow rings, each a motor of one slice -------------------------------------

struct Ring {
  double radius, width, amplitude, load;
};

// A ring under a rotor whose face stands at `height` over the neutral surface at the mean radius.
Ring ring_at(const MotorDesign& d, double radius, double width, double height) {
  const double r = d.stator.contact_radius;
  const RadialShape& shape = d.stator.radial_shape;
  const double amplitude =
      d.stator.amplitude * std::pow((radius - shape.root) / (r - shape.root), shape.exponent);
  const double face = height + (radius - r) * std::tan(d.rotor.taper);
  // the wave cuts the face at +-theta, and the layer gives way by what is above it
  const double theta = std::acos(std::clamp(face / amplitude, -1.0, 1.0));
  const double area = 2 * (amplitude * std::sin(theta) - face * theta);
  const double load = radius * width * d.layer.youngs_modulus / d.layer.thickness * area;
  return {radius, width, amplitude, load};
}

std::vector<Ring> rings_at(const MotorDesign& d, int count, double height) {
  const double width = d.stator.contact_width / count;
  std::vector<Ring> rings;
  for (int i = 0; i < count; ++i)
    rings.push_back(ring_at(d, inner_of(d) + (i + 0.5) * width, width, height));
  return rings;
}

MotorDesign motor_of(const MotorDesign& d, const Ring& ring) {
  MotorDesign one = sliced(d, 1);
  one.stator.contact_radius = ring.radius, one.stator.contact_width = ring.width;
  one.stator.amplitude = ring.amplitude, one.preload = ring.load;
  return one;
}

double load_of(const std::vector<Ring>& rings) {
  double load = 0;
  for (const Ring& ring : rings) load += ring.load;
  return load;
}

double height_of(const MotorDesign& d, int count) {
  double low = -1e-2, high = 1e-2;  // far beyond any height here
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (load_of(rings_at(d, count, middle)) > d.preload ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<Ring> pressed_rings(const MotorDesign& d, int count) {
  return rings_at(d, count, height_of(d, count));
}

OperatingPoint sum_of_rings(const MotorDesign& d, int count, double speed) {
  OperatingPoint sum;
  double touching = 0;
  for (const Ring& ring : pressed_rings(d, count)) {
    if (!(ring.load > 0)) continue;
    const Motor motor(motor_of(d, ring));
    const OperatingPoint p = motor.operating_point(speed);
    REQUIRE(p.status == PointStatus::ok);
    sum.torque += p.torque, sum.stator_power += p.stator_power;
    sum.friction_power += p.friction_power, sum.layer_loss += p.layer_loss;
    // a ring feels R times what the wave moves at the mean radius
    sum.reactive_force += p.reactive_force * ring.amplitude / d.stator.amplitude;
    const double area = motor.contact().half_angle * ring.radius * ring.width;
    sum.stick_fraction += p.stick_fraction * area, touching += area;
  }
  sum.stick_fraction /= touching;
  return sum;
}

struct Track {
  const char* name;
  MotorDesign design;
  double tolerance;          // of 48 slices, of mu_0 F_N r and of the scale of powers
  double automatic{1.2e-6};  // of `auto`
};

// 48 nodes leave 1e-5 where zones appear inside the track (W4.1), and 1/48 of a jump of some percent with mu_0 > mu; `auto`
// leaves 1e-6 (W4.2). Rings leave 1e-7, (1/2000)^(3/2) = 1e-5 where a contact begins or closes within the track, and where
// slices jump half a ring's share of a jump, 0.014 / 4000 = 3.5e-6, at each of the two ends of a stick zone.
std::vector<Track> tracks() {
  const MotorDesign ring = ring_motor();
  const double full = full_contact_load(ring);
  return {{"R = 1", ring, 1e-5},
          {"elastic", elastic(ring), 1e-5},
          {"damped", damped(ring), 1e-5},
          {"rising", shaped(ring, 2, 13.25e-3), 1e-5},
          {"falling", shaped(ring, -1, 0), 1e-5},
          {"tapered out", tapered(ring, 2e-4), 1e-5},
          {"tapered in", tapered(ring, -2e-4), 1e-5},
          {"outer edge alone", tapered(shaped(ring, 2, 20e-3), -1e-3), 1e-5, 1e-5},
          {"inner edge alone", pressed(tapered(damped(ring), 3e-3), 20), 1e-5, 1e-5},
          {"lifted off within", pressed(shaped(ring, 3, 20e-3), 5), 1e-5, 1e-5},
          {"full", pressed(shaped(elastic(ring), 1, 0), 1.5 * full), 1e-5},
          {"full in part", pressed(shaped(ring, 4, 10e-3), full), 1e-5, 1e-5},
          {"threshold", with_threshold(ring, 1.3), 1e-3, 8.2e-6},
          {"threshold, damped", with_threshold(damped(ring), 1.3), 1e-3, 8.2e-6},
          {"threshold, elastic", with_threshold(elastic(ring), 1.3), 1e-3, 8.2e-6}};
}

void check_against_rings(const Motor& motor, double speed, const OperatingPoint& sum,
                         double tolerance) {
  const OperatingPoint p = motor.operating_point(speed);
  REQUIRE(p.status == PointStatus::ok);
  const double torque = torque_scale(motor.design()), power = power_scale(motor, speed);
  CHECK(std::abs(p.torque - sum.torque) <= tolerance * torque);
  CHECK(std::abs(p.stator_power - sum.stator_power) <= tolerance * power);
  CHECK(std::abs(p.friction_power - sum.friction_power) <= tolerance * power);
  CHECK(std::abs(p.layer_loss - sum.layer_loss) <= tolerance * power);
  CHECK(std::abs(p.reactive_force - sum.reactive_force) <= tolerance * motor.design().preload);
  // stick zones are born with a finite length: their share converges like 1 / N
  CHECK(std::abs(p.stick_fraction - sum.stick_fraction) <= 0.02);
}

}  // namespace

TEST_CASE(
    "an annulus is the sum of rings, each a motor of one slice (W1.1, W1.2, W1.3, W2.1, W2.2, "
    "W3.1, W3.2, W3.3, W3.4, W4.2, W4.4)",
    "[core][annulus][oracle]") {
  constexpr int kRings = 2000, kSlices = 48;
  for (const Track& track : tracks()) {
    const Motor motor(sliced(track.design, kSlices)), split(sliced(track.design, kAutoSlices));
    for (const double share : {-0.1, 0.0, 0.4, 0.85, 0.95, 1.1, 1.4}) {
      CAPTURE(track.name, share);
      const double speed = share * motor.crest_speed();
      // an elastic layer with a threshold may have no periodic state
      const bool threshold = std::string(track.name).starts_with("threshold");
      if (threshold && motor.operating_point(speed).status != PointStatus::ok) continue;
      const OperatingPoint sum = sum_of_rings(track.design, kRings, speed);
      check_against_rings(motor, speed, sum, track.tolerance);
      check_against_rings(split, speed, sum, track.automatic);
    }
  }
}

TEST_CASE("the powers of an annulus balance (T7.10, W3.2, W3.5)", "[core][annulus][identity]") {
  Uniform random(31);
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    design = sliced(design, 2 + i % 11);
    design = shaped(design, random(-2, 4), random(0, 0.8) * inner_of(design));
    design = tapered(design, random(-5e-4, 5e-4));
    if (i % 3 == 1) design = elastic(design);
    if (i % 3 == 2) design = damped(design);
    const Motor motor(design);
    for (const double share : {-0.1, 0.0, 0.5, 0.9, 1.0, 1.2}) {
      const double speed = share * motor.crest_speed();
      const OperatingPoint p = motor.operating_point(speed);
      CAPTURE(i, share, to_string(p.status));
      REQUIRE(p.status == PointStatus::ok);
      // 1e-11 of the scale: what a slice keeps (E5 in events.md), and rounding of the sum
      CHECK(std::abs(imbalance(p)) <= 1e-11 * power_scale(motor, speed));
      const double outer = inner_of(design) + design.stator.contact_width;
      CHECK(std::abs(p.torque) <= design.friction.threshold * design.preload * outer);
    }
  }
}

TEST_CASE("one slice is the model of the mean radius, whatever the shape and the taper",
          "[core][annulus][identity]") {
  const Motor plain(ring_motor()), other(tapered(shaped(ring_motor(), 3, 10e-3), 1e-3));
  for (const double share : {0.0, 0.7, 0.95, 1.2}) {
    const double speed = share * plain.crest_speed();
    CHECK(other.operating_point(speed).torque == plain.operating_point(speed).torque);
  }
  CHECK(evaluate(other, {Metric::max_pressure}).value ==
        evaluate(plain, {Metric::max_pressure}).value);
  CHECK(evaluate(plain, {Metric::pressure_nonuniformity}).value == 1);
  CHECK(plain.slice_radii() == std::vector<double>{ring_motor().stator.contact_radius});
}

// The track's curvature acts with (b / r)^2, and so does what a symmetric rule leaves of a slope across the track.
TEST_CASE("a narrow track tends to one slice with order two in its width",
          "[core][annulus][limit]") {
  for (const double share : {0.3, 0.9, 1.2}) {
    const auto gap = [&](double width) {
      MotorDesign design = shaped(elastic(ring_motor()), 2, 5e-3);
      design.preload *= width / design.stator.contact_width;
      design.stator.contact_width = width;
      const Motor one(design), many(sliced(design, 6));
      const double speed = share * one.crest_speed();
      return (many.operating_point(speed).torque - one.operating_point(speed).torque) /
             torque_scale(design);
    };
    CAPTURE(share, gap(0.4e-3));
    CHECK(std::abs(gap(0.4e-3)) < 1e-3);
    // the next term is (b / r)^4, 2e-4 of this one, times a constant of some ten
    CHECK(gap(0.4e-3) / gap(0.2e-3) == Approx(4).epsilon(5e-3));
  }
}

TEST_CASE("torque at rest without drive is that of the flat rotor (W3.6)",
          "[core][annulus][oracle]") {
  const MotorDesign ring = ring_motor();
  const double r = ring.stator.contact_radius, b = ring.stator.contact_width;
  const double unit = torque_scale(ring);
  CHECK(Motor(sliced(ring, 8)).holding_torque() ==
        Approx(unit * (1 + b * b / (12 * r * r))).epsilon(1e-14));
  for (const double taper : {1e-5, -1e-5, 1e-3, -1e-3}) {
    // linear pressure where the cone reaches the layer, its depth found by halving; midpoint sums are good to 1e-8
    const auto moments = [&](double depth) {
      double load = 0, moment = 0;
      for (int i = 0; i < 20'000; ++i) {
        const double radius = r - b / 2 + b * (i + 0.5) / 20'000;
        const double give = std::max(0.0, depth - (radius - r) * std::tan(taper));
        load += radius * give, moment += radius * radius * give;
      }
      const double unit_load =
          2 * kPi * (b / 20'000) * ring.layer.youngs_modulus / ring.layer.thickness;
      return std::pair{unit_load * load, unit_load * moment};
    };
    double low = -1e-4, high = 1e-4;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (moments(middle).first < ring.preload ? low : high) = middle;
    }
    CAPTURE(taper);
    const MotorDesign cone = tapered(sliced(ring, 8), taper);
    CHECK(Motor(cone).holding_torque() ==
          Approx(ring.friction.threshold * moments(low).second).epsilon(1e-7));
    MotorDesign still = cone;
    still.stator.amplitude = 0;
    const OperatingPoint dragged = Motor(still).operating_point(1);
    CHECK(dragged.torque == Approx(-Motor(still).holding_torque()).epsilon(1e-14));
    CHECK(std::abs(imbalance(dragged)) <= 1e-14 * dragged.friction_power);
  }
}

// A cubic spline with not-a-knot ends through rows of a cubic polynomial is that polynomial.
TEST_CASE("a table of the shape says what its exponent says (W1.3)", "[core][annulus][identity]") {
  const MotorDesign by_exponent = shaped(sliced(ring_motor(), 8), 2, 13e-3);
  for (const double scale : {1.0, 250.0}) {  // R = 1 at the contact radius, whatever the unit
    MotorDesign by_table = by_exponent;
    by_table.stator.radial_shape = {};
    for (const double mm : {22.0, 24.0, 25.1, 27.7, 28.4, 29.0})
      by_table.stator.radial_shape.table.emplace_back(1e-3 * mm, scale * (mm - 13) * (mm - 13));
    const Motor a(by_exponent), b(by_table);
    for (const double share : {0.0, 0.8, 1.0}) {
      const double speed = share * a.crest_speed();
      // spline and power differ by rounding of R, 1e-15, which the indentation magnifies by A / delta
      CHECK(b.operating_point(speed).torque ==
            Approx(a.operating_point(speed).torque).epsilon(1e-11).margin(1e-13));
    }
    CHECK(evaluate(b, {Metric::max_pressure}).value ==
          Approx(evaluate(a, {Metric::max_pressure}).value).epsilon(1e-12));
  }
}

TEST_CASE("pressure across the track follows shape and taper (W5.1, W5.2, W5.3)",
          "[core][annulus][oracle]") {
  for (const Track& track : tracks()) {
    const MotorDesign& d = track.design;
    CAPTURE(track.name);
    double largest = 0, most = 0;
    const std::vector<Ring> rings = pressed_rings(d, 4000);
    for (const Ring& ring : rings) {
      most = std::max(most, ring.load / (2 * kPi * ring.radius * ring.width));
      if (!(ring.load > 0)) continue;
      largest = std::max(largest, Motor(motor_of(d, ring)).contact().max_pressure);
    }
    const Stator& s = d.stator;
    const double mean = d.preload / (2 * kPi * s.contact_radius * s.contact_width);
    const Motor motor(sliced(d, 64));
    // the largest ring is half a width from the edge: 1 / 8000 of the track, times the slope across it; where an edge alone
    // touches, a tenth of the track carries all
    CHECK(evaluate(motor, {Metric::max_pressure}).value == Approx(largest).epsilon(3e-3));
    CHECK(evaluate(motor, {Metric::pressure_nonuniformity}).value ==
          Approx(most / mean).epsilon(6e-3));
    CHECK(evaluate(motor, {Metric::max_pressure}).value >= largest * (1 - 1e-6));
  }
  const Motor ring(sliced(ring_motor(), 8));
  CHECK(evaluate(ring, {Metric::layer_aspect}).value ==
        Approx(ring_motor().layer.thickness / (2 * ring.contact().half_length)).epsilon(1e-15));
}

TEST_CASE("the plateau ends where the first ring sticks (W5.4)", "[core][annulus][oracle]") {
  constexpr int kRings = 2000;
  for (const Track& track : tracks()) {
    const MotorDesign& d = track.design;
    if (d.friction.threshold > d.friction.kinetic)
      continue;  // a ring that sticks may go on sticking
    const double height = height_of(d, kRings), width = d.stator.contact_width / kRings;
    std::vector<Ring> rings = rings_at(d, 200, height);
    for (const double edge : {inner_of(d), inner_of(d) + d.stator.contact_width})
      rings.push_back(ring_at(d, edge, width, height));
    double first = 1e9;
    for (const Ring& ring : rings)
      if (ring.load > 0)
        first = std::min(first, evaluate(Motor(motor_of(d, ring)), {Metric::plateau_speed}).value);
    const Motor motor(sliced(d, 8));
    const double end = evaluate(motor, {Metric::plateau_speed}).value;
    CAPTURE(track.name, end, first);
    // the height of 2000 rings is good to 1e-6 of the amplitude; a track that lifts off on one side is not first there
    CHECK(std::abs(end - first) <= 1e-5 * motor.crest_speed());
  }
}

TEST_CASE("fields at a radius are those of the wave and the rotor there (W1.1, W2.1)",
          "[core][annulus][identity]") {
  const MotorDesign design = tapered(shaped(sliced(ring_motor(), 8), 2, 13e-3), 1e-4);
  const Motor motor(design);
  const double r = design.stator.contact_radius, speed = 0.9 * motor.crest_speed();
  const double stiffness = design.layer.youngs_modulus / design.layer.thickness;
  for (const double radius : {inner_of(design), 0.0255, r, 0.0277, r + 0.002}) {
    const ContactFields fields = motor.fields(speed, 721, radius);
    CHECK(fields.radius == radius);
    REQUIRE(fields.samples.size() == 721);
    const FieldSample& crest = fields.samples[360];
    const double shape = std::pow((radius - 13e-3) / (r - 13e-3), 2);
    const double amplitude = design.stator.amplitude * shape;
    const double velocity = 2 * kPi * design.stator.frequency * design.stator.wavelengths / radius *
                            design.stator.neutral_plane_distance * amplitude;
    CHECK(crest.stator_velocity == Approx(velocity).epsilon(1e-13));
    // the face is a plane cone: pressures at two radii differ by the wave's height and the cone's
    const FieldSample middle = motor.fields(speed, 721, r).samples[360];
    const double rise = amplitude - design.stator.amplitude - (radius - r) * std::tan(1e-4);
    CHECK(
        crest.pressure ==
        Approx(std::max(0.0, middle.pressure + stiffness * rise)).margin(1e-12 * middle.pressure));
    for (const FieldSample& sample : fields.samples)
      CHECK(std::abs(sample.traction) <= design.friction.threshold * sample.pressure * (1 + 1e-9));
    CHECK(motor.zones(speed, radius).size() == fields.zones.size());
  }
  CHECK_THROWS_AS(motor.fields(speed, 11, r + 0.0021), InputError);
  CHECK(motor.fields(speed, 11).radius == r);
}

TEST_CASE("auto takes as many slices as 1e-6 asks for, and says how many (W4.2)",
          "[core][annulus][accuracy]") {
  for (const MotorDesign& design :
       {ring_motor(), elastic(ring_motor()), tapered(shaped(ring_motor(), 2, 13e-3), 2e-4)}) {
    const Motor motor(sliced(design, kAutoSlices));
    CHECK(motor.design().stator.radial_slices == kAutoSlices);
    const Motor same(with(motor.design(), P::radial_slices, motor.radial_slices())),
        fine(sliced(design, 256));
    for (const double share : {0.3, 0.72, 0.88, 0.97, 1.15}) {
      CAPTURE(share, motor.radial_slices());
      const double speed = share * motor.crest_speed();
      const double torque = motor.operating_point(speed).torque;
      CHECK(torque == same.operating_point(speed).torque);
      // 256 nodes leave a sixth of what 128 do
      CHECK(std::abs(torque - fine.operating_point(speed).torque) <= 1.2e-6 * torque_scale(design));
    }
  }
}
