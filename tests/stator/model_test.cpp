// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/stators.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace {

using namespace twum;
using namespace twum::stator;
using namespace twum::test;

// A flat ring with ceramic all over it, thin enough for Kirchhoff.
StatorGeometry plain_ring() {
  StatorGeometry g;
  g.substrate = {0.020, 0.030, 2e-3, 110e9, 0.33, 8800};
  g.ceramic = {0.020, 0.030, 0.5e-3, 70e9, 0.31, 7500, -120e-12, 1.1e-8};
  g.electrodes = {4, {}, {}};
  return g;
}

// +1, -1 or 0: the electrode of the phase that drives cos(n phi), `waves` wavelengths of half waves.
double electrode_sign(double phi, int n, double waves) {
  const double from_first_zero = phi + kPi / (2 * n);  // the first sector is centred on a crest
  if (from_first_zero < 0 || from_first_zero > 2 * kPi * waves / n) return 0;
  return std::cos(n * phi) >= 0 ? 1 : -1;
}

}  // namespace

TEST_CASE("the force factor is the charge that a deflection pushes out (P4.4)",
          "[stator][identity]") {
  const StatorGeometry g = plain_ring();
  const auto model = stator_model(g, 9, kContactRadius, PlateTheory::kirchhoff);
  const auto& c = g.ceramic;
  // Charge of a sector: e (eps_r + eps_t) of w = R cos(n phi) summed over the electrode by the midpoint rule
  // in both directions and over the thickness, curvatures from differences of R.
  const double n = 9;
  const double stress = c.d31 * c.youngs_modulus / (1 - c.poisson_ratio);
  const Section section =
      section_of<double>({{c.thickness, c.youngs_modulus, c.poisson_ratio, c.density},
                          {g.substrate.thickness, g.substrate.youngs_modulus,
                           g.substrate.poisson_ratio, g.substrate.density}});
  const double lever = c.thickness / 2 - section.neutral_plane;
  double radial = 0;
  constexpr int kRings = 1000;
  const double step = 0.010 / kRings;
  const double h = 2e-5;  // of differences
  for (int i = 0; i < kRings; ++i) {
    const double r = 0.020 + (i + 0.5) * step;
    const double w = model.shape(r);
    const double up = model.shape(r + h);
    const double down = model.shape(r - h);
    radial += ((up - 2 * w + down) / (h * h) + (up - down) / (2 * h * r) - n * n * w / (r * r)) *
              r * step;
  }
  double angular = 0;
  constexpr int kSectors = 36000;
  for (int i = 0; i < kSectors; ++i) {
    const double phi = -kPi / (2 * n) + (i + 0.5) * 2 * kPi / kSectors;
    angular += electrode_sign(phi, 9, 4) * std::cos(n * phi) * 2 * kPi / kSectors;
  }
  // The midpoint rules leave 1e-6, the differences of R (kappa h)^2 / 12 = 3e-5 with kappa = 1000 / m at the edges.
  CHECK(model.force_factor.v == Approx(std::abs(stress * lever * radial * angular)).epsilon(1e-4));
}

TEST_CASE("capacitance of a full ring (P4.5)", "[stator][closed-form]") {
  StatorGeometry g = plain_ring();
  g.electrodes.waves_per_phase = 4.5;  // two phases cover everything
  const auto model = stator_model(g, 9, kContactRadius);
  // Blocked permittivity of the whole piezoelectric matrix in plane stress: eps - d' c d, with c the inverse
  // of the compliances.
  const auto& c = g.ceramic;
  Eigen::Matrix2d compliance;
  compliance << 1, -c.poisson_ratio, -c.poisson_ratio, 1;
  compliance /= c.youngs_modulus;
  const Eigen::Vector2d d(c.d31, c.d31);
  const double blocked = c.permittivity - d.dot(compliance.inverse() * d);
  const double ring = blocked * kPi * (0.03 * 0.03 - 0.02 * 0.02) / c.thickness;
  CHECK(2 * model.blocked_capacitance.v == Approx(ring).epsilon(1e-13));  // rounding
}

