// SPDX-License-Identifier: Apache-2.0
// Pairs in tests/data/motor_errors: a wrong motor file, and beside it the whole text of the error.
#include <twum/io/diagnostics.hpp>
#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace twum::studies;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> wrong_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(TWUM_TEST_DATA) / "motor_errors")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("every wrong motor file is refused with place, entry, finding and remedy",
          "[studies][motor][error]") {
  const auto files = wrong_files();
  REQUIRE(files.size() > 70);
  for (const fs::path& file : files) {
    CAPTURE(file);
    const std::string expected =
        read_source(fs::path(file).replace_extension(".txt").string()).text();
    const Source source(file.filename().string(), read_source(file.string()).text());
    try {
      read_motor(source);
      FAIL_CHECK("not refused");
    } catch (const FileError& error) {
      CHECK(error.what() + std::string("\n") == expected);
      CHECK(!error.diagnostics().empty());
    }
  }
}
