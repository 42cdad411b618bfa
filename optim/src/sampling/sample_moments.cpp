// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/distributions.hpp>
#include <twum/optim/sample_moments.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::optim {

void Moments::add(double value) noexcept {
  const auto before = static_cast<double>(count_);
  const auto n = static_cast<double>(++count_);
  const double delta = value - mean_;
  const double step = delta / n;
  const double growth = delta * step * before;
  fourth_ +=
      growth * step * step * (n * n - 3 * n + 3) + 6 * step * step * second_ - 4 * step * third_;
  third_ += growth * step * (n - 2) - 3 * step * second_;
  second_ += growth;
  mean_ += step;
}

double Moments::mean() const noexcept {
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : mean_;
}

double Moments::sd() const noexcept {
  if (count_ < 2) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(second_ / static_cast<double>(count_ - 1));
}

IntervalEstimate Moments::mean_estimate(double confidence) const {
  if (count_ == 0) return {};
  if (count_ == 1) return {mean_, IntervalEstimate{}.low, IntervalEstimate{}.high};
  const auto n = static_cast<double>(count_);
  const double half = student_quantile(n - 1, (1 + confidence) / 2) * sd() / std::sqrt(n);
  return {mean_, mean_ - half, mean_ + half};
}

IntervalEstimate Moments::sd_estimate(double confidence) const {
  const double value = sd();
  const auto n = static_cast<double>(count_);
  const double z = normal_quantile((1 + confidence) / 2);
  // The correction n / (n - z) of small samples needs a few draws to make sense.
  if (count_ < 4 || n <= 2 * z) return {value, IntervalEstimate{}.low, IntervalEstimate{}.high};
  if (value == 0) return {0, 0, 0};
  const double kurtosis = n * fourth_ / (second_ * second_);
  const double correction = n / (n - z);
  // Standard error of the logarithm of the variance. max(): two values that occur equally often have a kurtosis of 1.
  const double error = correction * std::sqrt(std::max(0.0, kurtosis - (n - 3) / n) / (n - 1));
  const double centre = value * std::sqrt(correction);
  return {value, centre * std::exp(-z * error / 2), centre * std::exp(z * error / 2)};
}

}  // namespace twum::inline v0_1::optim
