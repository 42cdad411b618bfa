// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/curvature.hpp"

namespace twum::inline v0_1::optim {

/// A certificate with its first-order data.
struct Certified {
  KktPoint point;
  Multipliers multipliers;
  Certificate certificate;
  /// a better design that a probe found, or nothing
  std::optional<std::vector<double>> better{};
};

/// Reason in the certificate of a design that was not tested.
inline constexpr const char* kCutShort = "stopped before the test was done";

/// Certifies a design within a stage; its evaluations count. Tests of second order and for kinks are left out if the
/// stage's quota is too small for them. Of the scaling of the search only the factors of several objectives count. Nothing if the design cannot be evaluated. @throws Stop
std::optional<Certified> certify_in(Session& session, const Scaling& search,
                                    std::span<const double> design, bool second_order = true);

/// Largest number of evaluator calls for one certificate: curvature, kinks, probes and differences.
inline std::size_t certificate_cost(std::size_t free_variables) { return 6 * free_variables + 36; }

}  // namespace twum::inline v0_1::optim
