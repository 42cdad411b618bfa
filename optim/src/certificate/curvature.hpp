// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

namespace twum::inline v0_1::optim {

/// Second derivatives of the Lagrangian in scaled variables by differences of exact gradients: central ones, or
/// one-sided ones of second order beside a bound. Columns of variables that a bound holds with a multiplier are zero.
/// Nothing if a neighbouring point cannot be evaluated.
std::optional<Eigen::MatrixXd> lagrangian_curvature(Session& session, const Scaling& scaling,
                                                    const KktPoint& point,
                                                    const Multipliers& multipliers,
                                                    std::size_t objectives);

/// Whether differences over three times the steps agree with the largest entry: second derivatives that are all zero
/// look like the next ones times the square of the step. Costs two evaluations. With one objective.
bool curvature_is_resolved(Session& session, const Scaling& scaling, const KktPoint& point,
                           const Multipliers& multipliers, const Eigen::MatrixXd& hessian);

/// Directions (columns) along which all given limits stay met.
/// @param active  gradients of the limits, a column each
Eigen::MatrixXd null_space(const Eigen::MatrixXd& active);

/// Active limits and bounds, gradients of length 1 as columns.
struct Strength {
  Eigen::MatrixXd strong;  ///< equalities, and limits with a multiplier
  Eigen::MatrixXd weak;    ///< limits that are met with multiplier 0
};

/// A multiplier counts if its force is more than a millionth of `force`.
Strength strength(const KktPoint& point, const Multipliers& multipliers, double force);

/// Curvature along the critical cone (O4.1): the directions d with d a = 0 for strong limits and d a >= 0 for weak ones.
struct ConeCurvature {
  /// smallest d H d / d d found; NaN if the cone is a point
  double smallest{0.0};
  Eigen::VectorXd direction;  ///< with that curvature, if it is negative
  Eigen::MatrixXd flat;       ///< directions (columns) without curvature
  bool decided{true};         ///< false if there are too many weak limits to look at all faces
};

/// @param zero  curvature that counts as none
ConeCurvature cone_curvature(const Eigen::MatrixXd& hessian, const Strength& limits, double zero);

}  // namespace twum::inline v0_1::optim
