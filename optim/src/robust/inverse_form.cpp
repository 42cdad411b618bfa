// SPDX-License-Identifier: Apache-2.0
#include "robust/inverse_form.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <twum/base/scalar_search.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr int kMostFormSteps = 40;
constexpr double kSettled = 1e-8;  // G is then known to 1e-16, its gradient to 1e-8
// A margin this many linear standard deviations away from failing is not searched for its worst point.
constexpr double kFar = 8.0;

std::vector<double> scaled(std::span<const double> v, double factor) {
  std::vector<double> result(v.begin(), v.end());
  for (double& x : result) x *= factor;
  return result;
}

// Replaces slopes that do not exist, at a kink or a cusp, by zero. True if there was none.
bool only_finite(std::vector<double>& slopes) {
  const auto exists = [](double slope) { return std::isfinite(slope); };
  const bool all = std::ranges::all_of(slopes, exists);
  for (double& slope : slopes)
    if (!exists(slope)) slope = 0.0;
  return all;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double d = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) d = std::max(d, std::abs(a[k] - b[k]));
  return d;
}

// The root of a falling function between two places, or the end that is nearer to it.
double root(const std::function<double(double)>& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low <= 0.0) return low;
  if (at_high >= 0.0) return high;
  return closed_in("the worst product", f, {low, high, at_low, at_high}).nearest();
}

// The step of U3.2: the z on |z| = radius with the least sum of a_k T_k(z_k), where each component solves
// a_k dT_k/dz_k = -mu z_k. Costs no evaluation. Only the direction of the slopes counts: the largest is scaled to one.
class LinearInBuilt {
 public:
  LinearInBuilt(const RobustProblem& problem, std::span<const double> x, std::vector<double> slopes,
                double radius)
      : problem_(problem), x_(x), slopes_(std::move(slopes)), radius_(radius) {
    const double largest = std::abs(
        *std::ranges::max_element(slopes_, {}, [](double slope) { return std::abs(slope); }));
    if (largest > 0.0) slopes_ = scaled(slopes_, 1.0 / largest);
  }

  std::vector<double> least() const {
    // All normal: z = -d / mu. Otherwise mu is near that, and |z| falls with mu.
    double size = 0.0;
    for (std::size_t k = 0; k < slopes_.size(); ++k)
      size = std::max(size, std::abs(slopes_[k]) * by_normal(k, 0.0));
    if (size == 0.0) return std::vector<double>(slopes_.size(), 0.0);  // nothing moves the margin
    const double middle = std::log(size / radius_);
    const double log_mu = root([&](double t) { return norm(at(std::exp(t))) - radius_; },
                               middle - 40.0, middle + 10.0);
    std::vector<double> z = at(std::exp(log_mu));
    const double length = norm(z);
    return length > 0.0 ? scaled(z, radius_ / length) : z;
  }

 private:
  double by_normal(std::size_t k, double z) const {
    return problem_.inputs[k].at(design_value(problem_, x_, k), z).by_normal;
  }

  std::vector<double> at(double mu) const {
    std::vector<double> z(slopes_.size(), 0.0);
    for (std::size_t k = 0; k < z.size(); ++k) {
      if (slopes_[k] == 0.0) continue;
      const double side = slopes_[k] > 0.0 ? -1.0 : 1.0;
      const double slope = std::abs(slopes_[k]);
      if (problem_.inputs[k].law == Law::normal) {
        z[k] = side * slope * by_normal(k, 0.0) / mu;
        continue;
      }
      z[k] = side *
             root([&](double r) { return slope * by_normal(k, side * r) - mu * r; }, 0.0, radius_);
    }
    return z;
  }

  const RobustProblem& problem_;
  std::span<const double> x_;
  std::vector<double> slopes_;
  double radius_;
};

