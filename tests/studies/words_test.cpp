// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/text/words.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace twum::studies;

TEST_CASE("edit distance counts insertions, deletions, replacements and swaps", "[studies][text]") {
  CHECK(edit_distance("preload", "preload", 2) == 0);
  CHECK(edit_distance("preload", "prelod", 2) == 1);
  CHECK(edit_distance("preload", "preloda", 2) == 1);
  CHECK(edit_distance("preload", "preloads", 2) == 1);
  CHECK(edit_distance("preload", "freeload", 2) == 2);
  CHECK(edit_distance("preload", "thickness", 2) == 3);
  CHECK(edit_distance(std::string(1000, 'a'), "a", 2) == 3);
}

TEST_CASE("only near words are suggested", "[studies][text]") {
  const std::array<std::string_view, 3> names{"thickness", "preload", "E"};
  CHECK(nearest("thicknes", names) == "thickness");
  CHECK(nearest("THICKNESS", names) == "thickness");
  CHECK(nearest("e", names) == "E");
  CHECK(nearest("q", names).empty());
  CHECK(nearest("torque", names).empty());
  CHECK(did_you_mean("prelaod", names) == "did you mean 'preload'?");
  CHECK(did_you_mean("torque", names) == "expected one of thickness, preload, E");
}

TEST_CASE("what a user typed is safe to print", "[studies][text]") {
  CHECK(printable("µm\x1b[31m") == "µm\\x1b[31m");
  CHECK(printable("a\xff"
                  "b") == "a\\xffb");
  CHECK(printable("\xC2\x9B") == "\\xc2\\x9b");  // a control character beyond ASCII
  const std::vector<char> cut{'a', '\xC2'};  // a character without its end, and nothing behind it
  CHECK(printable({cut.data(), cut.size()}) == "a\\xc2");
  CHECK(printable("abcdef", 3) == "abc...");
  CHECK(quoted("it's") == "'it's'");
}

TEST_CASE("a list is split at commas outside parentheses", "[studies][text]") {
  using List = std::vector<std::string_view>;
  CHECK(split_list("a, b(1, 2) ,c") == List{"a", "b(1, 2)", "c"});
  CHECK(split_list("") == List{""});
  CHECK(split_list("a,,b") == List{"a", "", "b"});
  CHECK(split_list("a), b") == List{"a)", "b"});
}
