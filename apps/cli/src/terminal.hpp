// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace twum::inline v0_1::cli {

/// Width of the terminal of a file descriptor in characters: nothing if it is not a terminal, 80 if the width is
/// unknown.
std::optional<std::size_t> terminal_width(int descriptor);

/// Whether the terminal supports plain lines only: TERM is "dumb" or missing.
bool dumb_terminal();

}  // namespace twum::inline v0_1::cli
