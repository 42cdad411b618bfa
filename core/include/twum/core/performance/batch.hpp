// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>

#include <span>
#include <vector>

namespace twum {

/// Metrics of many designs on several threads. Row i holds the metrics of design i in the order asked;
/// the numbers do not depend on `jobs`. Cost: that of evaluate() per design, shared by the threads.
///
/// @param jobs  threads; 0 takes one for each core.
/// @throws InputError naming the first design that is not admissible, before anything is computed.
std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs = 0);

}  // namespace twum
