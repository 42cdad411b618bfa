// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::inline v0_1::studies {

/// A distribution of a quantity. Mean and standard deviation are those of the quantity itself (not of its logarithm), before it
/// is truncated at limits.
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

  /// Weibull from 0, with mean > 0 and sd from 1e-3 to 10 times it.
  static Distribution weibull(double mean, double sd);
  /// Beta over min < mean < max, with sd^2 < (mean - min) (max - mean).
  static Distribution beta(double mean, double sd, double min, double max);

  /// The distribution truncated to the limits.
  Distribution within(double min, double max) const;
  /// Share of the distribution that the limits cut off, 0 to 1.
  double cut_off() const noexcept { return 1 - (top_ - bottom_); }

  /// Share of the distribution below a value.
  double cdf(double x) const;
  /// The p-quantile, p in (0, 1); increases with p.
  double quantile(double p) const;
  /// A quantile by a standard normal number.
  struct OfNormal {
    double value;  ///< of the quantity
    double slope;  ///< its derivative with respect to z
  };
  /// The quantile of Phi(z), of a standard normal z, and its slope: smooth, and as accurate far out in both tails. |z| is cut off at
  /// 8.2, beyond which lies 1e-16.
  OfNormal of_normal(double z) const;
  /// The standard deviation, of what the limits leave.
  double sd() const;

 private:
  enum class Shape : std::uint8_t { normal, lognormal, uniform, triangular, weibull, beta };
  Distribution(Shape shape, double a, double b, double c = 0, double d = 0)
      : shape_(shape), a_(a), b_(b), c_(c), d_(d) {}
  double whole_cdf(double x) const;
  double whole_quantile(double p) const;
  OfNormal whole_of_normal(double z) const;
  double above(double x) const;

  Shape shape_;
  double a_;          // normal, lognormal: location; Weibull: scale; otherwise minimum
  double b_;          // normal, lognormal: scale; Weibull: exponent; otherwise maximum
  double c_;          // triangular: mode; beta: first exponent
  double d_;          // beta: second exponent
  double bottom_{0};  // probabilities below the limits
  double top_{1};
  double min_{0};
  double max_{0};
  bool limited_{false};
};

}  // namespace twum::inline v0_1::studies
