// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

/// Integrals over the worn depth, of several numbers at once.
namespace twum::core {

using NumbersAt = std::function<std::vector<double>(double depth)>;

struct DepthIntegral {
  std::vector<double> sums;
  bool smooth;  ///< no panel was halved: Gauss' rule with ten points knows the first number to 1e-8
};
/// By Gauss-Kronrod rules with 10 and 21 nodes; the panels are halved until the first number is known to 1e-8, or four times.
DepthIntegral integral_over_depth(const NumbersAt& numbers, double from, double to);

/// By Gauss' rule with ten points, which are every second one of those above.
std::vector<double> ten_points_over_depth(const NumbersAt& numbers, double from, double to);

/// By Gauss' rule with three points.
std::vector<double> three_points_over_depth(const NumbersAt& numbers, double from, double to);

}  // namespace twum::core
