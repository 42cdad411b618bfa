// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/telling.hpp>

#include <vector>

/// Curves and fields that a report shows; internal.
namespace twum::inline v0_1::studies {

/// The given parameters of a design, by flat name [SI].
Json design_json(const MotorDesign& design);

/// {"label", "design", "metrics", "columns": [{"name", "unit", "values": base64}, ...]} of one motor; of a whole curve also
/// "one_slice_torque", "fields" and "track", of others "last_speed".
Json curve_json(const telling::MotorCurve& curve);

/// Those of an answer at their places; null at others.
Json curves_json(const std::vector<telling::MotorCurve>& curves);

}  // namespace twum::inline v0_1::studies
