// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// A place in a text; line and column count from 1 in characters, as in editors.
struct SourceMark {
  int line{1};    ///< from the top
  int column{1};  ///< from the left
};

/// A text with a name, to which errors can refer by line and column.
class Source {
 public:
  /// @param name  its name in errors, such as its path
  /// @param text  all of it, UTF-8
  Source(std::string name, std::string text);

  /// Name in errors.
  const std::string& name() const noexcept { return name_; }
  /// All of it.
  const std::string& text() const noexcept { return text_; }

  /// One line without its end, counted from 1; empty beyond the text.
  std::string_view line(int number) const;
  /// The mark of a place given by line and byte, both counted from 0.
  SourceMark mark(int line, int byte) const;
  /// The mark of a byte of a value, counted from 0. The value begins at `begin`, possibly in quotes. If its text
  /// differs from that of the file, as for a value over several lines, returns `begin`.
  SourceMark mark_within(SourceMark begin, std::string_view value, std::size_t byte) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> line_begins_;
};

/// Size limit of files that are read into memory as a whole [bytes].
inline constexpr std::size_t kLargestFile = std::size_t{4} << 20U;

/// Reads a whole file; "-" is standard input.
/// @throws InputError if it cannot be read or is larger than kLargestFile.
Source read_source(const std::string& path);

}  // namespace twum::inline v0_1::io
