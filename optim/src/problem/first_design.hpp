// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/scaling.hpp"
#include "problem/session.hpp"

#include <optional>

namespace twum::inline v0_1::optim {

/// A design with its evaluation and Jacobian.
struct FirstDesign {
  std::vector<double> design;
  Evaluation evaluation;
};

/// The start design or, if it cannot be evaluated, the first of 1,024 low-discrepancy points that can. Nothing if none
/// can. @throws Stop
std::optional<FirstDesign> first_design(Session& session, const Scaling& scaling);

}  // namespace twum::inline v0_1::optim
