// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/study_result.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

/// Parts of summary.json for each kind of answer; internal.
namespace twum::inline v0_1::studies {

using Json = nlohmann::ordered_json;

/// A number, or null where there is none.
inline Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// {torque, speed}, or null.
Json load_json(const std::optional<LoadPoint>& load);

/// The content of summary.json.
Json summary_value(const StudyResult& result);

/// Entries of an answer in summary.json, in their order.
Json answer_json(const CurveResult& result);
Json answer_json(const FrequencyResult& result);
Json answer_json(const MapResult& result);
Json answer_json(const HeatResult& result);
Json answer_json(const LifeResult& result);
Json answer_json(const MotionResult& result);
Json answer_json(const SweepResult& result);
Json answer_json(const SensitivityResult& result);
Json answer_json(const OptimizeResult& result);
Json answer_json(const ParetoResult& result);
Json answer_json(const UncertaintyResult& result);
Json answer_json(const CalibrateResult& result);

}  // namespace twum::inline v0_1::studies
