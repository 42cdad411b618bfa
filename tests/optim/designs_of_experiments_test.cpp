// SPDX-License-Identifier: Apache-2.0
// Laws of the sequences that sweeps and starts are taken from: Latin hypercubes and Sobol sequences.
#include <twum/base/error.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/low_discrepancy.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

constexpr std::uint64_t kCount = 1000;
constexpr std::size_t kDimension = 4;

// The points of a Latin hypercube, each with its index, moved into the unit interval, in front.
std::vector<std::vector<double>> numbered_points(std::uint64_t seed) {
  const LatinHypercube hypercube(kDimension, kCount, seed);
  std::vector<std::vector<double>> points;
  std::vector<double> x(kDimension);
  for (std::uint64_t i = 0; i < kCount; ++i) {
    hypercube.point(i, x);
    points.push_back({(static_cast<double>(i) + 0.5) / double(kCount)});
    points.back().insert(points.back().end(), x.begin(), x.end());
  }
  return points;
}

// Pearson's sum over the 10 x 10 cells of two coordinates, whose strips hold a tenth of the points each.
double cells_apart(const std::vector<std::vector<double>>& points, std::size_t a, std::size_t b) {
  std::vector<double> hits(100, 0.0);
  for (const auto& x : points)
    hits[static_cast<std::size_t>(10 * x[a]) * 10 + static_cast<std::size_t>(10 * x[b])] += 1.0;
  const double expected = double(kCount) / 100;
  double sum = 0.0;
  for (const double h : hits) sum += (h - expected) * (h - expected) / expected;
  return sum;
}

}  // namespace

TEST_CASE("a Latin hypercube fills the cells of each two coordinates as independent shuffles do",
          "[optim][lhs]") {
  // With 10 strips of the same size on either axis the sum is that of chi-square with 9 * 9 degrees of
  // freedom: mean 81 and variance 162. Five deviations to either side; all points on a diagonal give 9000.
  for (const std::uint64_t seed : {1U, 5U}) {
    const auto points = numbered_points(seed);
    for (std::size_t a = 0; a <= kDimension; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        CAPTURE(seed, a, b);
        CHECK(std::abs(cells_apart(points, a, b) - 81.0) < 5.0 * std::sqrt(162.0));
      }
  }
}

TEST_CASE("a point of a Latin hypercube lies anywhere in its strata", "[optim][lhs]") {
  // Places in strata are uniform and independent: mean 1/2, variance 1/12, so the mean of 4000 of them
  // has the deviation sqrt(1/12/4000). None above 0.99, or below 0.01, has the odds of 0.99^4000 = 3e-18.
  const auto points = numbered_points(5);
  double sum = 0.0, lowest = 1.0, highest = 0.0;
  for (const auto& x : points)
    for (std::size_t j = 1; j <= kDimension; ++j) {
      const double place = x[j] * double(kCount) - std::floor(x[j] * double(kCount));
      sum += place;
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
    }
  const double all = double(kCount * kDimension);
  CHECK(std::abs(sum / all - 0.5) < 5.0 * std::sqrt(1.0 / 12.0 / all));
  CHECK(lowest < 0.01);
  CHECK(highest > 0.99);
}

TEST_CASE("even the lowest place of a stratum lies above its border", "[optim][lhs]") {
  // A single point has one stratum a coordinate, all of the interval. The seed is one of those whose
  // numbers come to the lowest of the 2^20 places, which is half of their width above the border.
  const std::size_t many = 1U << 16U;
  std::vector<double> x(many);
  LatinHypercube(many, 1, 4).point(0, x);
  const double lowest = *std::min_element(x.begin(), x.end());
  REQUIRE(lowest < 0x1.0p-20);
  CHECK(lowest > 0.0);
  CHECK(*std::max_element(x.begin(), x.end()) < 1.0);
}

TEST_CASE("a Sobol sequence is refused beyond its dimensions and its last index",
          "[optim][sobol][error]") {
  CHECK_THROWS_AS(SobolSequence(3668, 1), InputError);
  CHECK(SobolSequence(3667, 1).dimension() == 3667);
  // The Gray code of the last index is its highest bit alone, and the first axis is van der Corput's:
  // the last point is 2^-40 beside the first one, but for the rounding of numbers below 1.
  const SobolSequence sequence(2, 1);
  std::vector<double> first(2), last(2);
  sequence.point(0, first);
  sequence.point((std::uint64_t{1} << 40U) - 1, last);
  REQUIRE(first[0] < 0.9);
  CHECK(std::abs(last[0] - first[0] - 0x1.0p-40) <= 0x1.0p-52);
  CHECK_THROWS_AS(sequence.point(std::uint64_t{1} << 40U, last), InputError);
}
