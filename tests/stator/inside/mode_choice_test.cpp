// SPDX-License-Identifier: Apache-2.0
#include "mode_choice.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

using namespace twum;
using namespace twum::stator;

namespace {

Spectrum with_eigenvalues(std::vector<double> eigenvalues) { return {std::move(eigenvalues), {}}; }

// A ring without a web.
StatorPlate<double> ring(double inner) {
  const Section section = section_of<double>({{4e-3, 110e9, 0.34, 8800}});
  StatorPlate<double> plate;
  plate.segments = {{inner, 0.03, section}};
  return plate;
}

}  // namespace

TEST_CASE("eigenvalues nearer than a millionth cross", "[stator][inside]") {
  CHECK(crosses(with_eigenvalues({1, 1 + 5e-7, 3}), 0));
  CHECK(crosses(with_eigenvalues({1, 1 + 5e-7, 3}), 1));
  CHECK_FALSE(crosses(with_eigenvalues({1, 1 + 5e-7, 3}), 2));
  CHECK_FALSE(crosses(with_eigenvalues({1, 1 + 2e-6, 3}), 0));
  CHECK_FALSE(crosses(with_eigenvalues({1}), 0));
}

TEST_CASE("a ring that crosses a mode of its own order has no derivatives", "[stator][inside]") {
  const auto plate = ring(0.02);
  Order order = solve_order(plate, PlateTheory::mindlin, InnerEdge::free, 9, kLowest);
  CHECK(choose_mode(order, plate, 0.02, 0.0265).identity == ModeIdentity::clear);
  order.spectrum.eigenvalues[1] = order.spectrum.eigenvalues[0] * (1 + 1e-8);
  CHECK(choose_mode(order, plate, 0.02, 0.0265).identity == ModeIdentity::crossing);
}

TEST_CASE("a plate without a mode for the wave says so", "[stator][inside]") {
  // Of one mode without sign change and seven with, the first is taken away.
  const auto plate = ring(0.02);
  Order order = solve_order(plate, PlateTheory::mindlin, InnerEdge::free, 9, kLowest);
  order.frequencies[0] = 0;
  CHECK_THROWS_AS(choose_mode(order, plate, 0.02, 0.0265), EvaluationError);
  try {
    choose_mode(order, plate, 0.02, 0.0265);
  } catch (const EvaluationError& error) {
    CHECK(error.reason() == "no-ring-mode");
  }
}
