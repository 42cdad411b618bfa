// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/certify.hpp"

namespace twum::inline v0_1::optim {

/// Makes a few Newton steps on the optimality conditions with the active limits. Improves a nearly optimal design to
/// machine precision. Returns the better design, or nothing if no step improved it. With several objectives, their sum
/// with these weights, scaled as in the search, is minimized. @throws Stop
std::optional<std::vector<double>> polish(Session& session, const Scaling& search,
                                          std::span<const double> design,
                                          const std::vector<double>& weights = {1.0});

}  // namespace twum::inline v0_1::optim
