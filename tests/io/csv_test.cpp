// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/io/csv.hpp>

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>

#include <cstring>

using namespace twum::io;

namespace {

// A stream that hands out a text in pieces of a given size.
CsvReader::Bytes pieces_of(const std::string& text, std::size_t piece) {
  return [text, piece, at = std::size_t{0}](char* to, std::size_t size) mutable {
    const std::size_t count = std::min({piece, size, text.size() - at});
    std::memcpy(to, text.data() + at, count);
    at += count;
    return count;
  };
}

std::vector<std::string> records_of(const std::string& text, std::size_t piece = 7,
                                    std::size_t most = 3) {
  CsvReader reader("t.csv", pieces_of(text, piece));
  CsvChunk chunk;
  std::vector<std::string> records;
  while (reader.read(chunk, most)) {
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      records.push_back(std::to_string(chunk.records[i].line) + "|" + std::string(chunk.record(i)));
    }
  }
  return records;
}

using Records = std::vector<std::string>;

}  // namespace

TEST_CASE("records end at line ends outside quotes", "[studies][csv]") {
  CHECK(records_of("a,b\n1,2\n") == Records{"1|a,b", "2|1,2"});
  CHECK(records_of("a,b\r\n1,2\r\n3,4") == Records{"1|a,b", "2|1,2", "3|3,4"});
  CHECK(records_of("\xEF\xBB\xBF"
                   "a\n\n  \n1\n") == Records{"1|a", "4|1"});
  for (const std::size_t piece : {1U, 2U, 3U}) {  // as from a pipe
    CHECK(records_of("\xEF\xBB\xBF"
                     "a\n1\n",
                     piece) == Records{"1|a", "2|1"});
    CHECK(records_of("\xEF\xBB", piece) == Records{"1|\xEF\xBB"});
  }
  CHECK(records_of("\"x\ny\",1\n2,3\n") == Records{"1|\"x\ny\",1", "3|2,3"});
  CHECK(records_of("\"x\"\"\n\",1\n2\n") == Records{"1|\"x\"\"\n\",1", "3|2"});
  CHECK(records_of("5\" pipe,1\n2\n") ==
        Records{"1|5\" pipe,1", "2|2"});  // a mark inside a cell quotes nothing
  CHECK(records_of("").empty());
  CHECK(records_of("\n\n").empty());
}

TEST_CASE("a quotation that does not end is an error with its line", "[studies][csv][error]") {
  CHECK_THROWS_WITH(records_of("a\n\"b\nc\n"),
                    "t.csv:2:1: a quotation that does not end; close it with '\"'");
}

TEST_CASE("records before a quotation that does not end are not lost", "[studies][csv][error]") {
  CsvReader reader("t.csv", pieces_of("a\n1\n2\n\"3\n", 100));
  CsvChunk chunk;
  REQUIRE(reader.read(chunk, 100));
  CHECK(chunk.records.size() == 3);
  for (int i = 0; i < 2; ++i) CHECK_THROWS_AS(reader.read(chunk, 100), twum::InputError);
}

TEST_CASE("cells are cut at commas outside quotes", "[studies][csv]") {
  std::vector<std::string_view> cells;
  using Cells = std::vector<std::string_view>;
  CHECK(split_record("a,,\"b,c\",", cells));
  CHECK(cells == Cells{"a", "", "\"b,c\"", ""});
  CHECK_FALSE(split_record("a\"b,c", cells));
  CHECK_FALSE(split_record("\"a\" b,c", cells));
  CHECK(split_record("\"\"\"\",\"\"", cells));
  CHECK(cell_text(cells[0]) == "\"");
  CHECK(cell_text(cells[1]).empty());
  CHECK(cell_text("  x ") == "x");
}

TEST_CASE("very wide rows are read", "[studies][csv]") {
  std::string row;
  for (int i = 0; i < 300000; ++i) row += "123456,";
  CHECK(records_of(row + "1\n" + row + "2\n", 100000).size() == 2);
}

TEST_CASE("what is written as cells is read as the same cells, however the bytes arrive",
          "[studies][csv][property]") {
  rc::prop("append_cell, CsvReader and split_record are inverse",
           [](std::vector<std::string> cells) {
             RC_PRE(!cells.empty());
             const auto piece = *rc::gen::inRange<std::size_t>(1, 50);
             std::string row = "x";
             for (std::string& cell : cells) {
               std::erase(cell, '\0');
               row += ',';
               append_cell(row, cell);
             }
             const auto records = records_of(row + "\n", piece);
             RC_ASSERT(records.size() == 1U);
             std::vector<std::string_view> found;
             RC_ASSERT(split_record(std::string_view(records[0]).substr(2), found));
             RC_ASSERT(found.size() == cells.size() + 1);
             for (std::size_t i = 0; i < cells.size(); ++i) {
               std::string raw;
               append_cell(raw, cells[i]);
               RC_ASSERT(found[i + 1] == raw);
             }
           });
}
