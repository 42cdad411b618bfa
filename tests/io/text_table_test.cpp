// SPDX-License-Identifier: Apache-2.0
#include <twum/io/text_table.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>

using namespace twum::io;
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::multiset<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::multiset<std::string> words;
  for (std::string word; stream >> word;) words.insert(word);
  return words;
}

const TextTable kNumbers{
    {{"speed", "torque", "output_power"}, {"0", "1.036", "0"}, {"50.96", "1.019", "5.437"}}, true};
const TextTable kTexts{
    {{"name", "text"}, {"mu", "kinetic friction of the contact, while it slips"}, {"a", "short"}}};

}  // namespace

TEST_CASE("a table with room is as wide as it is", "[files][table]") {
  const std::string text =
      "speed  torque  output_power\n    0   1.036             0\n50.96   1.019         5.437\n";
  CHECK(aligned(kNumbers) == text);
  CHECK(aligned(kNumbers, 0) == text);
  CHECK(aligned(kNumbers, 27) == text);
  CHECK(aligned(TextTable{}, 10).empty());
  CHECK(aligned({{{"a  ->  b", ""}, {"", "c"}}}, 20) == "a  ->  b\n          c\n");
}

TEST_CASE("columns without room follow below, behind the keys", "[files][table]") {
  CHECK(aligned(kNumbers, 26) ==
        "speed  torque\n    0   1.036\n50.96   1.019\n\nspeed  output_power\n    0             "
        "0\n50.96         5.437\n");
  TextTable two = kNumbers;
  two.keys = 2;
  CHECK(aligned(two, 20) == aligned(two));  // nothing but the keys would fit
}

TEST_CASE("a column of words is broken between them", "[files][table]") {
  const std::string text = aligned(kTexts, 34);
  CHECK(text ==
        "name  text\nmu    kinetic friction of the\n      contact, while it slips\na     short\n");
  CHECK(words_of(text) == words_of(aligned(kTexts)));
}

TEST_CASE("a call is broken between its words only where no line has room for it",
          "[files][table]") {
  const auto broken = [](const std::string& text, std::size_t width) {
    return aligned({{{"1", text}, {"2", ""}}}, width);
  };
  CHECK(broken("largest stall_torque, smallest wear_intensity_at(80 rpm)", 52) ==
        "1  largest stall_torque, smallest\n   wear_intensity_at(80 rpm)\n2\n");
  CHECK(broken("probability(wear_intensity_at(80 rpm) <= 5 kW/m^2)", 31) ==
        "1  probability(wear_intensity_at(80\n   rpm) <= 5 kW/m^2)\n2\n");
  // A remark in parentheses is no call.
  CHECK(broken("the end of its range (as wide as the file gives it)", 40) ==
        "1  the end of its range (as wide as the\n   file gives it)\n2\n");
}

TEST_CASE("no line is wider than asked, and no word is lost", "[files][table]") {
  TextTable table{{{"größe", "unit", "text", "reason"}}};
  for (int i = 0; i < 5; ++i)
    table.rows.push_back({"µ" + std::to_string(i), "kW/m^2",
                          "what it is in some words, more or less",
                          "why its range ends where it does, and no sooner"});
  const std::size_t width = GENERATE(40U, 60U, 80U, 110U);
  CAPTURE(width);
  const std::string text = aligned(table, width);
  for (const std::string& line : lines_of(text)) {
    const auto letters = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    });
    CHECK(static_cast<std::size_t>(letters) <= width);
  }
  const std::multiset<std::string> shown = words_of(text), all = words_of(aligned(table));
  CHECK(std::includes(shown.begin(), shown.end(), all.begin(), all.end()));
}
