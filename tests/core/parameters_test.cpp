// SPDX-License-Identifier: Apache-2.0
#include "support/heat_motors.hpp"
#include "support/plate_motors.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace {

using namespace twum;
using namespace twum::test;
using P = Parameter;

MotorDesign ring() { return test::ring_motor(); }

}  // namespace

TEST_CASE("the parameter table has one row for each parameter, in order",
          "[core][design][identity]") {
  REQUIRE(parameter_table().size() == kParameterCount);
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    const ParameterInfo& row = parameter_table()[i];
    CAPTURE(row.name);
    CHECK(index_of(row.parameter) == i);
    CHECK(&info(row.parameter) == &row);
    CHECK(words.insert(row.name).second);
    if (!row.symbol.empty()) CHECK(words.insert(row.symbol).second);
    CHECK(find_parameter(row.name) == row.parameter);
    if (!row.symbol.empty()) CHECK(find_parameter(row.symbol) == row.parameter);
    if (row.alternative) CHECK(info(*row.alternative).alternative == row.parameter);
    CHECK(row.min < row.max);
    CHECK_FALSE(row.text.empty());
    CHECK_FALSE(row.reason.empty());
    CHECK_FALSE(row.example.empty());
  }
  CHECK_FALSE(find_parameter("no such thing").has_value());
  CHECK_FALSE(find_parameter("").has_value());
}

TEST_CASE("every parameter of the ring motor can be set and read back",
          "[core][design][identity]") {
  for (const ParameterInfo& row : parameter_table()) {
    CAPTURE(row.name);
    // what shapes the track is in use where it has more than one slice
    const MotorDesign design = of_geometry(row.parameter) ? plate_motor()
                               : of_heat(row.parameter)   ? motor_that_gives(row.parameter)
                               : of_driven_stator(row.parameter)
                                   ? unequal_motor()
                                   : with(ring(), P::radial_slices, 8);
    const double now = get(design, row.parameter);
    const double value = row.integer                           ? now + 1
                         : row.parameter == P::static_friction ? 0.3
                         : of_geometry(row.parameter)          ? now * (1 + 1e-4)
                                                               : now * 0.9 + 1e-9;
    const MotorDesign changed = with(design, row.parameter, value);
    CHECK(get(changed, row.parameter) == Approx(value).epsilon(1e-15));
    CHECK(in_use(changed, row.parameter));
    if (row.alternative) CHECK_FALSE(in_use(changed, *row.alternative));
  }
}

TEST_CASE("a parameter's alternative says the same (T1.2, T1.3, T1.4)",
          "[core][design][identity]") {
  const MotorDesign given = with(ring(), P::shear_modulus, 1.2e9);
  CHECK(get(given, P::poisson_ratio) == Approx(3e9 / 2.4e9 - 1).epsilon(1e-14));
  CHECK(get(with(given, P::poisson_ratio, 0.25), P::shear_modulus) == Approx(1.2e9).epsilon(1e-15));
  const double omega = 251327.41228718346;
  const MotorDesign viscous = with(ring(), P::shear_viscosity, 100);
  CHECK(get(viscous, P::loss_factor) ==
        Approx(100 * omega / shear_modulus(viscous)).epsilon(1e-14));
  const MotorDesign heavy = with(ring(), P::inertia, 6e-5);
  CHECK(get(heavy, P::density) == Approx(3 * 6e-5 / (0.3e-3 * 0.3e-3)).epsilon(1e-14));
}

TEST_CASE("static friction keeps its ratio unless it is set itself", "[core][design][identity]") {
  MotorDesign design = ring();
  design.friction = {0.2, 0.25};
  const MotorDesign more = with(design, P::kinetic_friction, 0.3);
  CHECK(more.friction.kinetic == 0.3);
  CHECK(more.friction.threshold == Approx(0.375).epsilon(1e-15));
  const std::array<ParameterValue, 2> both{{{P::static_friction, 0.5}, {P::kinetic_friction, 0.3}}};
  CHECK(with(design, both).friction.threshold == 0.5);  // whatever the order
  CHECK(with(design, both).friction.kinetic == 0.3);
  CHECK_THROWS_AS(with(design, P::static_friction, 0.1), InputError);
}

