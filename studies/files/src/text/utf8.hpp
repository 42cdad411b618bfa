// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace twum::studies {

/// Bytes of the well-formed UTF-8 character at the front of a text, 0 if there is none.
std::size_t utf8_length(std::string_view text);

/// One of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace twum::studies
