// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/motion/plant_table.hpp>

#include <cmath>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

PlantTableOptions small_table() {
  PlantTableOptions options;
  options.amplitudes = 5, options.speed_ratios = 7;
  return options;
}

TEST_CASE("a table holds the contact of the operating point at its nodes", "[motion][plant]") {
  const MotorDesign design = elastic_60(7e-6);
  const PlantTable table = tabulate(design, small_table()).value();
  REQUIRE(table.amplitudes.size() == 5);
  REQUIRE(table.along.torque.size() == 35);
  CHECK(table.amplitudes.front() == 0);
  CHECK(table.speed_ratios.front() == 0);
  CHECK(std::isinf(table.speed_ratios.back()));

  MotorDesign given = design;
  given.stator.voltage.reset(), given.stator.amplitude = 1e-6;
  const Motor motor(given);
  const double omega = 2 * std::numbers::pi * table.frequency;
  for (const std::size_t i : {1, 3, 5}) {
    for (const std::size_t j : {1, 4}) {
      const double a = table.amplitudes[j];
      const double crest = table.crest_per_amplitude * omega * a;
      for (const double side : {1.0, -1.0}) {
        const ContactTable& its = side > 0 ? table.along : table.against;
        const auto p =
            motor.operating_point({side * table.speed_ratios[i] * crest, a, table.frequency});
        CAPTURE(i, j, side);
        // The same contact at a speed that is rounded once more: 1e-9 of the largest value.
        CHECK(its.torque[i * 5 + j] == Approx(p.torque).margin(1e-9 * table.holding_torque));
        CHECK(its.reactive_stiffness[i * 5 + j] == Approx(p.reactive_force / a).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("a table ends when it is told, and refuses what is none", "[motion][plant]") {
  PlantTableOptions options = small_table();
  double last = 0;
  options.go_on = [&](double share) { return (last = share) < 0.5; };
  CHECK_FALSE(tabulate(elastic_60(7e-6), options).has_value());
  CHECK(last == Approx(0.5));

  options = small_table();
  options.amplitudes = 1;
  CHECK_THROWS_AS(tabulate(elastic_60(7e-6), options), InputError);
  MotorDesign sprung = elastic_60(7e-6);
  sprung.load = ShaftLoad{.stiffness = 1};
  CHECK_THROWS_AS(tabulate(sprung, small_table()), InputError);
}

}  // namespace
