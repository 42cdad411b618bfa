// SPDX-License-Identifier: Apache-2.0
#include "statistics/double_precision.hpp"

#include <twum/studies/statistics/fit_tests.hpp>

#include <boost/math/distributions/chi_squared.hpp>

namespace twum::studies {

double chi_square_tail(double chi_square, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return 1;
  const boost::math::chi_squared_distribution<double, DoublePrecision> distribution(
      static_cast<double>(degrees_of_freedom));
  return cdf(complement(distribution, chi_square));
}

}  // namespace twum::studies
