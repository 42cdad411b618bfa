// SPDX-License-Identifier: Apache-2.0
#include "support/scratch_folder.hpp"

#include <twum/io/value_error.hpp>
#include <twum/studies/study_file.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace twum;
using namespace twum::studies;
namespace fs = std::filesystem;

namespace {

// A folder with ring-60.yaml in it, and study files written into it.
class Folder {
 public:
  Folder() {
    fs::copy_file(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml", scratch_.path("ring-60.yaml"));
  }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(scratch_.path(name), std::ios::binary) << text;
    return scratch_.path(name);
  }

 private:
  twum::test::ScratchFolder scratch_;
};

std::vector<fs::path> wrong_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(TWUM_TEST_DATA) / "study_errors")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("the file that init writes is valid for every kind of study", "[studies][study]") {
  const Folder folder;
  for (std::size_t i = 0; i < study_kinds().size(); ++i) {
    const auto kind = static_cast<StudyKind>(i);
    CAPTURE(to_string(kind));
    const StudyFile study = read_study_file(folder.write("study.yaml", study_template(kind)));
    CHECK(study.kind() == kind);
    CHECK(study.motor.name == "ring-60");
  }
}

TEST_CASE("overrides of the file come before those of the command line", "[studies][study]") {
  const Folder folder;
  const std::string path =
      folder.write("s.yaml",
                   "twum: 1\nmotor: ring-60.yaml\nset: {F_N: 140 N, h: 0.2 mm}\n"
                   "study: {kind: curve, family: {A: [1 um, 2 um]}}\n");
  const std::vector<std::string> settings{"preload=120 N"};
  const StudyFile study = read_study_file(path, settings);
  CHECK(study.motor.design.preload == 120);
  CHECK(study.motor.design.layer.thickness == 0.2e-3);
}

TEST_CASE("a study may hold its motor", "[studies][study]") {
  const Folder folder;
  std::string motor = read_source(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml").text();
  const StudyFile study =
      read_study_file(folder.write("s.yaml", motor + "\nstudy: {kind: curve}\n"));
  CHECK(study.motor.design.stator.modal_damping == 45);
}

TEST_CASE("every wrong study file is refused with place, entry, finding and remedy",
          "[studies][study][error]") {
  const auto files = wrong_files();
  REQUIRE(files.size() > 20);
  const fs::path before = fs::current_path();
  fs::current_path(fs::path(TWUM_TEST_DATA) / "study_errors");
  for (const fs::path& file : files) {
    CAPTURE(file);
    const std::string expected =
        read_source(fs::path(file).replace_extension(".txt").string()).text();
    try {
      read_study_file(file.filename().string());
      FAIL_CHECK("not refused");
    } catch (const FileError& error) {
      CHECK(error.what() + std::string("\n") == expected);
    }
  }
  fs::current_path(before);
}

TEST_CASE("a motor file is not taken for a study", "[studies][study][error]") {
  CHECK_THROWS_WITH(read_study_file(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml"),
                    Catch::Contains("expected a study file"));
}
