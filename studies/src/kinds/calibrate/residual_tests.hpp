// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// Fills in what chance says of the residuals (section 4 of the theory): how alike neighbours are, whether the readings of a
/// column share an offset, and chi-square of all and of the kind of data that stands out most. Nothing if the residuals are
/// rounding.
/// @param residuals   of `fit`, in the order of the data
/// @param deviations  the points have standard deviations; those of columns are estimated, and not tested
/// @param known       standard deviation of a residual of weight 1 if it is stated; else NaN
void test_residuals(CalibrateResult& result, const optim::Residuals& residuals,
                    const optim::LeastSquaresResult& fit, bool deviations, double known);

/// The numbers of the points that are neighbours of each other on the bench, in the order of what it varied: of all kinds of data.
std::vector<std::vector<std::size_t>> measured_series(const CalibrateResult& result);

}  // namespace twum::inline v0_1::studies
