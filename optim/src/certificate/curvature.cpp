// SPDX-License-Identifier: Apache-2.0
#include "certificate/curvature.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Differences of exact gradients: truncation (h^2/6) L'''' and rounding eps |g| / h; both are near 1e-9 of the scaled
// gradient at this step.
constexpr double kStep = 1e-4;
constexpr double kForce = 1e-6;

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

// Held by a bound whose multiplier counts beside the objective and its gradient.
bool held(const Multipliers& m, Index k, double force) {
  for (std::size_t i = 0; i < m.bounds.size(); ++i)
    if (m.bounds[i] == k) return m.bound_values[i] > kForce * force;
  return false;
}

double force_that_counts(const KktPoint& p, const Scaling& scaling, const Multipliers& m,
                         std::size_t objectives) {
  const double slope = (objective_gradients(p, objectives) * m.weights).cwiseAbs().maxCoeff();
  return std::max(slope, std::abs(scaling.factor(0) * p.evaluation.values[0]));
}

// Second derivatives by one variable.
class Column {
 public:
  Column(Session& session, const Scaling& scaling, const KktPoint& point, const Multipliers& m,
         std::size_t objectives)
      : session_(session), scaling_(scaling), point_(point), m_(m), objectives_(objectives) {}

  std::optional<Eigen::VectorXd> of(Index k, double stretch = 1.0) {
    const auto at = static_cast<std::size_t>(k);
    const double width = scaling_.upper()[at] - scaling_.lower()[at];
    const double h = std::min(stretch * kStep * nearness(at), 0.25 * width);
    if (point_.room[at] >= h) {
      const auto right = gradient(at, h), left = gradient(at, -h);
      if (!right || !left) return std::nullopt;
      return ((*right - *left) / (2.0 * h)).eval();
    }
    const double inward = point_.nearer[at] == Side::lower ? h : -h;
    const auto near = gradient(at, inward), far = gradient(at, 2.0 * inward);
    if (!near || !far) return std::nullopt;
    const Eigen::VectorXd here = lagrangian_gradient(point_, m_, objectives_);
    return ((-3.0 * here + 4.0 * *near - *far) / (2.0 * inward)).eval();
  }

 private:
  // A variable near zero has a size of one unit, of which it needs a smaller part.
  double nearness(std::size_t k) const {
    constexpr double kLeast = 1e-2;
    const double magnitude = std::abs(point_.design[scaling_.variable(k)]);
    return std::clamp(magnitude / (point_.reach[k] * scaling_.slope(k, point_.design)), kLeast,
                      1.0);
  }

  std::optional<Eigen::VectorXd> gradient(std::size_t k, double step) {
    std::vector<double> unit = point_.unit;
    unit[k] += step;
    const auto p = kkt_point(session_, scaling_, scaling_.to_design(unit));
    if (!p) return std::nullopt;
    return lagrangian_gradient(*p, m_, objectives_);
  }

  Session& session_;
  const Scaling& scaling_;
  const KktPoint& point_;
  const Multipliers& m_;
  std::size_t objectives_;
};

Eigen::MatrixXd chosen(const Eigen::MatrixXd& columns, std::size_t subset) {
  Eigen::MatrixXd picked(columns.rows(), 0);
  for (Index j = 0; j < columns.cols(); ++j) {
    if ((subset >> static_cast<std::size_t>(j) & 1U) == 0) continue;
    picked.conservativeResize(Eigen::NoChange, picked.cols() + 1);
    picked.col(picked.cols() - 1) = columns.col(j);
  }
  return picked;
}

Eigen::MatrixXd side_by_side(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd both(a.rows(), a.cols() + b.cols());
  both.leftCols(a.cols()) = a;
  both.rightCols(b.cols()) = b;
  return both;
}

struct Spectrum {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // in the whole space
};

