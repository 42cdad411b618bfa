// SPDX-License-Identifier: Apache-2.0
#include <twum/io/diagnostics.hpp>

#include "text/utf8.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <tuple>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kMostShown = 100;  // of the errors of one file

std::string place(const Source& source, SourceMark mark) {
  return printable(source.name(), 4096) + ":" + std::to_string(mark.line) + ":" +
         std::to_string(mark.column) + ": ";
}

// The line with a caret below the column; of a long line, the part around the column.
std::string excerpt(const Source& source, SourceMark mark) {
  constexpr int kBefore = 60;
  constexpr std::size_t kWidth = 100;
  std::string_view line = source.line(mark.line);
  int caret = mark.column - 1;
  if (caret > kBefore + 20) {
    line.remove_prefix(byte_of(line, caret - kBefore));
    caret = kBefore;
  }
  std::string shown(line);
  std::replace(shown.begin(), shown.end(), '\t', ' ');
  const std::string number = std::to_string(mark.line);
  const std::string margin(number.size() < 5 ? 5 - number.size() : 0, ' ');
  return margin + number + " | " + printable(shown, kWidth) + "\n" +
         std::string(margin.size() + number.size(), ' ') + " | " +
         std::string(static_cast<std::size_t>(std::max(caret, 0)), ' ') + "^\n";
}

std::string all_of(const Source& source, const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (std::size_t i = 0; i < std::min(diagnostics.size(), kMostShown); ++i) {
    text += to_string(diagnostics[i], source);
  }
  if (diagnostics.size() > kMostShown) {
    text += source.name() + ": and " + std::to_string(diagnostics.size() - kMostShown) +
            " more errors\n";
  }
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic, const Source& source) {
  std::string text = place(source, diagnostic.mark);
  if (!diagnostic.entry.empty()) text += printable(diagnostic.entry, 200) + ": ";
  text += diagnostic.found;
  if (!diagnostic.expected.empty()) text += "; " + diagnostic.expected;
  text += "\n" + excerpt(source, diagnostic.mark);
  if (diagnostic.other) {
    text += place(source, *diagnostic.other) + "note: " + diagnostic.other_text + "\n" +
            excerpt(source, *diagnostic.other);
  }
  return text;
}

FileError::FileError(const Source& source, std::vector<Diagnostic> diagnostics)
    : InputError(all_of(source, diagnostics)),
      diagnostics_(std::make_shared<const std::vector<Diagnostic>>(std::move(diagnostics))) {}

FileError::FileError(const FileError& first, const FileError& second)
    : InputError(std::string(first.what()) + "\n" + second.what()),
      diagnostics_(first.diagnostics_) {}

void Diagnostics::throw_if_any() const {
  if (found_.empty()) return;
  std::vector<Diagnostic> sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.mark.line, a.mark.column) < std::tie(b.mark.line, b.mark.column);
  });
  throw FileError(source_, std::move(sorted));
}

}  // namespace twum::inline v0_1::io
