// SPDX-License-Identifier: Apache-2.0
#include "certificate/polish.hpp"

#include "certificate/newton.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

using Eigen::Index;

constexpr double kOnLimit = 1e-6;
constexpr double kNearLimit = 1e-2;  // how near a limit must be to be a guess at the active set
// relative to a variable's magnitude; a longer step means that the design is not nearly optimal
constexpr double kLongest = 0.15;
constexpr double kDone = 1e-12;
constexpr double kTiny = 1e-300;
constexpr int kSteps = 5;

double merit(const KktPoint& p, const Multipliers& m, double size) {
  return std::max(m.residual.cwiseAbs().maxCoeff() / size, p.infeasibility);
}

Eigen::VectorXd weighted_gradient(const KktPoint& p, const Eigen::VectorXd& weights) {
  return objective_gradients(p, static_cast<std::size_t>(weights.size())) * weights;
}

bool short_enough(const KktPoint& point, const Eigen::VectorXd& step) {
  for (Index k = 0; k < step.size(); ++k)
    if (!(std::abs(step[k]) <= kLongest * point.reach[static_cast<std::size_t>(k)])) return false;
  return true;
}

std::optional<KktPoint> step(Session& session, const Scaling& scaling, const KktPoint& point,
                             const Multipliers& m, const Eigen::MatrixXd& hessian,
                             Eigen::VectorXd& weights) {
  const Eigen::MatrixXd objectives =
      objective_gradients(point, static_cast<std::size_t>(m.weights.size()));
  // No steps along flat directions, whose curvature is 1e-9 of noise from the differences. With several objectives,
  // the front itself is a flat direction up to the error of the weights.
  const double flat = m.weights.size() > 1 ? 1e-4 : 1e-7;
  const NewtonStep newton =
      newton_step(hessian, objectives, m.weights, active_equations(point, m), flat);
  if (!newton.weights.allFinite() || newton.weights.minCoeff() < 0.0) return std::nullopt;
  weights = newton.weights;
  if (!short_enough(point, newton.unit)) return std::nullopt;
  return moved(session, scaling, point, newton.unit);
}

Multipliers multipliers(const KktPoint& p, const Eigen::VectorXd& weights, double near) {
  const auto objectives = static_cast<std::size_t>(weights.size());
  Multipliers m = find_multipliers(p, weighted_gradient(p, weights), objectives, near);
  m.weights = weights;
  return m;
}

// Newton steps with the limits within `near` as the guess at the active set, each of which has to halve the error.
std::optional<std::vector<double>> steps(Session& session, const Scaling& scaling,
                                         std::span<const double> design, Eigen::VectorXd w,
                                         double near) {
  auto point = kkt_point(session, scaling, design);
  if (!point || !point->jacobian.allFinite()) return std::nullopt;
  Multipliers m = multipliers(*point, w, near);
  bool improved = false;
  for (int i = 0; i < kSteps && merit(*point, m, 1.0) > 0.0; ++i) {
    if (session.left() < 2 * scaling.size() + 1) break;
    const auto hessian =
        lagrangian_curvature(session, scaling, *point, m, static_cast<std::size_t>(w.size()));
    if (!hessian) break;
    const double size = std::max({weighted_gradient(*point, w).cwiseAbs().maxCoeff(),
                                  hessian->cwiseAbs().maxCoeff(), kTiny});
    if (merit(*point, m, size) <= kDone) break;
    auto next = step(session, scaling, *point, m, *hessian, w);
    if (!next || !next->jacobian.allFinite()) break;
    Multipliers next_m = multipliers(*next, w, near);
    if (!(merit(*next, next_m, size) < 0.5 * merit(*point, m, size))) break;
    point = std::move(next);
    m = std::move(next_m);
    improved = true;
  }
  if (!improved) return std::nullopt;
  return point->design;
}

}  // namespace

std::optional<std::vector<double>> polish(Session& session, const Scaling& search,
                                          std::span<const double> design,
                                          const std::vector<double>& weights) {
  if (search.size() == 0) return std::nullopt;
  const Eigen::VectorXd w =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Index>(weights.size()));
  const Evaluation here = session.at(design, true);
  if (!here.ok()) return std::nullopt;
  const Problem& problem = session.problem();
  const Scaling scaling = scaling_at(problem, search, search_sizes(problem, design), design, here);
  for (const double near : {kNearLimit, kOnLimit})
    if (auto better = steps(session, scaling, design, w, near)) return better;
  return std::nullopt;
}

}  // namespace twum::optim
