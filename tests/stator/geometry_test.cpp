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
       "substrate_thickness is -0.001 m; it must be above 0 m");
  says([](auto& g) { g.ceramic.youngs_modulus = 0; },
       "ceramic_youngs_modulus is 0 Pa; it must be above 0 Pa");
  says([](auto& g) { g.substrate.poisson_ratio = 0.7; },
       "substrate_poisson_ratio is 0.7; it must be at most 0.5");
  says([](auto& g) { g.teeth->stiffness_share = 1.2; },
       "teeth_stiffness_share is 1.2; it must be at most 1");
  says([](auto& g) { g.teeth->count = 0; }, "teeth_count is 0; it must be at least 1");
  says([](auto& g) { g.teeth->slot_width = 2e-3; },
       "it must be below the pitch of the teeth at their inner radius");
  says([](auto& g) { g.ceramic.outer_radius = 0.031; },
       "ceramic_outer_radius is 0.031 m; it must be at most 0.03 m");
  says([](auto& g) { g.web->outer_radius = 0.019; },
       "web_outer_radius is 0.019 m; it must be at least 0.0205 m");
  says([](auto& g) { g.web->inner_radius = 0.022; },
       "web_inner_radius is 0.022 m; it must be below web_outer_radius");
  says([](auto& g) { g.electrodes.outer_radius = 0.02985; },
       "electrodes_outer_radius is 0.02985 m; it must be at most 0.0298 m");
  says(
      [](auto& g) {
        g.electrodes = {4, 0.0299, {}};
      },
      "electrodes_inner_radius is 0.0299 m; it must be below 0.0298 m");
  says([](auto& g) { g.electrodes.waves_per_phase = 0; },
       "electrodes_waves_per_phase is 0; it must be above 0");
  says([](auto& g) { g.ceramic.permittivity = 1e-9; },
       "check ceramic_d31 and ceramic_permittivity");
  says([](auto& g) { g.glue.thickness = std::numeric_limits<double>::quiet_NaN(); },
       "glue_thickness is nan m");
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
  CHECK_THROWS_WITH(stator_model(g, 0, kContactRadius), Catch::Contains("wavelengths is 0"));
  CHECK_THROWS_WITH(stator_model(g, 9, 0.031),
                    Catch::Contains("contact_radius is 0.031 m; it must lie on"));
  CHECK_THROWS_WITH(stator_model(g, 7, kContactRadius),
                    Catch::Contains("two phases must fit into the 7"));
  CHECK_THROWS_AS(stator_modes(g, -1, 1), InputError);
  CHECK_THROWS_AS(stator_modes(g, 9, 0), InputError);
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
