// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curvature.hpp"

namespace twum::optim {

/// A certificate with its first-order data.
struct Certified {
  KktPoint point;
  Multipliers multipliers;
  Certificate certificate;
};

/// Reason in the certificate of a design that was not tested.
inline constexpr const char* kCutShort = "stopped before the test was done";

/// Certifies a design within a stage; its evaluations count. Tests of second order and for kinks are left out if the
/// stage's quota is too small for them. Nothing if the design cannot be evaluated. @throws Stop
std::optional<Certified> certify_in(Session& session, const Scaling& scaling,
                                    std::span<const double> design, bool second_order = true);

/// Largest number of evaluator calls for one certificate.
inline std::size_t certificate_cost(std::size_t free_variables) { return 4 * free_variables + 2; }

}  // namespace twum::optim
