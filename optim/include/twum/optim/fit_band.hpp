// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/fit_profile.hpp>
#include <twum/optim/least_squares.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// A number that a fitted model predicts.
struct Prediction {
  double value{0.0};               ///< at some parameters
  std::vector<double> gradient{};  ///< in them; empty: it has no value there
};

/// Parameters in user units.
using PredictionFunction = std::function<Prediction(std::span<const double>)>;

/// The parameters at which a prediction is least, or largest, among all whose sum of squares exceeds that of the estimates by
/// `rise` at most (L3.3), by SLSQP from one start or two. An end without a certificate
/// counts where it has 0.9 of the rise. Cost: some ten to some hundred evaluations of both functions.
/// @param parameters  with their ranges, which are not left
/// @param prediction  the number
/// @param estimates   at the least sum of squares, in user units
/// @param rise        (t s)^2 of (L3.1)
/// @param near        parameters from which the search begins, such as the end for a prediction near this one; empty: the estimates
/// @return nothing where no such end is found
std::optional<std::vector<double>> band_end(const std::vector<Variable>& parameters,
                                            const ResidualFunction& residuals,
                                            const PredictionFunction& prediction,
                                            std::span<const double> estimates, double rise,
                                            IntervalEnd end, std::span<const double> near = {});

}  // namespace twum::inline v0_1::optim
