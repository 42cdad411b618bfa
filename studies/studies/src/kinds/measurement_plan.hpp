// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/measured_fit.hpp"

#include <twum/studies/results/calibrate_result.hpp>

#include <vector>

namespace twum::studies {

/// The measurements that would shrink the region of the estimates most, each after the ones before it (L6.1, L6.2): of the
/// kinds that were measured, with their scatter, at other speeds or torques and under other settings of preload and voltage.
/// Empty where the scatter is not known.
std::vector<CalibrateResult::Planned> measurement_plan(const MeasuredFit& fit,
                                                       const optim::LeastSquaresResult& best);

}  // namespace twum::studies
