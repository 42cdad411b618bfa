// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

namespace twum::inline v0_1::optim {

/// Limits and bounds that a step has to meet, used as equations.
struct Equations {
  Eigen::MatrixXd gradients;  ///< columns
  Eigen::VectorXd gaps;       ///< how far along its gradient each must move
  Eigen::VectorXd forces;     ///< multipliers where the step begins

  void add(const Eigen::VectorXd& gradient, double gap, double force);
};

/// Equalities, violated limits, and active limits with a multiplier.
Equations active_equations(const KktPoint& point, const Multipliers& multipliers);

struct NewtonStep {
  Eigen::VectorXd unit;     ///< step of the scaled variables
  Eigen::VectorXd weights;  ///< of the objectives after it
};

/// Newton's step for the optimality conditions, in changes of the variables, multipliers and weights. With several
/// objectives there is a whole front of solutions nearby; the shortest step leads to the nearest.
/// @param objectives  gradients as columns
/// @param flat  singular values below this part of the largest do not count: no steps along flat directions
NewtonStep newton_step(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& objectives,
                       const Eigen::VectorXd& weights, const Equations& equations, double flat);

/// The point after a step, kept within the bounds. @throws Stop
std::optional<KktPoint> moved(Session& session, const Scaling& scaling, const KktPoint& from,
                              const Eigen::VectorXd& step);

}  // namespace twum::inline v0_1::optim
