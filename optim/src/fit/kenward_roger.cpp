// SPDX-License-Identifier: Apache-2.0
#include "fit/kenward_roger.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

using Eigen::Index;

GroupShares::GroupShares(const Eigen::MatrixXd& basis, std::span<const std::size_t> groups,
                         std::size_t count)
    : shares(count, Eigen::MatrixXd::Zero(basis.cols(), basis.cols())),
      counts(Eigen::VectorXd::Zero(static_cast<Index>(count))) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto row = basis.row(static_cast<Index>(i));
    shares[groups[i]] += row.transpose() * row;
    ++counts[static_cast<Index>(groups[i])];
  }
}

KenwardRoger::KenwardRoger(const std::vector<Eigen::MatrixXd>& shares,
                           const Eigen::VectorXd& counts)
    : shares_(shares) {
  const Index groups = counts.size();
  const Index n = shares.front().rows();
  const auto share = [&](Index k) -> const Eigen::MatrixXd& {
    return shares[static_cast<std::size_t>(k)];
  };
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(groups, groups);
  for (Index k = 0; k < groups; ++k) {
    information(k, k) += 0.5 * counts[k] - share(k).trace();
    for (Index l = 0; l < groups; ++l)  // the trace of the product; both are symmetric
      information(k, l) += 0.5 * share(k).cwiseProduct(share(l)).sum();
  }
  covariance_ = information.completeOrthogonalDecomposition().pseudoInverse();
  more_ = Eigen::MatrixXd::Zero(n, n);
  for (Index k = 0; k < groups; ++k) {
    more_ += covariance_(k, k) * share(k);
    for (Index l = 0; l < groups; ++l) more_ -= covariance_(k, l) * share(k) * share(l);
  }
}

SmallSample KenwardRoger::of(const Eigen::VectorXd& c) const {
  Eigen::VectorXd v(covariance_.rows());
  for (Index k = 0; k < v.size(); ++k) v[k] = c.dot(shares_[static_cast<std::size_t>(k)] * c);
  return {2.0 / v.dot(covariance_ * v), std::sqrt(1.0 + 2.0 * std::max(c.dot(more_ * c), 0.0))};
}

}  // namespace twum::inline v0_1::optim
