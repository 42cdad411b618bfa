// SPDX-License-Identifier: Apache-2.0
#include "curvature.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::optim {
namespace {

using Eigen::Index;

// Central differences of exact gradients: truncation (h^2/6) L'''' and rounding eps |g| / h; both
// are near 1e-9 of the scaled gradient at this step.
constexpr double kStep = 1e-4;
constexpr double kFlat = 1e-6;  // eigenvalues below this part of the largest count as zero

Eigen::VectorXd lagrangian_gradient(const KktPoint& p, const Multipliers& m,
                                    std::size_t objectives) {
  Eigen::VectorXd g = objective_gradients(p, objectives) * m.weights;
  for (std::size_t i = 0; i < m.limits.size(); ++i) {
    const Limit& limit = p.limits[m.limits[i]];
    const double sign = limit.side == Side::upper ? -1.0 : 1.0;
    const Index row = static_cast<Index>(objectives + limit.constraint);
    g -= sign * m.limit_values[i] * p.jacobian.row(row).transpose();
  }
  return g;
}

bool at_bound(const Multipliers& m, Index k) {
  return std::find(m.bounds.begin(), m.bounds.end(), k) != m.bounds.end();
}

}  // namespace

Eigen::MatrixXd null_space(const Eigen::MatrixXd& active) {
  const Index n = active.rows();
  if (active.cols() == 0) return Eigen::MatrixXd::Identity(n, n);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(active);
  qr.setThreshold(1e-10);
  const Eigen::MatrixXd q = qr.householderQ();
  return q.rightCols(n - qr.rank());
}

std::optional<Curvature> lagrangian_curvature(Session& session, const Scaling& scaling,
                                              const KktPoint& point, const Multipliers& multipliers,
                                              std::size_t objectives) {
  const Index n = point.variables();
  Curvature result{Eigen::MatrixXd::Zero(n, n)};
  for (Index k = 0; k < n; ++k) {
    if (at_bound(multipliers, k)) continue;
    std::vector<double> unit = point.unit;
    double& u = unit[static_cast<std::size_t>(k)];
    const double centre = u;
    const double h = std::min({kStep, centre, 1.0 - centre});
    u = centre + h;
    const auto right = kkt_point(session, scaling, scaling.to_design(unit));
    u = centre - h;
    const auto left = kkt_point(session, scaling, scaling.to_design(unit));
    if (!right || !left) return std::nullopt;
    result.hessian.col(k) = (lagrangian_gradient(*right, multipliers, objectives) -
                             lagrangian_gradient(*left, multipliers, objectives)) /
                            (2.0 * h);
  }
  for (const Index k : multipliers.bounds) result.hessian.row(k).setZero();
  result.hessian = (0.5 * (result.hessian + result.hessian.transpose())).eval();
  if (!result.hessian.allFinite()) return std::nullopt;
  return result;
}

ReducedCurvature reduced_curvature(const Curvature& curvature, const Multipliers& multipliers) {
  const Eigen::MatrixXd z = null_space(multipliers.active);
  ReducedCurvature result;
  result.smallest = std::numeric_limits<double>::quiet_NaN();
  if (z.cols() == 0) return result;
  const Eigen::MatrixXd reduced = z.transpose() * curvature.hessian * z;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(reduced);
  // A curvature far below the slope at the start, which scaling made 1, is flat as well.
  const double size = std::max(curvature.hessian.cwiseAbs().maxCoeff(), 1.0);
  result.smallest = eigen.eigenvalues()[0] / size;
  Index flat = 0;
  for (Index i = 0; i < z.cols(); ++i)
    if (std::abs(eigen.eigenvalues()[i]) <= kFlat * size) ++flat;
  result.flat.resize(z.rows(), flat);
  for (Index i = 0, at = 0; i < z.cols(); ++i)
    if (std::abs(eigen.eigenvalues()[i]) <= kFlat * size)
      result.flat.col(at++) = z * eigen.eigenvectors().col(i);
  return result;
}

}  // namespace twum::optim
