// SPDX-License-Identifier: Apache-2.0
// What a schema becomes as JSON Schema and as a Markdown table, on schemas made for it.
#include <twum/io/publish.hpp>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace twum::io;
using Json = nlohmann::json;
using Catch::Matchers::Contains;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Schema of_kind(ValueKind kind, const std::string& text = "a text") {
  Schema schema;
  schema.kind = kind;
  schema.text = text;
  return schema;
}

Schema number(double min, double max, bool min_excluded = false) {
  Schema schema = of_kind(ValueKind::quantity, "a number");
  schema.min = min;
  schema.max = max;
  schema.min_excluded = min_excluded;
  return schema;
}

SchemaEntry entry(const std::string& name, Schema schema, bool required = false) {
  SchemaEntry result;
  result.name = name;
  result.schema = std::move(schema);
  result.required = required;
  return result;
}

Schema mapping(std::vector<SchemaEntry> entries) {
  Schema schema = of_kind(ValueKind::mapping, "the whole");
  schema.entries = std::move(entries);
  return schema;
}

Json published(const Schema& schema) { return Json::parse(json_schema(schema, "T", "urn:t")); }

// The cell that says what may stand there.
std::string value_cell(const Schema& schema) {
  const std::string table = markdown_table(mapping({entry("x", schema)}));
  const std::size_t begin = table.find("| `x` | ") + 8;
  return table.substr(begin, table.find(" | ", begin) - begin);
}

