// SPDX-License-Identifier: Apache-2.0
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// A contact with width whose slices jump, which takes mu_0 > mu.
namespace {

using namespace twum;
using namespace twum::test;

MotorDesign with_threshold(MotorDesign design, double ratio, int slices) {
  design.friction.static_ = ratio * design.friction.kinetic;
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
