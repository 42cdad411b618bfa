// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace twum::studies {

/// Do residuals change their sign as often as chance would have it?
struct RunsTest {
  std::size_t count{0};  ///< residuals that are not 0
  std::size_t runs{0};   ///< stretches of one sign
  double p{1};           ///< probability of as few runs or fewer if the signs were tossed
};

/// The runs of signs of residuals in a meaningful order, such as that of speed. With independent fair
/// signs the changes of sign are binomial, (count - 1, 1/2). Residuals of a fit change sign a little
/// more often than that, so that the test errs on the side of the fit.
RunsTest runs_test(std::span<const double> residuals);

/// Probability that chi-square with so many degrees of freedom is as large as this, or larger.
/// 1 without freedom.
/// @param chi_square  >= 0
double chi_square_tail(double chi_square, std::size_t degrees_of_freedom);

}  // namespace twum::studies
