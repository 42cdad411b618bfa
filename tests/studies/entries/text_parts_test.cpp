// SPDX-License-Identifier: Apache-2.0
// Small parts that read and write text: characters, numbers, units, YAML, places in a file.
#include "entries_support.hpp"
#include "text/utf8.hpp"
#include "units/unit_system.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/io/csv.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>
#include <twum/motors/model_notes.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

YamlNode loaded(const std::string& text) {
  const Source source("text", text);
  Diagnostics diagnostics(source);
  YamlNode node = load_yaml(diagnostics);
  diagnostics.throw_if_any();
  return node;
}

bool same(const YamlNode& a, const YamlNode& b) {
  if (a.kind != b.kind || a.scalar != b.scalar || a.items.size() != b.items.size() ||
      a.entries.size() != b.entries.size())
    return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!same(a.items[i], b.items[i])) return false;
  }
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    if (a.entries[i].key != b.entries[i].key || !same(a.entries[i].value, b.entries[i].value))
      return false;
  }
  return true;
}

YamlNode scalar(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.scalar = text;
  return node;
}

YamlNode mapping(std::vector<YamlEntry> entries) {
  YamlNode node;
  node.kind = YamlNode::Kind::mapping;
  node.entries = std::move(entries);
  return node;
}

YamlNode list(std::vector<YamlNode> items) {
  YamlNode node;
  node.kind = YamlNode::Kind::list;
  node.items = std::move(items);
  return node;
}

// What is said of a quantity that should be a torque or, with a second dimension, a speed.
std::string refusal(const std::string& text) {
  try {
    parse_quantity(text, {"N.m", "0.5 N.m"});
  } catch (const ValueError& error) {
    return error.found() + "; " + error.expected();
  }
  return {};
}

}  // namespace

TEST_CASE("characters of UTF-8 are those of its definition (RFC 3629)", "[studies][text]") {
  const auto length = [](std::string_view text) { return utf8_length(text); };
  CHECK(length("a") == 1);
  CHECK(length("\xC2\xB5") == 2);          // U+00B5
  CHECK(length("\xE2\x80\xAF") == 3);      // U+202F
  CHECK(length("\xF0\x9F\x98\x80") == 4);  // U+1F600
  // The ends of what each length may hold.
  CHECK(length("\xC2\x80") == 2);
  CHECK(length("\xE0\xA0\x80") == 3);
  CHECK(length("\xED\x9F\xBF") == 3);
  CHECK(length("\xEE\x80\x80") == 3);
  CHECK(length("\xF0\x90\x80\x80") == 4);
  CHECK(length("\xF4\x8F\xBF\xBF") == 4);  // U+10FFFF
  // Overlong, surrogates, beyond the last, stray and cut short.
  for (const char* bad : {"\x80",
                          "\xBF",
                          "\xC0\x80",
                          "\xC1\xBF",
                          "\xE0\x9F\xBF",
                          "\xED\xA0\x80",
                          "\xF0\x8F\xBF\xBF",
                          "\xF4\x90\x80\x80",
                          "\xF5\x80\x80\x80",
                          "\xFF",
                          "\xC2",
                          "\xC2z",
                          "\xE2",
                          "\xE2\x80",
                          "\xE2z\x80",
                          "\xE2\x80z",
                          "\xF0",
                          "\xF0\x9F",
                          "\xF0\x9F\x98",
                          "\xF0z\x98\x80",
                          "\xF0\x9Fz\x80",
                          "\xF0\x9F\x98z"}) {
    CAPTURE(bad);
    CHECK(length(bad) == 0);
  }
}

TEST_CASE("blanks that spreadsheets and word processors put in are none of the word",
          "[studies][text]") {
  CHECK(trimmed("\xC2\xA0 5 N\xE2\x80\xAF") == "5 N");
  CHECK(trimmed("\xE2\x80\xAF\t5 N\xC2\xA0\n") == "5 N");
  CHECK(trimmed("\xE2\x80\xB0") == "\xE2\x80\xB0");  // a per mille sign is no blank
  CHECK(trimmed(" \xC2\xA0 ").empty());
  CHECK(parse_quantity("5\xE2\x80\xAFN.m", {"N.m", "0.5 N.m"}) == 5);
}

