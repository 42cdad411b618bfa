// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace twum::inline v0_1::io {

/// Bytes of the well-formed UTF-8 character at the front of a text, 0 if there is none.
std::size_t utf8_length(std::string_view text);

/// Byte at which a character of a text begins, both counted from 0; the length of the text beyond its end.
std::size_t byte_of(std::string_view text, int character);

/// One of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace twum::inline v0_1::io
