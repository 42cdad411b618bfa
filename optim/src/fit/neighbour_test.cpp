// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/neighbour_test.hpp>

#include "fit/fitted_space.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Residuals in the order of their series, and where a series goes on.
struct Chain {
  std::vector<Index> rows;
  std::vector<bool> joined;  // to the one before

  explicit Chain(const std::vector<std::vector<std::size_t>>& series) {
    for (const auto& one : series) {
      if (one.size() < 2) continue;
      for (std::size_t i = 0; i < one.size(); ++i) {
        rows.push_back(static_cast<Index>(one[i]));
        joined.push_back(i > 0);
      }
    }
  }

  // D^T D x, where D x are the differences of neighbours.
  MatrixXd squared_differences(const MatrixXd& x) const {
    MatrixXd y = MatrixXd::Zero(x.rows(), x.cols());
    for (Index i = 1; i < x.rows(); ++i) {
      if (!joined[static_cast<std::size_t>(i)]) continue;
      y.row(i) += x.row(i) - x.row(i - 1);
      y.row(i - 1) -= x.row(i) - x.row(i - 1);
    }
    return y;
  }
};

// Probability that the sum of lambda_k z_k^2 is at most 0, for independent normal z_k (Imhof 1961). In the logarithm of his
// variable the integrand is analytic up to pi / 2 from the real line and falls exponentially to both sides. The error of the
// trapezoidal rule is then exp(-pi^2 / step).
double form_below_zero(const std::vector<double>& lambda) {
  constexpr double kStep = 0.25;
  constexpr double kLowest = -40.0;
  constexpr double kHighest = 80.0;
  double sum = 0.0;
  for (double t = kLowest; t <= kHighest; t += kStep) {
    const double rate = std::exp(t);
    double angle = 0.0, decay = 0.0;
    for (const double each : lambda) {
      angle += std::atan(each * rate);
      decay += std::log1p(each * rate * each * rate);
    }
    sum += std::sin(0.5 * angle) * std::exp(-0.25 * decay);
  }
  return std::clamp(0.5 - kStep * sum / std::numbers::pi, 0.0, 1.0);
}

// Of the quadratic form of squared differences less `ratio` times squares. The errors of the residuals in the chain have the
// covariance 1 - q q^T.
class DifferenceForm {
 public:
  DifferenceForm(const Chain& chain, const MatrixXd& q, double ratio)
      : chain_(chain), q_(q), ratio_(ratio) {}

  double below_zero() const { return q_.rows() > kMostExact ? as_normal() : exact(); }

 private:
  static constexpr Index kMostExact = 300;

  MatrixXd form(const MatrixXd& x) const { return chain_.squared_differences(x) - ratio_ * x; }

  // 1 - q v (1 + sqrt(1 - s))^-1 v^T q^T, with the eigenvectors v and eigenvalues s of q^T q.
  MatrixXd root_of_covariance() const {
    const MatrixXd one = MatrixXd::Identity(q_.rows(), q_.rows());
    if (q_.cols() == 0) return one;
    const MatrixXd gram = q_.transpose() * q_;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
    MatrixXd half = q_ * eigen.eigenvectors();
    for (Index k = 0; k < half.cols(); ++k)
      half.col(k) /= std::sqrt(1.0 + std::sqrt(std::max(1.0 - eigen.eigenvalues()[k], 0.0)));
    return one - half * half.transpose();
  }

  double exact() const {
    const MatrixXd root = root_of_covariance();
    const MatrixXd whole = root * form(root);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(whole, Eigen::EigenvaluesOnly);
    constexpr double kNothing = 1e-10;  // of the form's largest value, 4
    std::vector<double> lambda;
    for (const double one : eigen.eigenvalues())
      if (std::abs(one) > 4.0 * kNothing) lambda.push_back(one);
    if (lambda.empty()) return 1.0;
    return form_below_zero(lambda);
  }

  // A sum of so many terms is normal, with this mean and variance.
  double as_normal() const {
    const auto m = static_cast<double>(q_.rows());
    double pairs = 0.0;
    double squares = 0.0;  // of the entries of the form
    for (Index i = 0; i < q_.rows(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool before = chain_.joined[k];
      const bool after = k + 1 < chain_.joined.size() && chain_.joined[k + 1];
      pairs += before ? 1.0 : 0.0;
      squares +=
          std::pow((before ? 1.0 : 0.0) + (after ? 1.0 : 0.0) - ratio_, 2) + (before ? 2.0 : 0.0);
    }
    const MatrixXd fq = form(q_);
    const MatrixXd inner = q_.transpose() * fq;
    const double mean = 2.0 * pairs - ratio_ * m - inner.trace();
    const double variance = 2.0 * (squares - 2.0 * fq.squaredNorm() + inner.squaredNorm());
    return 0.5 * std::erfc(mean / std::sqrt(2.0 * variance));
  }

  const Chain& chain_;
  const MatrixXd& q_;
  double ratio_;
};

}  // namespace

NeighbourTest neighbour_test(const Residuals& at, const LeastSquaresResult& fit,
                             const std::vector<std::vector<std::size_t>>& series) {
  const Chain chain(series);
  NeighbourTest test{chain.rows.size()};
  if (chain.rows.empty()) return test;
  const VectorXd all =
      Eigen::Map<const VectorXd>(at.values.data(), static_cast<Index>(at.values.size()));
  const MatrixXd basis = fitted_space(free_jacobian(at, fit));
  const VectorXd left = all - basis * (basis.transpose() * all);
  const VectorXd r = left(chain.rows);
  constexpr double kRounding = 1e-10;
  if (!(r.norm() > kRounding * all.norm())) return test;
  double product = 0.0, first = 0.0, second = 0.0;
  for (Index i = 1; i < r.size(); ++i) {
    if (!chain.joined[static_cast<std::size_t>(i)]) continue;
    product += r[i - 1] * r[i];
    first += r[i - 1] * r[i - 1];
    second += r[i] * r[i];
  }
  if (first > 0.0 && second > 0.0) test.correlation = product / std::sqrt(first * second);
  const double ratio = r.dot(chain.squared_differences(r).col(0)) / r.squaredNorm();
  const MatrixXd q = basis(chain.rows, Eigen::all);
  test.p = DifferenceForm(chain, q, ratio).below_zero();
  return test;
}

}  // namespace twum::inline v0_1::optim
