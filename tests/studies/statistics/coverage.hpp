// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>

#include <twum/studies/estimate.hpp>

#include <boost/math/distributions/binomial.hpp>

namespace twum::test {

/// How often intervals covered the truth.
struct Coverage {
  int hits{0};
  int trials{0};

  /// `rounding` is what the truth may lie outside by.
  void count(const studies::Estimate& estimate, double truth, double rounding = 0) {
    ++trials;
    if (estimate.low - rounding <= truth && truth <= estimate.high + rounding) ++hits;
  }
  double share() const { return static_cast<double>(hits) / trials; }
  /// Fewest hits that a true coverage leaves room for: fewer have a probability below 1e-5.
  int fewest(double coverage) const { return at(coverage, 1e-5); }
  int most(double coverage) const { return at(coverage, 1 - 1e-5); }

 private:
  int at(double coverage, double level) const {
    using namespace boost::math;
    using Doubles = policies::policy<policies::promote_double<false>>;  // valgrind has no others
    return static_cast<int>(
        quantile(binomial_distribution<double, Doubles>(trials, coverage), level));
  }
};

}  // namespace twum::test
