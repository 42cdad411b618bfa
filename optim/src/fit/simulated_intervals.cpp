// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/distributions.hpp>
#include <twum/optim/group_deviations.hpp>
#include <twum/optim/random.hpp>

#include "fit/fitted_space.hpp"
#include "fit/kenward_roger.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Odd cases aside, a simulated quantile of 95 % then has a level that is right to 0.35 % (one standard deviation).
constexpr std::size_t kSimulations = 3999;
constexpr int kMostSettlingRounds = 100;
constexpr double kSimulatedSettled =
    1e-4;                                // of a squared deviation; moves a ratio by less than 1e-4
constexpr double kLeastSquares = 1e-12;  // of a group's squares: a fit through all its residuals

// Linearised fits to normal numbers of known deviations, each as group_deviations() makes it.
class SimulatedFits {
 public:
  SimulatedFits(const MatrixXd& columns, std::span<const std::size_t> groups)
      : groups_(groups),
        q_(fitted_space(columns)),
        told_(q_, groups, 1 + *std::max_element(groups.begin(), groups.end())),
        along_(parameter_rows(columns, q_)) {}

  // |error| of each parameter in its estimated standard deviations, of the simulation of this number.
  std::vector<double> ratios(std::size_t number) {
    draw(number);
    settle();
    std::vector<MatrixXd> whitened;
    for (std::size_t k = 0; k < told_.shares.size(); ++k) {
      const MatrixXd half =
          root_.matrixL().solve(told_.shares[k] / squares_[static_cast<Index>(k)]);
      whitened.emplace_back(root_.matrixL().solve(half.transpose()));
    }
    const KenwardRoger known(whitened, told_.counts);
    std::vector<double> list;
    for (Index j = 0; j < along_.rows(); ++j) {
      VectorXd c = root_.matrixL().solve(along_.row(j).transpose());
      const double deviation = c.norm();
      c /= deviation;
      list.push_back(std::abs(along_.row(j).dot(fit_)) / (deviation * known.of(c).widening));
    }
    return list;
  }

 private:
  void draw(std::size_t number) {
    constexpr std::uint64_t kSeed = 1;
    constexpr double kHalfStep = 0x1.0p-54;  // keeps 0 out
    Random random(kSeed, 0, number);
    seen_.assign(told_.shares.size(), VectorXd::Zero(q_.cols()));
    sums_ = VectorXd::Zero(told_.counts.size());
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const double e = normal_quantile(random.uniform() + kHalfStep);
      seen_[groups_[i]] += e * q_.row(static_cast<Index>(i)).transpose();
      sums_[static_cast<Index>(groups_[i])] += e * e;
    }
  }

  // L9.1, from sums over the groups alone.
  void settle() {
    squares_ = VectorXd::Ones(told_.counts.size());
    for (int round = 0; round < kMostSettlingRounds; ++round) {
      MatrixXd information = MatrixXd::Zero(q_.cols(), q_.cols());
      VectorXd right = VectorXd::Zero(q_.cols());
      for (std::size_t k = 0; k < told_.shares.size(); ++k) {
        information += told_.shares[k] / squares_[static_cast<Index>(k)];
        right += seen_[k] / squares_[static_cast<Index>(k)];
      }
      root_.compute(information);
      fit_ = root_.solve(right);
      const MatrixXd inverse = root_.solve(MatrixXd::Identity(q_.cols(), q_.cols()));
      bool same = true;
      for (Index k = 0; k < told_.counts.size(); ++k) {
        const auto group = static_cast<std::size_t>(k);
        const double left =
            sums_[k] - 2.0 * fit_.dot(seen_[group]) + fit_.dot(told_.shares[group] * fit_);
        const double freedom =
            told_.counts[k] - inverse.cwiseProduct(told_.shares[group]).sum() / squares_[k];
        const double next = std::max(left, kLeastSquares * sums_[k]) / freedom;
        same = same && std::abs(next / squares_[k] - 1.0) <= kSimulatedSettled;
        squares_[k] = next;
      }
      if (same) return;
    }
  }

  std::span<const std::size_t> groups_;
  MatrixXd q_;  // orthonormal basis of the fitted space
  GroupShares told_;
  MatrixXd along_;              // rows: each parameter in this basis
  std::vector<VectorXd> seen_;  // Q_k^T e_k
  VectorXd sums_;               // e_k^T e_k
  VectorXd squares_;            // d_k^2
  VectorXd fit_;                // in this basis
  Eigen::LLT<MatrixXd> root_;   // of the information
};

}  // namespace

std::vector<SmallSample> with_simulated_quantiles(const Residuals& at,
                                                  std::span<const std::size_t> groups,
                                                  const LeastSquaresResult& fit, double confidence,
                                                  std::vector<SmallSample> known) {
  const MatrixXd columns = free_jacobian(at, fit);
  if (columns.cols() == 0) return known;
  SimulatedFits fits(columns, groups);
  std::vector<std::vector<double>> ratios(static_cast<std::size_t>(columns.cols()));
  for (std::size_t i = 0; i < kSimulations; ++i) {
    const std::vector<double> one = fits.ratios(i);
    for (std::size_t j = 0; j < one.size(); ++j)
      ratios[j].push_back(std::isfinite(one[j]) ? one[j] : kInfinity);
  }
  const auto place = static_cast<std::ptrdiff_t>(confidence * (kSimulations + 1)) - 1;
  std::size_t free = 0;
  for (std::size_t j = 0; j < fit.estimates.size(); ++j) {
    if (fit.estimates[j].at_bound) continue;
    std::vector<double>& list = ratios[free++];
    std::nth_element(list.begin(), list.begin() + place, list.end());
    known[j].quantile = list[static_cast<std::size_t>(place)];
  }
  return known;
}

}  // namespace twum::inline v0_1::optim
