// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/first_design.hpp"

namespace twum::inline v0_1::optim {

/// Whether values and gradients at some designs agree with a convex problem: the tangent of the objective at each
/// design lies below its values at all others (above, if it is maximized), and that of each limit on its side. In a
/// convex problem every local optimum is the global one.
bool agree_with_convexity(const Problem& problem, const std::vector<FirstDesign>& seen);

}  // namespace twum::inline v0_1::optim
