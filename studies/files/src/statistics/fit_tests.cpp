// SPDX-License-Identifier: Apache-2.0
#include "statistics/double_precision.hpp"

#include <twum/studies/statistics/fit_tests.hpp>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>

namespace twum::studies {

RunsTest runs_test(std::span<const double> residuals) {
  RunsTest test;
  double last = 0;
  for (const double residual : residuals) {
    if (residual == 0) continue;
    ++test.count;
    if (test.runs == 0 || (residual > 0) != (last > 0)) ++test.runs;
    last = residual;
  }
  if (test.count < 2) return test;
  const boost::math::binomial_distribution<double, DoublePrecision> changes(
      static_cast<double>(test.count - 1), 0.5);
  test.p = cdf(changes, static_cast<double>(test.runs - 1));
  return test;
}

double chi_square_tail(double chi_square, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return 1;
  const boost::math::chi_squared_distribution<double, DoublePrecision> distribution(
      static_cast<double>(degrees_of_freedom));
  return cdf(complement(distribution, chi_square));
}

}  // namespace twum::studies
