// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>

#include <vector>

namespace twum::studies {

/// The root z of the rise along a profile: a cubic between its points with their slopes (L3.2), straight beyond them.
/// Slopes beyond three times that of the chord are limited to it, so that the cubic does not overshoot (Fritsch and Carlson 1980).
double along_profile(const std::vector<optim::ProfilePoint>& profile, double value);

/// The value of a parameter at a part of its interval along its profile: -1 is the lower end, 0 the estimate, 1 the upper end. Along
/// a straight line, or its logarithm, where there is no profile.
double value_at_part(const CalibrateResult::Estimate& estimate, double part);

}  // namespace twum::studies
