// SPDX-License-Identifier: Apache-2.0
#include "support/stators.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace {

using namespace twum;
using namespace twum::stator;
using namespace twum::test;

std::string complaint(const std::function<void(StatorGeometry&)>& change) {
  StatorGeometry g = distinct_stator();
  change(g);
  try {
    check_geometry(g);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a stator that can be built is accepted", "[stator][input]") {
  CHECK(complaint([](StatorGeometry&) {}).empty());
  CHECK(complaint([](StatorGeometry& g) { g.web.reset(); }).find("ceramic") == std::string::npos);
  CHECK(complaint([](StatorGeometry& g) { g.glue.thickness = 0; }).empty());
  CHECK(complaint([](StatorGeometry& g) { g.electrodes = {4, {}, {}}; }).empty());
  CHECK(complaint([](StatorGeometry& g) { g.ceramic.d31 *= -1; }).empty());
}

TEST_CASE("a wrong dimension is named, with what was found and what would be right",
          "[stator][input]") {
  const auto says = [](const std::function<void(StatorGeometry&)>& change,
                       const std::string& text) {
    const std::string found = complaint(change);
    CAPTURE(found);
    CHECK(found.find(text) != std::string::npos);
  };
  says([](auto& g) { g.substrate.thickness = -1e-3; },
       "substrate_thickness must be above 0 m, but is -1 mm");
  says([](auto& g) { g.ceramic.youngs_modulus = 0; },
       "ceramic_youngs_modulus must be above 0 Pa, but is 0 Pa");
  says([](auto& g) { g.substrate.poisson_ratio = 0.7; },
       "substrate_poisson_ratio must be at most 0.5, but is 0.7");
  says([](auto& g) { g.teeth->stiffness_share = 1.2; },
       "teeth_stiffness_share must be at most 1, but is 1.2");
  says([](auto& g) { g.teeth->count = 0; }, "teeth_count must be at least 1, but is 0");
  says([](auto& g) { g.teeth->slot_width = 2e-3; },
       "must be below the pitch of the teeth at their inner radius");
  says([](auto& g) { g.ceramic.outer_radius = 0.031; },
       "ceramic_outer_radius must be at most 30 mm (substrate_outer_radius), but is 31 mm");
  says([](auto& g) { g.web->outer_radius = 0.019; },
       "web_outer_radius must be at least 20.5 mm (substrate_inner_radius), but is 19 mm");
  says([](auto& g) { g.web->inner_radius = 0.022; },
       "web_inner_radius must be below 21 mm (web_outer_radius), but is 22 mm");
  says([](auto& g) { g.electrodes.outer_radius = 0.02985; },
       "electrodes_outer_radius must be at most 29.8 mm (ceramic_outer_radius), but is 29.85 mm");
  says(
      [](auto& g) {
        g.electrodes = {4, 0.0299, {}};
      },
      "electrodes_inner_radius must be below 29.8 mm (ceramic_outer_radius), but is 29.9 mm");
  says([](auto& g) { g.electrodes.waves_per_phase = 0; },
       "electrodes_waves_per_phase must be above 0, but is 0");
  says([](auto& g) { g.ceramic.permittivity = 1e-9; },
       "ceramic_d31 must give a planar coupling factor squared");
  says([](auto& g) { g.glue.thickness = std::numeric_limits<double>::quiet_NaN(); },
       "glue_thickness must be at least 0 m, but is nan m");
}

TEST_CASE("everything that is wrong is told at once", "[stator][input]") {
  const std::string found = complaint([](StatorGeometry& g) {
    g.substrate.density = 0;
    g.web->thickness = 0;
    g.ceramic.permittivity = 0;
  });
  for (const char* name : {"substrate_density", "web_thickness", "ceramic_permittivity"}) {
    CHECK(found.find(name) != std::string::npos);
  }
}

TEST_CASE("wavelengths, contact radius and phases that do not fit", "[stator][input]") {
  const auto g = distinct_stator();
  CHECK_THROWS_WITH(stator_model(g, 0, kContactRadius),
                    Catch::Contains("wavelengths must be a whole number of 1 or more, but is 0"));
  CHECK_THROWS_WITH(
      stator_model(g, 9, 0.031),
      Catch::Contains(
          "contact_radius must lie on the stator, between 12.5 mm and 30 mm, but is 31 mm"));
  CHECK_THROWS_WITH(
      stator_model(g, 7, kContactRadius),
      Catch::Contains("electrodes_waves_per_phase must be at most half of the 7 wavelengths"));
  CHECK_THROWS_AS(stator_modes(g, -1, 1), InputError);
  CHECK_THROWS_AS(stator_modes(g, 9, 0), InputError);
}

TEST_CASE("a wave that no mode of the plate carries is refused", "[stator][input][limit]") {
  // Modes of one nodal diameter are orthogonal to the tilt R = rho of the free plate, so each changes its sign.
  StatorGeometry ring = distinct_stator();
  // So thin and wide that the eight lowest are bending modes.
  ring.web.reset(), ring.teeth.reset(), ring.support = InnerEdge::free;
  ring.substrate.inner_radius = 3e-3, ring.substrate.thickness = 0.3e-3;
  ring.ceramic.thickness = 0.1e-3, ring.electrodes.waves_per_phase = 0.5;
  try {
    stator_model(ring, 1, kContactRadius);
    FAIL("there is such a mode");
  } catch (const EvaluationError& error) {
    CHECK(error.reason() == "no-ring-mode");
    CHECK_THAT(error.what(), Catch::Contains("1 nodal diameter"));
  }
  ring.support = InnerEdge::clamped;
  CHECK(stator_model(ring, 1, kContactRadius).frequency.v > 0);
}

TEST_CASE("plates that cannot be", "[stator][input]") {
  const Section section = section_of<double>({{1e-3, 1e11, 0.3, 8000}});
  const auto modes = [](const std::vector<Segment>& segments) {
    return plate_modes(segments, PlateTheory::mindlin, InnerEdge::free, 2, 1);
  };
  CHECK_THROWS_WITH(modes({}), Catch::Contains("no segment"));
  CHECK_THROWS_WITH(modes({{0, 1, section}}), Catch::Contains("0 < inner < outer"));
  CHECK_THROWS_WITH(modes({{1, 2, section}, {2.5, 3, section}}),
                    Catch::Contains("must begin where the one before ends"));
  Section soft = section;
  soft.bending_stiffness = 0;
  CHECK_THROWS_WITH(modes({{1, 2, soft}}), Catch::Contains("bending stiffness"));
  Section thin = section;
  thin.rotary_inertia = 0;
  CHECK_THROWS_WITH(modes({{1, 2, thin}}), Catch::Contains("rotary inertia above 0"));
}

TEST_CASE("names of dimensions find their members", "[stator][input]") {
  StatorGeometry g = distinct_stator();
  std::set<std::string_view> names;
  std::set<const double*> members;
  for (std::size_t i = 0; i < kDimensions; ++i) {
    names.insert(dimension_table()[i].name);
    const double* member = find(g, static_cast<Dimension>(i));
    if (static_cast<Dimension>(i) == Dimension::contact_radius) {
      CHECK(member == nullptr);
    } else {
      REQUIRE(member != nullptr);
      members.insert(member);
    }
  }
  CHECK(names.size() == kDimensions);
  CHECK(members.size() == kDimensions - 1);
  CHECK(find(g, Dimension::ceramic_thickness) == &g.ceramic.thickness);
  CHECK(dimension_table()[static_cast<std::size_t>(Dimension::ceramic_thickness)].name ==
        "ceramic_thickness");
}

TEST_CASE("very narrow rings are right or refused", "[stator][limit]") {
  // A ring without ceramic between web and ceramic shrinks to nothing: the frequency changes by the width times its
  // slope, about 2.3e5 Hz/m, and numerically by rounding, 1e-16 over the share of the width, 1e-7 at worst.
  StatorGeometry g = distinct_stator();
  g.ceramic.inner_radius = g.web->outer_radius;
  g.electrodes = {4, {}, {}};
  const double limit = stator_model(g, kWaves, kContactRadius).frequency.v;
  for (const double width : {1e-5, 1e-7, 1e-9}) {
    g.ceramic.inner_radius = g.web->outer_radius + width;
    CAPTURE(width);
    CHECK(std::abs(stator_model(g, kWaves, kContactRadius).frequency.v - limit) <
          1e6 * width + 1e-7 * limit);
    if (width < 1e-5) {
      CHECK_THROWS_WITH(stator_model(g, kWaves, kContactRadius, PlateTheory::kirchhoff),
                        Catch::Contains("choose Mindlin's plate"));
    }
  }
  const Section section = section_of<double>({{1e-3, 1e11, 0.3, 8000}});
  CHECK_THROWS_WITH(plate_modes({{1, 2, section}, {2, 2 + 1e-10, section}}, PlateTheory::mindlin,
                                InnerEdge::free, 2, 1),
                    Catch::Contains("Give its two edges the same radius"));
}
