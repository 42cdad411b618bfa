// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/optim/scrambled_sobol.hpp>

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace {

using twum::optim::ScrambledSobol;

}  // namespace

TEST_CASE("every 2^m points of a scrambled Sobol sequence share out each axis evenly",
          "[optim][sobol]") {
  const ScrambledSobol sequence(24, 7, 3);
  std::vector<double> x(24);
  for (int m = 1; m <= 8; ++m) {
    const std::uint64_t count = std::uint64_t{1} << m;
    for (const std::uint64_t block : {0U, 1U, 4U}) {
      std::vector<std::set<int>> cells(24);
      for (std::uint64_t i = 0; i < count; ++i) {
        sequence.point(block * count + i, x);
        for (std::size_t j = 0; j < 24; ++j) cells[j].insert(static_cast<int>(std::ldexp(x[j], m)));
      }
      CAPTURE(m, block);
      for (const auto& axis : cells) CHECK(axis.size() == count);
    }
  }
}

TEST_CASE("the first two dimensions of a scrambled Sobol sequence are a (0, 2)-sequence",
          "[optim][sobol]") {
  // In each way of cutting the unit square into 256 equal boxes with sides that are powers of two, every
  // box holds one point (Niederreiter): scrambling must keep that.
  const ScrambledSobol sequence(2, 11, 0);
  std::vector<double> x(2);
  for (int wide = 0; wide <= 8; ++wide) {
    std::set<std::pair<int, int>> boxes;
    for (std::uint64_t i = 0; i < 256; ++i) {
      sequence.point(i, x);
      boxes.emplace(static_cast<int>(std::ldexp(x[0], wide)),
                    static_cast<int>(std::ldexp(x[1], 8 - wide)));
    }
    CHECK(boxes.size() == 256);
  }
}

TEST_CASE("scrambled Sobol points lie inside the cube, also far out in the sequence",
          "[optim][sobol]") {
  const ScrambledSobol sequence(3, 1, 0);
  std::vector<double> x(3);
  for (int k = 0; k < 40; ++k) {
    sequence.point((std::uint64_t{1} << k) - 1, x);
    for (const double c : x) {
      CHECK(c > 0);
      CHECK(c < 1);
    }
  }
}

TEST_CASE("replicates of a Sobol sequence scatter as independent uniform numbers",
          "[optim][sobol]") {
  // One point alone is uniform: mean 1/2, variance 1/12, and neighbours in the replicate number do
  // not follow each other. Five standard errors at 4000 replicates.
  constexpr int kReplicates = 4000;
  double mean = 0;
  double square = 0;
  double product = 0;
  double last = 0;
  std::vector<double> x(2);
  for (int r = 0; r < kReplicates; ++r) {
    const ScrambledSobol sequence(2, 5, static_cast<std::uint64_t>(r));
    sequence.point(37, x);
    const double deviation = x[1] - 0.5;
    mean += deviation / kReplicates;
    square += deviation * deviation / kReplicates;
    product += deviation * last / kReplicates;
    last = deviation;
  }
  const double root = std::sqrt(static_cast<double>(kReplicates));
  CHECK(mean == Approx(0).margin(5 * std::sqrt(1.0 / 12) / root));
  CHECK(square == Approx(1.0 / 12).margin(5 * std::sqrt(1.0 / 180) / root));
  CHECK(product == Approx(0).margin(5 * (1.0 / 12) / root));
}

TEST_CASE("a Sobol sequence of impossible dimension is refused", "[optim][sobol]") {
  CHECK_THROWS_AS(ScrambledSobol(0, 1, 0), twum::InputError);
  CHECK_THROWS_AS(ScrambledSobol(3668, 1, 0), twum::InputError);
}
