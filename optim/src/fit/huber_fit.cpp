// SPDX-License-Identifier: Apache-2.0
// Fits under Huber's loss: local fits of softened residuals, in turn with the scale of the residuals.
#include "fit/huber_fit.hpp"

#include "fit/fit_rounds.hpp"
#include "fit/fit_statistics.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Residuals count linearly from so many scales on: 95 % of the efficiency of least squares for normal errors (Huber 1981).
constexpr double kBend = 1.345;

// Share of a normal law within the bend, and mean square of its numbers cut off there.
double normal_share() { return std::erf(kBend / std::numbers::sqrt2); }
double normal_square() {
  const double density = std::exp(-0.5 * kBend * kBend) / std::sqrt(2.0 * std::numbers::pi);
  return normal_share() - 2.0 * kBend * density + kBend * kBend * (1.0 - normal_share());
}

class HuberFit {
 public:
  HuberFit(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
           const LeastSquaresOptions& options)
      : parameters_(parameters), residuals_(residuals), options_(options) {
    options_.loss = Loss::squares;
  }

  LeastSquaresResult run() {
    if (known()) {
      scale_ = options_.deviation;
      step();
    } else {
      take(least_squares(parameters_, residuals_, options_));
      alternate();
    }
    fit_.counters = counters_;
    if (!fit_.estimates.empty() && scale_ > 0.0) finish();
    return fit_;
  }

 private:
  // Scale and parameters in turn lower one function that is convex where the residuals are linear (Huber 1981, chapter 7).
  void alternate() {
    constexpr double kSettled = 1e-10;
    for (int round = 0; round < kMostRounds && !fit_.estimates.empty(); ++round) {
      const double before = scale_;
      scale_ = scale_here();
      const bool settled = std::abs(scale_ - before) <= kSettled * scale_;
      if (scale_ == 0.0 || settled) return;
      if (cut_short(options_, counters_)) break;
      step();
    }
    leave_unsettled(options_, counters_, fit_);
  }

  // A scale far below the scatter about the fit would count nothing but signs.
  double scale_here() {
    constexpr double kLeast = 1e-6;
    const Residuals raw = residuals_(values());
    ++counters_.evaluations;
    ++counters_.gradients;
    const double rms = Eigen::Map<const Eigen::VectorXd>(raw.values.data(), size(raw)).norm() /
                       std::sqrt(static_cast<double>(raw.values.size()));
    if (fit_.degrees_of_freedom == 0) return 0.0;
    return std::max(huber_scale(raw.values, fit_.degrees_of_freedom), kLeast * rms);
  }

  void step() {
    std::vector<Variable> from = parameters_;
    for (std::size_t j = 0; j < fit_.estimates.size(); ++j) from[j].start = fit_.estimates[j].value;
    LeastSquaresOptions rest = options_;
    rest.max_evaluations -= std::min(rest.max_evaluations, counters_.evaluations);
    const double bend = kBend * scale_;
    take(least_squares(
        from, [&](auto b) { return softened(residuals_(b), bend, 1.0); }, rest));
  }

  void take(LeastSquaresResult found) {
    counters_.add(found.counters);
    fit_ = std::move(found);
  }

  // What the fit says is that of residuals whose squares are the loss, with the Jacobian as it is.
  void finish() {
    const Residuals raw = residuals_(values());
    std::vector<Index> free;
    for (std::size_t j = 0; j < parameters_.size(); ++j)
      if (!fit_.estimates[j].at_bound) free.push_back(static_cast<Index>(j));
    const double scatter = scatter_of(raw, static_cast<double>(free.size()));
    const Residuals loss = softened(raw, fit_.bend, fit_.share);
    const Eigen::VectorXd r = Eigen::Map<const Eigen::VectorXd>(loss.values.data(), size(loss));
    fit_.sum_of_squares = r.squaredNorm();
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::MatrixXd jacobian = Eigen::Map<const RowMajor>(
        raw.jacobian.data(), size(raw), static_cast<Index>(parameters_.size()));
    fit_.directions.clear();
    fit_.undetermined.clear();
    fit_statistics({jacobian, r, free, parameters_, raw.count(), scatter}, options_, fit_);
    if (!known()) fit_.residual_deviation = scale_;
  }

