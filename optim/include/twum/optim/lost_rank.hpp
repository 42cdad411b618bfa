// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// Sets of parameters that stay indistinguishable in a neighbourhood of the fit, not only at the fit itself. The Jacobian of a fit may lack rank at the least sum of
/// squares alone, as that of p^2 does at 0. There the data determine every parameter, and profile_end() finds its
/// interval. This compares the rank with that at two places beside the fit, which differ from it by a few thousandths of the
/// ranges (of the values where a range is infinite) in every free parameter.
/// @param fit  of these parameters and residuals, with these options
/// @returns    fit.undetermined where the rank is as low beside it, or where nothing can be evaluated there; otherwise the sets
///             at the place of the larger rank, none if it is full. Cost: two evaluations; none where the fit has its rank.
std::vector<std::vector<std::string>> lost_rank(const std::vector<Variable>& parameters,
                                                const ResidualFunction& residuals,
                                                const LeastSquaresOptions& options,
                                                const LeastSquaresResult& fit);

}  // namespace twum::inline v0_1::optim
