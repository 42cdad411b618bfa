// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/telling.hpp>

#include <string>
#include <vector>

/// The renderers of a presentation; internal. Pictures have theirs in the program.
namespace twum::inline v0_1::studies::telling {

/// Nothing in it can be written.
bool is_picture(const Section& section);

/// Headings, sentences a line each, and aligned tables, with names as one types them; charts are left out.
std::string terminal_text(const Headline& headline);
std::string terminal_text(const std::vector<Section>& sections);
/// One table with all of its rows. Width 0: as it is.
std::string terminal_text(const Table& table, std::size_t width);

/// Headings, sentences and tables; charts are left out.
/// @{
std::string markdown(const Phrase& phrase);
std::string markdown(const Table& table);
std::string markdown(const Headline& headline);
std::string markdown(const std::vector<Section>& sections);
/// @}

/// The same as HTML without colours and fonts, as a cell of a notebook shows it. A data sheet adds its style.
/// @{
std::string html(const Phrase& phrase);
std::string html(const Table& table);
std::string html(const Headline& headline);
/// @param heading  its element
/// @param several  width of each of several charts [pixels]
std::string html(const std::vector<Section>& sections, const std::string& heading = "h4",
                 double several = 460);
/// @}

/// What studies/page/telling.js draws.
Json headline_json(const Headline& headline);
/// Of each point of a front what it is, and what is said of it when it is chosen; null of other answers.
Json points_json(const Answer& answer, const Sources& sources);
Json sections_json(const std::vector<Section>& sections);
Json charts_json(const std::vector<Chart>& charts);

/// The whole answer as Markdown, and as HTML.
/// @{
std::string summary_markdown(const StudyResult& result, const Sources& sources);
std::string summary_html(const StudyResult& result, const Sources& sources);
/// @}

}  // namespace twum::inline v0_1::studies::telling
