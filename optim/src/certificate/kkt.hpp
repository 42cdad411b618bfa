// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/scaling.hpp"
#include "problem/session.hpp"

#include <Eigen/Core>
#include <optional>

namespace twum::inline v0_1::optim {

/// One limit of one constraint, scaled.
struct Limit {
  std::size_t constraint{0};
  Side side{Side::upper};
  double slack{0.0};      ///< >= 0 inside, scaled
  double excess{0.0};     ///< > 0 outside, scaled
  double tolerance{0.0};  ///< excess up to which the limit is kept, scaled
  double gap{
      0.0};  ///< how far along its inward gradient the value has to move to be on the limit, scaled
};

/// Scaled slack of an active limit; then its complementarity is checked.
inline constexpr double kActivity = 1e-6;

/// First-order data of one design in the unit box, scaled, with minimized objectives.
struct KktPoint {
  std::vector<double> design;
  std::vector<double> unit;
  Evaluation evaluation;
  /// responses x free variables; a limit that is not active counts as flat where it has no derivative
  Eigen::MatrixXd jacobian;
  std::vector<Limit> limits;
  double infeasibility{0.0};  ///< largest excess, scaled
  double violation{
      0.0};  ///< the same relative to what the limits tolerate, see relative_violation()
  std::vector<double> room;  ///< distance of each free variable to its nearer bound, scaled
  std::vector<Side> nearer;  ///< which bound that is
  std::vector<double>
      reach;  ///< a local step: the variable's magnitude, or one unit if that is more, scaled

  Eigen::Index variables() const { return jacobian.cols(); }
};

/// Scaling at a design: variables have these sizes, responses are scaled by their gradients there. With several
/// objectives, these keep the factors of `search`.
Scaling scaling_at(const Problem& problem, const Scaling& search, const std::vector<double>& sizes,
                   std::span<const double> design, const Evaluation& evaluation);

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
  /// What each of these is worth if it alone is loosened: its value, or if several sets of values balance the slope, the least of
  /// them.
  Eigen::VectorXd worth;
};

/// Scaled gradients of the objectives as columns.
Eigen::MatrixXd objective_gradients(const KktPoint& point, std::size_t objectives);

/// Inward gradients of these limits, then bounds, as columns.
Eigen::MatrixXd active_columns(const KktPoint& point, std::size_t objectives,
                               const Multipliers& multipliers);

/// Positions of the columns of `active` that others of them sum up to.
std::vector<Eigen::Index> dependent_columns(const Eigen::MatrixXd& active);

/// Replaces the worth of these columns by the least that it can be.
void set_least_worth(const KktPoint& point, const std::vector<Eigen::Index>& dependent,
                     Multipliers& multipliers);

/// Size of gradients (columns) over the variables that no bound holds, because a steep slope into a bound says nothing
/// about the others.
double slope_beside_bounds(const Eigen::MatrixXd& gradients, const Multipliers& multipliers);

/// Whether what is left of the slope of each variable is at most this part of its own terms, but for `rounding`: then a
/// large slope of another variable hides nothing.
bool each_slope_is_balanced(const Eigen::MatrixXd& gradients, const Multipliers& multipliers,
                            double part, double rounding);

/// `gradients` has one column for each gradient that may be mixed (objectives, or one-sided
/// gradients at a kink). Limits and bounds count as active within `activity` (scaled).
Multipliers find_multipliers(const KktPoint& point, const Eigen::MatrixXd& gradients,
                             std::size_t objectives, double activity);

}  // namespace twum::inline v0_1::optim
