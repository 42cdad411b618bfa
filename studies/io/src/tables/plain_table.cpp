// SPDX-License-Identifier: Apache-2.0
#include <twum/io/plain_table.hpp>

#include "tables/heading.hpp"
#include "tables/text_kind.hpp"

#include <twum/base/error.hpp>
#include <twum/io/dimension.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kMostPreamble = 200;  // lines above the headings
constexpr std::size_t kStreamHead = std::size_t{1}
                                    << 14U;  // bytes that tell whether a stream is plain
constexpr std::size_t kLargestTable = std::size_t{256} << 20U;  // bytes
constexpr std::array<char, 3> kSeparators{',', ';', '\t'};

using Cells = std::vector<std::string_view>;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool is_remark(std::string_view line) { return trimmed(line).empty() || line.starts_with('#'); }

// The number with a point in place of its decimal comma; nothing for any other text.
std::optional<std::string> with_point(std::string_view text) {
  if (text.find(',') == std::string_view::npos || text.find('.') != std::string_view::npos)
    return {};
  std::string number = comma_readings(text).decimal;
  if (number.empty()) return {};
  return number;
}

bool may_be_thousands(std::string_view text) { return !comma_readings(text).thousands.empty(); }

bool is_number(std::string_view text) { return parse_number(text) || with_point(text); }

// What separates headings of which none is known: commas, if there is one outside quotation marks.
char likely_separator(std::string_view line) {
  Cells cells;
  std::array<std::size_t, kSeparators.size()> counts{};
  for (std::size_t k = 0; k < kSeparators.size(); ++k)
    counts[k] = split_record(line, cells, kSeparators[k]) ? cells.size() : 1;
  if (counts[0] > 1) return kSeparators[0];
  return counts[1] >= counts[2] ? (counts[1] > 1 ? kSeparators[1] : kSeparators[0])
                                : kSeparators[2];
}

bool are_equal_units(std::string_view one, std::string_view other) {
  if (one == other) return true;
  try {
    const Measure a = parse_measure("1 " + std::string(one));
    const Measure b = parse_measure("1 " + std::string(other));
    return a.value == b.value && a.dimension == b.dimension;
  } catch (const ValueError&) {  // such as degC
    return false;
  }
}

std::string separator_name(char separator) {
  return separator == ',' ? "commas" : separator == ';' ? "semicolons" : "tabs";
}

// The line of the headings, how their cells are separated, and which of them are known.
struct Header {
  std::size_t line{0};
  char separator{','};
  std::size_t known{0};
};

class Rewriter {
 public:
  Rewriter(const std::string& name, std::string_view text, const KnownHeading& known,
           std::vector<std::string>& kinds)
      : name_(name),
        lines_(lines_of(text)),
        ends_in_line_(!text.ends_with('\n')),
        known_(known),
        kinds_(kinds) {}

  /// The plain table; nothing if it is one already.
  std::optional<std::string> rewritten() {
    header_ = find_header();
    if (header_.line >= lines_.size()) return {};
    read_headings();
    refuse_repeated_headings();
    refuse_cut_end();
    take_units();
    leave_out_end();
    decimal_commas_ = has_decimal_commas();
    if (decimal_commas_) kinds_.emplace_back("decimal commas");
    if (kinds_.empty() && !open_end_) return {};
    return text();
  }

 private:
  Header find_header() const {
    Header best{first_line(), ',', 0};
    Cells cells;
    for (std::size_t i = best.line; i < std::min(lines_.size(), kMostPreamble); ++i) {
      if (is_remark(lines_[i])) continue;
      for (const char separator : kSeparators) {
        if (separator != ',' && lines_[i].find(separator) == std::string_view::npos) continue;
        if (!split_record(lines_[i], cells, separator)) continue;
        const std::size_t count = known_among(cells);
        if (count > best.known) best = {i, separator, count};
      }
    }
    if (best.known == 0 && best.line < lines_.size())
      best.separator = likely_separator(lines_[best.line]);
    return best;
  }

  std::size_t first_line() const {
    const auto first = std::ranges::find_if_not(lines_, is_remark);
    return static_cast<std::size_t>(first - lines_.begin());
  }

  // No heading is a number: 0 for a row of values.
  std::size_t known_among(const Cells& cells) const {
    std::size_t count = 0;
    for (const std::string_view cell : cells) {
      const std::string text = cell_text(cell);
      if (is_number(text)) return 0;
      count += !text.empty() && known_(text) ? 1 : 0;
    }
    return count;
  }

