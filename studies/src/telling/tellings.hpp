// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/move.hpp>
#include <twum/studies/telling.hpp>

#include <vector>

/// The parts of a presentation, by kind of answer; internal.
namespace twum::inline v0_1::studies::telling {

/// Look and sentences of a headline, by kind of answer.
/// @{
Headline headline_of(const CurveResult& answer, const StudyResult& result);
Headline headline_of(const SweepResult& answer, const StudyResult& result);
Headline headline_of(const SensitivityResult& answer, const StudyResult& result);
Headline headline_of(const OptimizeResult& answer, const StudyResult& result);
Headline headline_of(const ParetoResult& answer, const StudyResult& result);
Headline headline_of(const UncertaintyResult& answer, const StudyResult& result);
Headline headline_of(const CalibrateResult& answer, const StudyResult& result);
Headline headline_of(const FrequencyResult& answer, const StudyResult& result);
Headline headline_of(const MapResult& answer, const StudyResult& result);
Headline headline_of(const HeatResult& answer, const StudyResult& result);
Headline headline_of(const LifeResult& answer, const StudyResult& result);
Headline headline_of(const MotionResult& answer, const StudyResult& result);
/// @}

/// The headline where no design keeps every limit: what is at fault, and the least that would make it possible.
Headline relaxation_headline(const Explanation& explanation);

/// "peak power 20 W with wear intensity at 80 rpm 6.4 kW/m²": a point of a front by its goals.
Phrase point_phrase(const ParetoResult& answer, std::size_t point);

/// What is said of a point of a front that one has chosen.
std::vector<Section> point_sections(const ParetoResult& answer, std::size_t point,
                                    const Sources& sources);

/// "amplitude 1.6 µm, preload 160 N"
Phrase design_phrase(const SweepResult& answer, const SweepResult::Design& design);

/// The shares of a variable as they are told: where no interactions are seen beyond their interval, the first and the total index
/// are one number, the one that is known better.
SobolShares told_shares(const SobolShares& shares);

/// What is said below the headline, by kind of answer.
/// @{
std::vector<Section> sections_of(const CurveResult& answer, const Sources& sources);
std::vector<Section> sections_of(const SweepResult& answer, const Sources& sources);
std::vector<Section> sections_of(const SensitivityResult& answer, const Sources& sources);
std::vector<Section> sections_of(const OptimizeResult& answer, const Sources& sources);
std::vector<Section> sections_of(const ParetoResult& answer, const Sources& sources);
std::vector<Section> sections_of(const UncertaintyResult& answer, const Sources& sources);
std::vector<Section> sections_of(const CalibrateResult& answer, const Sources& sources);
std::vector<Section> sections_of(const FrequencyResult& answer, const Sources& sources);
std::vector<Section> sections_of(const MapResult& answer, const Sources& sources);
std::vector<Section> sections_of(const HeatResult& answer, const Sources& sources);
std::vector<Section> sections_of(const LifeResult& answer, const Sources& sources);
std::vector<Section> sections_of(const MotionResult& answer, const Sources& sources);
/// @}

/// Why the contact efficiency is above the efficiency, where both are among the metrics; empty otherwise.
Phrase efficiency_note(const std::vector<NamedValue>& metrics);

/// How an answer changes with parameters that its study holds fixed, those that count first; none if none counts.
/// @param answer   the numbers that move, in the order of the slopes
/// @param goal     one of them that is no parameter, if there is one
/// @param missing  why nothing is known; empty if it is
/// @param touching  radii that are left out, each with the one that it touches
std::vector<Section> moves_sections(
    const std::vector<NamedValue>& answer, const std::vector<Move>& moves, const std::string& goal,
    const std::string& missing, const Sources& sources,
    const std::vector<std::pair<std::string, std::string>>& touching = {});

/// How many of the motors keep the limits, or that the wanted share cannot be reached.
Phrase yield_phrase(const RobustYield& yield);
/// From which table of measured parts the motors are; empty if there is none.
std::vector<Phrase> parts_sentence(const std::string& table, std::uint64_t count);
/// The sentence of a headline: the first yield, or the largest where the wanted one cannot be reached.
Phrase robust_sentence(const RobustReport& report);
/// What tolerances do to a search.
std::vector<Section> robust_sections(const RobustReport& report, const Goal& goal);

}  // namespace twum::inline v0_1::studies::telling
