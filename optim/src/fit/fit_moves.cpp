// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/fit_moves.hpp>

#include "fit/huber_fit.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <optional>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Relative step of the differences. Torques bend within some thousandths of a speed or an amplitude. The error is about the square
// of the step over this, 1e-6, and rounding over the step, 1e-13 / 3e-6. With 1e-5 moves of the modulus were off by 1e-5.
constexpr double kPart = 3e-6;

class Moves {
 public:
  Moves(const ResidualFunction& residuals, const LeastSquaresResult& fit,
        std::span<const double> held)
      : residuals_(residuals), held_(static_cast<Index>(held.size())) {
    for (const Estimate& e : fit.estimates) {
      if (!e.at_bound) free_.push_back(static_cast<Index>(at_.size()));
      at_.push_back(e.value);
    }
    count_ = static_cast<Index>(at_.size());
    at_.insert(at_.end(), held.begin(), held.end());
    cut_.emplace(residuals_(at_), fit);
  }

  std::vector<double> find() const {
    const auto n = static_cast<Index>(free_.size());
    Eigen::MatrixXd hessian(n, n);
    Eigen::MatrixXd mixed(n, held_);
    for (Index i = 0; i < n; ++i) hessian.col(i) = gradient_slope(free_[index(i)]);
    for (Index k = 0; k < held_; ++k) mixed.col(k) = gradient_slope(count_ + k);
    const Eigen::MatrixXd moves = solved(hessian, mixed);
    std::vector<double> result(index(count_ * held_), 0.0);
    for (Index i = 0; i < n; ++i)
      for (Index k = 0; k < held_; ++k) result[index(free_[index(i)] * held_ + k)] = moves(i, k);
    return result;
  }

 private:
  static std::size_t index(Index i) { return static_cast<std::size_t>(i); }

  // Gradient of half the loss by the free parameters; NaN if it cannot be evaluated.
  Eigen::VectorXd gradient(const std::vector<double>& at) const {
    Eigen::VectorXd g = Eigen::VectorXd::Constant(static_cast<Index>(free_.size()),
                                                  std::numeric_limits<double>::quiet_NaN());
    const Residuals r = residuals_(at);
    if (!r.failure.empty()) return g;
    g.setZero();
    const std::vector<double> cut = cut_->of(r.values);
    for (std::size_t i = 0; i < cut.size(); ++i)
      for (std::size_t j = 0; j < free_.size(); ++j)
        g[static_cast<Index>(j)] += cut[i] * r.jacobian[i * at.size() + index(free_[j])];
    return g;
  }

  Eigen::VectorXd gradient_slope(Index which) const {
    std::vector<double> low = at_;
    std::vector<double> high = at_;
    const double value = at_[index(which)];
    const double step = kPart * (value != 0.0 ? std::abs(value) : 1.0);
    low[index(which)] -= step;
    high[index(which)] += step;
    return (gradient(high) - gradient(low)) / (high[index(which)] - low[index(which)]);
  }

  // Solves with rows and columns scaled to a unit diagonal, so that the rank does not depend on units.
  static Eigen::MatrixXd solved(const Eigen::MatrixXd& hessian, const Eigen::MatrixXd& mixed) {
    if (hessian.rows() == 0) return mixed;  // bounds hold all
    constexpr double kRank = 1e-9;
    const Eigen::MatrixXd half = 0.5 * (hessian + hessian.transpose());
    const Eigen::VectorXd scale = half.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * half * scale.asDiagonal();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
    qr.setThreshold(kRank);
    if (!half.allFinite() || !scale.allFinite() || !qr.isInvertible())
      return Eigen::MatrixXd::Constant(mixed.rows(), mixed.cols(),
                                       std::numeric_limits<double>::quiet_NaN());
    const Eigen::MatrixXd right = scale.asDiagonal() * mixed;
    const Eigen::MatrixXd solution = qr.solve(right);
    return -(scale.asDiagonal() * solution);
  }

  const ResidualFunction& residuals_;
  std::optional<CutResiduals> cut_;
  Index held_;
  Index count_{0};           // parameters
  std::vector<double> at_;   // parameters, then held numbers
  std::vector<Index> free_;  // parameters that no bound holds
};

}  // namespace

std::vector<double> answer_moves(const ResidualFunction& residuals, const LeastSquaresResult& fit,
                                 std::span<const double> held) {
  return Moves(residuals, fit, held).find();
}

}  // namespace twum::inline v0_1::optim
