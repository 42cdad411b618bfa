// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <vector>

// The word that comes with a gradient: where the torque is on a plateau, where a kink is, and where neither.
namespace {

using namespace twum;
using namespace twum::test;

Smoothness word(const Motor& motor, const MetricRequest& request) {
  return differentiated(motor, request).smoothness;
}

}  // namespace

TEST_CASE("a metric at a speed is flat exactly where no parameter of the wave moves it (C8.1)",
          "[core][derivative][identity]") {
  Uniform random(61);
  int flat_torques = 0, flat_sticks = 0, smooth_torques = 0, smooth_sticks = 0;
  for (int i = 0; i < 60; ++i) {
    const MotorDesign design = i % 3 == 0   ? holding_motor(random, i)
                               : i % 3 == 1 ? ringing_motor(random, i)
                                            : box_motor(random);
    const Motor motor(design);
    if (motor.contact().full || !(motor.holding_torque() > 0)) continue;
    for (const double share : {0.0, 0.13, 0.41, 0.77, 0.96, 1.07, 1.4}) {
      const double speed = share * motor.crest_speed();
      const OperatingPoint point = motor.operating_point(speed);
      if (point.status != PointStatus::ok) continue;
      CAPTURE(i, share, point.stick_fraction);
      // Slip one way all through, forwards or backwards: T = +-mu F_N r. Slip in turns: no place sticks.
      const std::vector<Zone> zones = motor.zones(speed);
      const bool one_way = zones.size() == 1 && zones[0].state != ZoneState::stick;
      bool sticks = false;
      for (const Zone& zone : zones) sticks = sticks || zone.state == ZoneState::stick;
      const auto at = [&](Metric which) { return word(motor, {which, Argument::speed, speed}); };
      CHECK(at(Metric::torque_at) == (one_way ? Smoothness::flat : Smoothness::smooth));
      CHECK(at(Metric::stick_fraction_at) == (sticks ? Smoothness::smooth : Smoothness::flat));
      ++(one_way ? flat_torques : smooth_torques);
      ++(sticks ? smooth_sticks : flat_sticks);
      for (const Metric which :
           {Metric::output_power_at, Metric::stator_power_at, Metric::friction_power_at,
            Metric::layer_loss_at, Metric::wear_intensity_at})
        CHECK(at(which) == Smoothness::smooth);
      if (share == 0)
        CHECK(word(motor, {Metric::stall_torque}) ==
              (one_way ? Smoothness::flat : Smoothness::smooth));
    }
  }
  CHECK(flat_torques > 50);
  CHECK(flat_sticks > 50);
  CHECK(smooth_torques > 50);
  CHECK(smooth_sticks > 50);
}

TEST_CASE(
    "the no-load speed of a contact that sticks all through is smooth where the torque is (C8.6)",
    "[core][derivative][closed_form]") {
  // Just there the zone of slip at the exit vanishes. With mu_0 = mu an elastic layer's torque has a slope on which
  // both sides agree; a layer that holds more than it slides has two slopes.
  // Rounding decides whether the zone is there at all.
  for (const double phi : {2.90, 3.00, 3.02, 3.03, 3.05, 3.06, 3.08, 3.09}) {
    const MotorDesign design = elastic_ring(phi, 10 * (1 / phi - 1 / std::tan(phi)));
    CAPTURE(phi);
    CHECK(word(Motor(design), {Metric::no_load_speed}) == Smoothness::smooth);
    MotorDesign rough = design;
    rough.friction.threshold = 1.2 * rough.friction.kinetic;
    CHECK(word(Motor(rough), {Metric::no_load_speed}) == Smoothness::one_sided);
  }
}

