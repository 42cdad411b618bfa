// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <span>

namespace twum::inline v0_1::optim {

/// Some residuals of a fit that may share an offset.
struct OffsetRows {
  std::span<const std::size_t> rows;  ///< their numbers
  std::span<const double> slopes;     ///< of each of them by the offset: the root of its weight
  bool own_scatter{false};            ///< their scatter differs from that of the other residuals
};

/// Whether they do (L4.2).
struct OffsetTest {
  double offset{0.0};     ///< fitted - measured, estimated together with the parameters
  double deviation{0.0};  ///< its standard deviation; 0: an offset cannot be estimated
  /// Probability that independent normal errors give so large an offset of either sign, or a larger one; 1 where nothing can be
  /// said.
  double p{1.0};
};

/// Estimates an offset of some residuals together with the parameters of a linear fit with this Jacobian, and divides it by its
/// standard deviation. Exact where the errors have the sizes that their weights say; where the scatter of the rows is their own,
/// as good as these weights are; then its degrees of freedom are those of L4.3.
/// @param at         residuals and Jacobian at the fit's estimates; parameters at a bound count as known
/// @param deviation  standard deviation of a residual of weight 1, if it is known; else NaN
/// Cost: the number of residuals times the square of the number of parameters.
OffsetTest offset_test(const Residuals& at, const LeastSquaresResult& fit, const OffsetRows& asked,
                       double deviation);

}  // namespace twum::inline v0_1::optim
