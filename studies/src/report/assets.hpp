// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The parts of pages that are the same in all of them; made at build time by cmake/EmbedReport.cmake.
namespace twum::inline v0_1::studies::assets {

/// Templates: of a report, of `twum explore`, and of a data sheet with its style.
/// @{
std::string_view page();
std::string_view designer_page();
std::string_view datasheet_page();
/// @}

/// Styles of both, and scripts of each, with the SHA-256 of the text.
/// @{
std::string_view style();
std::string_view style_hash();
std::string_view script();
std::string_view script_hash();
std::string_view designer_script();
std::string_view designer_script_hash();
/// @}

/// The core as WebAssembly, compressed by gzip; empty in a build without it.
std::string_view core_module();

}  // namespace twum::inline v0_1::studies::assets
