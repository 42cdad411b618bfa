// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// Residuals as Huber's loss counts them: their squares are the loss (L8.1). Internal.
/// @param bend   residuals count by their square up to here, linearly beyond it; infinite: nothing changes
/// @param share  what the loss is divided by, so that it rises about a fit as a sum of squares does
Residuals softened(Residuals raw, double bend, double share);

/// The residuals in the gradient of a fit's loss: a residual beyond the bend counts as the bend. Where the fit estimated the
/// scatter, the bend follows the residuals (L8.2). Those beyond the bend are always those that are beyond it at the fit, so that
/// the gradient stays smooth (L5.1).
class CutResiduals {
 public:
  CutResiduals(const Residuals& at_fit, const LeastSquaresResult& fit);
  std::vector<double> of(std::vector<double> residuals) const;

 private:
  std::vector<double> side_;  // -1 or 1 beyond the bend, 0 within it
  double bend_;
  double rest_{
      0.0};  // degrees of freedom times beta, less those beyond the bend; 0: the bend is known
};

/// Huber's scale of residuals (L8.2); 0 if too few of them differ from 0.
double huber_scale(std::span<const double> residuals, std::size_t degrees_of_freedom);

/// least_squares() with the loss of Huber.
LeastSquaresResult huber_fit(const std::vector<Variable>& parameters,
                             const ResidualFunction& residuals, const LeastSquaresOptions& options);

}  // namespace twum::inline v0_1::optim
