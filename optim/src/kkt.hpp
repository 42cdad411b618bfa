// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scaling.hpp"
#include "session.hpp"

#include <Eigen/Core>
#include <optional>

namespace twum::optim {

/// One limit of one constraint, scaled.
struct Limit {
  std::size_t constraint{0};
  Side side{Side::upper};
  double slack{0.0};   ///< >= 0 inside, scaled
  double excess{0.0};  ///< > 0 outside, scaled
};

/// First-order data of one design in the unit box, scaled, with minimized objectives.
struct KktPoint {
  std::vector<double> design;
  std::vector<double> unit;
  Evaluation evaluation;
  Eigen::MatrixXd jacobian;  ///< responses x free variables
  std::vector<Limit> limits;
  double infeasibility{0.0};

  Eigen::Index variables() const { return jacobian.cols(); }
};

/// Evaluates a design with its Jacobian; nothing if it cannot be evaluated. @throws Stop
std::optional<KktPoint> kkt_point(Session& session, const Scaling& scaling,
                                  std::span<const double> design);

/// Multipliers of the active limits and bounds that leave the smallest gradient.
struct Multipliers {
  std::vector<std::size_t> limits;  ///< active ones, positions in KktPoint::limits
  /// >= 0; any sign for an equality (positive if it pushes the value up)
  std::vector<double> limit_values;
  std::vector<Eigen::Index> bounds;  ///< free variables at a bound
  std::vector<double> bound_values;  ///< >= 0
  Eigen::VectorXd weights;           ///< weights of the given gradients, sum 1
  Eigen::VectorXd residual;
  Eigen::MatrixXd active;  ///< inward gradients of limits, then bounds, as columns
};

/// Scaled gradients of the objectives as columns.
Eigen::MatrixXd objective_gradients(const KktPoint& point, std::size_t objectives);

/// `gradients` has one column for each gradient that may be mixed (objectives, or one-sided
/// gradients at a kink). Limits and bounds count as active within `activity` (scaled).
Multipliers find_multipliers(const KktPoint& point, const Eigen::MatrixXd& gradients,
                             std::size_t objectives, double activity);

}  // namespace twum::optim
