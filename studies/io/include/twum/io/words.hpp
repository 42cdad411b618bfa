// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// Number of insertions, deletions, replacements and swaps of neighbours between two words, or limit + 1 if there are
/// more than `limit`. Cost: the product of their lengths.
int edit_distance(std::string_view a, std::string_view b, int limit);

/// The candidate nearest to a word: at edit distance <= 2 and less than half its length, or different in case only.
/// Otherwise the only candidate that begins with the word and is less than twice as long. Empty if there is none.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "did you mean 'x'?" or, where nothing is near, "expected one of a, b, c".
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// Length in bytes of a blank at the beginning of the text: ASCII, U+00A0 or U+202F; 0 if there is none.
std::size_t leading_blank(std::string_view text);

/// The text without blanks at its ends (no-break spaces included); a view into it.
std::string_view trimmed(std::string_view text);

/// The text with its ASCII capitals as small letters.
std::string in_small_letters(std::string_view text);

/// A user's text made safe to print: control characters as \\xNN, at most `limit` characters.
std::string printable(std::string_view text, std::size_t limit = 60);

/// The same for a text of several lines, whole.
std::string printable_lines(std::string_view text);

/// printable() between single quotes.
std::string quoted(std::string_view text);
/// Overloads without which argument-dependent lookup would prefer std::quoted().
/// @{
inline std::string quoted(const std::string& text) { return quoted(std::string_view(text)); }
inline std::string quoted(const char* text) { return quoted(std::string_view(text)); }
/// @}

/// "1 row", "2 rows"
std::string counted(std::uint64_t count, std::string_view what);

/// Splits a text at commas outside parentheses and removes blanks at the ends of the pieces; views into the text.
std::vector<std::string_view> split_list(std::string_view text);

}  // namespace twum::inline v0_1::io
