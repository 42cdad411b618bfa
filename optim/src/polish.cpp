// SPDX-License-Identifier: Apache-2.0
#include "polish.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

using Eigen::Index;

constexpr double kNearLimit = 1e-3;  // how near a limit must be to be a guess at the active set
// of the box; a longer step means that the design is not nearly optimal
constexpr double kLongest = 0.05;
constexpr double kDone = 1e-11;
constexpr int kSteps = 5;

double merit(const KktPoint& p, const Multipliers& m) {
  return std::max(m.residual.cwiseAbs().maxCoeff(), p.infeasibility);
}

// Active limits, equalities and violated limits, used as equations.
struct Equations {
  Eigen::MatrixXd gradients;  // columns
  Eigen::VectorXd gaps;       // how far along its gradient each must move
};

Equations equations(const KktPoint& p, const Multipliers& m) {
  Equations eq{Eigen::MatrixXd(p.variables(), m.active.cols()), Eigen::VectorXd(m.active.cols())};
  Index count = 0;
  const auto add = [&](Index column, double gap) {
    eq.gradients.col(count) = m.active.col(column);
    eq.gaps[count++] = gap;
  };
  for (std::size_t i = 0; i < m.limits.size(); ++i) {
    const Limit& l = p.limits[m.limits[i]];
    const bool held = l.side == Side::equal || m.limit_values[i] > 1e-10 || l.excess > 0.0;
    if (held) add(static_cast<Index>(i), l.excess - l.slack);
  }
  for (std::size_t i = 0; i < m.bounds.size(); ++i) {
    if (m.bound_values[i] <= 1e-10) continue;
    const double u = p.unit[static_cast<std::size_t>(m.bounds[i])];
    add(static_cast<Index>(m.limits.size() + i), -std::min(u, 1.0 - u));
  }
  eq.gradients.conservativeResize(Eigen::NoChange, count);
  eq.gaps.conservativeResize(count);
  return eq;
}

// The excess of an equality has no sign of its own: recover it from the value.
void sign_equalities(const Problem& problem, const Scaling& scaling, KktPoint& p) {
  for (Limit& l : p.limits) {
    if (l.side != Side::equal) continue;
    const std::size_t r = problem.objectives.size() + l.constraint;
    const double error = p.evaluation.values[r] - problem.constraints[l.constraint].lower;
    l.excess = -scaling.factor(r) * error;  // positive: the value must rise
  }
}

struct NewtonStep {
  Eigen::VectorXd unit;
  Eigen::VectorXd weights;
};

// With several objectives their weights are unknowns as well: of the front's points near this one,
// the shortest step leads to the nearest.
NewtonStep newton_step(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& objectives,
                       const Eigen::VectorXd& weights, const Equations& eq, double flat) {
  const Index n = hessian.rows();
  const Index m = eq.gaps.size();
  const Index free = weights.size() - 1;  // the last follows from their sum
  const Eigen::VectorXd gradient = objectives * weights;
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + m, n + m + free);
  kkt.topLeftCorner(n, n) = hessian;
  kkt.block(0, n, n, m) = eq.gradients;
  kkt.bottomLeftCorner(m, n) = eq.gradients.transpose();
  for (Index k = 0; k < free; ++k)
    kkt.col(n + m + k).head(n) = objectives.col(k) - objectives.col(free);
  Eigen::VectorXd rhs(n + m);
  rhs << -gradient, eq.gaps;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr;
  qr.setThreshold(flat);
  const Eigen::VectorXd solution = qr.compute(kkt).solve(rhs);
  NewtonStep step{solution.head(n), weights};
  step.weights.head(free) += solution.tail(free);
  step.weights[free] -= solution.tail(free).sum();
  return step;
}

Eigen::VectorXd weighted_gradient(const KktPoint& p, const Eigen::VectorXd& weights) {
  return objective_gradients(p, static_cast<std::size_t>(weights.size())) * weights;
}

std::optional<KktPoint> step(Session& session, const Scaling& scaling, KktPoint point,
                             const Multipliers& m, Eigen::VectorXd& weights) {
  const auto curvature =
      lagrangian_curvature(session, scaling, point, m, static_cast<std::size_t>(m.weights.size()));
  if (!curvature) return std::nullopt;
  sign_equalities(session.problem(), scaling, point);
  const Eigen::MatrixXd objectives =
      objective_gradients(point, static_cast<std::size_t>(m.weights.size()));
  const Equations eq = equations(point, m);
  // No steps along flat directions, whose curvature is 1e-9 of noise from the differences. With several objectives,
  // the front itself is a flat direction up to the error of the weights.
  const double flat = m.weights.size() > 1 ? 1e-4 : 1e-7;
  const NewtonStep newton = newton_step(curvature->hessian, objectives, m.weights, eq, flat);
  const Eigen::VectorXd& d = newton.unit;
  if (!newton.weights.allFinite() || newton.weights.minCoeff() < 0.0) return std::nullopt;
  weights = newton.weights;
  if (!d.allFinite() || d.cwiseAbs().maxCoeff() > kLongest) return std::nullopt;
  std::vector<double> unit = point.unit;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    unit[k] = std::clamp(unit[k] + d[static_cast<Index>(k)], 0.0, 1.0);
    if (unit[k] < 1e-13) unit[k] = 0.0;
    if (unit[k] > 1.0 - 1e-13) unit[k] = 1.0;
  }
  return kkt_point(session, scaling, scaling.to_design(unit));
}

Multipliers multipliers(const KktPoint& p, const Eigen::VectorXd& weights) {
  const auto objectives = static_cast<std::size_t>(weights.size());
  Multipliers m = find_multipliers(p, weighted_gradient(p, weights), objectives, kNearLimit);
  m.weights = weights;
  return m;
}

}  // namespace

std::optional<std::vector<double>> polish(Session& session, const Scaling& scaling,
                                          std::span<const double> design,
                                          const std::vector<double>& weights) {
  if (scaling.size() == 0) return std::nullopt;
  Eigen::VectorXd w =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Index>(weights.size()));
  auto point = kkt_point(session, scaling, design);
  if (!point || !point->jacobian.allFinite()) return std::nullopt;
  Multipliers m = multipliers(*point, w);
  bool improved = false;
  for (int i = 0; i < kSteps && merit(*point, m) > kDone; ++i) {
    if (session.left() < 2 * scaling.size() + 1) break;
    auto next = step(session, scaling, *point, m, w);
    if (!next || !next->jacobian.allFinite()) break;
    Multipliers next_m = multipliers(*next, w);
    if (!(merit(*next, next_m) < 0.5 * merit(*point, m))) break;
    point = std::move(next);
    m = std::move(next_m);
    improved = true;
  }
  if (!improved) return std::nullopt;
  return point->design;
}

}  // namespace twum::optim
