// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scaling.hpp"
#include "session.hpp"

#include <optional>

namespace twum::optim {

/// Scales the responses at the start or, where it cannot be evaluated, at the first of some low-discrepancy
/// designs that can. Returns that design; nothing if none can be evaluated. @throws Stop
std::optional<std::vector<double>> scale_at_first_design(Session& session, Scaling& scaling);

}  // namespace twum::optim
