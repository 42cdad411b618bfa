// SPDX-License-Identifier: Apache-2.0
// The corpus of the fuzzers, and every example and wrong file of the tests, through the readers once.
#include "fuzz/targets.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using twum::fuzz::Target;
using twum::fuzz::targets;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders_of(std::string_view target) {
  std::vector<fs::path> folders{fs::path(TWUM_SOURCE_DIR) / "tests/fuzz/corpus" / target};
  if (target == "motor") {
    folders.emplace_back(TWUM_SOURCE_DIR "/examples/motors");
    folders.emplace_back(TWUM_TEST_DATA "/motor_errors");
  }
  if (target == "study") {
    folders.emplace_back(TWUM_SOURCE_DIR "/examples/studies");
    folders.emplace_back(TWUM_TEST_DATA "/study_errors");
  }
  return folders;
}

std::vector<fs::path> files_of(std::string_view target) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders_of(target)) {
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// One small change at a random place.
void mutate(std::string& text, std::mt19937& random) {
  const auto below = [&](std::size_t limit) { return random() % limit; };
  const std::size_t at = below(text.size() + 1);
  switch (below(4)) {
    case 0: text.erase(at, 1 + below(8)); break;
    case 1: text.insert(at, 1, static_cast<char>(below(256))); break;
    case 2: text.insert(at, text.substr(below(text.size() + 1), below(30))); break;
    default: text.insert(at, "0"); break;
  }
}

}  // namespace

TEST_CASE("readers keep their laws on the corpus", "[fuzz]") {
  for (const Target& target : targets()) {
    const auto files = files_of(target.name);
    REQUIRE(files.size() > 5);
    for (const fs::path& file : files) {
      CAPTURE(target.name, file);
      CHECK_NOTHROW(target.feed(content(file)));
    }
  }
}

TEST_CASE("readers keep their laws on changed files of the corpus", "[fuzz]") {
  std::mt19937 random(42);
  for (const Target& target : targets()) {
    for (const fs::path& file : files_of(target.name)) {
      for (int round = 0; round < 20; ++round) {
        std::string text = content(file);
        for (int changes = 0; changes <= round % 3; ++changes) mutate(text, random);
        CAPTURE(target.name, file, text);
        CHECK_NOTHROW(target.feed(text));
      }
    }
  }
}
