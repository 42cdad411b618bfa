// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace twum::studies {

/// Test whether the signs of residuals are random.
struct RunsTest {
  std::size_t count{0};  ///< residuals that are not 0
  std::size_t runs{0};   ///< runs of equal signs
  double p{1};           ///< probability of as few runs or fewer if the signs were random
};

/// The runs of signs of residuals in a meaningful order, such as that of speed. The number of sign changes of
/// independent random signs is binomial (count - 1, 1/2). Residuals of a fit change their sign slightly more often,
/// so the test favours the fit.
RunsTest runs_test(std::span<const double> residuals);

/// Probability that chi-square with so many degrees of freedom is as large as this, or larger. 1 for zero degrees of
/// freedom.
/// @param chi_square  >= 0
double chi_square_tail(double chi_square, std::size_t degrees_of_freedom);

}  // namespace twum::studies
