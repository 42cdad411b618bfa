// SPDX-License-Identifier: Apache-2.0
#include <twum/io/words.hpp>
#include <twum/motors/reasons.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
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

TEST_CASE("a limit stops the counting of edits and changes none below it", "[studies][text]") {
  std::mt19937 random(1);
  const auto word = [&] {
    std::string letters(random() % 12, 'a');
    for (char& letter : letters) letter = static_cast<char>('a' + random() % 3);
    return letters;
  };
  std::array<int, 13> seen{};
  for (int i = 0; i < 3000; ++i) {
    const std::string a = word();
    const std::string b = word();
    const int distance = edit_distance(a, b, 12);  // no word is longer, so nothing is cut off
    CAPTURE(a, b, distance);
    CHECK((distance == 0) == (a == b));
    CHECK(edit_distance(b, a, 12) == distance);
    for (int limit = 0; limit < 12; ++limit)
      CHECK(edit_distance(a, b, limit) == std::min(distance, limit + 1));
    ++seen.at(static_cast<std::size_t>(distance));
  }
  CHECK(*std::min_element(seen.begin(), seen.begin() + 8) > 0);
}

TEST_CASE(
    "the beginning of a name is enough if it is a word or more than half, and no other has it",
    "[studies][text]") {
  const std::array<std::string_view, 4> names{"neutral_plane_distance", "contact_radius",
                                              "contact_width", "static_friction"};
  CHECK(nearest("neutral_plane_dist", names) == "neutral_plane_distance");
  CHECK(nearest("neutral", names) == "neutral_plane_distance");
  CHECK(nearest("neut", names).empty());
  CHECK(nearest("contact", names).empty());
  CHECK(nearest("contact_", names).empty());
  CHECK(nearest("contact_wi", names) == "contact_width");
}

TEST_CASE("things are counted in the singular and the plural", "[studies][text]") {
  CHECK(counted(0, "row") == "0 rows");
  CHECK(counted(1, "row") == "1 row");
  CHECK(counted(2, "row") == "2 rows");
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

TEST_CASE("every reason for a missing answer is explained, in the guide with the same words",
          "[studies][text]") {
  using twum::MetricStatus;
  std::ostringstream guide;
  guide << std::ifstream(TWUM_SOURCE_DIR "/docs/guide/results.md").rdbuf();
  auto expected = static_cast<unsigned>(MetricStatus::ok);
  for (const Reason& reason : reasons()) {
    CHECK(static_cast<unsigned>(reason.status) == ++expected);
    const std::string row =
        "| `" + std::string(to_string(reason.status)) + "` | " + reason.meaning + " |";
    CAPTURE(row);
    CHECK(guide.str().find(row) != std::string::npos);
  }
  CHECK(expected == static_cast<unsigned>(MetricStatus::wear_localizes));  // the last there is
}
