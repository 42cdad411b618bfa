// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/random.hpp>
#include <twum/studies/distribution.hpp>
#include <twum/studies/estimate.hpp>

#include <cmath>

namespace {

using namespace twum::studies;
using twum::test::Coverage;

Moments draws(const Distribution& distribution, std::uint64_t count, std::uint64_t seed) {
  Moments moments;
  twum::optim::Random random(seed, 3, 0);
  for (std::uint64_t i = 0; i < count; ++i)
    moments.add(distribution.quantile(random.uniform() + 0x1.0p-54));
  return moments;
}

}  // namespace

TEST_CASE("mean and standard deviation of a few numbers", "[studies][moments]") {
  Moments moments;
  CHECK(std::isnan(moments.mean()));
  moments.add(4);
  CHECK(std::isnan(moments.sd()));
  CHECK(std::isnan(moments.mean_estimate(0.95).low));
  for (const double x : {7.0, 13.0, 16.0}) moments.add(x);
  CHECK(moments.mean() == 10);
  CHECK(moments.sd() == Approx(std::sqrt(30.0)).epsilon(1e-15));  // (36 + 9 + 9 + 36) / 3
  // t of 3 degrees at 97.5 % is 3.1824463 (tables).
  CHECK(moments.mean_estimate(0.95).high ==
        Approx(10 + 3.1824463 * std::sqrt(30.0) / 2).epsilon(1e-8));
}

TEST_CASE("a large mean does not cost the spread its digits", "[studies][moments]") {
  Moments moments;
  for (int i = 0; i < 1000; ++i) moments.add(1e9 + (i % 2 == 0 ? 1 : -1));
  // The deviations are exact, the running mean is off by up to 1e-7 (rounding at 1e9), which enters
  // the variance of 1 squared, and by its products with deviations of alternating sign.
  CHECK(moments.sd() == Approx(std::sqrt(1000.0 / 999)).epsilon(1e-6));
}

TEST_CASE("intervals of mean and standard deviation cover", "[studies][moments]") {
  struct Case {
    const char* name;
    Distribution distribution;
    double mean;
    double sd;
  };
  const Case cases[] = {
      {"normal", Distribution::normal(5, 2), 5, 2},
      {"uniform", Distribution::uniform(-1, 3), 1, 4 / std::sqrt(12.0)},
      {"lognormal", Distribution::lognormal(10, 1), 10, 1},
      {"triangular", Distribution::triangular(0, 1, 5), 2, std::sqrt((25 + 1 - 5) / 18.0)}};
  for (const Case& one : cases) {
    Coverage mean;
    Coverage sd;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Moments moments = draws(one.distribution, 1000, seed);
      mean.count(moments.mean_estimate(0.95), one.mean);
      sd.count(moments.sd_estimate(0.95), one.sd);
    }
    INFO(one.name << ": " << mean.share() << ", " << sd.share());
    // Both intervals are asymptotic; at 1000 draws they are right to about 1 %.
    CHECK(mean.hits >= mean.fewest(0.94));
    CHECK(sd.hits >= sd.fewest(0.94));
    CHECK(mean.hits <= mean.most(0.965));
    CHECK(sd.hits <= sd.most(0.965));
  }
}
