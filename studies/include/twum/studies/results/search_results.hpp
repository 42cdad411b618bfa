// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::studies {
struct OptimizeResult {};
struct ParetoResult {};
struct CalibrateResult {};
}  // namespace twum::studies
