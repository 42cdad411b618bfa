// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/statistics/fit_tests.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace twum::studies;
using Catch::Matchers::WithinRel;

TEST_CASE("runs and chi-square have the probabilities of textbooks", "[studies][statistics]") {
  // All 2^9 patterns of signs, each as likely as any other.
  constexpr int kCount = 9;
  std::vector<int> with_runs(kCount + 1);
  for (unsigned bits = 0; bits < (1U << kCount); ++bits) {
    int runs = 1;
    for (int i = 1; i < kCount; ++i) runs += ((bits >> i) & 1U) != ((bits >> (i - 1)) & 1U) ? 1 : 0;
    ++with_runs[static_cast<std::size_t>(runs)];
  }
  const std::vector<double> residuals{1, 2, 0, 1, -1, -2, 3, 1, 1, 1};  // a zero does not count
  const RunsTest test = runs_test(residuals);
  CHECK(test.count == kCount);
  CHECK(test.runs == 3);
  CHECK_THAT(test.p, WithinRel((with_runs[1] + with_runs[2] + with_runs[3]) / 512.0, 1e-12));
  CHECK(runs_test({}).p == 1);
  // With two degrees of freedom chi-square is exponential.
  CHECK_THAT(chi_square_tail(3.7, 2), WithinRel(std::exp(-3.7 / 2), 1e-12));
  CHECK(chi_square_tail(1, 0) == 1);
}
