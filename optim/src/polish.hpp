// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certify.hpp"

namespace twum::optim {

/// A few Newton steps on the optimality conditions of the limits that hold the objective back.
/// Brings a design that is nearly optimal to machine precision; leaves any other as it is.
/// Returns the better design, or nothing if no step improved. With several objectives their scaled
/// sum with these weights is meant. @throws Stop
std::optional<std::vector<double>> polish(Session& session, const Scaling& scaling,
                                          std::span<const double> design,
                                          const std::vector<double>& weights = {1.0});

}  // namespace twum::optim
