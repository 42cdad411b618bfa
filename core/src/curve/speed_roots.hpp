// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/curve.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

namespace twum::inline v0_1::core {

/// closed_in() for a search along the curve.
/// @throws SearchFailure (unresolved) if the ends do not differ in sign
Bracket close_in(FunctionRef<double(double)> f, const Bracket& ends);

/// Polynomial through a few points of a function, in Newton's form: where to begin an iteration.
class Interpolant {
 public:
  static constexpr std::size_t kMost = 5;  // points, besides a slope
  struct Value {
    double value, slope, curvature, jerk;
  };

  void add(double x, double f) {
    std::array<double, kMost> differences{f};
    for (std::size_t k = 1; k <= count_; ++k)
      differences[k] = (differences[k - 1] - last_[k - 1]) / (x - x_[count_ - k]);
    x_[count_] = x;
    coefficients_[count_] = differences[count_];
    last_ = differences;
    ++count_;
  }

  /// Gives the polynomial this slope at x, by a term that is zero at all points. Where that term has no slope itself, as
  /// near the middle of two points, nothing changes.
  void bend(double x, double slope) {
    Value term{1, 0, 0, 0};
    for (std::size_t k = 0; k < count_; ++k) term = times(term, x - x_[k]);
    const Value here = at(x);
    const double share = (slope - here.slope) / term.slope;
    const bool small = std::fabs(share * term.curvature) < 0.1 * std::fabs(here.curvature);
    if (small) coefficients_[count_++] = share;
  }

  Value at(double x) const {
    Value p{0, 0, 0, 0};
    for (std::size_t k = count_; k-- > 0;) {
      p = times(p, x - x_[k]);
      p.value += coefficients_[k];
    }
    return p;
  }

 private:
  // The product with a factor that has the slope one.
  static Value times(const Value& p, double factor) {
    return {p.value * factor, p.slope * factor + p.value, p.curvature * factor + 2 * p.slope,
            p.jerk * factor + 3 * p.curvature};
  }

  std::array<double, kMost + 1> x_{}, coefficients_{};
  std::array<double, kMost> last_{};
  std::size_t count_{0};
};

/// Inverse interpolation through the last two or three points of a function: the steps of an iteration
/// to its zero. Their lengths say when the next one would be lost in rounding.
class InverseInterpolation {
 public:
  /// @param unit      length against which steps count
  /// @param accuracy  of the zero, in this unit
  InverseInterpolation(double unit, double accuracy) : unit_(unit), accuracy_(accuracy) {}

  void add(double x, double f) {
    points_ = {Point{x, f}, points_[0], points_[1]};
    count_ = std::min(count_ + 1, 3);
  }
  int count() const { return count_; }

  /// Where the zero should be; NaN if the points do not tell.
  double zero() const { return points_[0].x + step(); }

  /// The zero after two points, or nothing if it is not accurate enough.
  ///
  /// The secant has the slope half way between the points, and the curvature changes it to the slope at the last one. The
  /// relative error of that slope, and of the step, is the change times the relative error of the curvature. The latter is
  /// taken to be ten times the change, or ten times the disagreement with the known slope if that is larger.
  /// @param slope, curvature  of the function at the last point, as far as they are known
  std::optional<double> zero_of_two(double slope, double curvature) const {
    if (count_ != 2) return {};
    const auto& [c, b, a] = points_;
    const double mean = (c.f - b.f) / (c.x - b.x), change = 0.5 * curvature * (c.x - b.x) / mean;
    const double here = mean * (1 + change), step = -c.f / here;
    const double doubt = std::max(std::fabs(slope / here - 1), std::fabs(change));
    if (!(std::fabs(step) * 10 * doubt * doubt <= accuracy_ * unit_)) return {};
    return c.x + step;
  }

  /// True if zero() is accurate enough. Two estimates of its error: the product of the distances to the three points over
  /// (unit / 30)^2, and the square of the last correction over the step.
  bool has_converged() const {
    if (count_ < 3) return false;
    const auto& [c, b, a] = points_;
    const double x = zero(), straight = secant(), curved = straight + bend();
    const double product = 1e3 * std::fabs((x - a.x) * (x - b.x) * (x - c.x));
    return std::fabs(bend()) < 0.1 * std::fabs(straight) &&
           bend() * bend() <= accuracy_ * unit_ * std::fabs(curved) &&
           product <= accuracy_ * unit_ * unit_ * unit_;
  }

 private:
  struct Point {
    double x{0}, f{0};
  };

  double secant() const {
    const auto& [c, b, a] = points_;
    return -c.f * (b.x - c.x) / (b.f - c.f);
  }

  // What the inverse parabola x(f), in Newton's form, adds to the secant at f = 0.
  double bend() const {
    const auto& [c, b, a] = points_;
    return c.f * b.f * ((b.x - c.x) / (b.f - c.f) - (a.x - b.x) / (a.f - b.f)) / (c.f - a.f);
  }

  double step() const {
    const double straight = secant();
    return count_ == 3 && std::fabs(bend()) < std::fabs(straight) ? straight + bend() : straight;
  }

  std::array<Point, 3> points_{};
  int count_{0};
  double unit_, accuracy_;
};

}  // namespace twum::inline v0_1::core
