// SPDX-License-Identifier: Apache-2.0
// Time of the modes of one number of nodal diameters of a stator of three rings, beside a plain finite element
// model of the same plate in the same run: Mindlin elements with linear shape functions and one Gauss point, solved
// by Eigen's dense symmetric eigensolver. Its elements are as many as it needs for 1e-3 of the frequency; ours is
// good to 1e-7.
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <twum/stator/plate.hpp>
#include <twum/stator/stator_model.hpp>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace twum::stator;

std::vector<Segment> three_rings() {
  const Layer ceramic{0.5e-3, 84.7e9, 0.31, 7800};
  const Layer metal{2.4e-3, 110e9, 0.34, 8800};
  const Layer teeth{1.6e-3, 4.4e9, 0.34, 6000};
  return {{0.0125, 0.0215, section_of<double>({{1e-3, 110e9, 0.34, 8800}})},
          {0.0215, 0.0230, section_of<double>({ceramic, metal})},
          {0.0230, 0.0300, section_of<double>({ceramic, metal, teeth})}};
}

constexpr double kNodalDiameters = 9;

// Frequency [Hz] by linear elements, clamped inside.
double linear_elements(const std::vector<Segment>& segments, int elements_each) {
  const auto size = static_cast<Eigen::Index>(
      3 * (segments.size() * static_cast<std::size_t>(elements_each) + 1));
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size);
  Eigen::Index first = 0;
  const double n = kNodalDiameters;
  for (const Segment& s : segments) {
    const double length = (s.outer - s.inner) / elements_each;
    const Section& c = s.section;
    Eigen::Matrix<double, 5, 5> elastic = Eigen::Matrix<double, 5, 5>::Zero();
    elastic(0, 0) = elastic(1, 1) = c.bending_stiffness;
    elastic(0, 1) = elastic(1, 0) = c.poisson_ratio * c.bending_stiffness;
    elastic(2, 2) = 0.5 * (1 - c.poisson_ratio) * c.bending_stiffness;
    elastic(3, 3) = elastic(4, 4) = c.shear_stiffness;
    for (int e = 0; e < elements_each; ++e, first += 3) {
      const double r = s.inner + (e + 0.5) * length;
      Eigen::Matrix<double, 5, 6> strain;
      for (int node = 0; node < 2; ++node) {
        const double d = (node == 0 ? -1 : 1) / length;
        const double v = 0.5;
        strain.col(3 * node) << 0, 0, 0, d, -n * v / r;
        strain.col(3 * node + 1) << d, v / r, -n * v / r, v, 0;
        strain.col(3 * node + 2) << 0, n * v / r, d - v / r, 0, v;
      }
      stiffness.block<6, 6>(first, first) +=
          std::numbers::pi * r * length * strain.transpose() * elastic * strain;
      for (int i = 0; i < 6; ++i) {  // lumped
        mass(first + i, first + i) +=
            0.5 * std::numbers::pi * r * length * (i % 3 == 0 ? c.mass : c.rotary_inertia);
      }
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness.bottomRightCorner(size - 3, size - 3), mass.bottomRightCorner(size - 3, size - 3));
  return std::sqrt(solver.eigenvalues()(0)) / (2 * std::numbers::pi);
}

void modes_of_one_order(benchmark::State& state) {
  const auto rings = three_rings();
  const auto ours = [&] {
    return plate_modes(rings, PlateTheory::mindlin, InnerEdge::clamped, 9, 1)[0].frequency;
  };
  const double frequency = ours();
  int elements = 4;
  while (std::abs(linear_elements(rings, elements) / frequency - 1) > 1e-3) elements *= 2;
  double seconds = 1e9;
  double other = 1e9;
  for (auto _ : state) {
    seconds = std::min(seconds, twum::bench::seconds([&] { benchmark::DoNotOptimize(ours()); }));
    other = std::min(other, twum::bench::seconds([&] {
                       benchmark::DoNotOptimize(linear_elements(rings, elements));
                     }));
  }
  state.counters["ours_ms"] = 1e3 * seconds;
  state.counters["elements_ms"] = 1e3 * other;
  state.counters["elements_each"] = elements;
  state.counters["elements_error"] = linear_elements(rings, elements) / frequency - 1;
  state.counters["ratio"] = other / seconds;
}
BENCHMARK(modes_of_one_order)->Iterations(20)->Unit(benchmark::kMillisecond);

StatorGeometry stator() {
  StatorGeometry g;
  g.substrate = {0.0215, 0.0300, 2.4e-3, 110e9, 0.34, 8800};
  g.web = Web{0.0125, 0.0215, 1.0e-3};
  g.teeth = Teeth{90, 1.6e-3, 0.6e-3, 0.0230, 0.0300, 0.04};
  g.ceramic = {0.0220, 0.0300, 0.5e-3, 84.7e9, 0.31, 7800, -120e-12, 1.0625e-8};
  g.electrodes = {4, {}, {}};
  g.support = InnerEdge::clamped;
  return g;
}

void whole_model(benchmark::State& state) {
  const StatorGeometry g = stator();
  double value = 1e9;
  double derivatives = 1e9;
  for (auto _ : state) {
    value = std::min(
        value, twum::bench::seconds([&] { benchmark::DoNotOptimize(stator_model(g, 9, 0.0265)); }));
    derivatives = std::min(derivatives, twum::bench::seconds([&] {
                             benchmark::DoNotOptimize(stator_model(
                                 g, 9, 0.0265, PlateTheory::mindlin, Derivatives::all));
                           }));
  }
  // A search that asks for frequency and separation: values alone, and with all numbers and derivatives as it once was.
  double asked = 1e9;
  for (int i = 0; i < 20; ++i)
    asked = std::min(asked, twum::bench::seconds([&] {
                       const SolvedStator solved(g, 9, 0.0265);
                       benchmark::DoNotOptimize(solved.wave(Derivatives::none).frequency.v +
                                                solved.mode_separation(Derivatives::none).v);
                     }));
  state.counters["frequency_and_separation_ms"] = 1e3 * asked;
  state.counters["everything_over_these_two"] = derivatives / asked;
  state.counters["five_orders_ms"] = 1e3 * value;
  state.counters["with_29_derivatives_ms"] = 1e3 * derivatives;
}
BENCHMARK(whole_model)->Iterations(20)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