class InverseForm {
 public:
  InverseForm(const RobustProblem& problem, const Margin& margin, std::span<const double> x,
              double beta)
      : problem_(problem), margin_(margin), x_(x), beta_(beta), side_(beta < 0.0 ? -1.0 : 1.0) {}

  InversePoint solve(std::span<const double> start) {
    if (start.empty()) {
      best_ = evaluate(std::vector<double>(problem_.inputs.size(), 0.0));
      if (!best_.failure.empty() || beta_ == 0.0) return concluded(true);
      const double slope = norm(best_.by_normal);
      const bool far = margin_.limited && best_.value > kFar * slope;
      if (slope == 0.0 || far) return concluded(true, true);
      best_ = evaluate(target());
    } else {
      best_ = evaluate(scaled(start, beta_));
    }
    for (int step = 1; step < kMostFormSteps && best_.failure.empty(); ++step) {
      if (norm(best_.by_normal) == 0.0) return concluded(true);
      const std::vector<double> next = shortened(target());
      if (largest_difference(next, best_.z) <= kSettled) return concluded(true);
      const MarginPoint tried = evaluate(next);
      if (!tried.failure.empty()) return failed(tried);
      if (side_ * tried.value <= side_ * best_.value + kRounding * std::abs(best_.value)) {
        best_ = tried;
        part_ = std::min(1.0, 2.0 * part_);
      } else {
        part_ *= 0.5;
      }
    }
    return best_.failure.empty() ? concluded(false) : failed(best_);
  }

 private:
  static constexpr double kRounding = 1e-12;

  // A product whose slopes do not all exist is not known to be the worst; drawn products decide about the margin then.
  MarginPoint evaluate(std::vector<double> z) {
    MarginPoint point = margin_at(problem_, margin_, x_, std::move(z));
    if (!point.failure.empty()) return point;
    if (!std::isfinite(point.value)) point.failure = "not-finite";
    const bool inputs = only_finite(point.by_input), spreads = only_finite(point.by_spread);
    exact_ = only_finite(point.by_normal) && inputs && spreads && exact_;
    return point;
  }

  // With correlated inputs the sum of U3.2 is no sum of functions of one z_k each: it is taken to be linear in z.
  std::vector<double> target() const {
    if (!problem_.correlation.independent())
      return scaled(best_.by_normal, -side_ * std::abs(beta_) / norm(best_.by_normal));
    return LinearInBuilt(problem_, x_, scaled(best_.by_input, side_), std::abs(beta_)).least();
  }

  // The step on the sphere, shortened after a step that increased the margin.
  std::vector<double> shortened(std::vector<double> z) const {
    if (part_ == 1.0) return z;
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = best_.z[k] + part_ * (z[k] - best_.z[k]);
    const double size = norm(z);
    return size > 0.0 ? scaled(z, std::abs(beta_) / size) : best_.z;
  }

  static InversePoint failed(const MarginPoint& point) {
    InversePoint result;
    result.at.failure = point.failure;
    return result;
  }

  // @param far  the point is the design, and the margin is taken along its tangent
  InversePoint concluded(bool converged, bool far = false) const {
    InversePoint result;
    result.at = best_;
    result.converged = converged && exact_;
    if (!best_.failure.empty()) return result;
    const double slope = norm(best_.by_normal);
    result.by_beta = -slope;
    result.direction = slope > 0.0 ? scaled(best_.by_normal, -1.0 / slope) : best_.by_normal;
    if (far) result.at.value -= beta_ * slope;
    return result;
  }

  const RobustProblem& problem_;
  const Margin& margin_;
  std::span<const double> x_;
  double beta_;
  double side_;
  double part_{1.0};
  bool exact_{true};  // every slope so far exists
  MarginPoint best_;
};

}  // namespace

InversePoint inverse_form(const RobustProblem& problem, const Margin& margin,
                          std::span<const double> x, double beta, std::span<const double> start) {
  return InverseForm(problem, margin, x, beta).solve(start);
}

}  // namespace twum::inline v0_1::optim
