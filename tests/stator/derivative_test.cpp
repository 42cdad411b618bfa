// SPDX-License-Identifier: Apache-2.0
#include "support/deviations.hpp"
#include "support/expect_derivatives.hpp"
#include "support/stators.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace twum;
using namespace twum::stator;
using namespace twum::test;

std::vector<Derived> numbers(const StatorModel& m) {
  return {m.frequency,        m.modal_mass,   m.modal_stiffness,     m.neutral_plane_distance,
          m.tangential_share, m.force_factor, m.blocked_capacitance, m.coupling_factor,
          m.mode_separation};
}

// Central differences with steps h, h/2 and h/4, extrapolated to h^6; the error is what the last step of the
// extrapolation changed.
std::vector<DifferenceQuotient> extrapolated_differences(const Functions& at, double h) {
  std::vector<std::vector<double>> rows;
  for (const double step : {h, h / 2, h / 4}) {
    const auto up = at(step);
    const auto down = at(-step);
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < up.size(); ++k) row.push_back((up[k] - down[k]) / (2 * step));
  }
  std::vector<DifferenceQuotient> result;
  for (std::size_t k = 0; k < rows[0].size(); ++k) {
    const double coarse = (4 * rows[1][k] - rows[0][k]) / 3;
    const double fine = (4 * rows[2][k] - rows[1][k]) / 3;
    const double best = (16 * fine - coarse) / 15;
    result.push_back({best, std::abs(best - fine)});
  }
  return result;
}

// A change of a dimension over which everything is smooth: radii lie 0.1 mm apart.
double scale_of(const StatorGeometry& g, Dimension dimension, double contact_radius) {
  const double* value = find(g, dimension);
  const double size = std::abs(value ? *value : contact_radius);
  const bool radius =
      std::string(dimension_table()[static_cast<std::size_t>(dimension)].name).find("radius") !=
      std::string::npos;
  return radius ? 1e-3 : size;
}

void check_all(const StatorGeometry& g, PlateTheory theory, Deviation& deviation) {
  const auto exact = numbers(differentiated(g, kContactRadius, theory));
  for (std::size_t d = 0; d < kDimensions; ++d) {
    const auto dimension = static_cast<Dimension>(d);
    if (!find(g, dimension) && dimension != Dimension::contact_radius) {
      for (const Derived& number : exact) CHECK(derivative(number, dimension) == 0);  // not there
      continue;
    }
    const auto at = [&](double change) {
      StatorGeometry moved = g;
      double radius = kContactRadius;
      double* value = find(moved, dimension);
      (value ? *value : radius) += change;
      std::vector<double> values;
      for (const Derived& number : numbers(stator_model(moved, kWaves, radius, theory)))
        values.push_back(number.v);
      return values;
    };
    const double scale = scale_of(g, dimension, kContactRadius);
    const auto quotients = extrapolated_differences(at, 2e-2 * scale);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const double unit = std::abs(exact[k].v) / scale;
      CAPTURE(static_cast<int>(theory), dimension_table()[d].name, k, exact[k].v,
              quotients[k].error / unit);
      // Differences have to be good themselves before they say anything.
      REQUIRE(quotients[k].error < 1e-6 * unit);
      // Their error, and what the mesh leaves: in a segment elements are fixed shares of its width.
      CHECK(deviation.add(derivative(exact[k], dimension), quotients[k].value, unit) <= 2e-6);
    }
  }
}

}  // namespace

TEST_CASE("derivatives with respect to every dimension (P5.1, P5.2, P5.3)",
          "[stator][derivatives]") {
  Deviation deviation("derivatives of a stator against differences, of value over scale", 2e-6);
  check_all(distinct_stator(), PlateTheory::mindlin, deviation);
  StatorGeometry thin = distinct_stator();
  thin.support = InnerEdge::supported;
  check_all(thin, PlateTheory::kirchhoff, deviation);
  StatorGeometry ring = distinct_stator();
  ring.web.reset();
  ring.teeth.reset();
  ring.electrodes = {4, {}, {}};
  ring.support = InnerEdge::free;
  check_all(ring, PlateTheory::mindlin, deviation);
  CHECK(deviation.holds());
}

