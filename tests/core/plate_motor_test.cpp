// SPDX-License-Identifier: Apache-2.0
#include "support/metric_requests.hpp"
#include "support/plate_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Motors whose stator is given by its geometry.
namespace {

using namespace twum;
using namespace twum::test;
using P = Parameter;

// The same motor with the numbers of its plate as modal data.
MotorDesign by_modal_data(const MotorDesign& design) {
  MotorDesign copy = design;
  Stator& s = copy.stator;
  s.geometry.reset();
  s.neutral_plane_distance = get(design, P::neutral_plane_distance);
  s.resonance_frequency = get(design, P::resonance_frequency);
  s.modal_mass = get(design, P::modal_mass);
  s.force_factor = get(design, P::force_factor);
  s.blocked_capacitance = get(design, P::blocked_capacitance);
  return copy;
}

}  // namespace

TEST_CASE("a motor from its geometry is the motor with the plate's modal data (P4.1, P4.4, P4.5)",
          "[core][plate][identity]") {
  const MotorDesign design = plate_motor();
  const auto plate = plate_model(design);
  CHECK(get(design, P::resonance_frequency) == plate->frequency.v);
  CHECK(get(design, P::modal_mass) == plate->modal_mass.v);
  CHECK(get(design, P::frequency) == Approx(1.046 * plate->frequency.v).epsilon(1e-15));
  const auto asked = every_metric(8.1, 0.3);
  const auto found = values_of(design, asked), expected = values_of(by_modal_data(design), asked);
  int compared = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (info(asked[i].metric).needs_geometry) continue;  // modal data do not tell
    if (asked[i].metric == Metric::radial_motion_ratio) continue;
    CAPTURE(info(asked[i].metric).name);
    // the same numbers in the same operations: equal to the bit
    CHECK((found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]))));
    compared += std::isfinite(found[i]);
  }
  CHECK(compared > 40);
}

TEST_CASE(
    "a plate computes what is asked: numbers without derivatives, and the separation alone (P4.7)",
    "[core][plate][identity]") {
  MotorDesign design = plate_motor();
  keep_plate(design);
  using stator::Derivatives, stator::OtherModes;
  const auto values = plate_model(design, OtherModes::none, Derivatives::none);
  CHECK(plate_model(design, OtherModes::none, Derivatives::none) == values);  // computed once
  CHECK(std::isnan(values->frequency.d[0]));
  const auto whole = plate_model(design);
  // The same numbers, of which the dual ones multiply by an inverse where the plain ones divide: some roundings.
  CHECK(values->frequency.v == Approx(whole->frequency.v).epsilon(1e-14));
  CHECK(values->modal_mass.v == Approx(whole->modal_mass.v).epsilon(1e-13));
  CHECK(values->force_factor.v == Approx(whole->force_factor.v).epsilon(1e-13));
  const stator::Derived plain = plate_separation(design, Derivatives::none);
  const stator::Derived sloped = plate_separation(design, Derivatives::all);
  CHECK(std::isnan(plain.d[0]));
  CHECK(plain.v == whole->mode_separation.v);
  CHECK(std::equal(std::begin(sloped.d), std::end(sloped.d), std::begin(whole->mode_separation.d)));
}

TEST_CASE(
    "the modes beside the wave are found where they are asked for, and change nothing else (P4.7)",
    "[core][plate][identity]") {
  MotorDesign design = plate_motor();
  keep_plate(design);
  const auto wave = plate_model(design, stator::OtherModes::none);
  CHECK(std::isnan(wave->mode_separation.v));
  CHECK(wave->unwanted.empty());
  const auto whole = plate_model(design);
  CHECK(whole->mode_separation.v > 0);
  CHECK(whole->unwanted.size() > 8);
  CHECK(plate_model(design) == whole);  // solved once
  CHECK(plate_model(MotorDesign(design), stator::OtherModes::none) == wave);
  CHECK(whole->frequency.v == wave->frequency.v);
  CHECK(std::equal(std::begin(whole->frequency.d), std::end(whole->frequency.d),
                   std::begin(wave->frequency.d)));
  CHECK(whole->force_factor.v == wave->force_factor.v);
}

