// SPDX-License-Identifier: Apache-2.0
#include "certificate/nnls.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Least squares over the passive columns; the others stay zero.
Eigen::VectorXd passive_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                 const std::vector<Index>& passive) {
  Eigen::MatrixXd part(a.rows(), static_cast<Index>(passive.size()));
  for (Index k = 0; k < part.cols(); ++k) part.col(k) = a.col(passive[static_cast<std::size_t>(k)]);
  const Eigen::VectorXd y = part.completeOrthogonalDecomposition().solve(b);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  for (Index k = 0; k < part.cols(); ++k) x[passive[static_cast<std::size_t>(k)]] = y[k];
  return x;
}

class Solver {
 public:
  Solver(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const std::vector<bool>& free)
      : a_(a), b_(b), free_(free), x_(Eigen::VectorXd::Zero(a.cols())) {
    for (Index j = 0; j < a.cols(); ++j)
      if (is_free(j)) passive_.push_back(j);
  }

  Eigen::VectorXd run() {
    if (!passive_.empty()) settle();
    const double tolerance = 1e-14 * b_.norm();  // of columns of about unit length
    for (Index turn = 0; turn < 3 * a_.cols() + 3; ++turn) {
      const Index j = most_wanted(tolerance);
      if (j < 0) break;
      passive_.push_back(j);
      settle();
    }
    return x_;
  }

 private:
  bool is_free(Index j) const { return free_[static_cast<std::size_t>(j)]; }
  bool is_passive(Index j) const {
    return std::find(passive_.begin(), passive_.end(), j) != passive_.end();
  }

  // The column outside the passive set along which the residual falls fastest.
  Index most_wanted(double tolerance) const {
    const Eigen::VectorXd pull = a_.transpose() * (b_ - a_ * x_);
    Index best = -1;
    for (Index j = 0; j < a_.cols(); ++j)
      if (!is_passive(j) && pull[j] > tolerance && (best < 0 || pull[j] > pull[best])) best = j;
    return best;
  }

  // Moves to the passive solution, dropping unknowns that would turn negative on the way.
  void settle() {
    while (true) {
      const Eigen::VectorXd y = passive_solution(a_, b_, passive_);
      double step = 1.0;
      Index blocking = -1;
      for (const Index j : passive_) {
        if (is_free(j) || y[j] > 0.0) continue;
        const double reach = x_[j] > 0.0 ? x_[j] / (x_[j] - y[j]) : 0.0;
        if (blocking < 0 || reach < step) {
          step = reach;
          blocking = j;
        }
      }
      if (blocking < 0) {
        x_ = y;
        return;
      }
      x_ += step * (y - x_);
      x_[blocking] = 0.0;
      std::erase(passive_, blocking);
      if (passive_.empty()) {
        x_.setZero();
        return;
      }
    }
  }

  const Eigen::MatrixXd& a_;
  const Eigen::VectorXd& b_;
  const std::vector<bool>& free_;
  Eigen::VectorXd x_;
  std::vector<Index> passive_;
};

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                          const std::vector<bool>& free) {
  if (a.cols() == 0) return {};
  return Solver(a, b, free).run();
}

}  // namespace twum::inline v0_1::optim
