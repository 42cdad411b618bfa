// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scaling.hpp"
#include "session.hpp"

#include <optional>

namespace twum::optim {

/// Scales the responses at the start design. If it cannot be evaluated, takes the first design of a low-discrepancy
/// sequence that can. Returns that design; nothing if none can be evaluated. @throws Stop
std::optional<std::vector<double>> scale_at_first_design(Session& session, Scaling& scaling);

}  // namespace twum::optim
