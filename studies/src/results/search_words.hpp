// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/optimize_result.hpp>

#include <string>
#include <vector>

/// Common parts of the answers of optimize, size and pareto; internal.
namespace twum::inline v0_1::studies {

Json values_json(const std::vector<NamedValue>& values);
/// Units of everything that values_json() was given.
void add_units(Json& units, const std::vector<NamedValue>& values);
Json goal_json(const Goal& goal);
/// {lining: "peek.yaml"}
Json choice_json(const std::vector<ChosenSet>& choice);
/// {constraints, bounds, certificate}
Json limits_json(const DesignReport& report);
/// {choice, design, metrics, constraints, bounds, certificate}; `choice` only where there is one
Json report_json(const DesignReport& report);
/// {conflict, limits: [{text, limit, amount, amount_alone}], impossible: [{text, limit, best, certified, ends}],
/// ranges: [{variable, side, limit, limit_alone}]}; `ends` are positions in `ranges`.
Json relaxation_json(const Explanation& explanation);

/// "lining peek.yaml and rotor light.yaml"
std::string choice_words(const std::vector<ChosenSet>& choice);
/// "a, b and c"
std::string enumeration(const std::vector<std::string>& names);
/// The value of a name; NaN if it is not there.
double value_of(const std::vector<NamedValue>& values, const std::string& name);
/// The value of a goal at a design; NaN if it has none.
double goal_value(const DesignReport& report, const Goal& goal);

}  // namespace twum::inline v0_1::studies
