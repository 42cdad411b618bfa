// SPDX-License-Identifier: Apache-2.0
// Tables as spreadsheets, loggers and instruments write them.
#include <twum/base/error.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/number.hpp>
#include <twum/io/plain_table.hpp>

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::io;

namespace {

using Row = std::vector<std::string>;

bool is_known(std::string_view heading) {
  return heading.starts_with("speed") || heading.starts_with("torque");
}

PlainTable plain(const std::string& content) { return plain_table("t.csv", content, is_known); }

CsvReader::Bytes bytes_in_pieces(const std::string& text, std::size_t piece) {
  return [text, piece, at = std::size_t{0}](char* to, std::size_t size) mutable {
    const std::size_t got = std::min({size, piece, text.size() - at});
    std::memcpy(to, text.data() + at, got);
    at += got;
    return got;
  };
}

// Cells of all records, with the lines on which they stand.
std::vector<std::pair<std::size_t, Row>> rows_of(const CsvReader::Bytes& bytes) {
  std::vector<std::pair<std::size_t, Row>> rows;
  CsvReader reader("t.csv", bytes);
  CsvChunk chunk;
  std::vector<std::string_view> cells;
  while (reader.read(chunk, 100))
    for (std::size_t i = 0; i < chunk.records.size(); ++i) {
      REQUIRE(split_record(chunk.record(i), cells));
      Row row;
      for (const std::string_view cell : cells) row.push_back(cell_text(cell));
      rows.emplace_back(chunk.records[i].line, row);
    }
  return rows;
}

// How a program writes a table.
struct Dialect {
  char separator;
  bool decimal_commas, quoted, units_below, utf16;
  int preamble;
};

std::string cell_of(const std::string& text, const Dialect& dialect) {
  const bool needed = text.find_first_of(",;\t\"") != std::string::npos;
  return dialect.quoted || needed ? "\"" + text + "\"" : text;
}

std::string line_of(const Row& row, const Dialect& dialect) {
  std::string line;
  for (const std::string& cell : row)
    line += (line.empty() ? "" : std::string(1, dialect.separator)) + cell_of(cell, dialect);
  return line + "\n";
}

std::string utf16_of(const std::string& ascii) {
  std::string bytes = "\xFF\xFE";
  for (const char c : ascii) bytes += {c, '\0'};
  return bytes;
}

std::string written(const std::vector<Row>& numbers, const Dialect& dialect) {
  std::string text;
  for (int i = 0; i < dialect.preamble; ++i) text += "Setting " + std::to_string(i) + ": 1\n";
  text += line_of(dialect.units_below ? Row{"speed", "remark", "torque"}
                                      : Row{"speed [rpm]", "remark", "torque [N.m]"},
                  dialect);
  if (dialect.units_below) text += line_of({"rpm", "", "N.m"}, dialect);
  for (Row row : numbers) {
    for (std::string& cell : row)
      if (dialect.decimal_commas && parse_number(cell)) std::ranges::replace(cell, '.', ',');
    text += line_of(row, dialect);
  }
  return dialect.utf16 ? utf16_of(text) : text;
}

}  // namespace

TEST_CASE("a plain table stays as it is", "[studies][csv]") {
  for (const char* text :
       {"speed [rpm],torque [N.m]\n1,2\n", "speed\n1\n", "# no\r\nspeed,\"torque\"\r\n1,2\r\n",
        "speed,remark\n1,\"a;b\"\n", "other,names\n1,2\n", ""}) {
    CHECK(plain(text).text == text);
    CHECK(plain(text).kind.empty());
  }
}

