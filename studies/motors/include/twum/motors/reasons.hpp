// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/metrics.hpp>

#include <span>

namespace twum::inline v0_1::motors {

/// A reason for a missing answer, and what it means.
struct Reason {
  MetricStatus status;  ///< never ok; to_string() gives the word in tables
  const char*
      meaning;  ///< a clause without a full stop, such as "the motor cannot carry this load"
};

/// Every reason, in the order of MetricStatus. Terminal, page and guide use the same words. Static lifetime.
std::span<const Reason> reasons();

}  // namespace twum::inline v0_1::motors
