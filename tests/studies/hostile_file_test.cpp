// SPDX-License-Identifier: Apache-2.0
// Files that were not written to be motor files: nothing but a FileError may come of them.
#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/motor/motor_file.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <random>

using namespace twum::studies;

namespace {

std::string example() {
  return read_source(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml").text();
}

// "" if the text is a motor file, else the first line of the error.
std::string outcome(const std::string& text) {
  try {
    read_motor(Source("m.yaml", text));
    return "";
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(0, what.find('\n'));
  }
}

}  // namespace

TEST_CASE("bytes that are no text are refused where they stand", "[studies][yaml][error]") {
  using namespace std::string_literals;
  CHECK(outcome("a: x\0y\n"s) == "m.yaml:1:5: a control character; a file is UTF-8 text");
  CHECK(outcome("a: 1\nµ: \x1b[0m\n") == "m.yaml:2:4: a control character; a file is UTF-8 text");
  CHECK(outcome("a: \xff\n") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xC0\x80\n") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xED\xA0\x80\n") ==
        "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xF0\x9F\x98") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("\xFF\xFEt\0w\0"s) == "m.yaml:1:1: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: 1\rb: 2\r") == "m.yaml:1:5: a control character; a file is UTF-8 text");
  CHECK(outcome("a: 😀 b: c\n") ==
        "m.yaml:1:7: a ':' that cannot stand here; check the indentation, and put a blank after "
        "the ':' of each entry");
}

TEST_CASE("deep and wide files are refused at once", "[studies][yaml][error]") {
  const auto begin = std::chrono::steady_clock::now();
  const std::string brackets(1000000, '[');
  CHECK(outcome("motor: " + brackets).find("nested more than") != std::string::npos);
  std::string block;
  for (int i = 0; i < 100000; ++i) block += "- ";
  CHECK(outcome(block).find("nested more than") != std::string::npos);
  std::string wide = "motor: [";
  for (int i = 0; i < 200000; ++i) wide += "1, ";
  CHECK(outcome(wide + "1]\n").find("missing") != std::string::npos);
  std::string keys;
  for (int i = 0; i < 50000; ++i) keys += "key" + std::to_string(i) + ": 1\n";
  CHECK(outcome(keys).find("unknown entry") != std::string::npos);
  std::string words = "motor: ";
  for (int i = 0; i < 500000; ++i) words += "word ";
  CHECK(!outcome(words).empty());
  // Each is linear in its size and takes a second at most; a quadratic one would take an hour.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::minutes(2));
}

TEST_CASE("mutilated motor files give a FileError or a motor, never anything else",
          "[studies][yaml][property]") {
  const std::string good = example();
  const std::string alphabet = "{}[]:,-?&*!|>'\"%@`#\n\t \r~<.0123456789eE+_azNm\xC2\xB5\xff";
  std::mt19937 random(42);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = good;
    for (std::size_t change = 0; change < 1 + below(4); ++change) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0: text.erase(at, 1 + below(20)); break;
        case 1: text.insert(at, 1, alphabet[below(alphabet.size())]); break;
        case 2: text[at] = alphabet[below(alphabet.size())]; break;
        default: text.insert(at, text.substr(below(text.size()), below(60))); break;
      }
    }
    CAPTURE(text);
    refused += outcome(text).empty() ? 0 : 1;
  }
  CHECK(refused > 1000);
}
