// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// How many products break a set of limits, and which inputs cause it: sums over 16 independent samples of the same size, plain or
/// weighted products.
class FailureShares {
 public:
  /// Independent samples; product i belongs to sample i mod 16.
  static constexpr std::size_t kSamples = 16;

  /// Of so many random inputs.
  explicit FailureShares(std::size_t inputs);

  /// A product that keeps the limits.
  void add(std::uint64_t index);
  /// A product that breaks one of them.
  /// @param weight  density of plain products over that of the drawn ones, N w of U4.2; 1 for plain products
  /// @param parts   of its inputs in |z|^2, U1.10
  void add_failing(std::uint64_t index, double weight, std::span<const double> parts);

  /// Products that break a limit, unweighted.
  std::uint64_t failing() const noexcept { return failing_; }
  /// Share of products that break a limit, U8.2, with Student's interval. Where none was drawn, the upper end is that of U8.3.
  IntervalEstimate share(double confidence) const;
  /// Share of each input in the failures, U8.4; the sum is 1. NaN with fewer than two samples that have failures.
  std::vector<IntervalEstimate> causes(double confidence) const;
  /// Change of the share of products that keep the limits if the spread of an input is 1 % smaller, U6.6, valid where its law is
  /// normal.
  IntervalEstimate tighter(std::size_t input, double confidence) const;

 private:
  struct Sums {
    double products{0};
    double weight{0};            // of the failing ones
    std::vector<double> scores;  // of the failing ones: weight times (part - 1) for each input
  };

  std::array<Sums, kSamples> samples_;
  std::uint64_t failing_{0};
};

}  // namespace twum::inline v0_1::optim
