// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::studies {

/// The value a part `t` in [0, 1] of the way from min to max, evenly or in the logarithm; exactly min
/// and max at the ends, never outside. SI.
double between(double min, double max, double t, bool log);

}  // namespace twum::studies