TEST_CASE("mass, stiffness and coupling of a mode (P4.1, P4.2, P4.6)", "[stator][identity]") {
  const auto model = differentiated(distinct_stator());
  const double omega = 2 * kPi * model.frequency.v;
  CHECK(model.modal_stiffness.v == Approx(omega * omega * model.modal_mass.v).epsilon(1e-13));
  // The coupling factor in terms of the two resonances that an impedance analyser shows.
  const double motional = model.force_factor.v * model.force_factor.v / model.modal_stiffness.v;
  const double fs = model.frequency.v;
  const double fp = fs * std::sqrt(1 + motional / model.blocked_capacitance.v);
  CHECK(model.coupling_factor.v == Approx(std::sqrt(1 - fs * fs / (fp * fp))).epsilon(1e-12));
}

TEST_CASE("modal mass by integrating the shape (P2.4, P4.1)", "[stator][identity]") {
  // Kirchhoff, with slopes by differences: T = pi/2 omega^2 integral [m R^2 + I (R'^2 + n^2 R^2/rho^2)] rho drho.
  const StatorGeometry g = plain_ring();
  const auto model = stator_model(g, 9, kContactRadius, PlateTheory::kirchhoff);
  const Section s = section_of<double>({{0.5e-3, 70e9, 0.31, 7500}, {2e-3, 110e9, 0.33, 8800}});
  double mass = 0;
  constexpr int kRings = 1000;
  for (int i = 0; i < kRings; ++i) {
    const double r = 0.020 + (i + 0.5) * 0.010 / kRings;
    const double w = model.shape(r);
    const double slope = (model.shape(r + 1e-6) - model.shape(r - 1e-6)) / 2e-6;
    mass += kPi * (s.mass * w * w + s.rotary_inertia * (slope * slope + 81 * w * w / (r * r))) * r *
            0.010 / kRings;
  }
  CHECK(model.modal_mass.v ==
        Approx(mass).epsilon(1e-5));  // midpoint rule: (kappa step)^2 / 24 = 4e-6
}

TEST_CASE("a stator larger or smaller in every direction (P1.8, P4.1, P4.4)", "[stator][scaling]") {
  // Lengths times s: frequencies 1 / s, masses s^3, stiffnesses s, force factor s, capacitance s.
  const double s = GENERATE(1.0 / 64, 2.0, 64.0);
  StatorGeometry large = distinct_stator();
  for (std::size_t i = 0; i < kDimensions; ++i) {
    if (dimension_table()[i].unit == "m") {
      if (double* length = find(large, static_cast<Dimension>(i))) *length *= s;
    }
  }
  const auto one = stator_model(distinct_stator(), 9, kContactRadius);
  const auto two = stator_model(large, 9, s * kContactRadius);
  // A power of two: rounding alone, with the condition of the lowest modes.
  CHECK(two.frequency.v == Approx(one.frequency.v / s).epsilon(1e-10));
  CHECK(two.modal_mass.v == Approx(one.modal_mass.v * s * s * s).epsilon(1e-9));
  CHECK(two.modal_stiffness.v == Approx(one.modal_stiffness.v * s).epsilon(1e-9));
  CHECK(two.force_factor.v == Approx(one.force_factor.v * s).epsilon(1e-9));
  CHECK(two.blocked_capacitance.v == Approx(one.blocked_capacitance.v * s).epsilon(1e-12));
  CHECK(two.mode_separation.v == Approx(one.mode_separation.v / s).epsilon(1e-9));
  CHECK(two.tangential_share.v == Approx(one.tangential_share.v).epsilon(1e-9));
}