Spectrum spectrum(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& met) {
  const Eigen::MatrixXd z = null_space(met);
  if (z.cols() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(z.transpose() * hessian * z);
  return {eigen.eigenvalues(), z * eigen.eigenvectors()};
}

void set_flat(ConeCurvature& cone, const Spectrum& s, double zero) {
  cone.flat.resize(s.vectors.rows(), 0);
  for (Index j = 0; j < s.values.size(); ++j) {
    if (std::abs(s.values[j]) > zero) continue;
    cone.flat.conservativeResize(Eigen::NoChange, cone.flat.cols() + 1);
    cone.flat.col(cone.flat.cols() - 1) = s.vectors.col(j);
  }
}

bool allowed(const Eigen::VectorXd& d, const Eigen::MatrixXd& weak) {
  return weak.cols() == 0 || (weak.transpose() * d).minCoeff() >= -1e-9;
}

// The least curvature on a cone lies within one of its faces, where it is the smallest eigenvalue of the Hessian on
// the subspace of that face.
void look_at_face(ConeCurvature& cone, const Spectrum& s, const Eigen::MatrixXd& weak,
                  double zero) {
  for (Index j = 0; j < s.values.size() && s.values[j] < -zero; ++j)
    for (const double sign : {1.0, -1.0}) {
      if (!(s.values[j] < cone.smallest) || !allowed(sign * s.vectors.col(j), weak)) continue;
      cone.smallest = s.values[j];
      cone.direction = sign * s.vectors.col(j);
    }
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

std::optional<Eigen::MatrixXd> lagrangian_curvature(Session& session, const Scaling& scaling,
                                                    const KktPoint& point,
                                                    const Multipliers& multipliers,
                                                    std::size_t objectives) {
  const Index n = point.variables();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n);
  Column column(session, scaling, point, multipliers, objectives);
  const double force = force_that_counts(point, scaling, multipliers, objectives);
  for (Index k = 0; k < n; ++k) {
    if (held(multipliers, k, force)) continue;
    const auto one = column.of(k);
    if (!one) return std::nullopt;
    hessian.col(k) = *one;
  }
  for (Index k = 0; k < n; ++k)
    if (held(multipliers, k, force)) hessian.row(k).setZero();
  hessian = (0.5 * (hessian + hessian.transpose())).eval();
  if (!hessian.allFinite()) return std::nullopt;
  return hessian;
}

bool curvature_is_resolved(Session& session, const Scaling& scaling, const KktPoint& point,
                           const Multipliers& multipliers, const Eigen::MatrixXd& hessian) {
  constexpr double kStretch = 3.0, kMost = 0.5;
  Index row = 0, k = 0;
  const double largest = hessian.cwiseAbs().maxCoeff(&row, &k);
  Column column(session, scaling, point, multipliers, 1);
  const auto further = column.of(k, kStretch);
  return further && std::abs((*further)[row] - hessian(row, k)) <= kMost * largest;
}

Strength strength(const KktPoint& point, const Multipliers& m, double force) {
  const Index n = m.active.rows();
  Strength s{Eigen::MatrixXd(n, 0), Eigen::MatrixXd(n, 0)};
  for (Index j = 0; j < m.active.cols(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const bool limit = at < m.limits.size();
    const double value = limit ? m.limit_values[at] : m.bound_values[at - m.limits.size()];
    const double size = m.active.col(j).norm();
    if (!(size > 0.0)) continue;
    const bool equal = limit && point.limits[m.limits[at]].side == Side::equal;
    Eigen::MatrixXd& list = equal || value * size > kForce * force ? s.strong : s.weak;
    list.conservativeResize(Eigen::NoChange, list.cols() + 1);
    list.col(list.cols() - 1) = m.active.col(j) / size;
  }
  return s;
}

ConeCurvature cone_curvature(const Eigen::MatrixXd& hessian, const Strength& limits, double zero) {
  constexpr Index kMostWeak = 10;
  ConeCurvature cone;
  const Spectrum wide = spectrum(hessian, limits.strong);
  cone.smallest =
      wide.values.size() > 0 ? wide.values[0] : std::numeric_limits<double>::quiet_NaN();
  set_flat(cone, wide, zero);
  if (wide.values.size() == 0 || wide.values[0] >= -zero) return cone;
  const Spectrum narrow = spectrum(hessian, side_by_side(limits.strong, limits.weak));
  cone.smallest = 0.0;
  set_flat(cone, narrow, zero);
  cone.decided = limits.weak.cols() <= kMostWeak;
  const Index faces = Index{1} << std::min(limits.weak.cols(), kMostWeak);
  for (Index face = 0; face < faces; ++face) {
    const auto met = chosen(limits.weak, static_cast<std::size_t>(face));
    look_at_face(cone, spectrum(hessian, side_by_side(limits.strong, met)), limits.weak, zero);
  }
  look_at_face(cone, narrow, limits.weak, zero);
  return cone;
}

}  // namespace twum::inline v0_1::optim
