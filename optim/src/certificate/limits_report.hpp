// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

namespace twum::inline v0_1::optim {

/// Every constraint limit, then the bounds with their multipliers, in user units.
std::vector<Activity> report_limits(const Problem& problem, const Scaling& scaling,
                                    const KktPoint& point, const Multipliers& multipliers);

}  // namespace twum::inline v0_1::optim
