// SPDX-License-Identifier: Apache-2.0
#include <twum/io/text_table.hpp>

#include <algorithm>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kGap = 2;
// Least width of a column of words.
constexpr std::size_t kLeastWords = 28;

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::vector<std::size_t> widths_of(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& row : table.rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  return widths;
}

// Where the word that begins there ends; a call such as "torque_at(80 rpm)" is one word.
std::size_t end_of_word(const std::string& text, std::size_t begin) {
  int inside = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] == '(' && (inside > 0 || (i > begin && text[i - 1] != ' '))) ++inside;
    if (text[i] == ')' && inside > 0) --inside;
    if (text[i] == ' ' && inside == 0) return i;
  }
  return text.size();
}

// The word that begins there. A call that no line has room for is broken between its own words.
std::string word_at(const std::string& text, std::size_t begin, std::size_t width) {
  const std::string word = text.substr(begin, end_of_word(text, begin) - begin);
  return width_of(word) <= width ? word : word.substr(0, word.find(' '));
}

// The text in lines of at most `width`, broken between words; never empty.
std::vector<std::string> broken_lines(const std::string& text, std::size_t width) {
  if (width_of(text) <= width) return {text};
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::string word = word_at(text, begin, width);
    begin += word.size() + 1;
    std::string& line = lines.back();
    if (line.empty())
      line = word;
    else if (width_of(line) + 1 + width_of(word) <= width)
      line += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

// A column of the table with the width that it has.
struct PlacedColumn {
  std::size_t index;
  std::size_t width;
};
using Block = std::vector<PlacedColumn>;

// Whether a column can be wrapped instead of moved below: its cells have several words.
bool has_words(const TextTable& table, std::size_t column, std::size_t width) {
  for (const auto& row : table.rows) {
    if (column >= row.size()) continue;
    for (const std::string& line : broken_lines(row[column], width))
      if (width_of(line) > width) return false;
  }
  return true;
}

// The columns that every block begins with.
Block keys_of(const TextTable& table, const std::vector<std::size_t>& widths) {
  Block keys;
  for (std::size_t i = 0; i < std::min(table.keys, widths.size()); ++i)
    keys.push_back({i, widths[i]});
  return keys;
}

std::size_t width_of(const Block& block) {
  std::size_t width = 0;
  for (const PlacedColumn& column : block) width += (width > 0 ? kGap : 0) + column.width;
  return width;
}

// Divides the columns into blocks that fit the width.
std::vector<Block> blocks_of(const TextTable& table, std::size_t width) {
  const std::vector<std::size_t> widths = widths_of(table);
  const Block keys = keys_of(table, widths);
  std::vector<Block> blocks{keys};
  for (std::size_t i = keys.size(); i < widths.size(); ++i) {
    const auto room = [&] {
      const std::size_t used = width_of(blocks.back()) + kGap;
      return width > used ? width - used : 0;
    };
    const bool breaks = room() >= kLeastWords && has_words(table, i, room());
    if (widths[i] > room() && !breaks && blocks.back().size() > keys.size()) blocks.push_back(keys);
    blocks.back().push_back({i, std::min(widths[i], std::max(room(), kLeastWords))});
  }
  return blocks;
}

std::string line_of(const std::vector<std::string>& cells, const Block& block, bool numbers) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t width = width_of(cells[i]);
    const std::string blanks(block[i].width > width ? block[i].width - width : 0, ' ');
    line +=
        (i > 0 ? std::string(kGap, ' ') : "") + (numbers ? blanks + cells[i] : cells[i] + blanks);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string row_of(const std::vector<std::string>& row, const Block& block, bool numbers) {
  std::vector<std::vector<std::string>> cells;
  std::size_t height = 1;
  for (const PlacedColumn& column : block) {
    cells.push_back(broken_lines(column.index < row.size() ? row[column.index] : "", column.width));
    height = std::max(height, cells.back().size());
  }
  std::string text;
  for (std::size_t k = 0; k < height; ++k) {
    std::vector<std::string> line;
    for (const std::vector<std::string>& cell : cells)
      line.push_back(k < cell.size() ? cell[k] : "");
    text += line_of(line, block, numbers);
  }
  return text;
}

}  // namespace

std::string aligned(const TextTable& table, std::size_t width) {
  const std::size_t unlimited = static_cast<std::size_t>(-1) / 2;
  std::string text;
  for (const Block& block : blocks_of(table, width > 0 ? width : unlimited)) {
    if (!text.empty()) text += "\n";
    for (const auto& row : table.rows) text += row_of(row, block, table.numbers);
  }
  return text;
}

std::string aligned(const TextTable& table) { return aligned(table, 0); }

}  // namespace twum::inline v0_1::io