  void read_headings() {
    Cells cells;
    well_formed_ = split_record(lines_[header_.line], cells, header_.separator);
    for (const std::string_view cell : cells) headings_.push_back(cell_text(cell));
    for (const std::string& heading : headings_)
      used_.push_back(header_.known == 0 || known_(heading));
    // Many programs end each line with a separator.
    open_end_ = headings_.size() > 1 && headings_.back().empty();
    if (open_end_) headings_.pop_back();
    if (header_.separator != ',')
      kinds_.push_back("columns separated by " + separator_name(header_.separator));
    if (header_.line != first_line())
      kinds_.push_back("headings on line " + std::to_string(header_.line + 1));
  }

  [[noreturn]] void refuse(std::size_t line, const std::string& words) const {
    throw InputError(name_ + ":" + std::to_string(line + 1) + ": " + words);
  }

  // As of tables that were joined.
  void refuse_repeated_headings() const {
    if (header_.known == 0) return;
    for (std::size_t i = header_.line + 1; i < lines_.size(); ++i)
      if (lines_[i] == lines_[header_.line])
        refuse(i, "the headings of line " + std::to_string(header_.line + 1) +
                      " again; leave this line out");
  }

  // A file that was copied in part may end within a number.
  void refuse_cut_end() const {
    Cells cells;
    if (!ends_in_line_ || is_remark(lines_.back()) ||
        !split_record(lines_.back(), cells, header_.separator))
      return;
    const std::string last = cell_text(cells.back());
    if (last.ends_with('.') && parse_number(last))
      refuse(lines_.size() - 1, "the file ends within a number: " + quoted(last) +
                                    "; copy all of it, or leave this line out");
  }

  // A row of units below the headings.
  void take_units() {
    std::size_t at = header_.line + 1;
    while (at < lines_.size() && is_remark(lines_[at])) ++at;
    Cells cells;
    if (at == lines_.size() || !split_record(lines_[at], cells, header_.separator)) return;
    std::vector<std::string> units;
    for (const std::string_view cell : cells) units.push_back(without_brackets(cell_text(cell)));
    const bool all = std::ranges::all_of(units, [](const std::string& unit) {
      return unit.empty() || (!is_number(unit) && names_unit(unit));
    });
    bool known = false;
    for (std::size_t i = 0; i < std::min(units.size(), used_.size()); ++i)
      known = known || (used_[i] && !units[i].empty());
    if (!all || !known) return;
    units_ = at;
    for (std::size_t i = 0; i < std::min(units.size(), headings_.size()); ++i)
      if (!units[i].empty()) take_unit(i, units[i]);
    kinds_.push_back("a row of units on line " + std::to_string(at + 1));
  }

  // A heading may have the same unit already.
  void take_unit(std::size_t column, const std::string& unit) {
    std::string& heading = headings_[column];
    for (const Heading& form : heading_forms(heading)) {
      if (!form.has_unit) continue;
      if (used_[column] && !are_equal_units(form.unit, unit))
        refuse(units_, "the row of units has " + quoted(unit) + " for the heading " +
                           quoted(heading) + "; leave one of the two units out");
      return;
    }
    heading += " [" + unit + "]";
  }

  // A word below the rows, such as END.
  void leave_out_end() {
    Cells cells;
    std::size_t last = lines_.size();
    while (last > header_.line + 1 && is_remark(lines_[last - 1])) --last;
    if (headings_.size() < 2 || last <= header_.line + 2) return;
    const bool words = split_record(lines_[last - 1], cells, header_.separator) &&
                       cells.size() == 1 && likely_separator(lines_[last - 1]) == kSeparators[0] &&
                       !is_number(cell_text(cells[0]));
    if (!words) return;
    lines_[last - 1] = {};
    kinds_.push_back(quoted(cell_text(cells[0])) + " left out at the end");
  }

  static std::string without_brackets(const std::string& unit) {
    const bool enclosed = (unit.starts_with('[') && unit.ends_with(']')) ||
                          (unit.starts_with('(') && unit.ends_with(')'));
    return enclosed ? std::string(trimmed(std::string_view(unit).substr(1, unit.size() - 2)))
                    : unit;
  }

  // Takes each row apart; the function is given its cells.
  template <typename Take>
  void each_row(Take take) const {
    Cells cells;
    for (std::size_t i = header_.line + 1; i < lines_.size(); ++i)
      if (i != units_ && !is_remark(lines_[i]) && split_record(lines_[i], cells, header_.separator))
        take(cells);
  }

  bool has_decimal_commas() const {
    bool commas = false;
    bool points = false;
    each_row([&](const Cells& cells) {
      for (std::size_t k = 0; k < std::min(cells.size(), used_.size()); ++k) {
        if (!used_[k] || cells[k].find_first_of(",.") == std::string_view::npos) continue;
        const std::string text = cell_text(cells[k]);
        points = points || (text.find('.') != std::string::npos && parse_number(text));
        commas = commas || (with_point(text) && !may_be_thousands(text));
      }
    });
    return commas && !points;
  }

