// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace twum::test {

/// A derivative by differences, with its own idea of how good it is.
struct DifferenceQuotient {
  double value{std::numeric_limits<double>::quiet_NaN()};
  double error{std::numeric_limits<double>::infinity()};
};

/// Several functions of one variable, evaluated together.
using Functions = std::function<std::vector<double>(double)>;

/// df/dx of each function by central differences with Richardson extrapolation (Ridders' scheme: steps
/// shrink, the entry of the triangle whose neighbours agree best is kept). Several first steps are
/// tried. The error is the disagreement of the neighbours; a kink within reach makes it large, and noise
/// of f shows in it too.
/// @param scale  a change of x over which the functions change smoothly, usually |x|
std::vector<DifferenceQuotient> central_differences(const Functions& functions, double x,
                                                    double scale);

/// The same from one side: `side` is +1 or -1.
std::vector<DifferenceQuotient> one_sided_differences(const Functions& functions, double x,
                                                      double scale, int side);

}  // namespace twum::test
