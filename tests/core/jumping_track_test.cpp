// SPDX-License-Identifier: Apache-2.0
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// A contact with width whose slices jump, which takes mu_0 > mu.
namespace {

using namespace twum;
using namespace twum::test;

MotorDesign with_threshold(MotorDesign design, double ratio, int slices) {
  design.friction.threshold = ratio * design.friction.kinetic;
  design.stator.radial_slices = slices;
  return design;
}

// Steps of the torque between equally spaced speeds.
std::vector<double> torque_steps(const Motor& motor, double low, double high, int count) {
  std::vector<double> steps;
  double before = motor.operating_point(low).torque;
  for (int i = 1; i <= count; ++i) {
    const double torque = motor.operating_point(low + (high - low) * i / count).torque;
    steps.push_back(std::abs(torque - before));
    before = torque;
  }
  return steps;
}

}  // namespace

// In a hundredth of the interval a torque that is continuous, and nowhere steeper than twice its mean slope over that
// interval, moves by a fiftieth of its step there. One slice of eight makes a step of which nothing is lost.
TEST_CASE("the torque of auto is continuous where its slices jump (W4.5)",
          "[core][annulus][limit]") {
  for (const bool inertia : {true, false}) {
    const MotorDesign ring = inertia ? ring_motor() : elastic(ring_motor());
    const Motor automatic(with_threshold(ring, 1.3, kAutoSlices)),
        eight(with_threshold(ring, 1.3, 8));
    constexpr int kSteps = 200;
    const double low = 0.55 * automatic.crest_speed(), high = 1.25 * automatic.crest_speed();
    const double width = (high - low) / kSteps;
    double most = 0, most_of_eight = 0;
    for (int i = 0; i < kSteps; i += 10) {
      const double from = low + i * width, scale = torque_scale(automatic.design());
      const double whole = std::abs(automatic.operating_point(from + width).torque -
                                    automatic.operating_point(from).torque);
      const auto fine = torque_steps(automatic, from, from + width, 100),
                 jumping = torque_steps(eight, from, from + width, 100);
      CAPTURE(inertia, i, whole);
      CHECK(*std::max_element(fine.begin(), fine.end()) <= 0.02 * whole + 1e-6 * scale);
      most = std::max(most, whole / scale);
      most_of_eight =
          std::max(most_of_eight, *std::max_element(jumping.begin(), jumping.end()) / scale);
    }
    CHECK(most > 0.01);           // the torque falls there
    CHECK(most_of_eight > 1e-4);  // and slices do jump there
  }
}

TEST_CASE("with jumps the largest power of a contact with width is that of many samples (T7.16)",
          "[core][annulus][brute_force]") {
  for (const double ratio : {1.1, 1.3}) {
    const Motor motor(with_threshold(ring_motor(), ratio, 8));
    constexpr int kSteps = 20'000;
    double best = 0;
    for (int i = 0; i <= kSteps; ++i)
      best = std::max(best, motor.operating_point(motor.crest_speed() * i / kSteps).output_power);
    const double peak = evaluate(motor, {Metric::peak_power}).value;
    CAPTURE(ratio, best, peak);
    CHECK(peak >= best);
    // Over a step the speed adds V0 / r / 20,000 of mu_0 F_N r, and a torque that falls to zero over a tenth of the crest
    // speed ten times as much.
    CHECK(peak - best <= 11 * torque_scale(motor.design()) * motor.crest_speed() / kSteps);
  }
}

namespace {

// A motor with mu_0 > mu whose layer rings for a while: its track is not split.
MotorDesign ringing_track() {
  MotorDesign d;
  d.stator.wavelengths = 7;
  d.stator.contact_radius = 0.0302032662484915;
  d.stator.contact_width = 0.006391753376829166;
  d.stator.neutral_plane_distance = 0.003969872323621195;
  d.stator.frequency = 59066.01279324238;
  d.stator.amplitude = 1.944070813496769e-06;
  d.stator.radial_shape.exponent = 1;
  d.layer.thickness = 0.0004853177701741958;
  d.layer.youngs_modulus = 1133096891.2736824;
  d.layer.poisson_ratio = 0.38;
  d.layer.density = 1500;
  d.layer.loss_factor = 0.02;
  d.friction = {0.25657408830087397, 0.34637501920617986};
  d.preload = 200.15314500354842;
  return d;
}

// A motor whose torque has no periodic state over two per cent of its speeds, next to its largest power.
MotorDesign gap_beside_the_peak() {
  MotorDesign d;
  d.stator.wavelengths = 5;
  d.stator.contact_radius = 0.03950655809328363;
  d.stator.contact_width = 0.009471916014741653;
  d.stator.neutral_plane_distance = 0.0043371454816301825;
  d.stator.frequency = 57947.02294761341;
  d.stator.amplitude = 2.04426293723323e-06;
  d.layer.thickness = 0.0007340738823197728;
  d.layer.youngs_modulus = 1100450523.9513614;
  d.layer.poisson_ratio = 0.38;
  d.layer.density = 1500;
  d.layer.loss_factor = 2;
  d.friction = {0.18122404357016908, 0.24465245881972827};
  d.rotor.taper = 3e-4;
  d.preload = 352.7637228152719;
  return d;
}

}  // namespace

TEST_CASE("the plateau ends where an edge of the track leaves it, whatever the slices (W5.4)",
          "[core][annulus][limit]") {
  std::vector<double> ends;
  for (const int slices : {kAutoSlices, 8, 64}) {
    const Motor motor(with(ringing_track(), Parameter::radial_slices, slices));
    const MetricValue end = evaluate(motor, {Metric::plateau_speed});
    REQUIRE(end.status == MetricStatus::ok);
    ends.push_back(end.value);
  }
  // The place is one radius, an edge; its contact alone decides, to the rounding of the bisection.
  CHECK(std::fabs(ends[0] - ends[2]) <= 1e-12 * ends[2]);
  CHECK(std::fabs(ends[1] - ends[2]) <= 1e-12 * ends[2]);
}

TEST_CASE("a maximum beside speeds without a periodic state has no value",
          "[core][annulus][edge]") {
  for (const int slices : {kAutoSlices, 8, 64}) {
    const Motor motor(with(gap_beside_the_peak(), Parameter::radial_slices, slices));
    CAPTURE(slices);
    const MetricValue power = evaluate(motor, {Metric::peak_power});
    // Either no answer, or at least the power at every speed that has one.
    if (power.status != MetricStatus::ok) {
      CHECK(power.status == MetricStatus::no_periodic_state);
      continue;
    }
    for (int i = 1; i < 400; ++i) {
      const OperatingPoint p = motor.operating_point(i * 10.5 / 400);
      if (p.status == PointStatus::ok) CHECK(p.output_power <= power.value * (1 + 1e-9));
    }
  }
}
