// SPDX-License-Identifier: Apache-2.0
#include "support/scratch_folder.hpp"

#include <twum/studies/metrics/constraint.hpp>
#include <twum/studies/study/study_file.hpp>
#include <twum/studies/text/value_error.hpp>

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

TEST_CASE("a constraint limits a metric or a parameter in its own unit", "[studies][metrics]") {
  const Constraint wear = parse_constraint(" wear_intensity_at(80 rpm) <= 5 kW/m^2 ");
  CHECK(wear.limit == 5000);
  CHECK_FALSE(wear.at_least);
  CHECK(wear.text == "wear_intensity_at(80 rpm) <= 5 kW/m^2");
  CHECK(parse_constraint("preload>=60 N").at_least);
  CHECK(parse_constraint("contact_ratio <= 0.3").limit == 0.3);
}

TEST_CASE("a wrong constraint says where, what and what would be right",
          "[studies][metrics][error]") {
  const auto complaint = [](const char* text) -> std::string {
    try {
      parse_constraint(text);
      return "";
    } catch (const ValueError& error) {
      return std::to_string(error.position()) + ": " + error.what();
    }
  };
  CHECK(complaint("stall_torque") ==
        "12: 'stall_torque' limits nothing; expected a limit such as 'stall_torque >= 0.8 N.m'");
  CHECK(complaint("stall_torque > 1 N.m") ==
        "13: 'stall_torque > 1 N.m' compares with '>'; only '>=' and '<=' are known");
  CHECK(complaint("stall_torque = 1 N.m") ==
        "13: 'stall_torque = 1 N.m' compares with '='; only '>=' and '<=' are known");
  CHECK(complaint("stall_torque >= 1 N") == "18: '1 N' is a force [N]; expected a torque [N.m]");
  CHECK(complaint("stal_torque >= 1 N.m") ==
        "0: unknown metric 'stal_torque'; did you mean 'stall_torque'?");
  CHECK(complaint("stall_torque >=") == "15: nothing; expected a torque [N.m]");
  CHECK(complaint(">= 1 N.m") ==
        "0: nothing; expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'");
}
