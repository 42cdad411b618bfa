// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/statistics/fit_tests.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum::studies;
using Catch::Matchers::WithinRel;

TEST_CASE("chi-square has the probabilities of textbooks", "[studies][statistics]") {
  // With two degrees of freedom chi-square is exponential.
  CHECK_THAT(chi_square_tail(3.7, 2), WithinRel(std::exp(-3.7 / 2), 1e-12));
  CHECK(chi_square_tail(1, 0) == 1);
}