TEST_CASE("a decimal unit moves the point of any number there is", "[studies][text]") {
  CHECK(parse_decimal("+2.5", -3) == 2.5e-3);
  CHECK(parse_decimal("2.5e+2", -3) == 0.25);
  CHECK(parse_decimal("2.5E-2", 3) == 25);
  CHECK(parse_decimal("7", 0) == 7);
  CHECK_FALSE(parse_decimal("", 3));
  CHECK_FALSE(parse_decimal("7 x", 3));
  CHECK_FALSE(parse_decimal("1e100001", 3));
  CHECK_FALSE(parse_decimal("1e-100001", 3));
  CHECK_FALSE(parse_decimal("1e99999999999999999999", 3));
  CHECK_FALSE(parse_decimal("1e308", 3));
  // So many digits are read as they are and multiplied: 1/3 to the last bit, give or take a rounding.
  const std::string third = "0." + std::string(80, '3');
  CHECK(parse_decimal(third, 3).value() == Approx(1000.0 / 3).epsilon(1e-15));
  CHECK_FALSE(parse_decimal(std::string(320, '9'), 3));
  CHECK_FALSE(parse_decimal(std::string(307, '9'), 3));
}

TEST_CASE("long words are no typing errors", "[studies][text]") {
  const std::string long_word(49, 'a');
  CHECK(edit_distance(long_word, "a", 60) == 61);
  CHECK(edit_distance("a", long_word, 60) == 61);
  CHECK(edit_distance(long_word, long_word, 2) == 3);
  CHECK(edit_distance(std::string(48, 'a'), std::string(48, 'a'), 2) == 0);
}

TEST_CASE("what can be no unit is called none", "[studies][units]") {
  for (const char* bad : {"", "2m", "m@3", "N from m", "m^100", "m/3", "3", "-2", "m 2", "/s"}) {
    CAPTURE(bad);
    CHECK(unit_form_complaint(bad) == "is not a unit");
    CHECK_FALSE(is_unit(bad));
  }
  CHECK(unit_form_complaint(std::string(61, 'm')) == "is not a unit");
  CHECK(unit_form_complaint(std::string(60, 'm')).empty());
  for (const char* good : {"m", "m2", "m^2", "m**2", "s-1", "s^-1", "m^+2", "(N)", "%", "m^12"}) {
    CAPTURE(good);
    CHECK(unit_form_complaint(good).empty());
  }
  CHECK_THAT(unit_form_complaint("W/m.K"), Contains("is ambiguous"));
  CHECK_THAT(unit_form_complaint("W/m*K"), Contains("is ambiguous"));
  CHECK_THAT(unit_form_complaint("W/m K"), Contains("is ambiguous"));
  CHECK(unit_form_complaint("W/(m.K)").empty());
  CHECK_FALSE(is_unit("furlong"));
  CHECK(factor_to("h", "s").value() == Approx(3600).epsilon(1e-15));
  CHECK_FALSE(factor_to("us", "Hz"));  // a period is no frequency
}

