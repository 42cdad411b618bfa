// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/outliers.hpp>

#include "fit/fitted_space.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <twum/optim/distributions.hpp>

namespace twum::optim {
namespace {

using Eigen::Index;

class OutlierSearch {
 public:
  OutlierSearch(const Residuals& at, const LeastSquaresResult& fit, double deviation)
      : deviation_(deviation), rows_(at.values.size()) {
    residuals_ =
        Eigen::Map<const Eigen::VectorXd>(at.values.data(), static_cast<Index>(at.values.size()));
    jacobian_ = free_jacobian(at, fit);
    std::iota(rows_.begin(), rows_.end(), Index{0});
  }

  // Removes the farthest residual again and again. All up to the last unlikely one are outliers: two that hide each
  // other show only when the first is removed.
  std::vector<Outlier> find(double level) {
    std::vector<Outlier> list;
    std::size_t unlikely = 0;
    const std::size_t most = 1 + freedom() / 10;
    while (list.size() < most && freedom() >= (known() ? 1 : 3)) {
      const auto [place, outlier] = farthest();
      if (outlier.distance == 0.0) break;
      rows_.erase(rows_.begin() + place);
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
    return rows_.size() > n ? rows_.size() - n : 0;
  }

  // L7.1 for every row that remains, and L7.2 for the largest.
  Found farthest() const {
    const Eigen::MatrixXd q = fitted_space(jacobian_(rows_, Eigen::all));
    const Eigen::VectorXd r = residuals_(rows_);
    const Eigen::VectorXd e = r - q * (q.transpose() * r);
    const double freedom = static_cast<double>(static_cast<Index>(rows_.size()) - q.cols());
    Found found{0, {}};
    for (Index i = 0; i < e.size(); ++i) {
      const double own = 1.0 - q.row(i).squaredNorm();
      if (own < kLeastOwn) continue;
      const double rest = (e.squaredNorm() - e[i] * e[i] / own) / (freedom - 1.0);
      const double scatter = known() ? deviation_ : std::sqrt(std::max(rest, 0.0));
      const double t = e[i] == 0.0 ? 0.0 : e[i] / (scatter * std::sqrt(own));
      if (std::abs(t) <= std::abs(found.outlier.distance)) continue;
      found = {i, {static_cast<std::size_t>(rows_[static_cast<std::size_t>(i)]), t, 1.0}};
    }
    const double each =
        student_tails(known() ? kInfinity : freedom - 1.0, std::abs(found.outlier.distance));
    found.outlier.p = std::min(1.0, static_cast<double>(rows_.size()) * each);
    return found;
  }

  // A row with less residual share than this determines a parameter by itself: the fit passes through it at any
  // value.
  static constexpr double kLeastOwn = 1e-8;

  double deviation_;
  std::vector<Index> rows_;  // that remain
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd jacobian_;  // by the free parameters
};

}  // namespace

std::vector<Outlier> find_outliers(const Residuals& at, const LeastSquaresResult& fit,
                                   double deviation, double level) {
  return OutlierSearch(at, fit, deviation).find(level);
}

}  // namespace twum::optim
