// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/telling.hpp>

#include <string>
#include <vector>

/// The renderers of a presentation; internal. Pictures have theirs in the program.
namespace twum::studies::telling {

/// Headings, sentences a line each, and aligned tables, with names as one types them; charts are left out.
std::string terminal_text(const Headline& headline);
std::string terminal_text(const std::vector<Section>& sections);

/// Headings, sentences and tables; charts are left out.
/// @{
std::string markdown(const Phrase& phrase);
std::string markdown(const Headline& headline);
std::string markdown(const std::vector<Section>& sections);
/// @}

/// What studies/page/telling.js draws.
Json headline_json(const Headline& headline);
/// Of each point of a front its goals and its yields, in words; null of other answers.
Json points_json(const Answer& answer);
Json sections_json(const std::vector<Section>& sections);

}  // namespace twum::studies::telling
