// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/serial_errors.hpp>

#include "fit/fitted_space.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/neighbour_test.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Series = std::vector<std::vector<std::size_t>>;

constexpr double kAsUnlike = 0.3;
constexpr double kMostCorrelation = 0.98;
constexpr int kCorrelationSteps = 49;

// Errors of variance 1, whose correlation is rho to the number of steps between them in a series.
class SerialLaw {
 public:
  SerialLaw(const Series& series, double rho) : series_(series), rho_(rho) {}

  // The logarithm of the determinant of R.
  double log_determinant() const {
    double steps = 0.0;
    for (const auto& one : series_)
      steps += one.empty() ? 0.0 : static_cast<double>(one.size() - 1);
    return steps * std::log1p(-rho_ * rho_);
  }

  // W x with W^T W = R^-1: the part of each error that the one before does not explain.
  MatrixXd whitened(const MatrixXd& x) const {
    MatrixXd result = x;
    const double size = std::sqrt(1.0 - rho_ * rho_);
    for (const auto& one : series_)
      for (std::size_t i = 1; i < one.size(); ++i)
        result.row(place(one[i])) = (x.row(place(one[i])) - rho_ * x.row(place(one[i - 1]))) / size;
    return result;
  }

  // x^T R x (L10.1)
  double form(const VectorXd& x) const {
    double sum = x.squaredNorm();
    for (const auto& one : series_) {
      double before = 0.0;  // sum over the earlier ones of rho to their distance times x
      for (std::size_t i = 1; i < one.size(); ++i) {
        before = rho_ * (before + x[place(one[i - 1])]);
        sum += 2.0 * before * x[place(one[i])];
      }
    }
    return sum;
  }

 private:
  static Index place(std::size_t number) { return static_cast<Index>(number); }

  const Series& series_;
  double rho_;
};

// One correlation: its likelihood, and the deviations of the estimates that it gives, in parts of those of independent errors.
struct Supposed {
  double correlation;
  double log_likelihood;
  double scatter;
  std::vector<double> widening;
};

// L10.2: the restricted likelihood, in which the parameters have no part.
Supposed supposed(const SerialLaw& law, double rho, const MatrixXd& basis,
                  const VectorXd& residuals, const MatrixXd& directions) {
  const MatrixXd q = law.whitened(basis);
  const VectorXd e = law.whitened(residuals);
  const Eigen::LLT<MatrixXd> information(q.transpose() * q);
  const VectorXd projected = information.matrixL().solve(q.transpose() * e);
  const double squares = e.squaredNorm() - projected.squaredNorm();
  const auto freedom = static_cast<double>(residuals.size() - basis.cols());
  Supposed one{rho, 0.0, std::sqrt(squares / freedom), {}};
  const MatrixXd factor = information.matrixL();
  one.log_likelihood = -0.5 * law.log_determinant() - factor.diagonal().array().log().sum() -
                       0.5 * freedom * std::log(squares);
  for (Index j = 0; j < directions.cols(); ++j)
    one.widening.push_back(std::sqrt(law.form(directions.col(j))));
  return one;
}

// L10.3: the mean over all correlations of the probability that the estimate is farther off than h.
class MixedTail {
 public:
  MixedTail(const std::vector<Supposed>& list, const std::vector<double>& weights, std::size_t j,
            double freedom)
      : list_(list), weights_(weights), parameter_(j), freedom_(freedom) {}

  double deviation(std::size_t k) const { return list_[k].scatter * list_[k].widening[parameter_]; }

  double tail_above(double h) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < list_.size(); ++k)
      sum += weights_[k] * student_tails(freedom_, h / deviation(k));
    return sum;
  }

  // By bisection, to 1e-9 of it; the tail falls with h.
  double half_width(double tail) const {
    double low = 0.0, high = deviation(0);
    while (tail_above(high) > tail) high *= 2.0;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (low + high);
      (tail_above(middle) > tail ? low : high) = middle;
    }
    return high;
  }

  double root_mean_square() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < list_.size(); ++k) sum += weights_[k] * deviation(k) * deviation(k);
    return std::sqrt(sum);
  }

 private:
  const std::vector<Supposed>& list_;
  const std::vector<double>& weights_;
  std::size_t parameter_;
  double freedom_;
};

std::vector<double> weights_of(const std::vector<Supposed>& list) {
  const double most = std::ranges::max_element(list, {}, &Supposed::log_likelihood)->log_likelihood;
  std::vector<double> weights;
  double sum = 0.0;
  for (const Supposed& one : list) {
    weights.push_back(std::exp(one.log_likelihood - most));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

// The direction in the residuals along which each free parameter is estimated, of length 1.
MatrixXd directions_of(const MatrixXd& columns) {
  MatrixXd rows =
      unit_columns(columns).completeOrthogonalDecomposition().pseudoInverse().transpose();
  return unit_columns(std::move(rows));
}

}  // namespace

SerialErrors serial_errors(const Residuals& at, const LeastSquaresResult& fit, const Series& series,
                           double confidence) {
  SerialErrors result;
  const NeighbourTest test = neighbour_test(at, fit, series);
  const MatrixXd columns = free_jacobian(at, fit);
  const MatrixXd basis = fitted_space(columns);
  if (!(test.p < kAsUnlike) || basis.cols() < columns.cols() || columns.cols() == 0) return result;
  const VectorXd all =
      Eigen::Map<const VectorXd>(at.values.data(), static_cast<Index>(at.values.size()));
  const VectorXd residuals = all - basis * (basis.transpose() * all);
  const MatrixXd directions = directions_of(columns);
  std::vector<Supposed> list;
  for (int k = 0; k <= kCorrelationSteps; ++k) {
    const double rho = kMostCorrelation * k / kCorrelationSteps;
    list.push_back(supposed(SerialLaw(series, rho), rho, basis, residuals, directions));
  }
  result.correlation = std::ranges::max_element(list, {}, &Supposed::log_likelihood)->correlation;
  const std::vector<double> weights = weights_of(list);
  const auto freedom = static_cast<double>(all.size() - basis.cols());
  const double student = student_quantile(freedom, 0.5 + 0.5 * confidence);
  std::size_t free = 0;
  for (const Estimate& estimate : fit.estimates) {
    SmallSample& sample = result.small_sample.emplace_back(SmallSample{freedom});
    if (estimate.at_bound) continue;
    const MixedTail tail(list, weights, free++, freedom);
    const double independent = list.front().scatter;
    sample.widening = std::max(1.0, tail.root_mean_square() / independent);
    sample.quantile =
        std::max(tail.half_width(1.0 - confidence) / independent, student) / sample.widening;
  }
  return result;
}

}  // namespace twum::inline v0_1::optim
