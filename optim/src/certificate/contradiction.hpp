// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

#include <functional>
#include <string>

namespace twum::inline v0_1::optim {

/// Says which response that matters has values that contradict its Jacobian along a line through a design; empty if none has
/// (O5.1, O5.2).
/// The line leads away from every bound and changes all free variables, each by a ten-thousandth of its size. Two values
/// are enough where both agree. A difference counts if gradients on the line and a line ten times as long confirm it,
/// which costs four evaluations more. @throws Stop
std::string contradiction(Session& session, const Scaling& scaling, const KktPoint& point,
                          const std::function<bool(std::size_t response)>& matters);

}  // namespace twum::inline v0_1::optim
