// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/telling.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What is said of limits and designs by searches and fronts; internal.
namespace twum::inline v0_1::studies::telling {

/// The value of a goal at a design; NaN if it has none.
double goal_of(const DesignReport& report, const Goal& goal);

/// The quantity that a limit limits, such as "max_pressure"; of one that the search adds, its text.
std::string limited_by(const std::string& text);

/// "preload ≤ 300 N"
Phrase end_phrase(const std::string& name, bool at_least, double limit, const std::string& unit);

/// What moving a limit by 1 % brings for these goals.
/// @param standing  one that binds; see standings_json()
Phrase holder_phrase(const Json& standing, const std::vector<Goal>& goals,
                     const DesignReport& report);

/// What holds a design, one phrase each, the most valuable first: limits, and whole numbers at an end of their range.
std::vector<Phrase> holder_phrases(const Json& standings, const std::vector<Goal>& goals,
                                   const DesignReport& report,
                                   const std::vector<BoundState>& whole_ends,
                                   const Sources& sources);

/// "broken by 20 mN.m"
Phrase state_phrase(const Json& standing);

/// What each limit is doing, and what loosening it by 1 % changes.
Table limits_table(const Json& standings, const std::vector<Goal>& goals);
/// What the effects of limits are changes of: the goal, or where the required yield cannot be reached, the yield, which the search
/// made as large as it can be.
Goal priced_goal(const OptimizeResult& answer);

/// The range of a variable of the study; nothing for others.
std::optional<std::pair<double, double>> range_of(const Sources& sources, const std::string& name);

/// Whole numbers of a design that are at an end of their range.
std::vector<BoundState> whole_ends_of(const DesignReport& report, const Sources& sources);

/// Designs side by side: what was chosen, parameters, and their ranges.
Table design_table(const std::string& name, const std::string& title, const DesignReport& report,
                   const std::vector<NamedValue>& before, const Sources& sources);

/// Metrics side by side.
Table metrics_table(const std::string& name, const std::string& title, const DesignReport& report,
                    const std::vector<NamedValue>& before);

/// Integer variables and choices, which the certificate and each run of a solver hold fixed.
std::vector<Part> held_parts(const DesignReport& report);

/// What the word "optimal" rests on.
Phrase certificate_phrase(const DesignReport& report, const std::string& goal_unit);

/// What could be loosened where no design keeps every limit; none if there is nothing.
std::vector<Section> relaxation_sections(const Explanation& explanation);

/// Which of the stored rows keep every limit whose metric is among their columns.
std::vector<bool> rows_that_keep(const ResultStore& rows, const Json& standings);

}  // namespace twum::inline v0_1::studies::telling