// Each value is a product of powers of the others: its slope is the power times the quotient.
TEST_CASE("parameters that follow from others move with them (T1.2, T1.3, T1.4)",
          "[core][design][identity]") {
  const double eps = 1e-14;  // a few roundings of quotients and products
  MotorDesign design = ring();
  design.friction = {0.2, 0.25};
  const auto of = [](const ParameterJacobian& j, P value, P moved) {
    return j[index_of(value)][index_of(moved)];
  };
  const ParameterJacobian j = parameter_jacobian(design);
  const double G = shear_modulus(design), gamma = shear_viscosity(design), m = inertia(design);
  CHECK(of(j, P::youngs_modulus, P::youngs_modulus) == 1);
  CHECK(of(j, P::shear_modulus, P::youngs_modulus) == Approx(G / 3e9).epsilon(eps));
  CHECK(of(j, P::shear_modulus, P::poisson_ratio) == Approx(-G / 1.35).epsilon(eps));
  CHECK(of(j, P::shear_viscosity, P::poisson_ratio) == Approx(-gamma / 1.35).epsilon(eps));
  CHECK(of(j, P::shear_viscosity, P::frequency) == Approx(-gamma / 40e3).epsilon(eps));
  CHECK(of(j, P::inertia, P::thickness) == Approx(2 * m / 0.3e-3).epsilon(eps));
  CHECK(of(j, P::static_friction, P::kinetic_friction) == Approx(1.25).epsilon(eps));
  CHECK(of(parameter_jacobian(design, true), P::static_friction, P::kinetic_friction) == 0);
  for (const ParameterInfo& row : parameter_table())
    CHECK(of(j, row.parameter, P::shear_modulus) == 0);  // not in use
  const ParameterJacobian given = parameter_jacobian(with(design, P::shear_modulus, 1.1e9));
  CHECK(of(given, P::poisson_ratio, P::shear_modulus) ==
        Approx(-3e9 / (2 * 1.1e9 * 1.1e9)).epsilon(eps));
  CHECK(of(given, P::shear_modulus, P::youngs_modulus) == 0);
}

TEST_CASE("setting both of a pair is refused", "[core][design][error]") {
  const std::array<ParameterValue, 2> both{{{P::poisson_ratio, 0.3}, {P::shear_modulus, 1e9}}};
  CHECK_THROWS_AS(with(ring(), both), InputError);
}

TEST_CASE("values outside their range are refused for every parameter", "[core][design][error]") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ParameterInfo& row : parameter_table()) {
    CAPTURE(row.name);
    const double below = row.min - 1e-3 * (row.max - row.min);
    for (const double value : {below, 2 * row.max, std::nan(""), infinity, -infinity}) {
      CHECK_FALSE(complaint(row.parameter, value).empty());
      CHECK_THROWS_AS(with(ring(), row.parameter, value), InputError);
    }
    const MotorDesign design = of_geometry(row.parameter)        ? plate_motor()
                               : of_heat(row.parameter)          ? motor_that_gives(row.parameter)
                               : of_driven_stator(row.parameter) ? unequal_motor()
                                                                 : ring();
    CHECK(complaint(row.parameter, get(design, row.parameter)).empty());
  }
  CHECK_FALSE(complaint(P::wavelengths, 8.5).empty());
}

// Theory sections 1 and 10: what the model divides by must exceed zero, all else may vanish.
TEST_CASE("zero is admissible where the model has an answer for it", "[core][design][limit]") {
  for (const P p :
       {P::amplitude, P::modal_damping, P::poisson_ratio, P::density, P::loss_factor,
        P::shear_viscosity, P::inertia, P::kinetic_friction, P::static_friction, P::preload}) {
    CAPTURE(info(p).name);
    CHECK(complaint(p, 0).empty());
  }
  for (const P p : {P::wavelengths, P::contact_radius, P::contact_width, P::neutral_plane_distance,
                    P::frequency, P::thickness, P::youngs_modulus, P::shear_modulus}) {
    CAPTURE(info(p).name);
    CHECK_FALSE(complaint(p, 0).empty());
  }
  CHECK_FALSE(complaint(P::poisson_ratio, -1).empty());  // G = E / (2 (1 + nu)) has no value there
  CHECK(complaint(P::poisson_ratio, 0.5).empty());       // rubber
  CHECK_FALSE(complaint(P::poisson_ratio, 0.5 + 1e-9).empty());  // no stable isotropic material
}

TEST_CASE("a design's complaints are complete", "[core][design][error]") {
  MotorDesign design = ring();
  CHECK(complaints(design).empty());
  design.preload = -3;
  design.stator.wavelengths = 2.5;
  design.layer.given_inertia = std::nan("");
  CHECK(complaints(design).size() == 3);
}