TEST_CASE("what people call a unit is known as what it is here", "[studies][units]") {
  CHECK(refusal("5 Nm").empty());  // as data sheets have it
  CHECK(refusal("5 Ncm").empty());
  CHECK(refusal("5 Nmm").empty());
  // Known, but no torque: 'rpm' would be no help here.
  CHECK_THAT(refusal("5 1/min"), !Contains("did you mean"));
  CHECK_THAT(refusal("5 microns"), !Contains("'um'"));
  CHECK_THAT(refusal("5 N.mm2"), StartsWith("'5 N.mm2' is something in 'N.mm2'"));
  CHECK_THAT(refusal("5"), StartsWith("'5' has no unit"));
  CHECK_THAT(refusal("5 %"), StartsWith("'5 %' is a number without dimension"));
  CHECK_THAT(refusal("1e308 kN.m"), StartsWith("'1e308 kN.m' is beyond the range of numbers"));
  CHECK_THAT(refusal("1e400 N.m"), Contains("is beyond the range of numbers"));
  CHECK_THAT(refusal("0,5 N.m"), StartsWith("'0,5 N.m' has a decimal comma; write '0.5 N.m'"));
  CHECK_THAT(refusal("x,5"), StartsWith("'x,5' is not a number"));
}

TEST_CASE("a scale of powers of ten rounds once, another one multiplies", "[studies][units]") {
  CHECK(Scale(1e-3).read("26.5") == 0.0265);
  CHECK(Scale(1e-3 * (1 + 1e-15)).factor() == 1e-3);  // UDUNITS' own roundings
  const double rpm = 2 * std::numbers::pi / 60;
  CHECK(Scale(rpm).factor() == rpm);
  CHECK(Scale(rpm).read("30") == 30 * rpm);
  CHECK_FALSE(Scale(3600).read("1e308"));
  CHECK_FALSE(Scale(3600).read("x"));
  CHECK(Scale(1e301).factor() == 1e301);
}

TEST_CASE("a column without a unit is one of numbers", "[studies][units]") {
  for (const char* none : {"", "1", "-", " "}) {
    CAPTURE(none);
    CHECK(parse_unit(none, {"1", "0.2"}).factor() == 1);
    CHECK_THROWS_WITH(parse_unit(none, {"N", "160 N"}), Contains("is not a unit"));
  }
  CHECK(parse_unit("kN", {"N", "160 N"}).factor() == 1000);
}

TEST_CASE("a dimension without a common name is a quantity", "[studies][units]") {
  CHECK(dimension_phrase("N.m") == "a torque [N.m]");
  CHECK(dimension_phrase("rad/s") == "an angular speed [rad/s]");
  CHECK(dimension_phrase("m^7") == "a quantity [m^7]");
  CHECK(dimension_name("m^7").empty());
  CHECK(dimension_phrase("1") == "a number without unit");
}

TEST_CASE("a size beyond all prefixes is shown in its plain unit", "[studies][units]") {
  CHECK(engineering(5e-13, "m") == "5e-13 m");
  CHECK(engineering(1e-12, "m") == "1 pm");
  CHECK(engineering(-2.5e-3, "m") == "-2.5 mm");
  CHECK(engineering(3e15, "Pa") == "3000 TPa");
  CHECK(engineering(0, "N") == "0 N");
  CHECK(engineering(std::numeric_limits<double>::infinity(), "N") == "inf N");
  CHECK(engineering(1800, "kg/m^3") == "1800 kg/m^3");
  CHECK(engineering(std::numbers::pi / 30, "rad/s") == "1 rpm");
  CHECK(engineering(0.25, "1") == "0.25");
}

TEST_CASE("units of display are read back by UDUNITS, and print as in books", "[studies][units]") {
  for (const char* si : {"m", "Pa", "N.m", "W/m^2", "N.s/m", "kg/m^3", "Hz", "rad/s"}) {
    const std::vector<DisplayUnit> units = display_units(si);
    CHECK(units.size() == (std::string(si).find_first_of("kr") == 0 ? 1 : 9));
    for (std::size_t i = 0; i < units.size(); ++i) {
      // Decimal factors are exact; that of rpm is a product of two roundings.
      CHECK(parse_unit(units[i].text, {si, ""}).factor() ==
            Approx(units[i].divisor).epsilon(1e-15));
      CHECK((i == 0 || units[i].divisor < units[i - 1].divisor));
    }
  }
  CHECK(display_units("1/s").size() == 1);
  CHECK(display_unit(2e-6, "m").text == "um");
  CHECK(printed_unit("um") == "µm");
  CHECK(printed_unit("N.s/m") == "N·s/m");
  CHECK(printed_unit("kW/m^2") == "kW/m²");
  CHECK(printed_unit("kg/m^3") == "kg/m³");
  CHECK(printed_engineering(1.6e-6, "m") == "1.6 µm");
  CHECK(printed_engineering(0.25, "1") == "0.25");
}

