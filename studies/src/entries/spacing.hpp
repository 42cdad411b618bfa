// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::inline v0_1::studies {

/// Interpolates from min to max on a linear or logarithmic scale; t in [0, 1]. Exactly min and max at the ends, never
/// outside. SI.
double between(double min, double max, double t, optim::Scale scale);

}  // namespace twum::inline v0_1::studies
