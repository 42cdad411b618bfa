// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/deviations.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Where the plateau ends (T7.17): beside the speeds a search radii_between_turns at, and where mu_0 > mu ends it early.
namespace {

using namespace twum;
using namespace twum::test;

bool slips_one_way(const Motor& motor, double speed) {
  const std::vector<Zone> zones = motor.zones(speed);
  return zones.size() == 1 && zones[0].state == ZoneState::slip_plus;
}

// The smallest share of the crest velocity by which the stator overtakes the layer just before the plateau's end, by
// samples over the contact; nothing is overtaken less where slip ends of itself.
double least_slip(const Motor& motor, double speed) {
  const ContactFields fields = motor.fields(speed, 20001);
  const double half = motor.contact().half_angle;
  double least = 1e300;
  for (const FieldSample& sample : fields.samples)
    if (std::abs(sample.phase) <= half)
      least = std::min(least, sample.stator_velocity - sample.layer_velocity);
  return least / (motor.crest_speed() * motor.design().stator.contact_radius);
}

}  // namespace

TEST_CASE("an elastic layer's plateau ends where it should beside any round speed (C8.5, T7.17)",
          "[core][metrics][closed_form]") {
  Deviation deviation("plateau speed of the elastic layer beside round speeds, of V0 / r", 1e-13);
  const double phi = 0.6;
  for (int k = 1; k <= 16; ++k) {
    for (const double beside : {-2e-5, -3e-8, 3e-8, 2e-5}) {
      const double end = 0.05 * k + beside;
      if (!(end < std::cos(phi) - 1e-3)) continue;
      // V = cos phi - S sin phi with S = S_0 (1 + kappa V0 V / omega), solved for S_0.
      const MotorDesign ring = ring_motor();
      const double wave_number = ring.stator.wavelengths / ring.stator.contact_radius;
      const double coupling = wave_number * crest_speed_of(ring) * ring.stator.contact_radius /
                              (2 * std::numbers::pi * ring.stator.frequency);
      const double compliance = (std::cos(phi) - end) / (std::sin(phi) * (1 + coupling * end));
      const Motor motor(elastic_ring(phi, compliance));
      CAPTURE(end);
      // The half angle carries the rounding of the preload, some 1e-15.
      CHECK(deviation.add(ask(motor, Metric::plateau_speed).value / motor.crest_speed(), end, 1) <=
            1e-13);
    }
  }
  CHECK(deviation.holds());
}

TEST_CASE("with mu_0 well above mu the plateau ends where the layer first does something else",
          "[core][metrics][brute_force]") {
  Uniform random(7);
  std::vector<MotorDesign> designs{sticky_motor()};
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = holding_motor(random, i);
    if (i % 2 == 1) continue;
    designs.push_back(design);
    design.layer.loss_factor *= 0.1;
    designs.push_back(design);
  }
  int in_time = 0, early = 0;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const Motor motor(designs[i]);
    const MetricDerivative end = differentiated(motor, {Metric::plateau_speed});
    CAPTURE(i, end.value.value / motor.crest_speed(), to_string(end.value.status));
    if (end.value.status != MetricStatus::ok || !(end.value.value > 0)) continue;
    const double speed = end.value.value;
    CHECK(slips_one_way(motor, speed * (1 - 1e-9)));
    CHECK_FALSE(slips_one_way(motor, speed * (1 + 1e-9)));
    for (int k = 0; k < 40; ++k) CHECK(slips_one_way(motor, speed * k / 40));
    // Slip ends of itself where the stator no longer overtakes the layer somewhere; 20,001 samples miss that place by
    // 1e-4, and the least by half its square times the curvature, some thousand V0 at most. A plateau that the layer
    // leaves before has no derivative.
    const bool left_before = least_slip(motor, speed * (1 - 1e-9)) > 1e-4;
    if (left_before) CHECK(end.smoothness == Smoothness::undefined);
    early += left_before;
    in_time += !left_before && end.smoothness == Smoothness::smooth;
  }
  CHECK(in_time >= 20);
  CHECK(early >= 5);
}

TEST_CASE("a narrow contact that holds more than it slides carries every load below its largest",
          "[core][metrics][brute_force]") {
  const Motor motor(sticky_motor());
  const double unit = motor.holding_torque();
  const std::vector<MetricRequest> requests{{Metric::max_torque},
                                            {Metric::no_load_speed},
                                            {Metric::speed_at, Argument::torque, 0.1 * unit},
                                            {Metric::speed_at, Argument::torque, 0.3 * unit},
                                            {Metric::speed_at, Argument::torque, 0.5 * unit}};
  const std::vector<MetricValue> found = evaluate(motor, requests);
  for (const MetricValue& each : found) REQUIRE(each.status == MetricStatus::ok);
  REQUIRE(found[0].value > 0.5 * unit);
  for (std::size_t k = 2; k < found.size(); ++k) {
    const double speed = found[k].value, load = requests[k].at;
    CAPTURE(load / unit);
    // A root in speed, or a jump past the load; torque falls by some thousand scales per V0 / r at the most.
    CHECK(motor.operating_point(speed * (1 - 1e-9)).torque >= load - 1e-5 * unit);
    CHECK(motor.operating_point(speed * (1 + 1e-9)).torque <= load + 1e-5 * unit);
    CHECK(speed <= found[1].value);
  }
}
