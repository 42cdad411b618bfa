// SPDX-License-Identifier: Apache-2.0
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <string>

namespace {

using namespace twum;
using namespace twum::test;
using P = Parameter;

MotorDesign sliced_ring() {
  MotorDesign design = ring_motor();
  design.stator.radial_slices = 8;
  return design;
}

}  // namespace

TEST_CASE("tracks that cannot be are refused with what would be right", "[core][annulus][error]") {
  const auto complaint_of = [](const MotorDesign& design) {
    const auto found = complaints(design);
    return found.empty() ? std::string() : found.front();
  };
  MotorDesign wide = ring_motor(), rooted = sliced_ring();
  rooted.stator.radial_shape = {2, 25e-3, {}};
  wide.stator.contact_width = 60e-3;
  CHECK(complaint_of(wide) ==
        "contact_width must be less than twice the contact_radius = 26.5 mm, but is 60 mm");
  CHECK_THROWS_AS(Motor(wide), InputError);
  CHECK_THROWS_AS(with(ring_motor(), P::contact_width, 60e-3), InputError);
  CHECK(complaint_of(rooted) ==
        "shape_root must lie outside the contact track, 24.5 mm to 28.5 mm, but is 25 mm");
  MotorDesign table = sliced_ring();
  auto& rows = table.stator.radial_shape.table;
  rows = {{0.024, 1}, {0.025, 1}, {0.029, 1}};
  CHECK(complaint_of(table) == "radial_shape.table needs at least 4 rows, but has 3");
  rows = {{0.025, 1}, {0.026, 1}, {0.027, 1}, {0.029, 1}};
  CHECK(complaint_of(table) ==
        "radial_shape.table must cover the contact track, 24.5 mm to 28.5 mm, but covers 25 mm to "
        "29 mm");
  rows = {{0.024, 1}, {0.026, 1}, {0.026, 1}, {0.029, 1}};
  CHECK(complaint_of(table) ==
        "radial_shape.table row 3 must have a larger radius than the row before, 26 mm, but has 26 "
        "mm");
  rows = {{0.024, -1}, {0.025, 0}, {0.027, 2}, {0.029, 4}};
  CHECK(complaint_of(table) ==
        "radial_shape.table must be positive on the contact track, but is -0.5 at 24.5 mm");
  CHECK(complaint_of(with(table, P::shape_exponent, 1)).empty());  // an exponent replaces the table
}
