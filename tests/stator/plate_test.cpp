// SPDX-License-Identifier: Apache-2.0
#include "stator/bessel_plate.hpp"
#include "stator/plates.hpp"
#include "support/deviations.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace {

using namespace twum::stator;
using namespace twum::test;

using Cells = std::map<std::string, std::string>;

std::vector<Cells> annular_plates() {
  std::ifstream file(TWUM_TEST_DATA "/reference/annular_plates.csv");
  const auto split = [](std::string line) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(file, line);
  const auto names = split(line);
  std::vector<Cells> rows;
  while (std::getline(file, line)) {
    const auto cells = split(line);
    Cells row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
    rows.push_back(row);
  }
  return rows;
}

constexpr InnerEdge kEdges[] = {InnerEdge::free, InnerEdge::clamped, InnerEdge::supported};

}  // namespace

TEST_CASE("annular plates of the reference table (P2.3, P2.4, P2.5, P3.1)",
          "[stator][differential]") {
  const auto rows = annular_plates();
  REQUIRE(rows.size() == 154);
  // 1e-5 is asked for. The table has 8 digits; the method leaves about 1e-8.
  Deviation kirchhoff("annular plates of the reference table, Kirchhoff", 1e-5);
  Deviation mindlin("annular plates of the reference table, Mindlin", 1e-5);
  for (const Cells& row : rows) {
    const bool thick = row.at("theory") == "Mindlin";
    const double factor = row.at("kappa2") == "5/6" ? 5.0 / 6 : kMindlinShearFactor;
    const Section section =
        thick ? homogeneous(std::stod(row.at("h_over_a")), std::stod(row.at("nu")), factor)
              : thin(0.01, std::stod(row.at("nu")));
    const auto edge = row.at("inner_bc") == "C" ? InnerEdge::clamped : InnerEdge::free;
    const int n = std::stoi(row.at("n_nodal_diameters"));
    CAPTURE(row.at("theory"), row.at("h_over_a"), row.at("kappa2"), row.at("inner_bc"), n);
    const auto theory = thick ? PlateTheory::mindlin : PlateTheory::kirchhoff;
    const double found =
        lambdas({{std::stod(row.at("b_over_a")), 1, section}}, theory, edge, n, 1).at(0);
    const double expected = std::stod(row.at("lambda2_omega_a2_sqrt_rhoh_over_D"));
    CHECK((thick ? mindlin : kirchhoff).add(found, expected, expected) <= 1e-5);
  }
  CHECK(kirchhoff.holds());
  CHECK(mindlin.holds());
}

TEST_CASE("thin rings by Bessel functions over radius ratio and n (P2.5, P3.3, P3.4)",
          "[stator][differential]") {
  // 1e-7: 1e-8 of the method, and b/a = 0.1 with n = 0 and 1, where ln(rho) is hardest.
  Deviation deviation("thin rings, three lowest modes, against Bessel functions", 1e-7);
  for (const double ratio : {0.1, 0.3, 0.5, 0.75, 0.9}) {
    for (const int n : {0, 1, 2, 3, 5, 7, 9, 11}) {
      for (const InnerEdge edge : kEdges) {
        const std::vector<Segment> plate{{ratio, 1, thin()}};
        const auto exact = exact_thin_plate(plate, edge, n, 3);
        const auto found = lambdas(plate, PlateTheory::kirchhoff, edge, n, 3);
        for (std::size_t i = 0; i < 3; ++i) {
          const double expected = lambda_squared(exact[i], thin());
          CAPTURE(ratio, n, static_cast<int>(edge), i, expected, found[i]);
          CHECK(deviation.add(found[i], expected, expected) <= 1e-7);
        }
      }
    }
  }
  CHECK(deviation.holds());
}

TEST_CASE("annular plates with nine nodal diameters by another program (P2.3, P2.5)",
          "[stator][differential]") {
  // lambda^2 at b/a = 0.75, nu = 0.3. Free and clamped thin plates have nine digits; those with rotary
  // inertia, and Mindlin's, four: half a unit of the last is 6e-5.
  const auto value = [](const Section& section, PlateTheory theory, InnerEdge edge) {
    return lambdas({{0.75, 1, section}}, theory, edge, 9, 1).at(0);
  };
  CHECK(value(thin(), PlateTheory::kirchhoff, InnerEdge::free) == Approx(96.399955).epsilon(1e-8));
  CHECK(value(thin(), PlateTheory::kirchhoff, InnerEdge::clamped) ==
        Approx(125.829632).epsilon(1e-8));
  struct Row {
    double thickness, rotary, mindlin;
  };
  for (const Row& row : {Row{0.05, 95.30, 91.76}, Row{0.1, 92.19, 82.33}}) {
    const Section section = homogeneous(row.thickness);
    CHECK(value(section, PlateTheory::kirchhoff, InnerEdge::free) ==
          Approx(row.rotary).epsilon(1e-4));
    CHECK(value(section, PlateTheory::mindlin, InnerEdge::free) ==
          Approx(row.mindlin).epsilon(1e-4));
  }
}

