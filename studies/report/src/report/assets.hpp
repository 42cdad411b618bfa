// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The parts of pages that are the same in all of them; made at build time by cmake/EmbedReport.cmake.
namespace twum::studies::assets {

std::string_view page();
std::string_view style();
std::string_view script();

/// The page of `twum explore`. A hash is the SHA-256 of the text of that name.
/// @{
std::string_view designer_page();
std::string_view designer_style();
std::string_view designer_style_hash();
std::string_view designer_script();
std::string_view designer_script_hash();
/// @}

/// The core as WebAssembly, compressed by gzip; empty in a build without it.
std::string_view core_module();

}  // namespace twum::studies::assets
