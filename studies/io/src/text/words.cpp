// SPDX-License-Identifier: Apache-2.0
#include <twum/io/words.hpp>

#include "text/utf8.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kLongestWord = 48;  // longer words are not typing errors of known names

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::size_t trailing_blank(std::string_view text) {
  if (text.empty()) return 0;
  if (text.back() == ' ' || (text.back() >= '\t' && text.back() <= '\r')) return 1;
  if (text.ends_with("\xC2\xA0")) return 2;
  return text.ends_with("\xE2\x80\xAF") ? 3 : 0;
}

void append_escaped(std::string& out, unsigned char byte) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  out += "\\x";
  out += kDigits[byte >> 4U];
  out += kDigits[byte & 0xFU];
}

// The candidate that the word begins, if there is only one: by more than half, or by all before an underscore.
std::string_view only_beginning(std::string_view word,
                                std::span<const std::string_view> candidates) {
  std::string_view found;
  for (const std::string_view candidate : candidates) {
    if (!candidate.starts_with(word)) continue;
    const bool part = candidate.size() > word.size() && candidate[word.size()] == '_';
    if (!part && 2 * word.size() <= candidate.size()) continue;
    if (!found.empty()) return {};
    found = candidate;
  }
  return found;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int limit) {
  if (a.size() > kLongestWord || b.size() > kLongestWord) return limit + 1;
  const int longer = std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size()));
  if (longer > limit) return limit + 1;  // at least this many letters are missing
  std::array<std::array<int, kLongestWord + 1>, kLongestWord + 1> d;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  int least_before = 0;  // of the row above
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int least = d[i][0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      least = std::min(least, d[i][j]);
    }
    // Each row follows from the two above it, and no step makes a distance smaller.
    if (std::min(least, least_before) > limit) return limit + 1;
    least_before = least;
  }
  return std::min(d[a.size()][b.size()], limit + 1);
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  std::string_view best;
  int best_distance = 3;
  for (const std::string_view candidate : candidates) {
    if (same_but_for_case(word, candidate)) return candidate;
    const int distance = edit_distance(word, candidate, 2);
    const bool near =
        2 * static_cast<std::size_t>(distance) < std::max(word.size(), candidate.size());
    if (near && distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best.empty() ? only_beginning(word, candidates) : best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
  if (const auto best = nearest(word, candidates); !best.empty()) {
    return "did you mean '" + std::string(best) + "'?";
  }
  std::string text = "expected one of ";
  for (const std::string_view& candidate : candidates) {
    text += (&candidate == candidates.data() ? "" : ", ") + std::string(candidate);
  }
  return text;
}

std::size_t leading_blank(std::string_view text) {
  if (text.empty()) return 0;
  if (text[0] == ' ' || (text[0] >= '\t' && text[0] <= '\r')) return 1;
  if (text.starts_with("\xC2\xA0")) return 2;
  return text.starts_with("\xE2\x80\xAF") ? 3 : 0;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string_view trimmed(std::string_view text) {
  while (const std::size_t blank = leading_blank(text)) text.remove_prefix(blank);
  while (const std::size_t blank = trailing_blank(text)) text.remove_suffix(blank);
  return text;
}

namespace {

// Moves the first character of a text to the end of another one, a control character or a byte that is no UTF-8 as \xNN.
void move_printable(std::string_view& text, std::string& out) {
  const std::size_t length = utf8_length(text);
  const auto byte = static_cast<unsigned char>(text.front());
  const bool control = byte < 0x20 || byte == 0x7F;
  const bool control_beyond_ascii =
      length == 2 && byte == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0;
  const bool shown = length > 0 && !control && !control_beyond_ascii;
  if (shown)
    out.append(text, 0, length);
  else
    append_escaped(out, byte);
  text.remove_prefix(shown ? length : 1);
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  for (std::size_t shown = 0; !text.empty(); ++shown) {
    if (shown == limit) return out + "...";
    move_printable(text, out);
  }
  return out;
}

std::string printable_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    if (text.front() != '\n') {
      move_printable(text, out);
      continue;
    }
    out += '\n';
    text.remove_prefix(1);
  }
  return out;
}

std::string quoted(std::string_view text) { return "'" + printable(text) + "'"; }

std::vector<std::string_view> split_list(std::string_view text) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')' && depth > 0) --depth;
    if (text[i] == ',' && depth == 0) {
      pieces.push_back(trimmed(text.substr(begin, i - begin)));
      begin = i + 1;
    }
  }
  pieces.push_back(trimmed(text.substr(begin)));
  return pieces;
}

std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace twum::inline v0_1::io
