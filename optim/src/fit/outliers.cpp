// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/outliers.hpp>

#include "fit/fitted_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Orthonormal basis Q of the columns of some residuals, from which residuals are taken away one by one. What is left of Q
// has the squares G = 1 - sum of q_i q_i^T over those that are gone.
class ShrinkingFit {
 public:
  ShrinkingFit(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian)
      : residuals_(residuals),
        jacobian_(jacobian),
        rows_(static_cast<std::size_t>(jacobian.rows())) {
    std::iota(rows_.begin(), rows_.end(), Index{0});
    orthonormalize();
  }

  const std::vector<Index>& rows() const { return rows_; }
  Index rank() const { return basis_.rows(); }

  // Takes the residual at this place among those that are left.
  void take(std::ptrdiff_t place) {
    const Index row = rows_[static_cast<std::size_t>(place)];
    const Eigen::VectorXd q = basis_.col(row);
    rows_.erase(rows_.begin() + place);
    squares_ -= q * q.transpose();
    products_ -= residuals_[row] * q;
    if (!well_known()) orthonormalize();
  }

  // Of each that is left: what the fit to them leaves of it, and the share of its own error that the fit does not take up.
  struct Left {
    std::vector<double> residuals, own;
    double sum{0.0};  // of the squares
  };
  Left left() const {
    const Eigen::LLT<Eigen::MatrixXd> squares(squares_);
    const Eigen::MatrixXd basis = squares.matrixL().solve(basis_);  // orthonormal again
    const Eigen::VectorXd fitted = squares.matrixL().solve(products_);
    Left left;
    for (const Index row : rows_) {
      left.residuals.push_back(residuals_[row] - basis.col(row).dot(fitted));
      left.own.push_back(1.0 - basis.col(row).squaredNorm());
      left.sum += left.residuals.back() * left.residuals.back();
    }
    return left;
  }

 private:
  // Up to here the inverse of G loses less than a digit. Residuals that say much about a parameter are few.
  bool well_known() const {
    constexpr double kLeast = 0.5;
    if (rank() == 0) return true;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(squares_, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[0] > kLeast;
  }

  void orthonormalize() {
    const Eigen::MatrixXd q = fitted_space(jacobian_(rows_, Eigen::all));
    basis_ = Eigen::MatrixXd::Zero(q.cols(), residuals_.size());
    basis_(Eigen::all, rows_) = q.transpose();
    squares_ = Eigen::MatrixXd::Identity(q.cols(), q.cols());
    products_ = q.transpose() * residuals_(rows_);
  }

  const Eigen::VectorXd& residuals_;
  const Eigen::MatrixXd& jacobian_;
  std::vector<Index> rows_;   // that remain
  Eigen::MatrixXd basis_;     // Q^T
  Eigen::MatrixXd squares_;   // G
  Eigen::VectorXd products_;  // Q^T r of those that remain
};

class OutlierSearch {
 public:
  OutlierSearch(const Residuals& at, const LeastSquaresResult& fit, double deviation)
      : deviation_(deviation),
        residuals_(Eigen::Map<const Eigen::VectorXd>(at.values.data(),
                                                     static_cast<Index>(at.values.size()))),
        jacobian_(free_jacobian(at, fit)),
        fit_(residuals_, jacobian_) {}

  // Removes the farthest residual again and again. All up to the last unlikely one are outliers: two that hide each
  // other show only when the first is removed.
  std::vector<Outlier> find(double level) {
    std::vector<Outlier> list;
    std::size_t unlikely = 0;
    const std::size_t most = 1 + freedom() / 10;
    while (list.size() < most && freedom() >= (known() ? 1 : 3)) {
      const auto [place, outlier] = farthest();
      if (outlier.distance == 0.0) break;
      fit_.take(place);
      list.push_back(outlier);
      if (outlier.p < level) unlikely = list.size();
    }
    list.resize(unlikely);
    return list;
  }

 private:
  struct Found {
    std::ptrdiff_t place;  // among the rows that remain
    Outlier outlier;
  };

  bool known() const { return std::isfinite(deviation_); }
  std::size_t freedom() const {
    const auto n = static_cast<std::size_t>(jacobian_.cols());
    return fit_.rows().size() > n ? fit_.rows().size() - n : 0;
  }

  // L7.1 for every row that remains, and L7.2 for the largest.
  Found farthest() const {
    const std::vector<Index>& rows = fit_.rows();
    const ShrinkingFit::Left left = fit_.left();
    const double freedom = static_cast<double>(static_cast<Index>(rows.size()) - fit_.rank());
    Found found{0, {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double e = left.residuals[i], own = left.own[i];
      if (own < kLeastOwn) continue;
      const double rest = (left.sum - e * e / own) / (freedom - 1.0);
      const double scatter = known() ? deviation_ : std::sqrt(std::max(rest, 0.0));
      const double t = e == 0.0 ? 0.0 : e / (scatter * std::sqrt(own));
      if (std::abs(t) <= std::abs(found.outlier.distance)) continue;
      found = {static_cast<std::ptrdiff_t>(i), {static_cast<std::size_t>(rows[i]), t, 1.0}};
    }
    const double each =
        student_tails(known() ? kInfinity : freedom - 1.0, std::abs(found.outlier.distance));
    found.outlier.p = std::min(1.0, static_cast<double>(rows.size()) * each);
    return found;
  }

  // A row with less residual share than this determines a parameter by itself: the fit passes through it at any
  // value.
  static constexpr double kLeastOwn = 1e-8;

  double deviation_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd jacobian_;  // by the free parameters
  ShrinkingFit fit_;
};

}  // namespace

std::vector<Outlier> find_outliers(const Residuals& at, const LeastSquaresResult& fit,
                                   double deviation, double level) {
  return OutlierSearch(at, fit, deviation).find(level);
}

}  // namespace twum::inline v0_1::optim
