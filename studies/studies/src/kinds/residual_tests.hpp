// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/calibrate_result.hpp>

namespace twum::studies {

/// Fills in what chance says of the residuals (section 4 of the theory): the runs of their signs, and chi-square of all and of
/// the kind of data that stands out most. Nothing if the residuals are rounding.
/// @param deviations  the points have standard deviations; those of columns are estimated, and not tested
void test_residuals(CalibrateResult& result, bool deviations);

}  // namespace twum::studies