TEST_CASE("the surface turns with the teeth, without teeth with the sheared plate (P4.3)",
          "[core][plate][identity]") {
  MotorDesign design = plate_motor();
  CHECK(get(design, P::neutral_plane_distance) == plate_model(design)->neutral_plane_distance.v);
  design.stator.geometry->teeth.reset();
  const auto plate = plate_model(design);
  const double expected = plate->neutral_plane_distance.v * plate->tangential_share.v;
  CHECK(get(design, P::neutral_plane_distance) == Approx(expected).epsilon(1e-15));
}

// Through its four points and the middle the polynomial leaves the fifth derivative's share; a mode of nine waves changes over
// r / n = 2.9 mm, so that a half width of 2 mm leaves (2 / 2.9)^5 / (16 5!) = 8e-5 of it where R grew like exp.
TEST_CASE("the shape on the track is that of the mode (P8.1)", "[core][plate]") {
  MotorDesign design = plate_motor();
  design.stator.radial_slices = 32;
  MotorDesign table = by_modal_data(design);
  const auto plate = plate_model(design);
  const double inner = 24.5e-3, outer = 28.5e-3;
  for (int i = 0; i <= 80; ++i) {
    const double radius = inner + (outer - inner) * i / 80;
    table.stator.radial_shape.table.emplace_back(radius, plate->shape(radius));
  }
  for (const Metric metric : {Metric::stall_torque, Metric::no_load_speed, Metric::max_efficiency,
                              Metric::pressure_nonuniformity, Metric::max_pressure}) {
    const double found = evaluate(Motor(design), {metric}).value,
                 expected = evaluate(Motor(table), {metric}).value;
    CAPTURE(info(metric).name, found, expected);
    // pressures follow R times the amplitude over the indentation, some tenths: ten times the error of R at most
    CHECK(found == Approx(expected).epsilon(8e-4));
    CHECK(found != evaluate(Motor(by_modal_data(design)), {metric}).value);
  }
}

namespace {

void compare_derivatives(const MotorDesign& design) {
  // Radii lie 0.1 mm apart, 4e-3 of themselves. A relative change of a length counts up to 25 * 2 times near the resonance:
  // Richardson's extrapolation leaves (50 * 2e-5)^4 = 1e-12. Eigenvalues are good to 1e-11, of which the quotient by 2e-5
  // makes 1e-6, and the resonance's 25 times 2e-5 of the value.
  const GradientCheck check = against_differences(design, every_metric(8.1, 0.3), 2e-5);
  CAPTURE(check.where);
  CHECK(check.worst <= 2e-5);
  CHECK(check.compared > 1500);
}

}  // namespace

TEST_CASE("gradients of a motor from its geometry are the limits of differences (P5.1, P5.2, P8.1)",
          "[core][plate][derivative]") {
  MotorDesign design = plate_motor();
  SECTION("one slice, under a voltage") { compare_derivatives(design); }
  SECTION("over the width of the track") {
    design.stator.radial_slices = 6;
    compare_derivatives(design);
  }
  SECTION("with an amplitude and electrodes as wide as the ceramic") {
    design.stator.geometry->electrodes = {4, {}, {}};
    compare_derivatives(with(design, P::amplitude, 1.5e-6));
  }
}

TEST_CASE("a count of teeth and slots moves the plate as their product (P1.8)",
          "[core][plate][identity]") {
  const MotorDesign design = plate_motor();
  const MetricDerivative found =
      differentiate(Motor(design), std::vector<MetricRequest>{{Metric::coupling_factor}})[0];
  const double by_count = found.gradient[index_of(P::teeth_count)] * get(design, P::teeth_count),
               by_width =
                   found.gradient[index_of(P::teeth_slot_width)] * get(design, P::teeth_slot_width);
  CHECK(by_count == Approx(by_width).epsilon(1e-14));
}