TEST_CASE("a table of any program holds the cells that it was written from",
          "[studies][csv][property]") {
  rc::prop("plain_table() undoes the program's way of writing", [] {
    Dialect dialect{*rc::gen::element(',', ';', '\t'), *rc::gen::arbitrary<bool>(),
                    *rc::gen::arbitrary<bool>(),       *rc::gen::arbitrary<bool>(),
                    *rc::gen::arbitrary<bool>(),       *rc::gen::inRange(0, 4)};
    std::vector<Row> rows;
    // Two digits behind the point: no number may have its thousands separated.
    for (int i = 0; i <= *rc::gen::inRange(0, 5); ++i)
      rows.push_back({std::to_string(*rc::gen::inRange(-999, 999)) + ".25",
                      *rc::gen::element<std::string>("", "a", "3.5 kg", "x;y,z"),
                      std::to_string(*rc::gen::inRange(0, 99)) + ".5"});
    const PlainTable table = plain(written(rows, dialect));
    const auto found = rows_of(bytes_in_pieces(table.text, 1000));
    RC_ASSERT(found.size() == rows.size() + 1);
    RC_ASSERT(found[0].second == (Row{"speed [rpm]", "remark", "torque [N.m]"}));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      RC_ASSERT(found[i + 1].second == rows[i]);
      const std::size_t above =
          static_cast<std::size_t>(dialect.preamble) + (dialect.units_below ? 2 : 1);
      RC_ASSERT(found[i + 1].first == above + i + 1);  // the line where it was
    }
  });
}

TEST_CASE("a stream has the records of the whole table, however it comes", "[studies][csv]") {
  std::string table = "speed [rpm];torque [N.m]\n";
  std::string same = "speed [rpm],torque [N.m]\n";
  for (int i = 0; i < 3000; ++i) {  // more than the beginning that is looked at
    table += std::to_string(i) + ",5;" + std::to_string(i % 7) + ",25\n";
    same += std::to_string(i) + ".5," + std::to_string(i % 7) + ".25\n";
  }
  for (const std::size_t piece : {std::size_t{7}, std::size_t{1000000}}) {
    const PlainStream stream = plain_stream("t.csv", bytes_in_pieces(table, piece), is_known);
    CHECK(stream.kind == "columns separated by semicolons, decimal commas");
    CHECK(rows_of(stream.bytes) == rows_of(bytes_in_pieces(same, piece)));
    const PlainStream passed = plain_stream("t.csv", bytes_in_pieces(same, piece), is_known);
    CHECK(passed.kind.empty());
    CHECK(rows_of(passed.bytes) == rows_of(bytes_in_pieces(same, piece)));
  }
}

TEST_CASE("the headings are in the line with the most known ones", "[studies][csv]") {
  const PlainTable table = plain("torque\nName,speed log\n7,8\nspeed,torque\n1,2\n");
  CHECK(table.kind == "headings on line 4");
  CHECK(table.text == "\n\n\nspeed,torque\n1,2\n");
  // Of a file without any, the first line is told about.
  CHECK(plain("a;b\n1;2\n").text == "a,b\n1,2\n");
}

TEST_CASE("a row of units has a unit for a known column, and no number", "[studies][csv]") {
  CHECK(plain("speed,remark\n[rpm],\n1,x\n").text == "speed [rpm],remark\n\n1,x\n");
  CHECK(plain("speed [rpm],torque\nrpm,(N.m)\n1,2\n").text == "speed [rpm],torque [N.m]\n\n1,2\n");
  CHECK(plain("speed,remark\n,V\n1,x\n").text == "speed,remark\n,V\n1,x\n");
  CHECK(plain("speed,torque\nrpm,5\n").text == "speed,torque\nrpm,5\n");
}

TEST_CASE("a heading and the row of units agree on the unit", "[studies][csv][error]") {
  CHECK(plain("speed (rpm),torque\nr/min,N.m\n1,2\n").text == "speed (rpm),torque [N.m]\n\n1,2\n");
  CHECK_THROWS_WITH(
      plain("speed [rad/s],torque\nrpm,N.m\n1,2\n"),
      "t.csv:2: the row of units has 'rpm' for the heading 'speed [rad/s]'; leave one "
      "of the two units out");
  CHECK_NOTHROW(plain("speed,other [V]\nrpm,mV\n1,2\n"));  // a column that is not used
}

TEST_CASE("headings stand once", "[studies][csv][error]") {
  CHECK_THROWS_WITH(plain("# a\nspeed,torque\n1,2\nspeed,torque\n3,4\n"),
                    "t.csv:4: the headings of line 2 again; leave this line out");
  CHECK_NOTHROW(plain("a,b\n1,2\na,b\n"));  // of headings that nobody knows the reader tells
}

TEST_CASE("a file that ends within a number is not read", "[studies][csv][error]") {
  CHECK_THROWS_WITH(plain("speed,torque\n1,2\n3,0."),
                    "t.csv:3: the file ends within a number: '0.'; copy all of it, or leave this "
                    "line out");
  CHECK_NOTHROW(plain("speed,torque\n1,2\n3,0.\n"));  // the line is whole
  CHECK_NOTHROW(plain("speed,torque\n1,2\n3,0"));     // as many editors end a file
  CHECK_NOTHROW(plain("speed,remark\n1,2\n3,done."));
}

