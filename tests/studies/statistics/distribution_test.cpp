// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/studies/distribution.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using twum::studies::Distribution;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct MeanAndSd {
  double mean;
  double sd;
};

// Mean of q(p) and of its square over p by the midpoint rule.
MeanAndSd integrated(const Distribution& distribution) {
  constexpr int kSteps = 200000;
  double sum = 0;
  double square = 0;
  const double centre = distribution.quantile(0.5);
  for (int i = 0; i < kSteps; ++i) {
    const double x = distribution.quantile((i + 0.5) / kSteps) - centre;
    sum += x / kSteps;
    square += x * x / kSteps;
  }
  return {centre + sum, std::sqrt(square - sum * sum)};
}

double phi(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }
double below(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

// The midpoint rule misses the outermost half step, 2.5e-6 of the probability on each side, where x is
// 4.6 sd away: 2 * 2.5e-6 * 21 = 1e-4 of the variance, less of the mean; a heavy tail ten times that.
constexpr double kTails = 1e-4;

}  // namespace

TEST_CASE("mean and sd of a distribution are those of the quantity", "[studies][distribution]") {
  const MeanAndSd normal = integrated(Distribution::normal(160, 8));
  CHECK(normal.mean == Approx(160).epsilon(1e-12));  // symmetric: the tails cancel
  CHECK(normal.sd == Approx(8).epsilon(kTails));
  const MeanAndSd lognormal = integrated(Distribution::lognormal(0.2, 0.08));
  CHECK(lognormal.mean == Approx(0.2).epsilon(kTails));
  CHECK(lognormal.sd == Approx(0.08).epsilon(10 * kTails));
}

TEST_CASE("moments of uniform and triangular distributions", "[studies][distribution]") {
  // The error of the midpoint rule is that of a bounded integrand: below 1e-5 steps squared, save
  // for the ends of a triangular one, where q is a square root: steps to the power 3/2.
  const MeanAndSd uniform = integrated(Distribution::uniform(2, 5));
  CHECK(uniform.mean == Approx(3.5).epsilon(1e-9));
  CHECK(uniform.sd == Approx(3 / std::sqrt(12.0)).epsilon(1e-9));
  for (const double c : {-1.0, 0.5, 4.0}) {
    const MeanAndSd triangular = integrated(Distribution::triangular(-1, c, 4));
    const double variance = (1 + 16 + c * c + 4 + c - 4 * c) / 18;  // a^2+b^2+c^2-ab-ac-bc
    CHECK(triangular.mean == Approx((-1 + 4 + c) / 3).epsilon(1e-7));
    CHECK(triangular.sd == Approx(std::sqrt(variance)).epsilon(1e-7));
  }
}

TEST_CASE("quantiles at known probabilities", "[studies][distribution]") {
  CHECK(Distribution::normal(0, 1).quantile(0.975) == Approx(1.959963984540054).epsilon(1e-14));
  CHECK(Distribution::normal(3, 2).quantile(0.5) == 3);
  // The median of a lognormal quantity is mean / sqrt(1 + (sd / mean)^2).
  CHECK(Distribution::lognormal(3, 4).quantile(0.5) == Approx(3 / (5.0 / 3)).epsilon(1e-14));
  CHECK(Distribution::triangular(0, 1, 4).quantile(0.25) == Approx(1).epsilon(1e-14));  // c / b
}

TEST_CASE("limits cut off what is not admissible, and say how much", "[studies][distribution]") {
  const Distribution normal = Distribution::normal(1, 2);
  const Distribution positive = normal.within(0, kInfinity);
  CHECK(positive.cut_off() == Approx(below(-0.5)).epsilon(1e-14));
  CHECK(positive.quantile(1e-12) >= 0);
  // Mean of the part above a: m + s phi(z) / (1 - Phi(z)), z = (a - m) / s.
  CHECK(integrated(positive).mean == Approx(1 + 2 * phi(-0.5) / below(0.5)).epsilon(kTails));
  const Distribution both = normal.within(-1, 2);
  CHECK(both.cut_off() == Approx(below(-1) + below(-0.5)).epsilon(1e-14));
  CHECK(both.quantile(0.3) == Approx(1 + 2 * Distribution::normal(0, 1).quantile(
                                                 below(-1) + 0.3 * (below(0.5) - below(-1))))
                                  .epsilon(1e-14));
  CHECK(Distribution::lognormal(1, 1).within(0, kInfinity).cut_off() == 0);
  CHECK(Distribution::uniform(0, 4).within(-1, 1).cut_off() == 0.75);
  // Of a triangle with its mode at the end, (1 - x / b)^2 lies above x.
  CHECK(Distribution::triangular(0, 0, 4).within(-1, 1).cut_off() == Approx(9.0 / 16));
  CHECK(Distribution::normal(160, 8).within(0, kInfinity).cut_off() == 0);
}

TEST_CASE("Weibull and beta distributions have the mean and sd that were asked",
          "[studies][distribution]") {
  for (const double sd : {0.02, 0.3, 0.8}) {
    CAPTURE(sd);
    const MeanAndSd found = integrated(Distribution::weibull(1, sd));
    CHECK(found.mean == Approx(1).epsilon(kTails));
    CHECK(found.sd == Approx(sd).epsilon(10 * kTails));
  }
  // With its sd equal to the mean a Weibull distribution is exponential: the median is ln 2 of the mean.
  CHECK(Distribution::weibull(3, 3).quantile(0.5) == Approx(3 * std::numbers::ln2).epsilon(1e-12));
  const MeanAndSd beta = integrated(Distribution::beta(2.5, 0.4, 2, 4));
  CHECK(beta.mean == Approx(2.5).epsilon(kTails));
  CHECK(beta.sd == Approx(0.4).epsilon(kTails));
  // With the variance of a uniform one it is uniform.
  CHECK(Distribution::beta(3, 2 / std::sqrt(12.0), 2, 4).quantile(0.3) ==
        Approx(2.6).epsilon(1e-12));
}

TEST_CASE("the share below a quantile is its probability", "[studies][distribution]") {
  for (const Distribution& one :
       {Distribution::normal(3, 2), Distribution::lognormal(3, 2), Distribution::uniform(3, 4),
        Distribution::triangular(1, 2, 5), Distribution::weibull(3, 1),
        Distribution::beta(3, 0.5, 2, 5), Distribution::normal(3, 2).within(2, 4)})
    for (const double p : {0.01, 0.3, 0.9})
      CHECK(one.cdf(one.quantile(p)) == Approx(p).epsilon(1e-12));
}