TEST_CASE(
    "where a zone is about to vanish or to appear a point is one-sided, but for elastic layers "
    "with mu_0 = mu",
    "[core][derivative][identity]") {
  Uniform random(5);
  int vanishing = 0, appearing = 0, ordinary = 0, elastics = 0;
  for (int i = 0; i < 40; ++i) {
    MotorDesign design = ringing_motor(random, i);
    design.layer.loss_factor = 0.1;
    if (i % 4 == 1) design = elastic(design);
    const Motor motor(design);
    double low = 0, high = 0;
    const auto count = [&](double speed) { return motor.zones(speed).size(); };
    for (int k = 1; k < 24; ++k, low = high) {
      high = k * 0.05 * motor.crest_speed();
      const std::size_t first = count(low);
      if (count(high) == first) continue;
      double left = low, right = high;
      for (int n = 0; n < 60; ++n) {
        const double middle = 0.5 * (left + right);
        (count(middle) == first ? left : right) = middle;
      }
      // Neighbouring speeds on both sides, some within 1e-9, which counts as the same speed, and some far off it.
      for (const double off : {-1e-3, -1e-10, 0.0, 1e-10, 1e-3}) {
        for (const double edge : {left, right}) {
          const double speed = edge + off * motor.crest_speed();
          const SpeedDerivative there = differentiate_in_speed(motor, speed);
          if (there.point.status != PointStatus::ok) continue;
          double shortest = 1;
          for (const Zone& zone : motor.zones(speed))
            shortest = std::fmin(shortest, zone.to - zone.from);
          CAPTURE(i, speed / motor.crest_speed(), shortest);
          const bool beside = std::fabs(off) < 1e-9;
          if (i % 4 == 1) {
            elastics += beside;
            CHECK(there.smoothness == Smoothness::smooth);
          } else if (beside) {
            ++(shortest < 1e-8 ? vanishing : appearing);
            CHECK(there.smoothness == Smoothness::one_sided);
          } else if (shortest > 1e-6) {
            ++ordinary;
            CHECK(there.smoothness == Smoothness::smooth);
          }
        }
      }
    }
  }
  CAPTURE(vanishing, appearing, ordinary, elastics);
  CHECK(vanishing >= 10);
  CHECK(appearing >= 10);
  CHECK(ordinary >= 20);
  CHECK(elastics >= 3);
}

TEST_CASE(
    "where contact just becomes full its angle has a kink, and so has all that follows (T3.2)",
    "[core][derivative][limit]") {
  const MotorDesign design = ring_motor();
  const double full = full_contact_load(design);
  const auto words = [&](double share) {
    MotorDesign loaded = design;
    loaded.preload = share * full;
    const Motor motor(loaded);
    std::vector<Smoothness> found;
    for (const Metric which :
         {Metric::stall_torque, Metric::contact_half_length, Metric::max_pressure})
      found.push_back(word(motor, {which}));
    return found;
  };
  // To either side by a few roundings of the preload.
  for (const double share : {1.0, 1 + 1e-15, 1 - 1e-15})
    for (const Smoothness found : words(share)) CHECK(found == Smoothness::one_sided);
  for (const double share : {0.9, 1.1})
    for (const Smoothness found : words(share)) CHECK(found == Smoothness::smooth);
}

TEST_CASE("a largest torque that is the stall torque moves as the stall torque does (T7.12, T7.13)",
          "[core][derivative][identity]") {
  Uniform box(11), real(7), ring(5);
  int equal = 0, slow = 0, rough = 0;
  for (int i = 0; i < 180; ++i) {
    const MotorDesign design = i % 3 == 0   ? random_box_point(box).design
                               : i % 3 == 1 ? holding_motor(real, i / 3)
                                            : ringing_motor(ring, i);
    const Motor motor(design);
    const std::vector<MetricRequest> requests{{Metric::max_torque}, {Metric::stall_torque}};
    const auto found = differentiate(motor, requests);
    const MetricDerivative &top = found[0], &stall = found[1];
    if (top.value.status != MetricStatus::ok || top.value.value != stall.value.value) continue;
    CAPTURE(i);
    ++equal;
    slow += motor.crest_speed() < 2;
    rough += design.friction.threshold > design.friction.kinetic;
    CHECK(top.smoothness == stall.smoothness);
    if (stall.smoothness != Smoothness::undefined) CHECK(top.gradient == stall.gradient);
  }
  CHECK(equal > 30);
  CHECK(slow > 3);
  CHECK(rough > 3);
}

TEST_CASE("without preload the size of the contact has no derivative (T3.2)",
          "[core][metrics][limit]") {
  // theta_L grows with the cube root of the first preload, and the pressure with its two thirds.
  MotorDesign design = ring_motor();
  for (const double preload : {0.0, 1e-6}) {
    design.preload = preload;
    const Motor motor(design);
    for (const Metric which :
         {Metric::contact_half_length, Metric::contact_ratio, Metric::max_pressure}) {
      const MetricDerivative found = differentiated(motor, {which});
      CAPTURE(info(which).name, preload);
      CHECK((found.value.value == 0) == (preload == 0));
      CHECK(found.smoothness == (preload == 0 ? Smoothness::undefined : Smoothness::smooth));
    }
  }
}