  void append_row(std::string& out, std::size_t number) const {
    const std::string_view line = lines_[number];
    Cells cells;
    if (!split_record(line, cells, header_.separator)) {
      out += line;  // the reader says what is wrong
      return;
    }
    if (cells.size() == 1 && headings_.size() > 1 && likely_separator(line) != header_.separator)
      refuse_other_separator(number);
    if (open_end_ && cells.size() == headings_.size() + 1 && trimmed(cells.back()).empty())
      cells.pop_back();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (k > 0) out += ',';
      const std::string text = cell_text(cells[k]);
      const auto number = decimal_commas_ ? with_point(text) : std::nullopt;
      append_own_cell(out, number ? *number : text);
    }
  }

  // The headings and the rows contradict each other.
  void refuse_other_separator(std::size_t number) const {
    const std::string_view line = lines_[number];
    if (line.find_first_of(",;\t") == std::string_view::npos) return;
    refuse(number, "columns separated by " + separator_name(likely_separator(line)) +
                       ", but the headings by " + separator_name(header_.separator) +
                       "; use one of them throughout");
  }

  std::string text() const {
    std::string out;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const bool header = i == header_.line && well_formed_;
      for (std::size_t k = 0; header && k < headings_.size(); ++k) {
        if (k > 0) out += ',';
        append_own_cell(out, headings_[k]);
      }
      if (i == header_.line && !well_formed_) out += lines_[i];
      if (i > header_.line && i != units_)
        is_remark(lines_[i]) ? void(out += lines_[i]) : append_row(out, i);
      out += '\n';
    }
    return out;
  }

  const std::string& name_;
  std::vector<std::string_view> lines_;
  bool ends_in_line_;  // the last line has no end
  const KnownHeading& known_;
  std::vector<std::string>& kinds_;
  Header header_;
  std::vector<std::string> headings_;
  std::vector<bool> used_;  // which columns are known; all if none is
  std::size_t units_{0};    // line of a row of units; 0: none
  bool well_formed_{true};
  bool open_end_{false};
  bool decimal_commas_{false};
};

// The bytes of a text, after which those of a stream follow.
CsvReader::Bytes followed(std::string text, CsvReader::Bytes rest) {
  const auto kept = std::make_shared<std::string>(std::move(text));
  return [kept, at = std::size_t{0}, rest = std::move(rest)](char* to, std::size_t size) mutable {
    if (at == kept->size()) return rest ? rest(to, size) : 0;
    const std::size_t got = std::min(size, kept->size() - at);
    std::memcpy(to, kept->data() + at, got);
    at += got;
    return got;
  };
}

// Appends bytes of the stream until there are `most`; false at its end.
bool append_bytes(std::string& text, std::size_t most, const CsvReader::Bytes& bytes) {
  while (text.size() < most) {
    const std::size_t before = text.size();
    text.resize(std::min(most, before + kStreamHead));
    const std::size_t got = bytes(text.data() + before, text.size() - before);
    text.resize(before + got);
    if (got == 0) return false;
  }
  return true;
}

}  // namespace

PlainTable plain_table(const std::string& name, std::string content, const KnownHeading& known) {
  std::vector<std::string> kinds;
  PlainTable table{utf8_text(name, std::move(content), kinds), {}};
  std::string_view text = table.text;
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  if (auto plain = Rewriter(name, text, known, kinds).rewritten()) table.text = *std::move(plain);
  for (const std::string& kind : kinds) table.kind += (table.kind.empty() ? "" : ", ") + kind;
  return table;
}

PlainStream plain_stream(const std::string& name, CsvReader::Bytes bytes,
                         const KnownHeading& known) {
  std::string head;
  bool more = append_bytes(head, kStreamHead, bytes);
  // A line that is cut off would look malformed.
  const std::size_t last = head.rfind('\n');
  const std::size_t end = more && last != std::string::npos ? last + 1 : head.size();
  const PlainTable first = plain_table(name, head.substr(0, end), known);
  if (more && first.kind.empty()) return {followed(std::move(head), std::move(bytes)), {}};
  if (more) more = append_bytes(head, kLargestTable, bytes);
  if (more)
    throw InputError(name +
                     ": a table of more than 256 MiB has to be CSV with commas and decimal "
                     "points, in UTF-8, with its headings in the first line");
  PlainTable table = plain_table(name, std::move(head), known);
  return {followed(std::move(table.text), {}), std::move(table.kind)};
}

}  // namespace twum::inline v0_1::io
