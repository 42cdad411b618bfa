// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The parts of the page that are the same in every report; made at build time by
/// cmake/EmbedReport.cmake.
namespace twum::studies::assets {

std::string_view page();
std::string_view style();
std::string_view script();

}  // namespace twum::studies::assets
