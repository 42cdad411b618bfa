// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/measured_fit.hpp"

#include <twum/studies/results/calibrate_result.hpp>

#include <vector>

namespace twum::studies {

/// How the estimates move with each parameter of the motor that the study holds fixed and that what was measured depends on.
std::vector<CalibrateResult::Move> moves_of(const MeasuredFit& fit,
                                            const optim::LeastSquaresResult& best);

}  // namespace twum::studies
