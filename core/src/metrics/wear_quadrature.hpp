// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

/// Integrals over the worn depth, of several numbers at once.
namespace twum::inline v0_1::core {

using NumbersAt = std::function<std::vector<double>(double depth)>;

struct DepthIntegral {
  std::vector<double> sums;
  bool smooth;  ///< no panel was halved: Gauss' rule with ten points knows the first number to 1e-8
};
/// By Gauss-Kronrod rules with 10 and 21 nodes; the panels are halved until the first number is known to 1e-8, or four times.
DepthIntegral integral_over_depth(const NumbersAt& numbers, double from, double to);

/// By Gauss' rule with ten points, which are every second one of those above.
std::vector<double> ten_points_over_depth(const NumbersAt& numbers, double from, double to);

/// Integrals from 0 to any depth of numbers that are smooth along the way: those of the polynomial through the 21 nodes of the rule.
class SmoothDepthIntegral {
 public:
  /// Nothing if the rule does not know the first number to 1e-8 without a panel that is halved.
  static std::optional<SmoothDepthIntegral> of(const NumbersAt& numbers, double to);

  std::vector<double> up_to(double depth) const;

 private:
  explicit SmoothDepthIntegral(double to) : to_(to) {}
  std::vector<double> at(double depth) const;

  double to_;
  std::vector<double> depths_, weights_;  // of the barycentric formula
  std::vector<std::vector<double>> numbers_;
};

/// By Gauss' rule with three points.
std::vector<double> three_points_over_depth(const NumbersAt& numbers, double from, double to);

}  // namespace twum::inline v0_1::core
