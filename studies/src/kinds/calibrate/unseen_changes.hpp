// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>
#include <twum/studies/calibrate_result.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Sets of parameters that the data do not tell apart.
/// @param residuals  at the fit
/// @param names      of the parameters of each set
std::vector<CalibrateResult::Undetermined> unseen_sets(
    const optim::LeastSquaresResult& fit, const optim::Residuals& residuals,
    const std::vector<std::vector<std::string>>& names);

/// Directions along which a confidence interval is half of the values wide, or more (L2.3); if there are none, the one
/// that is seen least.
/// @param exact  the residuals are rounding, so that nothing is known of the scatter
std::vector<CalibrateResult::Combination> hardly_seen(const optim::LeastSquaresResult& fit,
                                                      std::size_t points, bool exact);

}  // namespace twum::inline v0_1::studies
