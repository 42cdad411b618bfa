// SPDX-License-Identifier: Apache-2.0
// Where in a tree something is wrong, and files to start from.
#include "support/file_text.hpp"
#include "support/scratch_folder.hpp"

#include <twum/io/csv.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/publish.hpp>
#include <twum/io/yaml_loader.hpp>

#include <catch2/catch.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

using namespace twum::io;
using namespace twum::test;

namespace {

using Lines = std::vector<std::string>;

// "line:column: entry: found" of everything that is wrong with a text.
Lines wrong(const std::string& text) {
  const Source source("text", text);
  Diagnostics diagnostics(source);
  load_yaml(diagnostics);
  Lines lines;
  try {
    diagnostics.throw_if_any();
  } catch (const FileError& error) {
    for (const Diagnostic& one : error.diagnostics())
      lines.push_back(std::to_string(one.mark.line) + ":" + std::to_string(one.mark.column) + ": " +
                      one.entry + ": " + one.found);
  }
  return lines;
}

}  // namespace

TEST_CASE("what is wrong in a tree is named by the way that leads there",
          "[studies][yaml][error]") {
  const std::string anchor = "an anchor (&)";
  CHECK(wrong("a: &x 1\n") == Lines{"1:4: a: " + anchor});
  CHECK(wrong("a: {b: &x 1}\n") == Lines{"1:8: a.b: " + anchor});
  CHECK(wrong("a: [1, &x 2]\n") == Lines{"1:8: a[1]: " + anchor});
  CHECK(wrong("a: [1, [2, 3, &x 4]]\n") == Lines{"1:15: a[1][2]: " + anchor});
  CHECK(wrong("a: [{b: 1}, {c: &x 2}]\n") == Lines{"1:17: a[1].c: " + anchor});
  CHECK(wrong("[1, &x 2]\n") == Lines{"1:5: [1]: " + anchor});
  CHECK(wrong("a: !tag 1\n").at(0).find("a: a tag (!tag)") != std::string::npos);
  CHECK(wrong("a: &x\nb: 2\n").size() == 1);
  CHECK(wrong("a: &x [1]\nb: {c: &y {}}\n").size() == 2);
  // After a letter of two bytes a column is still counted in characters.
  CHECK(wrong("\xC3\xA4: {b: &x 1}\n") == Lines{"1:8: \xC3\xA4.b: " + anchor});
}

TEST_CASE("a key is a word, and is there once", "[studies][yaml][error]") {
  CHECK(wrong("? [1]\n: 2\n") == Lines{"1:3: : a key that is a list"});
  CHECK(wrong("a: {? {b: 1} : 2}\n") == Lines{"1:7: a: a key that is a mapping"});
  CHECK(wrong("~: 2\n") == Lines{"1:1: : a key that is empty"});
  CHECK(wrong("<<: {a: 1}\n") == Lines{"1:1: : a merge key (<<)"});
  CHECK(wrong("a: 1\nb: 2\na: 3\n") == Lines{"3:1: a: given twice"});
  CHECK(wrong("x:\n  a: 1\n  a: 3\n") == Lines{"3:3: x.a: given twice"});
  // An alias is refused once, be it a value or a key.
  CHECK(wrong("a: &x 1\nb: *x\n") == Lines{"1:4: a: an anchor (&)", "2:4: b: an alias (*)"});
  CHECK(wrong("a: &x 1\n*x : 2\n").size() == 2);
}

TEST_CASE("a quotation that does not end is found where it begins", "[studies][yaml][error]") {
  CHECK(wrong("a: \"b\nc: 1\n").size() == 1);
  CHECK(wrong("a: \"b\\\"\nc: 1\n").size() == 1);
  CHECK(wrong("a: 'b\n") == Lines{"1:4: a: a quotation that does not end"});
  CHECK(wrong("a: 'it''s'\n").empty());
  CHECK(wrong("a: \"b \\\" c\"\n").empty());
  CHECK(wrong("a: b\"\n").empty());
}

TEST_CASE("a line ends with a line feed, with or without a return before it",
          "[studies][yaml][error]") {
  CHECK(wrong("a: 1\r\nb: 2\r\n").empty());
  CHECK(wrong("a: 1\rb: 2\n") == Lines{"1:5: : a control character"});
  CHECK(wrong("a: 1\r") == Lines{"1:5: : a control character"});
  CHECK(wrong("a: \x7F\n") == Lines{"1:4: : a control character"});
  CHECK(wrong("a: 1\nb: \xFF\n") == Lines{"2:4: : a byte that is not UTF-8"});
  CHECK(wrong("") == Lines{"1:1: : an empty file"});
  CHECK(wrong("a: 1\n---\nb: 2\n") == Lines{"2:1: : more text after the end of the document"});
  CHECK(wrong("a:\n\tb: 1\n") == Lines{"2:1: : a tab in the indentation"});
}

TEST_CASE("comments of a file to start from stand below each other, or right after a long line",
          "[studies][schema]") {
  Schema whole;
  whole.kind = ValueKind::mapping;
  for (const char* name : {"short", "an_entry_with_a_name_that_is_longer_than_most"}) {
    SchemaEntry& entry = whole.entries.own().emplace_back();
    entry.name = name;
    entry.required = true;
    entry.schema.example = "1";
    entry.schema.text = "what it is";
  }
  CHECK(yaml_template(whole, "# A file.\n") ==
        "# A file.\n"
        "short: 1                            # what it is\n"
        "an_entry_with_a_name_that_is_longer_than_most: 1 # what it is\n");
}

TEST_CASE("a table is read to the end of its file", "[studies][csv]") {
  const ScratchFolder folder;
  write(folder.path("t.csv"), "a,b\n1,2\n\n3,4");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(folder.path("t.csv").c_str(), "rb"), &std::fclose);
  REQUIRE(file);
  CsvReader reader("t.csv", bytes_of(file.get(), "t.csv"));
  CsvChunk chunk;
  REQUIRE(reader.read(chunk, 100));
  REQUIRE(chunk.records.size() == 3);
  CHECK(chunk.record(2) == "3,4");
  CHECK(chunk.records[2].line == 4);
  CHECK(reader.bytes_taken() == 12);
  CHECK_FALSE(reader.read(chunk, 100));
}
