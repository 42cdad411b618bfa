// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>

namespace twum::studies {

/// A metric of a motor at kReachable times its largest torque, a load that moves with the design, and
/// its total derivative. This goes on where the metric at a fixed load ends: a solver that has left
/// the motors that carry the load sees finite numbers there. The status stays `unreachable` if there
/// is no torque at all.
MetricDerivative out_of_reach(const Motor& motor, Metric metric, bool gradient,
                              bool fixed_static_friction);

}  // namespace twum::studies
