// SPDX-License-Identifier: Apache-2.0
#include "solid/solved_sector.hpp"
#include "support/csv_rows.hpp"
#include "support/deviations.hpp"

#include <twum/solid/wave.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace {

using namespace twum;
using namespace twum::test;

constexpr double kOuter = 0.03;  // [m]

// Lowest frequency of a ring with inner over outer radius 1/2 as lambda^2 = omega a^2 sqrt(rho h / D).
double solid_lambda(stator::InnerEdge edge, double h_over_a, int n, int elements) {
  const auto g = metal_plate(0.5 * kOuter, kOuter, h_over_a * kOuter, edge);
  const double e = g.substrate.youngs_modulus, h = g.substrate.thickness, nu = 0.3;
  const auto sector = solid::make_sector(g, n, 0.8 * kOuter, elements);
  const double f = bending_modes(sector, g, n, 6, 0.8 * kOuter).at(0).frequency;
  const double d = e * h * h * h / (12 * (1 - nu * nu));
  return 2 * std::numbers::pi * f * kOuter * kOuter * std::sqrt(g.substrate.density * h / d);
}

double exact_lambda(const std::string& edge, const std::string& theory, double h_over_a, int n) {
  for (const CsvRow& row : csv_rows("annular_plates.csv"))
    if (row.word("inner_bc") == edge && row.word("theory") == theory &&
        row["h_over_a"] == h_over_a && row["n_nodal_diameters"] == n &&
        row.word("kappa2") != "pi2/12")
      return row["lambda2_omega_a2_sqrt_rhoh_over_D"];
  throw std::runtime_error("no such plate in the table");
}

constexpr std::pair<stator::InnerEdge, const char*> kEdges[] = {{stator::InnerEdge::free, "F"},
                                                                {stator::InnerEdge::clamped, "C"}};

}  // namespace

TEST_CASE("a solid ring becomes the exact thin plate as its thickness falls (F1.1)",
          "[solid][differential]") {
  for (const auto& [edge, name] : kEdges) {
    for (const int n : {3, 6}) {
      const double exact = exact_lambda(name, "Kirchhoff", 0, n);
      const auto error = [&, inner = edge](double h) {
        return 1 - solid_lambda(inner, h, n, 1) / exact;
      };
      const double thick = error(0.05), thin = error(0.025), thinner = error(0.0125);
      CAPTURE(name, n, thick, thin, thinner);
      // Shear and rotary inertia make a solid softer in proportion to h^2, its free edges in proportion to h: half of the
      // thickness has less than half of the error.
      CHECK(thin > 0);
      CHECK(thin < 0.5 * thick);
      CHECK(thinner > 0);
      CHECK(thinner < 0.5 * thin);
      CHECK(thinner < 0.005);  // (n h / b)^2 = 0.6 % at n = 6
    }
  }
}

TEST_CASE("a solid ring of any thickness is near Mindlin's plate (F1.1)", "[solid][differential]") {
  for (const auto& [edge, name] : kEdges) {
    for (const int n : {3, 9}) {
      for (const double h : {0.05, 0.1}) {
        const double exact = exact_lambda(name, "Mindlin", h, n);
        const double coarse = solid_lambda(edge, h, n, 1) / exact;
        const double fine = solid_lambda(edge, h, n, 2) / exact;
        CAPTURE(name, n, h, coarse, fine);
        // Errors of the mesh fall at least in proportion to the bricks, so that the finer one is off by less than the two differ;
        // they are larger than what Mindlin's plate leaves out.
        CHECK(std::abs(fine - 1) < std::abs(coarse - fine));
        CHECK(std::abs(fine - 1) < 0.01);
      }
    }
  }
}
