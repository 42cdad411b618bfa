// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace twum::studies {

/// Probability that chi-square with so many degrees of freedom is as large as this, or larger. 1 for zero degrees of
/// freedom.
/// @param chi_square  >= 0
double chi_square_tail(double chi_square, std::size_t degrees_of_freedom);

}  // namespace twum::studies
