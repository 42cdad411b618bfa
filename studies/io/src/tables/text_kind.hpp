// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// The content of a file as UTF-8 with line feeds. What it was besides is added to `kinds`: UTF-16, an encoding of one byte
/// for each character, line ends of carriage returns alone.
/// @param name  of the file, for errors
/// @throws InputError for a spreadsheet or another file that is no text
std::string utf8_text(const std::string& name, std::string content,
                      std::vector<std::string>& kinds);

}  // namespace twum::inline v0_1::io
