// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/study_kind.hpp"
#include "kinds/torque_fit.hpp"

#include <twum/optim/least_squares.hpp>

#include <vector>

namespace twum::studies {

/// What local fits from several starts say together: the best of them (of equals the first) with its
/// statistics, the other places where starts ended, and whether the best one fits.
KindAnswer calibration(const TorqueFit& fit, const std::vector<optim::LeastSquaresResult>& fits,
                       double confidence);

}  // namespace twum::studies
