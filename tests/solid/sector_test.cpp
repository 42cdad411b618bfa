// SPDX-License-Identifier: Apache-2.0
#include "support/stators.hpp"

#include <twum/base/error.hpp>
#include <twum/solid/deck.hpp>
#include <twum/solid/eigenmodes.hpp>
#include <twum/solid/section.hpp>
#include <twum/solid/stiffness_share.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

namespace {

using namespace twum;
using namespace twum::test;
using solid::Part;

// Volume of the bricks of a part by their corners, in all sectors [m^3]: of a brick between two radii, angles and heights.
double volume_of(const solid::Sector& sector, Part part) {
  double sum = 0;
  for (const solid::SectorBrick& brick : sector.bricks) {
    if (brick.part != part) continue;
    const auto node = [&](int n) {
      return sector.nodes[static_cast<std::size_t>(brick.nodes[static_cast<std::size_t>(n)])];
    };
    const auto a = node(0), b = node(6);
    const double inner = node(3).angle - node(0).angle, outer = node(2).angle - node(1).angle;
    // The angle changes in proportion to the radius between the two.
    const double width = b.radius - a.radius, slope = (outer - inner) / width;
    const double area = inner * (b.radius * b.radius - a.radius * a.radius) / 2 +
                        slope * (std::pow(b.radius, 3) - std::pow(a.radius, 3)) / 3 -
                        slope * a.radius * (b.radius * b.radius - a.radius * a.radius) / 2;
    sum += area * (b.height - a.height);
  }
  return sum * sector.count;
}

double ring(double inner, double outer, double height) {
  return std::numbers::pi * (outer * outer - inner * inner) * height;
}

}  // namespace

TEST_CASE("the bricks of a sector fill the volume of the drawing", "[solid]") {
  for (const auto& g : {default_stator(0.1), distinct_stator()}) {
    for (const int elements : {1, 3}) {
      const auto sector = solid::make_sector(g, kWaves, kContactRadius, elements);
      const auto& t = *g.teeth;
      const double teeth = ring(t.inner_radius, t.outer_radius, t.height) -
                           t.count * t.slot_width * t.height * (t.outer_radius - t.inner_radius);
      const double metal =
          ring(g.web->inner_radius, g.web->outer_radius, g.web->thickness) +
          ring(g.web->outer_radius, g.substrate.outer_radius, g.substrate.thickness) + teeth;
      // A slot of constant width has an angle that falls with 1 / radius; bricks take it linear between lines: 1/12 of
      // (brick / radius)^2 of the slots' volume, below 1e-3 of it.
      CHECK(volume_of(sector, Part::metal) / metal == Approx(1).epsilon(1e-3));
      const auto layer = [&](double thickness) {
        return ring(g.ceramic.inner_radius, g.ceramic.outer_radius, thickness);
      };
      CHECK(volume_of(sector, Part::ceramic) / layer(g.ceramic.thickness) ==
            Approx(1).epsilon(1e-12));
      CHECK(volume_of(sector, Part::glue) / layer(g.glue.thickness) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("more elements divide all directions", "[solid]") {
  const auto bricks = [](int elements) {
    return solid::make_sector(default_stator(0.1), kWaves, kContactRadius, elements).bricks.size();
  };
  CHECK(bricks(1) < bricks(2));
  // Twice along radius, axis and tooth; slots, ceramic and glue keep one brick.
  CHECK(bricks(8) > 3 * bricks(4));
}

TEST_CASE("sectors that cannot be made are refused", "[solid]") {
  const auto g = default_stator(0.1);
  CHECK_THROWS_AS(solid::make_sector(g, kWaves, kContactRadius, 0), InputError);
  CHECK_THROWS_AS(solid::make_sector(g, kWaves, 0.040, 2), InputError);
  CHECK_THROWS_AS(solid::make_sector(g, 45, kContactRadius, 2), InputError);
  auto foil = g;
  foil.substrate.thickness = 1e-6;
  CHECK_THROWS_AS(solid::make_sector(foil, kWaves, kContactRadius, 12), InputError);
  CHECK(solid::most_nodal_diameters(solid::make_sector(g, kWaves, kContactRadius, 1)) == 44);
}

TEST_CASE("the cross-section bends as the wave says", "[solid]") {
  const auto g = default_stator(0.1);
  const auto sector = solid::make_sector(g, kWaves, kContactRadius, 1);
  // A rigid turn about a line at the neutral radius: axial motion x, along the radius -z, all in step with the wave.
  solid::Eigenmode turn{1, {}};
  for (const solid::SectorNode& node : sector.nodes) {
    const auto wave = std::polar(1.0, kWaves * node.angle);
    turn.motion.push_back({-node.height * wave, 0.0, (node.radius - 0.0215) * wave});
  }
  const auto faces = solid::bent_section(sector, kWaves, kContactRadius, turn);
  REQUIRE(faces.size() > 10);
  double area = 0;
  for (const solid::BentFace& face : faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      // Over the axial motion at the contact radius, 5 mm; exact but for rounding.
      CHECK(face.motion[k][1] == Approx((face.place[k][0] - 0.0215) / 0.005).margin(1e-12));
      CHECK(face.motion[k][0] == Approx(-face.place[k][1] / 0.005).margin(1e-12));
      const auto& next = face.place[(k + 1) % 4];
      area += (face.place[k][0] * next[1] - next[0] * face.place[k][1]) / 2;
    }
  }
  double drawn = 0;
  for (const solid::SectionPart& part : solid::cross_section(g, kContactRadius))
    drawn += (part.outer - part.inner) * (part.top - part.bottom);
  CHECK(area == Approx(drawn).epsilon(1e-12));
}

TEST_CASE("text that is no result of CalculiX is refused", "[solid]") {
  const auto sector = solid::make_sector(default_stator(0.1), kWaves, kContactRadius, 1);
  for (const char* text : {"", "nothing\n", " 1 2 3 4 5\n P A R T I C I P A T I O N\n"}) {
    std::istringstream dat(text);
    CHECK_THROWS_AS(solid::read_eigenmodes(dat, sector), InputError);
  }
}

TEST_CASE("the share of the teeth is found where there is one", "[solid]") {
  const auto frequency = [](double share) {
    return stator::stator_model(default_stator(share), kWaves, kContactRadius).frequency.v;
  };
  for (const double share : {0.0, 0.03, 0.4, 1.0}) {
    const auto fitted =
        solid::fit_stiffness_share(default_stator(0.2), kWaves, kContactRadius, frequency(share));
    REQUIRE(fitted.share);
    // 30 bits of the share.
    CHECK(*fitted.share == Approx(share).margin(1e-8));
  }
  const auto none = solid::fit_stiffness_share(default_stator(0.2), kWaves, kContactRadius, 1e3);
  CHECK_FALSE(none.share);
  CHECK(none.lowest == frequency(0));
  CHECK(none.highest == frequency(1));
  auto plain = default_stator(0.2);
  plain.teeth.reset();
  CHECK_THROWS_AS(solid::fit_stiffness_share(plain, kWaves, kContactRadius, 4e4), InputError);
}
