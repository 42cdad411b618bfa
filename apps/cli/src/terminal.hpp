// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace twum::cli {

/// Columns of the terminal that a file descriptor is; nothing if it is none, 80 if it does not say.
std::optional<std::size_t> terminal_width(int descriptor);

/// Whether the terminal only takes plain lines: TERM is "dumb", or missing.
bool dumb_terminal();

}  // namespace twum::cli
