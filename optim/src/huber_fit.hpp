// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <span>

namespace twum::optim {

/// Residuals as Huber's loss counts them: their squares are the loss (L8.1). Internal.
/// @param bend   residuals count by their square up to here, linearly beyond it; infinite: nothing changes
/// @param share  what the loss is divided by, so that it rises about a fit as a sum of squares does
Residuals softened(Residuals raw, double bend, double share);

/// The same as another fit has them; where that fit estimated the scatter, its estimate follows the residuals.
Residuals softened_anew(Residuals raw, const LeastSquaresResult& fit);

/// Huber's scale of residuals (L8.2); 0 if too few of them differ from 0.
double huber_scale(std::span<const double> residuals, std::size_t degrees_of_freedom);

/// least_squares() with the loss of Huber.
LeastSquaresResult huber_fit(const std::vector<Variable>& parameters,
                             const ResidualFunction& residuals, const LeastSquaresOptions& options);

}  // namespace twum::optim