TEST_CASE("radii that coincide move together (P5.1)", "[stator][derivatives]") {
  StatorGeometry g = distinct_stator();
  g.ceramic.outer_radius = g.substrate.outer_radius;
  g.teeth->outer_radius = g.substrate.outer_radius;
  const auto model = differentiated(g);
  CHECK(model.joint_edges == std::vector<Dimension>{Dimension::substrate_outer_radius,
                                                    Dimension::teeth_outer_radius,
                                                    Dimension::ceramic_outer_radius});
  const auto moved = [&](double change) {
    StatorGeometry other = g;
    for (double* radius :
         {&other.substrate.outer_radius, &other.ceramic.outer_radius, &other.teeth->outer_radius}) {
      *radius += change;
    }
    return std::vector<double>{stator_model(other, kWaves, kContactRadius).frequency.v};
  };
  const auto quotient = extrapolated_differences(moved, 2e-5).at(0);
  double sum = 0;
  for (const Dimension d : model.joint_edges) sum += derivative(model.frequency, d);
  // As above; the sum also holds the teeth's fill and what else depends on these radii directly.
  CHECK(sum == Approx(quotient.value).epsilon(1e-6));
}

TEST_CASE("derivatives where a web mode and the ring's mix (P5.2)", "[stator][derivatives]") {
  // The masses of two modes change places within a few percents of the web's thickness. Derivatives are large there
  // and still those of differences, whose steps are small against that distance.
  StatorGeometry g = distinct_stator();
  g.web->thickness = 0.58e-3;
  const auto model = differentiated(g);
  REQUIRE(model.identity == ModeIdentity::shared);
  const auto moved = [&](double change) {
    StatorGeometry other = g;
    other.web->thickness += change;
    const auto m = stator_model(other, kWaves, kContactRadius);
    return std::vector<double>{m.frequency.v, m.modal_mass.v, m.force_factor.v};
  };
  const auto quotients = extrapolated_differences(moved, 2e-7);
  const double scale = g.web->thickness;
  const Derived* numbers[] = {&model.frequency, &model.modal_mass, &model.force_factor};
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = derivative(*numbers[k], Dimension::web_thickness);
    CAPTURE(k, slope * scale / numbers[k]->v, quotients[k].error / slope);
    REQUIRE(quotients[k].error < 1e-4 * std::abs(slope));
    CHECK(slope == Approx(quotients[k].value).epsilon(1e-4));
  }
  CHECK(std::abs(derivative(model.modal_mass, Dimension::web_thickness)) * scale >
        model.modal_mass.v);
}

TEST_CASE("no derivatives unless they are asked for", "[stator][derivatives]") {
  const auto with = differentiated(distinct_stator());
  const auto without = stator_model(distinct_stator(), kWaves, kContactRadius);
  for (std::size_t i = 0; i < kDimensions; ++i) {
    CHECK(std::isnan(without.frequency.d[i]));
    CHECK(std::isnan(without.mode_separation.d[i]));
    CHECK(std::isfinite(with.frequency.d[i]));
  }
  // The values are the same to rounding.
  CHECK(without.frequency.v == Approx(with.frequency.v).epsilon(1e-13));
  CHECK(without.force_factor.v == Approx(with.force_factor.v).epsilon(1e-12));
}

TEST_CASE("a mode separation with two nearest modes has no derivative (P4.7)",
          "[stator][derivatives]") {
  // Halfway between two unwanted modes; which is found by bisection over the ring's thickness.
  StatorGeometry g = distinct_stator();
  const auto difference = [&](double height) {
    g.teeth->height = height;
    const auto m = stator_model(g, kWaves, kContactRadius);
    double below = 1e9;
    double above = 1e9;
    for (const StatorMode& mode : m.unwanted) {
      const double gap = mode.frequency - m.frequency.v;
      (gap < 0 ? below : above) = std::min(gap < 0 ? below : above, std::abs(gap));
    }
    return below - above;
  };
  double low = 0;
  double high = 0;
  double before = difference(0.2e-3);
  for (double height = 0.3e-3; height < 6e-3; height += 0.1e-3) {
    const double now = difference(height);
    if (before * now < 0) {
      low = height - 0.1e-3;
      high = height;
      break;
    }
    before = now;
  }
  REQUIRE(high > 0);
  const double sign = difference(low);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (difference(middle) * sign > 0 ? low : high) = middle;
  }
  REQUIRE(std::abs(difference(low)) < 1e-4);
  g.teeth->height = low;
  const auto model = differentiated(g);
  CHECK(std::isnan(derivative(model.mode_separation, Dimension::teeth_height)));
  CHECK(std::isfinite(derivative(model.frequency, Dimension::teeth_height)));
}
