// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kkt.hpp"

namespace twum::optim {

/// Second derivatives of the Lagrangian in the unit box by central differences of exact gradients. Columns of
/// variables at a bound are zero. Nothing if a neighbouring point cannot be evaluated.
struct Curvature {
  Eigen::MatrixXd hessian;
};
std::optional<Curvature> lagrangian_curvature(Session& session, const Scaling& scaling,
                                              const KktPoint& point, const Multipliers& multipliers,
                                              std::size_t objectives);

/// Directions (columns) along which all active limits stay met, including those with multiplier zero. The smaller space may
/// miss a descent direction, but never contains a false one.
/// @param active  gradients of the limits, a column each
Eigen::MatrixXd null_space(const Eigen::MatrixXd& active);

/// Properties of the reduced Hessian at a stationary point.
struct ReducedCurvature {
  double smallest{
      0.0};  ///< eigenvalues relative to the Hessian's size; NaN if there is no free direction
  Eigen::MatrixXd flat;  ///< directions (columns) with zero curvature
};
ReducedCurvature reduced_curvature(const Curvature& curvature, const Multipliers& multipliers);

}  // namespace twum::optim
