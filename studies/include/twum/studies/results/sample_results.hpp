// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::studies {
struct CurveResult {};
struct SweepResult {};
struct SensitivityResult {};
struct UncertaintyResult {};
}  // namespace twum::studies
