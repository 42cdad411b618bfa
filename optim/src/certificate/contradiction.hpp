// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

#include <functional>
#include <optional>

namespace twum::optim {

/// The first response that matters whose values contradict its Jacobian along a line through a design, or nothing (O5.1, O5.2).
/// The line leads away from every bound and changes all free variables, each by a ten-thousandth of its size. Two values
/// are enough where both agree. A difference counts if gradients on the line and a line ten times as long confirm it,
/// which costs four evaluations more. @throws Stop
std::optional<std::size_t> contradicted_response(
    Session& session, const Scaling& scaling, const KktPoint& point,
    const std::function<bool(std::size_t response)>& matters);

}  // namespace twum::optim
