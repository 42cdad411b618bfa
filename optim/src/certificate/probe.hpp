// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

namespace twum::inline v0_1::optim {

/// A stationary point with what is known of its second order.
struct ProbeBase {
  const KktPoint& point;
  const Multipliers& multipliers;
  const Eigen::MatrixXd& hessian;
  double enough;  ///< by how much a scaled objective has to fall to be better
};

/// What values along a direction say.
struct Probed {
  std::optional<std::vector<double>> better;  ///< a better design, if there is one
  bool rises{
      false};  ///< the objective is higher after the longest step, by more than ProbeBase::enough
};

/// Looks for a better design along a direction: a few steps, each followed by Newton steps across the direction until
/// the limits are kept again. A better design breaks no limit by more than a hundredth of its tolerance, or than the
/// point does. @throws Stop
Probed probe(Session& session, const Scaling& scaling, const ProbeBase& base,
             const Eigen::VectorXd& direction);

}  // namespace twum::inline v0_1::optim