  // L8.3. Where the scale is known the residuals may be fewer than it takes to tell how many are off: the normal law is the
  // least that is assumed.
  double scatter_of(const Residuals& raw, double parameters) {
    const auto count = static_cast<double>(raw.values.size());
    fit_.bend = kBend * scale_;
    double inside = 0.0;
    double squares = 0.0;
    for (const double r : raw.values) {
      inside += std::abs(r) <= fit_.bend ? 1.0 : 0.0;
      squares += std::pow(std::min(std::abs(r) / scale_, kBend), 2);
    }
    fit_.share = std::max(inside, 1.0) / count;
    double mean = squares / std::max(count - parameters, 1.0);
    if (known()) {
      fit_.share = std::min(fit_.share, normal_share());
      mean = std::max(mean, normal_square());
    }
    const double more = 1.0 + parameters / count * (1.0 - fit_.share) / fit_.share;
    return scale_ * more * std::sqrt(mean) / fit_.share;
  }

  bool known() const { return std::isfinite(options_.deviation); }
  static Index size(const Residuals& r) { return static_cast<Index>(r.values.size()); }
  std::vector<double> values() const {
    std::vector<double> b;
    for (const Estimate& e : fit_.estimates) b.push_back(e.value);
    return b;
  }

  const std::vector<Variable>& parameters_;
  const ResidualFunction& residuals_;
  LeastSquaresOptions options_;
  LeastSquaresResult fit_;
  Counters counters_;
  double scale_{0.0};
};

}  // namespace

Residuals softened(Residuals raw, double bend, double share) {
  const std::size_t n = raw.values.empty() ? 0 : raw.jacobian.size() / raw.values.size();
  const double unit = 1.0 / std::sqrt(share);
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    double& r = raw.values[i];
    double slope = unit;
    if (std::abs(r) > bend) {
      const double root = std::sqrt(bend * (2.0 * std::abs(r) - bend));
      slope = unit * bend / root;
      r = std::copysign(root, r);
    }
    r *= unit;
    for (std::size_t j = 0; j < n; ++j) raw.jacobian[i * n + j] *= slope;
  }
  return raw;
}

CutResiduals::CutResiduals(const Residuals& at_fit, const LeastSquaresResult& fit)
    : side_(at_fit.values.size(), 0.0), bend_(fit.bend) {
  double beyond = 0.0;
  for (std::size_t i = 0; i < side_.size(); ++i) {
    if (std::abs(at_fit.values[i]) <= bend_) continue;
    side_[i] = std::copysign(1.0, at_fit.values[i]);
    beyond += 1.0;
  }
  if (std::isfinite(bend_) && !fit.scatter_known)
    rest_ = static_cast<double>(fit.degrees_of_freedom) * normal_square() - kBend * kBend * beyond;
}

std::vector<double> CutResiduals::of(std::vector<double> residuals) const {
  double inside = 0.0;
  for (std::size_t i = 0; i < side_.size(); ++i)
    if (side_[i] == 0.0) inside += residuals[i] * residuals[i];
  const double bend = rest_ > 0.0 ? kBend * std::sqrt(inside / rest_) : bend_;
  for (std::size_t i = 0; i < side_.size(); ++i)
    if (side_[i] != 0.0) residuals[i] = side_[i] * bend;
  return residuals;
}

// s^2 is the sum of the squares within the bend over what is left of (m - n) beta by those beyond it: the right number of
// these is the one at which they are just those beyond.
double huber_scale(std::span<const double> residuals, std::size_t degrees_of_freedom) {
  std::vector<double> sizes;
  for (const double r : residuals) sizes.push_back(std::abs(r));
  std::sort(sizes.begin(), sizes.end());
  double inside = 0.0;
  for (const double r : sizes) inside += r * r;
  double left = static_cast<double>(degrees_of_freedom) * normal_square();
  while (!sizes.empty() && left > 0.0) {
    const double scale = std::sqrt(inside / left);
    if (sizes.back() <= kBend * scale) return scale;
    inside = std::max(inside - sizes.back() * sizes.back(), 0.0);
    left -= kBend * kBend;
    sizes.pop_back();
  }
  return 0.0;
}

LeastSquaresResult huber_fit(const std::vector<Variable>& parameters,
                             const ResidualFunction& residuals,
                             const LeastSquaresOptions& options) {
  return HuberFit(parameters, residuals, options).run();
}

}  // namespace twum::inline v0_1::optim
