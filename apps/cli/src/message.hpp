// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace twum::inline v0_1::cli {

/// Prints a line, or several, to the standard error. Control characters, which names of files may contain and terminals obey,
/// are shown as \xNN.
void say(std::string_view text);

/// The same, with the lines that hold a caret in red.
void say_with_red_carets(std::string_view text);

}  // namespace twum::inline v0_1::cli
