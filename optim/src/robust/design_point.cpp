// SPDX-License-Identifier: Apache-2.0
#include "robust/design_point.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

constexpr int kMostNewtonSteps = 40;
constexpr double kSettledBeta = 1e-9;
// A tail beyond it holds 1e-16; random inputs are cut off there.
constexpr double kFarthestBeta = 8.2;

class DesignPointSearch {
 public:
  DesignPointSearch(const RobustProblem& problem, const Margin& margin, std::span<const double> x)
      : problem_(problem), margin_(margin), x_(x) {}

  NearestFailure from(std::span<const double> start) {
    const double size = norm(start);
    direction_.assign(start.begin(), start.end());
    for (double& c : direction_) c /= size;
    double beta = std::min(size, kFarthestBeta);
    for (int step = 0; step < kMostNewtonSteps; ++step) {
      const double next = next_after(beta);
      if (!std::isfinite(next)) return {{}, next};
      if (std::abs(next - beta) <= kSettledBeta) break;
      beta = next;
    }
    return found_;
  }

 private:
  // beta + G / |d| (U8.1). At a distance without an answer the margin fails.
  double next_after(double beta) {
    const std::vector<double> none;
    const InversePoint here =
        inverse_form(problem_, margin_, x_, beta, beta == 0.0 ? none : direction_);
    if (!here.at.failure.empty()) {
      failing_ = beta;
      return middle();
    }
    found_ = {here, beta};
    if (here.by_beta == 0.0) return kInfinity;  // nothing moves the margin
    direction_ = here.direction;
    const double value = here.at.value;
    if (std::abs(beta) == kFarthestBeta && value * beta > 0.0)
      return std::copysign(kInfinity, beta);
    (value > 0.0 ? safe_ : failing_) = beta;
    return within(beta - value / here.by_beta);
  }

  // The step, shortened to an end where the margin was not tried, or to the middle.
  double within(double next) const {
    if (next <= safe_) return safe_ == -kFarthestBeta ? safe_ : middle();
    if (next >= failing_) return failing_ == kFarthestBeta ? failing_ : middle();
    return next;
  }

  double middle() const { return 0.5 * (safe_ + failing_); }

  const RobustProblem& problem_;
  const Margin& margin_;
  std::span<const double> x_;
  std::vector<double> direction_;
  double safe_{-kFarthestBeta};
  double failing_{kFarthestBeta};
  NearestFailure found_{{}, kInfinity};
};

}  // namespace

NearestFailure nearest_failure(const RobustProblem& problem, const Margin& margin,
                               std::span<const double> x, std::span<const double> start) {
  return DesignPointSearch(problem, margin, x).from(start);
}

}  // namespace twum::inline v0_1::optim