TEST_CASE("a word below the rows is left out", "[studies][csv]") {
  CHECK(plain("BEGIN CH1\nspeed,torque\n1,2\n3,4\nEND\n\n").text ==
        "\nspeed,torque\n1,2\n3,4\n\n\n");
  CHECK(plain("BEGIN CH1\nspeed,torque\n1,2\nEND\n").kind ==
        "headings on line 2, 'END' left out at the end");
  CHECK(plain("speed,torque\n1,2\n7\n").text == "speed,torque\n1,2\n7\n");  // half a row is no word
  CHECK(plain("speed,torque\nEND\n").text == "speed,torque\nEND\n");
  CHECK(plain("speed\n1\nEND\n").text == "speed\n1\nEND\n");
}

TEST_CASE("commas are decimal ones only where nothing contradicts", "[studies][csv]") {
  CHECK(plain("speed;torque\n1,200;850\n").text == "speed,torque\n\"1,200\",850\n");
  CHECK(plain("speed;torque\n1,200;0,850\n").text == "speed,torque\n1.200,0.850\n");
  CHECK(plain("speed;torque\n1,5;0.850\n").text == "speed,torque\n\"1,5\",0.850\n");
  CHECK(plain("speed;date;torque\n1,5;24.12;2\n").text == "speed,date,torque\n1.5,24.12,2\n");
}

TEST_CASE("commas in numbers are read, or refused with what they may mean",
          "[studies][units][error]") {
  CHECK(comma_readings("1,200").decimal == "1.200");
  CHECK(comma_readings("1,200").thousands == "1200");
  CHECK(comma_readings("1,200.5").decimal.empty());
  CHECK(comma_readings("1,200.5").thousands == "1200.5");
  CHECK(comma_readings("1.200,5").decimal == "1200.5");
  CHECK(comma_readings("0,200").thousands.empty());
  CHECK(comma_readings("-12,345,678").thousands == "-12345678");
  CHECK(comma_readings("-12,345,678").decimal.empty());
  CHECK(comma_readings("1,2,3").decimal.empty());
  CHECK(comma_readings("12").decimal.empty());
  CHECK(number_complaint("1,200", " N").expected == "write '1.200 N' or '1200 N'");
  CHECK(number_complaint("12").found.empty());
  CHECK(number_complaint("\xE2\x88\x92"
                         "1.5",
                         " N")
            .expected == "write '-1.5 N'");
  for (const char* grouped : {"12 345.5", "12'345.5",
                              "12\xC2\xA0"
                              "345.5",
                              "12\xE2\x80\xAF"
                              "345.5"})
    CHECK(number_complaint(grouped).expected == "write '12345.5'");
  for (const char* other : {"1 2", "12 34", "1 200 N", "a 200", "", " ", "'", "1'2000"})
    CHECK(number_complaint(other).found.empty());
}

TEST_CASE("characters outside the first plane come out of UTF-16", "[studies][csv]") {
  const std::string text("\xFE\xFF\0s\0p\0e\0e\0d\0\n\xD8\x35\xDF\x00\0\n\xD8\x35\0x\0\n", 26);
  CHECK(plain(text).text ==
        "speed\n\xF0\x9D\x9C\x80\n\xEF\xBF\xBDx\n");  // U+1D700; half of a pair is U+FFFD
}

TEST_CASE("files that are no text are called what they are", "[studies][csv][error]") {
  CHECK_THROWS_WITH(plain(std::string("PK\x03\x04") + std::string(50, '\0')),
                    Catch::StartsWith("t.csv: is a spreadsheet (.xlsx, .ods)"));
  CHECK_THROWS_WITH(plain("\xD0\xCF\x11\xE0"), Catch::Contains("(.xls)"));
  CHECK_THROWS_WITH(plain(std::string("a\0\0\0b\0", 6)), Catch::Contains("is not a text"));
  CHECK_THROWS_WITH(
      plain("speed;torque\n1,2\n"),
      "t.csv:2: columns separated by commas, but the headings by semicolons; use one of "
      "them throughout");
}
