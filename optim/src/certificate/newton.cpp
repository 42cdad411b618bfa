// SPDX-License-Identifier: Apache-2.0
#include "certificate/newton.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

using Eigen::Index;

void Equations::add(const Eigen::VectorXd& gradient, double gap, double force) {
  gradients.conservativeResize(gradient.size(), gradients.cols() + 1);
  gradients.col(gradients.cols() - 1) = gradient;
  gaps.conservativeResize(gaps.size() + 1);
  gaps[gaps.size() - 1] = gap;
  forces.conservativeResize(gaps.size());
  forces[gaps.size() - 1] = force;
}

Equations active_equations(const KktPoint& p, const Multipliers& m) {
  constexpr double kForce = 1e-10;
  Equations eq{Eigen::MatrixXd(p.variables(), 0), Eigen::VectorXd(0), Eigen::VectorXd(0)};
  for (std::size_t i = 0; i < m.limits.size(); ++i) {
    const Limit& l = p.limits[m.limits[i]];
    const bool held = l.side == Side::equal || m.limit_values[i] > kForce || l.excess > 0.0;
    if (held) eq.add(m.active.col(static_cast<Index>(i)), l.gap, m.limit_values[i]);
  }
  for (std::size_t i = 0; i < m.bounds.size(); ++i)
    if (m.bound_values[i] > kForce)
      eq.add(m.active.col(static_cast<Index>(m.limits.size() + i)),
             -p.room[static_cast<std::size_t>(m.bounds[i])], m.bound_values[i]);
  return eq;
}

NewtonStep newton_step(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& objectives,
                       const Eigen::VectorXd& weights, const Equations& eq, double flat) {
  const Index n = hessian.rows();
  const Index m = eq.gaps.size();
  const Index free = weights.size() - 1;  // the last follows from their sum
  // One size for slopes and curvatures, or the limits would count as flat beside them.
  const double size = std::max(hessian.cwiseAbs().maxCoeff(), objectives.cwiseAbs().maxCoeff());
  const double scale = size > 0.0 ? 1.0 / size : 1.0;
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + m, n + m + free);
  kkt.topLeftCorner(n, n) = scale * hessian;
  kkt.block(0, n, n, m) = eq.gradients;
  kkt.bottomLeftCorner(m, n) = eq.gradients.transpose();
  for (Index k = 0; k < free; ++k)
    kkt.col(n + m + k).head(n) = scale * (objectives.col(k) - objectives.col(free));
  Eigen::VectorXd rhs(n + m);
  rhs << -scale * (objectives * weights - eq.gradients * eq.forces), eq.gaps;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr;
  qr.setThreshold(flat);
  const Eigen::VectorXd solution = qr.compute(kkt).solve(rhs);
  NewtonStep step{solution.head(n), weights};
  step.weights.head(free) += solution.tail(free);
  step.weights[free] -= solution.tail(free).sum();
  return step;
}

std::optional<KktPoint> moved(Session& session, const Scaling& scaling, const KktPoint& from,
                              const Eigen::VectorXd& step) {
  constexpr double kAtBound = 1e-13;
  std::vector<double> unit = from.unit;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    const double lower = scaling.lower()[k], upper = scaling.upper()[k];
    unit[k] = std::clamp(unit[k] + step[static_cast<Index>(k)], lower, upper);
    if (unit[k] < lower + kAtBound) unit[k] = lower;
    if (unit[k] > upper - kAtBound) unit[k] = upper;
  }
  return kkt_point(session, scaling, scaling.to_design(unit));
}

}  // namespace twum::inline v0_1::optim