TEST_CASE("the share of tangential motion is 1 without shear (P4.3)", "[stator][limit]") {
  const auto kirchhoff = stator_model(distinct_stator(), 9, kContactRadius, PlateTheory::kirchhoff);
  CHECK(kirchhoff.tangential_share.v == Approx(1).epsilon(1e-13));
  const auto mindlin = stator_model(distinct_stator(), 9, kContactRadius);
  CHECK(mindlin.tangential_share.v < 1);
  CHECK(mindlin.tangential_share.v > 0.8);
  // A straight beam of the plain ring's section, E I = D (1 - nu^2), turns by 1 / (1 + (kappa^2 E I - I omega^2) / S)
  // of the slope. The ring is wide and curved: 5 %.
  const StatorGeometry plain = plain_ring();
  const auto model = stator_model(plain, 9, 0.025);
  const Section s = section_of<double>({{0.5e-3, 70e9, 0.31, 7500}, {2e-3, 110e9, 0.33, 8800}});
  const double kappa = 9 / 0.025;
  const double bending = s.bending_stiffness * (1 - s.poisson_ratio * s.poisson_ratio);
  const double omega = 2 * kPi * model.frequency.v;
  const double beam =
      1 / (1 + (kappa * kappa * bending - s.rotary_inertia * omega * omega) / s.shear_stiffness);
  CHECK(model.tangential_share.v == Approx(beam).epsilon(0.05));
}

TEST_CASE("unwanted modes and the nearest of them (P4.7)", "[stator]") {
  const auto g = distinct_stator();
  const auto model = stator_model(g, 9, kContactRadius);
  REQUIRE(model.unwanted.size() == 5 * 8 - 1);
  double nearest = 1e9;
  for (int n = 7; n <= 11; ++n) {
    for (const PlateMode& mode : stator_modes(g, n, 8)) {
      const double distance = std::abs(mode.frequency - model.frequency.v);
      if (distance > 1e-6 * model.frequency.v) nearest = std::min(nearest, distance);
    }
  }
  CHECK(model.mode_separation.v == Approx(nearest).epsilon(1e-12));
  CHECK(std::abs(model.unwanted[0].frequency - model.frequency.v) ==
        Approx(nearest).epsilon(1e-12));
  CHECK(model.shape(kContactRadius) == Approx(1).epsilon(1e-13));
  CHECK(model.shape.sign_changes(g.web->outer_radius, g.substrate.outer_radius) == 0);
}

// Most plates are settled by the four lowest modes of each order; the webs here have more below the wave. Two solutions of one
// plate differ by rounding, some 1e-13 of a frequency.
TEST_CASE("the nearest of the eight lowest modes of each order is found (P4.7)", "[stator]") {
  StatorGeometry g = distinct_stator();
  int beyond_four = 0;
  for (const double web : {0.05e-3, 0.08e-3, 0.12e-3, 0.3e-3, 0.6e-3, 0.9e-3}) {
    for (const double ring : {1.2e-3, 2e-3, 3.3e-3}) {
      g.web->thickness = web;
      g.substrate.thickness = ring;
      INFO("web " << web << " m, ring " << ring << " m");
      const SolvedStator solved(g, 9, kContactRadius);
      const double wave = solved.wave(Derivatives::none).frequency.v;
      double nearest = 1e9;
      bool beyond = false;
      for (int n = 7; n <= 11; ++n) {
        const auto modes = stator_modes(g, n, 8);
        for (std::size_t i = 0; i < modes.size(); ++i) {
          const double distance = std::abs(modes[i].frequency - wave);
          if (distance <= 1e-9 * wave || distance >= nearest) continue;
          nearest = distance;
          beyond = i >= 4;
        }
      }
      beyond_four += beyond;
      CHECK(std::abs(solved.mode_separation(Derivatives::none).v - nearest) < 1e-11 * wave);
      CHECK(std::abs(solved.mode_separation(Derivatives::all).v - nearest) < 1e-11 * wave);
    }
  }
  CHECK(beyond_four > 0);
}