TEST_CASE("stepped thin plates by Bessel functions (P2.5, P3.3)", "[stator][differential]") {
  // As for one ring.
  Deviation deviation("stepped thin plates, three lowest modes, against Bessel functions", 1e-7);
  const Section thick = thin(0.02);
  const Section web = thin(0.007);
  const std::vector<std::vector<Segment>> plates{
      {{0.3, 0.6, web}, {0.6, 1, thick}},
      {{0.25, 0.3, thick}, {0.3, 0.7, web}, {0.7, 1, thick}},
      {{0.5, 0.65, thick}, {0.65, 0.95, thin(0.015, 0.2)}, {0.95, 1, web}}};
  for (const auto& plate : plates) {
    for (const int n : {0, 2, 5, 9}) {
      for (const InnerEdge edge : kEdges) {
        const auto exact = exact_thin_plate(plate, edge, n, 3);
        const auto found = lambdas(plate, PlateTheory::kirchhoff, edge, n, 3);
        for (std::size_t i = 0; i < 3; ++i) {
          const double expected = lambda_squared(exact[i], plate.back().section);
          CAPTURE(plate.size(), n, static_cast<int>(edge), i, expected, found[i]);
          CHECK(deviation.add(found[i], expected, expected) <= 1e-7);
        }
      }
    }
  }
  CHECK(deviation.holds());
}

TEST_CASE("a plate in equal segments is the same plate (P3.2, P3.3)", "[stator][identity]") {
  // Both are good to about 1e-7 of the third frequency (thin rings by Bessel functions; Mindlin's edge
  // layers, half a tenth of the width here, to 1e-6).
  for (const PlateTheory theory : {PlateTheory::kirchhoff, PlateTheory::mindlin}) {
    const Section section = homogeneous(0.1);
    for (const int n : {0, 1, 3, 9}) {
      const auto whole = lambdas({{0.5, 1, section}}, theory, InnerEdge::free, n, 3);
      const auto parts = lambdas({{0.5, 0.62, section}, {0.62, 0.85, section}, {0.85, 1, section}},
                                 theory, InnerEdge::free, n, 3);
      for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(n, i);
        CHECK(parts[i] == Approx(whole[i]).epsilon(theory == PlateTheory::kirchhoff ? 1e-7 : 1e-6));
      }
    }
  }
}

TEST_CASE("a Mindlin plate tends to Kirchhoff's (P2.3, P2.5)", "[stator][limit]") {
  // The clamped ring differs by terms of order (h / a)^2: a tenth of the thickness, a hundredth of the
  // difference. At a free edge Kirchhoff's condition of the twisting moment leaves a term of order h / a.
  const auto difference = [](double thickness, InnerEdge edge, int n) {
    const Section section = homogeneous(thickness);
    const double mindlin = lambdas({{0.5, 1, section}}, PlateTheory::mindlin, edge, n, 1).at(0);
    const double thin_plate = lambdas({{0.5, 1, thin()}}, PlateTheory::kirchhoff, edge, n, 1).at(0);
    return 1 - mindlin / thin_plate;
  };
  for (const int n : {0, 2, 5}) {
    CAPTURE(n);
    const double thicker = difference(0.02, InnerEdge::clamped, n);
    const double thinner = difference(0.002, InnerEdge::clamped, n);
    CHECK(thicker > 0);
    CHECK(thicker < 0.03);
    CHECK(thinner > 0);
    CHECK(thinner < 0.2 * thicker);  // between h and h^2: the outer edge is free
  }
  CHECK(std::abs(difference(0.001, InnerEdge::free, 9)) < 0.001);
}

