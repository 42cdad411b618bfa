// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/fit_profile.hpp>

#include <twum/base/error.hpp>

#include "fit/huber_fit.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// The linearised end is kept if the profile agrees to this, in half widths.
constexpr double kAgrees = 0.1;
// First step of the search where the fit has no linearised interval, in parts of the range.
constexpr double kFirstPart = 0.01;
// Accuracy of an end found by a search, in half widths.
constexpr double kFound = 1e-3;
constexpr int kMostSearchSteps = 40;
// A sum of squares lower than that of the fit by this relative amount is not a rounding error.
constexpr double kBetter = 1e-6;

// The profile on one side of the fit, in half widths of the linearised interval: z(u) is the root of the increase of the
// sum of squares in units of (t s)^2 when the parameter is u half widths away. Linear residuals give z = u.
class Profile {
 public:
  Profile(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
          const LeastSquaresOptions& options, const LeastSquaresResult& fit, std::size_t parameter,
          IntervalEnd end)
      : parameters_(parameters),
        residuals_(residuals),
        options_(options),
        fit_(fit),
        which_(parameter),
        sign_(end == IntervalEnd::high ? 1.0 : -1.0),
        lowest_((1.0 - kBetter) * fit.sum_of_squares) {
    const Estimate& e = fit.estimates[which_];
    log_ = parameters[which_].scale == Scale::log;
    linear_ = e.standard_deviation > 0.0 && std::isfinite(e.standard_deviation);
    width_ = linear_ ? (log_ ? std::log(e.high / e.value) : e.high - e.value) : first_width();
    const double bound =
        end == IntervalEnd::high ? parameters[which_].upper : parameters[which_].lower;
    farthest_ = std::abs(log_ ? std::log(bound / e.value) : bound - e.value) / width_;
    if (std::isnan(farthest_)) farthest_ = kInfinity;
  }

  ProfileEnd find() {
    double inside = 0.0;
    double at = std::min(1.0, farthest_);
    double z = height(at);
    if (linear_ && at == 1.0 && std::abs(z - 1.0) <= kAgrees) return answer(1.0, true, false);
    while (z < 1.0) {
      if (at == farthest_) return answer(at, false, true);
      inside = at;
      at = std::min(farthest_, at * std::clamp(1.1 / z, 1.5, 4.0));
      z = height(at);
    }
    return answer(root(inside, at, z), false, false);
  }

 private:
  // Where the Jacobian lacks rank: a part of the range, or of the value where the range is infinite.
  double first_width() const {
    const Variable& v = parameters_[which_];
    if (log_) return kFirstPart * std::log(v.upper / v.lower);
    const double range = v.upper - v.lower;
    const double value = std::abs(fit_.estimates[which_].value);
    return kFirstPart * (std::isfinite(range) ? range : value > 0.0 ? value : 1.0);
  }

  double value(double u) const {
    const double centre = fit_.estimates[which_].value;
    if (u == farthest_) return sign_ > 0 ? parameters_[which_].upper : parameters_[which_].lower;
    const double step = sign_ * u * width_;
    return std::clamp(log_ ? centre * std::exp(step) : centre + step, parameters_[which_].lower,
                      parameters_[which_].upper);
  }

  ProfileEnd answer(double u, bool linear, bool cut_off) {
    std::sort(points_.begin(), points_.end(),
              [](const ProfilePoint& a, const ProfilePoint& b) { return a.value < b.value; });
    return {value(u), linear, cut_off, better_, points_};
  }

  // Problem with the parameter held at u half widths. The others start at the values of the linearised fit; where there is
  // none, at those of the last place inside the interval.
  std::vector<Variable> held_at(double u) const {
    std::vector<Variable> list = parameters_;
    const std::size_t n = list.size();
    const double moved = value(u) - fit_.estimates[which_].value;
    const double variance = fit_.covariance[which_ * n + which_];
    for (std::size_t i = 0; i < n; ++i) {
      Variable& v = list[i];
      const double follows = fit_.covariance[i * n + which_] / variance * moved;
      v.start = fit_.estimates[i].value + (std::isfinite(follows) ? follows : 0.0);
      if (!linear_ && !inside_.empty()) v.start = inside_[i];
      v.start = std::clamp(v.start, v.lower, v.upper);
      if (i == which_) v.start = value(u);
      if (i == which_ || fit_.estimates[i].at_bound) v.lower = v.upper = v.start;
    }
    return list;
  }