TEST_CASE("a web mode beside the ring's is told (P4.7)", "[stator]") {
  // A thin wide web has modes of its own. While its thickness grows they pass the ring's mode, and where they
  // are near, two modes share the motion of the ring.
  StatorGeometry g = distinct_stator();
  bool shared = false;
  bool clear = false;
  for (int i = 0; i <= 20; ++i) {
    g.web->thickness = 0.5e-3 + i * 0.01e-3;
    const auto model = stator_model(g, 9, kContactRadius);
    CHECK(model.shape.sign_changes(g.web->outer_radius, g.substrate.outer_radius) == 0);
    shared = shared || model.identity == ModeIdentity::shared;
    clear = clear || model.identity == ModeIdentity::clear;
  }
  CHECK(shared);
  CHECK(clear);
}

TEST_CASE("the stator of the 60 mm motor (P4.1, P4.4, P4.5)", "[stator]") {
  // What docs/theory/stator-plate.md, section 7, says it was made for: 39.0 kHz by the fitted share of stiffness, whose
  // third digit makes 1e-4 of the frequency; a surface 3 mm above the neutral plane and 8.5 nF, which the other
  // lengths meet to 5 %; modal masses of such stators are 25 to 34 g.
  const auto model = stator_model(default_stator(0.0445), 9, kContactRadius);
  CHECK(model.frequency.v == Approx(39.0e3).epsilon(2e-4));
  CHECK(model.neutral_plane_distance.v == Approx(3e-3).epsilon(0.05));
  CHECK(model.blocked_capacitance.v == Approx(8.5e-9).epsilon(0.05));
  CHECK(model.modal_mass.v > 0.025);
  CHECK(model.modal_mass.v < 0.034);
  CHECK(model.identity == ModeIdentity::clear);
  CHECK(model.unwanted[0].nodal_diameters == 8);
}

// Hooke's law on curvatures from differences of the mode's shape. Gauss points miss the ends of an element by 1 % of its
// length, over which the stress of these modes changes by some percent at most.
TEST_CASE("the ceramic's stress is that of its curvature (P4.8)", "[stator][identity]") {
  StatorGeometry g = distinct_stator();
  g.teeth.reset(), g.glue.thickness = 0;
  const StatorModel model = stator_model(g, kWaves, kContactRadius, PlateTheory::kirchhoff);
  const double metal = 105e9 / (1 - 0.34 * 0.34), ceramic = 75e9 / (1 - 0.31 * 0.31);
  const double h_m = 3.0e-3, h_p = 0.5e-3;
  // moments of both layers about the bottom of the ceramic, which is the face farthest from the neutral plane
  const double neutral =
      (ceramic * h_p * h_p / 2 + metal * h_m * (h_p + h_m / 2)) / (ceramic * h_p + metal * h_m);
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double rho = 0.0224 + (0.0298 - 0.0224) * i / 4000, step = 1e-7;
    const double slope = model.shape.slope(rho);
    const double kappa_r =
        -(model.shape.slope(rho + step) - model.shape.slope(rho - step)) / (2 * step);
    const double kappa_t = kWaves * kWaves * model.shape(rho) / (rho * rho) - slope / rho;
    for (const double sum : {kappa_r + 0.31 * kappa_t, kappa_t + 0.31 * kappa_r})
      largest = std::max(largest, std::fabs(ceramic * neutral * sum));
  }
  // Radii stand 1.9 um apart, and the stress changes over r / n = 3 mm: by less than 1e-3 from one to the next.
  CHECK(model.ceramic_stress.v <= largest * (1 + 1e-3));
  CHECK(model.ceramic_stress.v >= 0.95 * largest);
}

TEST_CASE("the slope of a mode's shape is the limit of its differences", "[stator][identity]") {
  const StatorModel model = stator_model(distinct_stator(), kWaves, kContactRadius);
  for (const double rho : {0.0150, 0.0240, 0.0265, 0.0290}) {
    const double h = 1e-6;
    const double quotient = (model.shape(rho + h) - model.shape(rho - h)) / (2 * h);
    // the third derivative, of the size of R over (3 mm)^3, times h^2 / 6, and rounding of 1e-14 / h
    CHECK(model.shape.slope(rho) == Approx(quotient).epsilon(1e-6).margin(1e-4));
  }
}
