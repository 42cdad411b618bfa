// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

/// Integrals over the worn depth, of several numbers at once.
namespace twum::core {

using NumbersAt = std::function<std::vector<double>(double depth)>;

/// By Gauss-Kronrod rules with 10 and 21 nodes; the panels are halved until the first number is known to 1e-8, or four times.
std::vector<double> integral_over_depth(const NumbersAt& numbers, double from, double to);

/// By Gauss' rule with three points.
std::vector<double> three_points_over_depth(const NumbersAt& numbers, double from, double to);

}  // namespace twum::core