TEST_CASE("every kind of YAML node has its words", "[studies][yaml]") {
  CHECK(kind_phrase(YamlNode::Kind::empty) == "empty");
  CHECK(kind_phrase(YamlNode::Kind::scalar) == "a text");
  CHECK(kind_phrase(YamlNode::Kind::list) == "a list");
  CHECK(kind_phrase(YamlNode::Kind::mapping) == "a mapping");
  CHECK(kind_phrase(YamlNode::Kind::refused) == "unreadable");
}

TEST_CASE("YAML that is written is read back as it was", "[studies][yaml]") {
  const std::vector<std::string> texts{"160 N",
                                       "",
                                       " ",
                                       "a ",
                                       "~",
                                       "null",
                                       "-1",
                                       "a: b",
                                       "a #b",
                                       "\"quoted\" and \\ that",
                                       "two\nlines\tand a tab",
                                       "bell\a, return\r, delete\x7F and \x1B",
                                       "\xC2\xB5m",
                                       "nul" + std::string(1, '\0') + "l",
                                       std::string(120, 'x'),
                                       "speed_at(0.5 N.m) >= 80 rpm"};
  std::vector<YamlEntry> scalars;
  std::vector<YamlNode> items;
  for (const std::string& text : texts) {
    scalars.push_back({"key" + std::to_string(scalars.size()), {}, scalar(text)});
    items.push_back(scalar(text));
  }
  YamlNode empty;
  const YamlNode deep = mapping({{"a", {}, mapping({{"b", {}, mapping({{"c", {}, scalar("1")}})}})},
                                 {"of_lists", {}, mapping({{"x", {}, list({scalar("1")})}})},
                                 {"empty", {}, empty},
                                 {"list", {}, list(items)},
                                 {"short", {}, list({scalar("1 N"), scalar("2 N")})},
                                 {"none", {}, list({})},
                                 {"mappings", {}, list({mapping({{"m", {}, scalar("x")}})})},
                                 {"scalars", {}, mapping(scalars)},
                                 {"flat", {}, mapping({{"min", {}, scalar("60 N")}})}});
  CHECK(same(loaded(yaml_text(deep, 0)), deep));
  // Mappings of up to nine entries with one that is a list in any place.
  for (std::size_t size = 1; size <= 9; ++size) {
    for (std::size_t place = 0; place < size; ++place) {
      std::vector<YamlEntry> entries;
      for (std::size_t i = 0; i < size; ++i)
        entries.push_back({"k" + std::to_string(i), {}, scalar("1")});
      entries[place].value = list({scalar("2")});
      const YamlNode whole = mapping({{"x", {}, mapping(entries)}});
      CHECK(same(loaded(yaml_text(whole, 0)), whole));
      CHECK(yaml_text(whole, 0).starts_with("x:\n"));  // no mapping of lists in one line
    }
  }
}

TEST_CASE("a motor of any name has a file that is read back", "[studies][motor]") {
  MotorFile motor;
  motor.name = "two\nlines, \"quoted\", \\, bell\a and return\r";
  CHECK(read_motor(Source("m.yaml", motor_text(motor))).name == motor.name);
  motor.name.clear();
  CHECK(read_motor(Source("m.yaml", motor_text(motor))).name.empty());
}

