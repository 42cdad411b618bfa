// SPDX-License-Identifier: Apache-2.0
#include "certificate/polish.hpp"

#include "certificate/newton.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
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
class Steps {
 public:
  Steps(Session& session, const Scaling& scaling, Eigen::VectorXd weights, double near)
      : session_(session), scaling_(scaling), w_(std::move(weights)), near_(near) {}

  std::optional<std::vector<double>> from(std::span<const double> design) {
    point_ = kkt_point(session_, scaling_, design);
    if (!point_ || !point_->jacobian.allFinite()) return std::nullopt;
    m_ = multipliers(*point_, w_, near_);
    bool improved = false;
    for (int i = 0; i < kSteps && merit(*point_, m_, 1.0) > 0.0; ++i) {
      if (!has_curvature() || merit(*point_, m_, size()) <= kDone) break;
      if (advance())
        improved = true;
      else if (curvature_is_of_here_)
        break;
      else
        hessian_.reset();
    }
    if (!improved) return std::nullopt;
    return point_->design;
  }

 private:
  // Beside an optimum the curvature hardly changes from step to step, and it costs two evaluations a variable.
  bool has_curvature() {
    if (hessian_) return session_.left() >= 1;
    if (session_.left() < 2 * scaling_.size() + 1) return false;
    hessian_ =
        lagrangian_curvature(session_, scaling_, *point_, m_, static_cast<std::size_t>(w_.size()));
    curvature_is_of_here_ = true;
    return hessian_.has_value();
  }

  double size() const {
    return std::max({weighted_gradient(*point_, w_).cwiseAbs().maxCoeff(),
                     hessian_->cwiseAbs().maxCoeff(), kTiny});
  }

  bool advance() {
    constexpr double kFast = 0.01;  // slower steps ask for the curvature where they are
    Eigen::VectorXd w = w_;
    auto next = step(session_, scaling_, *point_, m_, *hessian_, w);
    if (!next || !next->jacobian.allFinite()) return false;
    Multipliers next_m = multipliers(*next, w, near_);
    const double before = merit(*point_, m_, size()), after = merit(*next, next_m, size());
    if (!(after < 0.5 * before)) return false;
    point_ = std::move(next);
    m_ = std::move(next_m);
    w_ = w;
    curvature_is_of_here_ = false;
    if (after > kFast * before) hessian_.reset();
    return true;
  }

  Session& session_;
  const Scaling& scaling_;
  Eigen::VectorXd w_;
  double near_;
  std::optional<KktPoint> point_;
  Multipliers m_;
  std::optional<Eigen::MatrixXd> hessian_;
  bool curvature_is_of_here_{false};
};

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
    if (auto better = Steps(session, scaling, w, near).from(design)) return better;
  return std::nullopt;
}

}  // namespace twum::inline v0_1::optim
