// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// What a fit says of residuals in groups, each with a standard deviation of its own.
struct GroupDeviations {
  std::vector<double> deviations;  ///< of the groups, in units of the residuals
  /// Of the residuals relative to these; its scatter is 1. Not optimal where parameters and deviations have not settled.
  LeastSquaresResult fit;
  /// Comparable among fits from different starts: the logarithm of the geometric mean of the deviations, each counted by the
  /// degrees of freedom of its group. The least fits best.
  double level{0.0};
  /// Of each parameter (L9.2, L9.3), for LeastSquaresOptions::small_sample of a fit in parts of the deviations.
  std::vector<SmallSample> small_sample;
};

/// Residuals in parts of the deviations of their groups.
/// @throws InputError if not every residual has a group
Residuals in_deviations(Residuals raw, std::span<const std::size_t> groups,
                        std::span<const double> deviations);

/// Estimates parameters and the deviation of each group of residuals in turn until both stay (L9.1), for 60 rounds at most. A group that a fit can go
/// through has no scatter to estimate: each needs more residuals than there are parameters.
/// @param groups   number of the group of each residual, from 0
/// @param options  with the loss of squares and no known deviation
/// @throws InputError as least_squares(); for other options
/// Cost: about ten fits.
GroupDeviations group_deviations(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const std::vector<std::size_t>& groups,
                                 const LeastSquaresOptions& options = {});

/// Quantiles for intervals where the groups are so small that (L9.3) is not enough. The linearised fit is repeated with 3999 sets
/// of normal residuals, each with deviations of its groups estimated anew. The half width of an interval is the quantile of
/// |error| of the parameter in its estimated standard deviations (L9.4). The numbers are the same in every call.
/// @param at     residuals at the fit, in parts of the deviations of their groups
/// @param known  of each parameter, as of group_deviations()
/// @returns      `known` with its quantiles. Cost: about 0.1 s.
std::vector<SmallSample> with_simulated_quantiles(const Residuals& at,
                                                  std::span<const std::size_t> groups,
                                                  const LeastSquaresResult& fit, double confidence,
                                                  std::vector<SmallSample> known);

}  // namespace twum::inline v0_1::optim
