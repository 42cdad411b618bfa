// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curvature.hpp"

namespace twum::optim {

/// A certificate with the first-order data it was made from.
struct Certified {
  KktPoint point;
  Multipliers multipliers;
  Certificate certificate;
};

/// What the certificate of a design says that no test was made of.
inline constexpr const char* kCutShort = "stopped before the test was done";

/// Certifies a design within a stage; its evaluations count. Tests of second order and for kinks
/// are left out when the stage's quota has no room for them. Nothing if the design cannot be
/// evaluated. @throws Stop
std::optional<Certified> certify_in(Session& session, const Scaling& scaling,
                                    std::span<const double> design, bool second_order = true);

/// Evaluator calls that one certificate may need.
inline std::size_t certificate_cost(std::size_t free_variables) { return 4 * free_variables + 2; }

}  // namespace twum::optim
