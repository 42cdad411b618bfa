// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <string>

/// Parts of a presentation as HTML; internal.
namespace twum::inline v0_1::studies::telling {

/// A text without markup.
std::string harmless(const std::string& text);

/// A chart as SVG with its key below. Text and axes have the colour of the page, so that they can be read in light and dark.
/// @param width  [pixels]
std::string html(const Chart& chart, double width);

}  // namespace twum::inline v0_1::studies::telling
