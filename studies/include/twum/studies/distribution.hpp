// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::studies {

/// A distribution of a quantity with admissible limits. Mean and standard deviation are those of the quantity itself
/// (not of its logarithm), before it is truncated at the limits.
class Distribution {
 public:
  /// Normal with sd > 0.
  static Distribution normal(double mean, double sd);
  /// Lognormal with mean > 0 and sd > 0.
  static Distribution lognormal(double mean, double sd);
  /// Uniform over min < max.
  static Distribution uniform(double min, double max);
  /// Triangular over min < max with its peak at min <= mode <= max.
  static Distribution triangular(double min, double mode, double max);

  /// The distribution truncated to the limits.
  Distribution within(double min, double max) const;
  /// Share of the distribution that the limits cut off, 0 to 1.
  double cut_off() const noexcept { return 1 - (top_ - bottom_); }

  /// The p-quantile, p in (0, 1); increases with p.
  double quantile(double p) const;

 private:
  enum class Shape : std::uint8_t { normal, lognormal, uniform, triangular };
  Distribution(Shape shape, double a, double b, double c = 0)
      : shape_(shape), a_(a), b_(b), c_(c) {}
  double whole_cdf(double x) const;
  double whole_quantile(double p) const;

  Shape shape_;
  double a_;          // normal, lognormal: location; otherwise minimum
  double b_;          // normal, lognormal: scale; otherwise maximum
  double c_;          // triangular: mode
  double bottom_{0};  // probabilities below the limits
  double top_{1};
  double min_{0};
  double max_{0};
  bool limited_{false};
};

}  // namespace twum::studies
