// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>

#include <span>
#include <vector>

namespace twum {

/// Metrics of many designs on several threads. Row i holds the metrics of design i in the order asked,
/// bit for bit those of evaluate(), whatever `jobs` is. Cost: that of evaluate() per design, shared by
/// the threads, and 16 bytes a metric.
///
/// @param jobs  threads; 0 takes one for each core.
/// @throws InputError naming the first design that is not admissible, before anything is computed.
std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs = 0);

/// Metrics with exact derivatives (SI) of many designs on several threads. Row i holds those of design
/// i in the order asked, bit for bit those of differentiate(), whatever `jobs` is. Each says by its
/// Smoothness what its derivatives are good for. Cost: that of differentiate() per design, shared by the
/// threads, and 168 bytes a metric.
///
/// @param fixed_static_friction  as of differentiate(): holds mu_0 while mu moves
/// @param jobs                   threads; 0 takes one for each core.
/// @throws InputError naming the first design that is not admissible, before anything is computed.
std::vector<std::vector<MetricDerivative>> differentiate_designs(
    std::span<const MotorDesign> designs, std::span<const MetricRequest> requests,
    bool fixed_static_friction = false, unsigned jobs = 0);

}  // namespace twum