std::string row(const std::string& table, const std::string& path) {
  const std::size_t begin = table.find("| `" + path + "` |");
  return begin == std::string::npos ? "" : table.substr(begin, table.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("limits of a number are said in JSON Schema where there are some", "[studies][schema]") {
  const auto limits = [](const Schema& schema) { return published(schema)["anyOf"][0]; };
  CHECK(limits(number(-kInfinity, kInfinity)) == Json{{"type", "number"}});
  CHECK(limits(number(0, 2)) == Json{{"type", "number"}, {"minimum", 0.0}, {"maximum", 2.0}});
  CHECK(limits(number(0, kInfinity, true)) == Json{{"type", "number"}, {"exclusiveMinimum", 0.0}});
  CHECK(limits(number(-kInfinity, 5)) == Json{{"type", "number"}, {"maximum", 5.0}});
  Schema below = number(-kInfinity, 5);
  below.max_excluded = true;
  CHECK(limits(below) == Json{{"type", "number"}, {"exclusiveMaximum", 5.0}});
  Schema whole = number(1, kInfinity);
  whole.whole = true;
  CHECK(limits(whole)["type"] == "integer");
  CHECK(limits(of_kind(ValueKind::count))["type"] == "integer");
}

TEST_CASE("a number without unit may be text, with a per cent sign at most", "[studies][schema]") {
  const Json text = published(number(0, 1))["anyOf"][1];
  CHECK(text["type"] == "string");
  CHECK_THAT(text["pattern"].get<std::string>(), Contains("%?"));
}

TEST_CASE("a quantity with a unit is text that tells its unit", "[studies][schema]") {
  Schema force = of_kind(ValueKind::quantity, "total axial force");
  force.unit = "N";
  force.example = "160 N";
  const Json json = published(force);
  CHECK(json["type"] == "string");
  CHECK(json["description"] == "total axial force [N]");
  CHECK(json["examples"] == Json::array({"160 N"}));
}

TEST_CASE("words are an enumeration, in which 1 may be a number too", "[studies][schema]") {
  Schema word = of_kind(ValueKind::word, "");
  word.words = {"linear", "log", "1", "12x"};
  const Json json = published(word);
  CHECK(json["enum"] == Json::array({"linear", "log", "1", 1, "12x"}));
  CHECK_FALSE(json.contains("description"));  // nothing is said of it
}

TEST_CASE("lists say how long they may be", "[studies][schema]") {
  Schema list = of_kind(ValueKind::list);
  list.items = {of_kind(ValueKind::text)};
  list.min_items = 2;
  CHECK(published(list)["minItems"] == 2);
  CHECK_FALSE(published(list).contains("maxItems"));
  list.max_items = 3;
  CHECK(published(list)["maxItems"] == 3);
}

TEST_CASE("entries with names of one's own have one shape", "[studies][schema]") {
  Schema named = of_kind(ValueKind::named);
  named.items = {of_kind(ValueKind::count)};
  const Json json = published(named);
  CHECK(json["type"] == "object");
  CHECK(json["minProperties"] == 1);
  CHECK(json["additionalProperties"]["anyOf"][0]["type"] == "integer");
}

TEST_CASE("entries that exclude each other are a rule, said once", "[studies][schema]") {
  const auto pair = [](bool required, bool alias) {
    SchemaEntry a = entry("a", of_kind(ValueKind::text), required);
    SchemaEntry b = entry("b", of_kind(ValueKind::text));
    a.alternative_entry = "b";
    b.alternative_entry = "a";
    if (alias) {
      a.alias = "alpha";
      a.alias_counts = true;
    }
    return published(mapping({a, b}));
  };
  const Json a{{"required", {"a"}}};
  const Json b{{"required", {"b"}}};
  CHECK(pair(true, false)["allOf"] == Json::array({Json{{"oneOf", Json::array({a, b})}}}));
  CHECK_FALSE(pair(true, false).contains("required"));  // either of them will do
  const Json not_both{{"not", {{"allOf", Json::array({a, b})}}}};
  CHECK(pair(false, false)["allOf"] == Json::array({not_both}));
  // By its alias an entry is given as well.
  const Json by_either{{"anyOf", Json::array({a, Json{{"required", {"alpha"}}}})}};
  CHECK(pair(true, true)["allOf"][0]["oneOf"][0] == by_either);
  CHECK(pair(true, true)["properties"].contains("alpha"));
  // An alternative that is not there makes no rule.
  SchemaEntry lonely = entry("a", of_kind(ValueKind::text));
  lonely.alternative_entry = "gone";
  CHECK_FALSE(published(mapping({lonely})).contains("allOf"));
}

TEST_CASE("an alias that does not count is no property", "[studies][schema]") {
  SchemaEntry known = entry("preload", of_kind(ValueKind::text), true);
  known.alias = "force";
  const Json json = published(mapping({known}));
  CHECK(json["properties"].size() == 1);
  CHECK(json["required"] == Json::array({"preload"}));
  CHECK(json["additionalProperties"] == false);
}

TEST_CASE("a long piece that comes again is defined once and referred to", "[studies][schema]") {
  const Schema piece = of_kind(ValueKind::text, std::string(300, 'x'));
  Schema any = of_kind(ValueKind::any_of);
  any.alternatives = {piece, piece, of_kind(ValueKind::text)};
  const Json json = published(any);
  CHECK(json["anyOf"][0] == Json{{"$ref", "#/$defs/part1"}});
  CHECK(json["anyOf"][1] == json["anyOf"][0]);
  CHECK(json["anyOf"][2]["type"] == Json::array({"string", "number"}));
  CHECK(json["$defs"].size() == 1);
  CHECK(json["$defs"]["part1"]["description"] == std::string(300, 'x'));
  CHECK_FALSE(published(of_kind(ValueKind::text)).contains("$defs"));
}

TEST_CASE("one of several mappings needs the word that decides", "[studies][schema]") {
  Schema variant = of_kind(ValueKind::variant);
  variant.selector = "kind";
  variant.words = {"one", "two"};
  variant.alternatives = {mapping({entry("kind", of_kind(ValueKind::text))}), mapping({})};
  const Json json = published(variant);
  CHECK(json["required"] == Json::array({"kind"}));
  CHECK(json["oneOf"].size() == 2);
  CHECK(json["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(json["$id"] == "urn:t");
  CHECK(json["title"] == "T");
}

TEST_CASE("the table says a range in words", "[studies][schema]") {
  CHECK(value_cell(number(-kInfinity, kInfinity)) == "number");
  CHECK(value_cell(number(0, 2)) == "number, 0 to 2");
  CHECK(value_cell(number(0, 10, true)) == "number, more than 0 to 10");
  CHECK(value_cell(number(0.25, 1e17)) == "number, 0.25 to 1e+17");
  CHECK(value_cell(number(3, kInfinity)) == "number, at least 3");
  CHECK(value_cell(number(3, kInfinity, true)) == "number, more than 3");
  CHECK(value_cell(number(-kInfinity, 1.5)) == "number, at most 1.5");
  Schema inside = number(0, 1, true);
  CHECK(value_cell(inside) == "number, more than 0 to 1");  // 1 itself will do
  inside.max_excluded = true;
  CHECK(value_cell(inside) == "number, between 0 and 1");
  Schema count = of_kind(ValueKind::count);
  CHECK(value_cell(count) == "whole number");
  count.min = 2;
  CHECK(value_cell(count) == "whole number, at least 2");
}

TEST_CASE("the table says what kinds of values may stand there", "[studies][schema]") {
  CHECK(value_cell(of_kind(ValueKind::text)) == "text");
  Schema path = of_kind(ValueKind::text);
  path.example = "points.csv";
  CHECK(value_cell(path) == "`points.csv`");
  Schema word = of_kind(ValueKind::word);
  word.words = {"lhs", "sobol"};
  CHECK(value_cell(word) == "`lhs`, `sobol`");
  Schema one_of = of_kind(ValueKind::any_of);
  one_of.alternatives = {path, word};
  CHECK(value_cell(one_of) == "`points.csv` or `lhs`, `sobol`");
  Schema list = of_kind(ValueKind::list);
  list.items = {word};
  CHECK(value_cell(list) == "list: `lhs`, `sobol`");
  Schema named = of_kind(ValueKind::named);
  named.items = {list};
  CHECK(value_cell(named) == "by name: list: `lhs`, `sobol`");
  Schema variant = of_kind(ValueKind::variant);
  variant.selector = "kind";
  CHECK(value_cell(variant) == "mapping, by `kind`");
  Schema force = of_kind(ValueKind::quantity);
  force.unit = "N";
  force.example = "160 N";
  CHECK(value_cell(force) == "a force [N], `160 N`");
}

TEST_CASE("a mapping is one by parameter if every name of it has a symbol that counts",
          "[studies][schema]") {
  CHECK(value_cell(mapping({})) == "mapping");
  for (std::size_t size = 1; size <= 8; ++size) {
    std::vector<SchemaEntry> entries;
    for (std::size_t i = 0; i < size; ++i) {
      entries.push_back(entry("p" + std::to_string(i), number(0, 1)));
      entries.back().alias_counts = true;
    }
    CAPTURE(size);
    CHECK(value_cell(mapping(entries)) == "by parameter");
    // One row stands for all of them, of a sixth entry where there is one.
    const std::string table = markdown_table(mapping({entry("x", mapping(entries))}));
    CHECK(row(table, "x.NAME") ==
          "| `x.NAME` | value of the parameter |  | one parameter, by name or symbol |");
    for (std::size_t i = 0; i < size; ++i) {
      entries[i].alias_counts = false;
      CHECK(value_cell(mapping(entries)) == "mapping");
      entries[i].alias_counts = true;
    }
  }
}

TEST_CASE("the table says what is required, and which entry replaces which", "[studies][schema]") {
  SchemaEntry a = entry("a", of_kind(ValueKind::text, "this | that"), true);
  SchemaEntry b = entry("b", of_kind(ValueKind::text));
  SchemaEntry c = entry("c", of_kind(ValueKind::text), true);
  SchemaEntry d = entry("d", of_kind(ValueKind::text));
  a.alternative_entry = "b";
  b.alternative_entry = "a";
  d.fallback = "1000";
  const std::string table = markdown_table(mapping({a, b, c, d}));
  CHECK(row(table, "a") == "| `a` | text | required, or `b` | this \\| that |");
  CHECK(row(table, "b") == "| `b` | text | instead of `a` | a text |");
  CHECK(row(table, "c") == "| `c` | text | required | a text |");
  CHECK(row(table, "d") == "| `d` | text | 1000 | a text |");
}

TEST_CASE("within a parameter each entry keeps its own text", "[studies][schema]") {
  Schema low = number(0, 1);
  low.text = "smallest value";
  SchemaEntry preload =
      entry("preload", mapping({entry("min", low), entry("scale", number(0, 1))}));
  preload.alias_counts = true;
  const std::string table = markdown_table(mapping({entry("v", mapping({preload}))}));
  CHECK(row(table, "v.NAME.min") ==
        "| `v.NAME.min` | value of the parameter |  | smallest value |");
  CHECK(row(table, "v.NAME.scale") == "| `v.NAME.scale` | value of the parameter |  | a number |");
}

TEST_CASE("what lies within lists and alternatives has rows of its own", "[studies][schema]") {
  Schema list = of_kind(ValueKind::list);
  list.items = {mapping({entry("speed", of_kind(ValueKind::text))})};
  Schema variant = of_kind(ValueKind::variant);
  variant.selector = "kind";
  variant.words = {"one", "two"};
  variant.alternatives = {mapping({entry("kind", of_kind(ValueKind::text)),
                                   entry("x", of_kind(ValueKind::text, "of the first"))}),
                          mapping({entry("y", of_kind(ValueKind::text))})};
  Schema one_of = of_kind(ValueKind::any_of);
  one_of.alternatives = {of_kind(ValueKind::text),
                         mapping({entry("name", of_kind(ValueKind::text))})};
  const Schema options = mapping({entry("own", of_kind(ValueKind::text))});
  const std::string table = markdown_table(mapping(
      {entry("duty", list), entry("v", variant), entry("s", one_of), entry("options", options)}));
  CHECK_FALSE(row(table, "duty[].speed").empty());
  CHECK(row(table, "v.x") == "| `v.x` | text |  | `one`: of the first |");
  CHECK(row(table, "v.y") == "| `v.y` | text |  | `two`: a text |");
  CHECK(row(table, "v.kind").empty());  // said in the row of the whole
  CHECK_FALSE(row(table, "s.name").empty());
  CHECK_FALSE(row(table, "options").empty());
  CHECK(row(table, "options.own").empty());  // they have a page of their own
}