TEST_CASE("the ceramic's stress grows with the amplitude (P4.8)", "[core][plate][scaling]") {
  const MotorDesign design = with(plate_motor(), P::amplitude, 1e-6);
  const auto stress = [&](double amplitude) {
    return evaluate(Motor(with(design, P::amplitude, amplitude)), {Metric::ceramic_stress}).value;
  };
  CHECK(stress(2e-6) == Approx(2 * stress(1e-6)).epsilon(1e-14));
  CHECK(stress(1e-6) == Approx(1e-6 * plate_model(design)->ceramic_stress.v).epsilon(1e-14));
}

TEST_CASE("what a geometry does not go with is refused by name", "[core][plate][error]") {
  const MotorDesign design = plate_motor();
  CHECK_THROWS_WITH(with(driven_motor(), P::ceramic_thickness, 1e-3),
                    Catch::Contains("ceramic_thickness") && Catch::Contains("geometry"));
  CHECK_THROWS_WITH(with(design, P::modal_mass, 0.03),
                    Catch::Contains("follows from the geometry"));
  CHECK_THROWS_WITH(with(design, P::shape_root, 0.01),
                    Catch::Contains("follows from the geometry"));
  const auto motor = [&](P parameter, double value) {
    return Motor(with(design, parameter, value));
  };
  CHECK_THROWS_WITH(motor(P::ceramic_outer_radius, 0.031),
                    Catch::Contains("ceramic_outer_radius must be at most 30 mm"));
  CHECK_THROWS_WITH(motor(P::contact_width, 0.012),
                    Catch::Contains("contact_width must leave the contact track on the stator") &&
                        Catch::Contains("reaches 32.5 mm"));
  CHECK_THROWS_WITH(motor(P::wavelengths, 7), Catch::Contains("so that two phases fit"));
  MotorDesign bare = design;
  bare.stator.geometry->web.reset();
  CHECK_THROWS_WITH(with(bare, P::web_thickness, 1e-3), Catch::Contains("the block 'web'"));
  CHECK(std::isnan(get(bare, P::web_thickness)));
  MotorDesign both = design;
  both.stator.modal_mass = 0.03;
  CHECK_THROWS_WITH(Motor(both), Catch::Contains("geometry must stand without modal data"));
}

TEST_CASE("blocks of the geometry that are left out have no parameters in use", "[core][plate]") {
  MotorDesign design = plate_motor();
  CHECK(in_use(design, P::glue_density));
  CHECK(in_use(design, P::electrodes_inner_radius));
  CHECK_FALSE(in_use(design, P::modal_mass));
  CHECK_FALSE(in_use(design, P::neutral_plane_distance));
  stator::StatorGeometry& g = *design.stator.geometry;
  g.web.reset(), g.teeth.reset(), g.glue.thickness = 0, g.electrodes = {4, {}, {}};
  for (const P absent : {P::web_thickness, P::teeth_count, P::teeth_height, P::glue_density,
                         P::electrodes_inner_radius})
    CHECK_FALSE(in_use(design, absent));
  CHECK(in_use(design, P::glue_thickness));
  CHECK(get(design, P::electrodes_outer_radius) == g.ceramic.outer_radius);
}

TEST_CASE("parameters of the geometry are named after its dimensions", "[core][plate]") {
  for (const ParameterInfo& row : parameter_table()) {
    if (!of_geometry(row.parameter) || row.parameter == P::teeth_count ||
        row.parameter == P::electrodes_waves_per_phase)
      continue;
    CAPTURE(row.name);
    const auto& dimensions = stator::dimension_table();
    const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                    [&](const auto& one) { return one.name == row.name; });
    REQUIRE(found != dimensions.end());
    CHECK(found->unit == row.unit);
    // Setting the parameter moves that dimension, and no other.
    const auto dimension = static_cast<stator::Dimension>(found - dimensions.begin());
    const MotorDesign design = plate_motor();
    const double now = get(design, row.parameter);
    const MotorDesign moved = with(design, row.parameter, now * (1 + 1e-4));
    CHECK(*find(*moved.stator.geometry, dimension) == Approx(now * (1 + 1e-4)).epsilon(1e-15));
  }
}