TEST_CASE("a motor and a study of any name have results that hold", "[studies][run]") {
  const ScratchFolder folder;
  StudyFile file = study_in(folder,
                            "{kind: optimize, maximize: stall_torque, variables: {preload: {min: "
                            "100 N, max: 200 N}}}",
                            "elastic-layer", "two\nlines.yaml");
  file.motor.name = "bell\a";
  const StudyResult result = run_study(file, folder.path("out"));
  CHECK(result.study == "two\nlines");
  const Verification found = verify_study(folder.path("out"));
  CAPTURE(found.complaints);
  CHECK(found.holds());
  CHECK(read_study_file(folder.path("out/study.yaml")).motor.name == "bell\a");
  CHECK(read_motor_file(folder.path("out/best.yaml")).name == "bell\a, best of two\nlines");
}

TEST_CASE("a place in a text is one, be it beyond its end", "[studies][diagnostics]") {
  const Source source("name", "first\r\nsec\xC3\xB6nd\nlast");
  CHECK(source.line(1) == "first");
  CHECK(source.line(3) == "last");
  for (const int beyond : {-1, 0, 4, 1000}) CHECK(source.line(beyond).empty());
  CHECK(source.mark(1, 5).column == 5);  // the two bytes of one letter lie before it
  CHECK(source.mark(1, -3).column == 1);
  CHECK(source.mark(7, 3).line == 8);
  CHECK(source.mark(7, 3).column == 1);
}

TEST_CASE("a diagnostic without entry or remedy says the rest", "[studies][diagnostics]") {
  const Source source("f.yaml", "a: 1\nb: 2\n");
  const auto text = [&](const Diagnostic& diagnostic) { return to_string(diagnostic, source); };
  CHECK(text({{2, 1}, "b", "wrong", "be right", {}, {}}) ==
        "f.yaml:2:1: b: wrong; be right\n    2 | b: 2\n      | ^\n");
  CHECK(text({{2, 4}, "", "wrong", "", {}, {}}) ==
        "f.yaml:2:4: wrong\n    2 | b: 2\n      |    ^\n");
  CHECK(text({{0, 0}, "", "nowhere", "", {}, {}}) == "f.yaml:0:0: nowhere\n    0 | \n      | ^\n");
  const std::string both = text({{1, 1}, "", "twice", "", SourceMark{2, 1}, "and here"});
  CHECK_THAT(both, Contains("f.yaml:2:1: note: and here\n    2 | b: 2\n"));
  // Of a line with a number of six digits no margin is left.
  const Source far("f", std::string(123455, '\n') + "x");
  CHECK_THAT(to_string({{123456, 1}, "", "wrong", "", {}, {}}, far), Contains("\n123456 | x\n"));
  // Of a long line the part round the column is shown, with the caret below it.
  const Source wide("f", std::string(300, 'a') + "X" + std::string(300, 'b'));
  const std::string part = to_string({{1, 301}, "", "wrong", "", {}, {}}, wide);
  const std::size_t line = part.find("| ") + 2;
  const std::size_t caret = part.find('^') - (part.rfind("| ") + 2);
  CHECK(part[line + caret] == 'X');
}

TEST_CASE("a row of more than 64 MiB lacks a quotation mark", "[studies][csv]") {
  std::size_t given = 0;
  CsvReader reader("table.csv", [&](char* to, std::size_t size) {
    const std::size_t got = std::min<std::size_t>(size, (std::size_t{1} << 27U) - given);
    std::fill(to, to + got, 'x');
    if (given == 0) to[0] = '"';
    given += got;
    return got;
  });
  CsvChunk chunk;
  CHECK_THROWS_WITH(reader.read(chunk, 1),
                    "table.csv:1:1: a row longer than 64 MiB; is a quotation mark missing?");
}

TEST_CASE("doubled quotation marks in a cell are one each", "[studies][csv]") {
  CHECK(cell_text("\"a\"\"b\"") == "a\"b");
  CHECK(cell_text("\"\"\"\"") == "\"");
  CHECK(cell_text("\"a\"\"\"") == "a\"");
  CHECK(cell_text("\"\"").empty());
  CHECK(cell_text("\"") == "\"");
}