  // Infinite where nothing can be evaluated.
  double height(double u) {
    const LeastSquaresResult found = least_squares(held_at(u), residuals_, options_);
    if (found.estimates.empty()) return kInfinity;
    if (found.sum_of_squares < lowest_) {
      lowest_ = found.sum_of_squares;
      better_.clear();
      for (const Estimate& e : found.estimates) better_.push_back(e.value);
    }
    const double z = std::sqrt(std::max(found.sum_of_squares - fit_.sum_of_squares, 0.0)) /
                     fit_.estimates[which_].rise;
    add_point(found, z);
    if (z < 1.0) {
      inside_.clear();
      for (const Estimate& e : found.estimates) inside_.push_back(e.value);
    }
    return z;
  }

  // The others are at their optimum or held, so that the least sum of squares rises as the sum itself does, by 2 J^T r (L3.2).
  void add_point(const LeastSquaresResult& found, double z) {
    const double noise = 1e-3;  // below, z is the root of a rounding error
    if (!(z > noise)) return;
    std::vector<double> b;
    for (const Estimate& e : found.estimates) b.push_back(e.value);
    const Residuals here = residuals_(b);
    if (!here.failure.empty()) return;
    double slope = 0.0;
    for (std::size_t i = 0; i < here.values.size(); ++i)
      slope += here.values[i] * here.jacobian[i * b.size() + which_];
    const double rise = fit_.estimates[which_].rise;
    points_.push_back({b[which_], sign_ * z, sign_ * slope / (z * rise * rise)});
  }

  // Finds z = 1, where z rises from below 1 at `low` to 1 or more at `high`, by regula falsi; bisects if one end has
  // stayed twice.
  double root(double low, double high, double z_high) {
    double z_low = low;  // value of the linearised fit; only its sign matters in the end
    int same_end = 0;  // steps in a row that moved the same end: > 0 the low one, < 0 the high one
    for (int step = 0; step < kMostSearchSteps && high - low > kFound * high; ++step) {
      const bool secant = std::isfinite(z_high) && std::abs(same_end) < 2 && z_high > z_low;
      const double part = secant ? (1.0 - z_low) / (z_high - z_low) : 0.5;
      const double at = low + std::clamp(part, 0.02, 0.98) * (high - low);
      const double z = height(at);
      if (std::abs(z - 1.0) <= kFound) return at;
      if (z < 1.0) {
        low = at;
        z_low = z;
        same_end = std::max(same_end, 0) + 1;
      } else {
        high = at;
        z_high = z;
        same_end = std::min(same_end, 0) - 1;
      }
      if (options_.stop.stop_requested()) break;
    }
    return high;
  }

  const std::vector<Variable>& parameters_;
  const ResidualFunction& residuals_;
  const LeastSquaresOptions& options_;
  const LeastSquaresResult& fit_;
  std::size_t which_;
  double sign_;
  bool log_{false};
  bool linear_{false};  // the fit has a linearised interval
  double width_{0.0};   // half, of this interval, or the first step; in the scale of the parameter
  double farthest_{0.0};        // bound, in half widths
  double lowest_;               // least sum of squares found below that of the fit
  std::vector<double> better_;  // where
  std::vector<double> inside_;  // all parameters at the last place where z is below 1
  std::vector<ProfilePoint> points_;
};

}  // namespace

ProfileEnd profile_end(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
                       const LeastSquaresOptions& options, const LeastSquaresResult& fit,
                       std::size_t parameter, IntervalEnd end) {
  TWUM_ASSERT(parameter < fit.estimates.size() && !fit.estimates[parameter].at_bound &&
              fit.estimates[parameter].rise > 0.0);
  const ResidualFunction as_fitted = [&](auto b) {
    return softened(residuals(b), fit.bend, fit.share);
  };
  LeastSquaresOptions plain = options;
  plain.loss = Loss::squares;
  return Profile(parameters, as_fitted, plain, fit, parameter, end).find();
}

const char* to_string(IntervalEnd value) noexcept {
  switch (value) {
    case IntervalEnd::low: return "low";
    case IntervalEnd::high: return "high";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