TEST_CASE(
    "a laminate of one material is the homogeneous plate (P1.1, P1.2, P1.3, P1.4, P1.5, P1.6, "
    "P1.7)",
    "[stator][identity]") {
  const Layer whole{0.005, 110e9, 0.33, 8800};
  const Section one = section_of<double>({whole});
  std::vector<Layer> layers;
  for (const double share : {0.1, 0.05, 0.6, 0.25}) {
    layers.push_back(whole);
    layers.back().thickness *= share;
  }
  const Section many = section_of(layers);
  // Closed forms of a homogeneous plate; 1e-13 is rounding with cubes that cancel.
  const double h = whole.thickness;
  const double stiffness = whole.youngs_modulus * h * h * h / (12 * (1 - 0.33 * 0.33));
  for (const Section& s : {one, many}) {
    CHECK(s.neutral_plane == Approx(h / 2).epsilon(1e-13));
    CHECK(s.top == Approx(h).epsilon(1e-13));
    CHECK(s.bending_stiffness == Approx(stiffness).epsilon(1e-13));
    CHECK(s.poisson_ratio == Approx(0.33).epsilon(1e-13));
    CHECK(s.mass == Approx(8800 * h).epsilon(1e-13));
    CHECK(s.rotary_inertia == Approx(8800 * h * h * h / 12).epsilon(1e-13));
    CHECK(s.shear_stiffness ==
          Approx(std::numbers::pi * std::numbers::pi / 12 * 110e9 / 2.66 * h).epsilon(1e-13));
  }
}

TEST_CASE("the neutral plane of a bimetal strip (P1.1, P1.2)", "[stator][closed-form]") {
  // Timoshenko 1925: two strips, E_1 : E_2 = 4 : 1, equal thickness h, equal nu. Transformed section about the
  // bottom: z_n = (4 h/2 + 3h/2) / 5 = 0.7 h; E I = E_2 h^3 [4 (1/12 + 0.04) + (1/12 + 0.64)] = 1.21667 E_2 h^3.
  const Section s = section_of<double>({{1, 4, 0, 1}, {1, 1, 0, 1}});
  CHECK(s.neutral_plane == Approx(0.7).epsilon(1e-14));
  CHECK(s.bending_stiffness == Approx(73.0 / 60).epsilon(1e-14));
}

TEST_CASE("the NAFEMS free ring bends out of its plane (P2.1, P2.2, P2.3)", "[stator][benchmark]") {
  // NAFEMS, Selected Benchmarks for Natural Frequency Analysis, R0015, test 6: a free ring of radius 1 m with a
  // circular section of 0.1 m, E = 200 GPa, nu = 0.3, 8000 kg/m^3 (Altair SimSolid verification manual, VM09;
  // SolidWorks verification NAFEMS_Freq_Test6). Theory without shear 51.85, 148.8, 287.0 Hz, the benchmark's
  // own elements 52.29, 149.7, 288.3 Hz; SimSolid's solid 51.484, 146.74, 280.66 Hz.
  const auto ring = [](double diameter, double shear_factor) {
    // The section in strips of the same area: thickness of an ellipse at the middle of equal angles.
    constexpr int kStrips = 16;
    std::vector<Segment> segments;
    const double r = diameter / 2;
    const auto edge = [&](int i) { return 1 - r * std::cos(std::numbers::pi * i / kStrips); };
    const auto area = [&](int i) {  // of the circle up to an angle
      const double angle = std::numbers::pi * i / kStrips;
      return r * r * (angle - std::sin(angle) * std::cos(angle));
    };
    for (int i = 0; i < kStrips; ++i) {
      const double inner = i == 0 ? 1 - r : segments.back().outer;
      const double thickness = (area(i + 1) - area(i)) / (edge(i + 1) - inner);
      segments.push_back(
          {inner, edge(i + 1), section_of<double>({{thickness, 200e9, 0.3, 8000}}, shear_factor)});
    }
    return segments;
  };
  const auto frequency = [](const std::vector<Segment>& segments, int n) {
    return plate_modes(segments, PlateTheory::mindlin, InnerEdge::free, n, 1).at(0).frequency;
  };
  const double theory[] = {51.85, 148.8, 287.0};
  const double solid[] = {51.484, 146.74, 280.66};
  for (int n = 2; n <= 4; ++n) {
    CAPTURE(n);
    // The theory has no shear: a ring a tenth as thick has a tenth of its frequency, and hardly any shear. A
    // plate of elliptic section twists as the solid does if the shear factor is 1 (Saint-Venant's solution
    // is then in reach of its kinematics), so that 0.2 % are those of the strips and of four digits.
    CHECK(10 * frequency(ring(0.01, 1), n) == Approx(theory[n - 2]).epsilon(0.002));
    // As it stands shear counts: 1 % of a solid model.
    CHECK(frequency(ring(0.1, 1), n) == Approx(solid[n - 2]).epsilon(0.01));
  }
  // With shear the lowest mode is still within 1 % of the benchmark.
  CHECK(frequency(ring(0.1, 1), 2) == Approx(51.85).epsilon(0.01));
}
