// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/run_study.hpp>

#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <twum/io/result_store.hpp>
#include <twum/motors/reasons.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

using namespace twum::studies;
using twum::test::ScratchFolder;

namespace {

// A grid of two preloads and three amplitudes; every default in it is that of the schema.
constexpr const char* kGrid = R"text(
  kind: sweep
  variables:
    F_N: [100 N, 200 N]
    amplitude: {min: 1 um, max: 2 um, points: 3}
  sampling: grid
  metrics: [stall_torque, preload]
)text";

std::string write_study(const ScratchFolder& folder, const std::string& study,
                        const std::string& name = "grid.yaml") {
  std::ofstream(folder.path(name))
      << "twum: 1\nmotor: " << twum::test::motor_path("ring-60") << "\nstudy:" << study;
  return folder.path(name);
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string without_times(const std::string& summary) {
  return std::regex_replace(summary, std::regex("  \"(seconds|started)\": .*\n"), "");
}

RunOptions with_jobs(unsigned jobs) {
  RunOptions options;
  options.jobs = jobs;
  return options;
}

}  // namespace

TEST_CASE("a run in memory and one in a directory answer the same", "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = read_study_file(write_study(folder, kGrid));
  const StudyResult kept = run_study(file, folder.path("out"));
  const StudyResult fleeting = run_study(file, with_jobs(1));
  CHECK(without_times(summary_json(kept)) == without_times(summary_json(fleeting)));
  CHECK(without_times(content(folder.path("out/summary.json"))) ==
        without_times(summary_json(fleeting)));
  CHECK(kept.study == "grid");
  CHECK(kept.outcome == "done");
  CHECK(kept.evaluations == 6);
}

TEST_CASE("the table of results is in SI and in the order of the designs", "[studies][run]") {
  const ScratchFolder folder;
  run_study(read_study_file(write_study(folder, kGrid)), folder.path("out"));
  std::istringstream table(content(folder.path("out/results.csv")));
  std::string line;
  REQUIRE(std::getline(table, line));
  CHECK(line == "preload [N],amplitude [m],stall_torque [N.m],preload [N],status");
  std::size_t rows = 0;
  for (; std::getline(table, line); ++rows) {
    const bool first_half = line.starts_with("100,");
    CHECK((first_half || line.starts_with("200,")));
    CHECK(line.ends_with(first_half ? ",100,ok" : ",200,ok"));
  }
  CHECK(rows == 6);
}

TEST_CASE("a study that was resolved stays as it is when it is resolved again", "[studies][run]") {
  const ScratchFolder folder;
  const StudyResult first =
      run_study(read_study_file(write_study(folder, kGrid)), folder.path("out"));
  const std::string resolved = content(folder.path("out/study.yaml"));
  const StudyResult again =
      run_study(read_study_file(folder.path("out/study.yaml")), folder.path("again"));
  CHECK(again.hash == first.hash);
  // All but the name in the comment above it.
  const std::string other = content(folder.path("again/study.yaml"));
  CHECK(resolved.substr(resolved.find("twum: 1")) == other.substr(other.find("twum: 1")));
  CHECK(content(folder.path("again/results.csv")) == content(folder.path("out/results.csv")));
}

TEST_CASE("the resolved file of every kind is valid and keeps its hash", "[studies][run]") {
  const ScratchFolder folder;
  for (const char* points : {"points.csv"}) {
    std::ofstream data(folder.path(points));
    data << "speed [rpm],torque [N.m]\n";
    for (int i = 0; i < 8; ++i) data << 10 * i << "," << 0.8 - 0.05 * i << "\n";
  }
  for (const std::string motor : {"ring-60", "drive-60", "warm-60", "worn-60", "moving-60"})
    std::filesystem::copy_file(twum::test::motor_path(motor), folder.path(motor + ".yaml"));
  for (const std::string_view kind : study_kinds()) {
    CAPTURE(kind);
    const std::string path = folder.path(std::string(kind) + ".yaml");
    // A sweep needs a voltage, temperatures and lives the blocks of their motors, a motion an inertia.
    const std::string motor = kind == FrequencyStudy::kName ? "drive-60"
                              : kind == HeatStudy::kName    ? "warm-60"
                              : kind == LifeStudy::kName    ? "worn-60"
                              : kind == MotionStudy::kName  ? "moving-60"
                                                            : "ring-60";
    std::ofstream(path) << study_template(*find_study_kind(kind), motor + ".yaml");
    // Asked to stop at once: a directory with the resolved study and hardly a row.
    std::stop_source stop;
    stop.request_stop();
    RunOptions options;
    options.stop = stop.get_token();
    const StudyResult first = run_study(read_study_file(path), folder.path("out"), options);
    CHECK(first.outcome == "interrupted");
    const StudyResult again =
        run_study(read_study_file(folder.path("out/study.yaml")), folder.path("again"), options);
    CHECK(again.hash == first.hash);
    for (const char* name : {"out", "again"}) std::filesystem::remove_all(folder.path(name));
  }
}

TEST_CASE("a study that was asked to stop goes on to the same bytes", "[studies][run]") {
  const ScratchFolder folder;
  const std::string study = R"text(
  kind: sweep
  variables: {preload: {min: 60 N, max: 300 N}}
  sampling: lhs
  samples: 3000
  metrics: [stall_torque, peak_power]
)text";
  const StudyFile file = read_study_file(write_study(folder, study));
  run_study(file, folder.path("peace"));
  std::stop_source stop;
  RunOptions options = with_jobs(2);
  options.stop = stop.get_token();
  options.progress = [&](const RunProgress& now) {
    CHECK(now.done <= now.total);
    CHECK_FALSE(now.budget);
    if (now.done > 700) stop.request_stop();
  };
  const StudyResult part = run_study(file, folder.path("out"), options);
  CHECK(part.outcome == "interrupted");
  CHECK(part.evaluations > 0);
  CHECK(part.evaluations < 3000);
  const StudyResult whole = run_study(file, folder.path("out"), with_jobs(8));
  CHECK(whole.outcome == "done");
  CHECK_FALSE(whole.was_complete);
  CHECK(content(folder.path("out/results.csv")) == content(folder.path("peace/results.csv")));
  CHECK(without_times(content(folder.path("out/summary.json"))) ==
        without_times(content(folder.path("peace/summary.json"))));
  CHECK(run_study(file, folder.path("out")).was_complete);
}

TEST_CASE("a directory of another study is refused with what differs", "[studies][run]") {
  const ScratchFolder folder;
  run_study(read_study_file(write_study(folder, kGrid)), folder.path("out"));
  const std::vector<std::string> settings{"thickness=0.2 mm"};
  CHECK_THROWS_WITH(
      run_study(read_study_file(folder.path("grid.yaml"), settings), folder.path("out")),
      Catch::Contains("motor.contact_layer.thickness: '3e-04 m' there, '2e-04 m' here") &&
          Catch::Contains("--fresh"));
  RunOptions fresh;
  fresh.fresh = true;
  CHECK(run_study(read_study_file(folder.path("grid.yaml"), settings), folder.path("out"), fresh)
            .outcome == "done");
}

TEST_CASE("the content of a file that the study names belongs to the study", "[studies][run]") {
  const ScratchFolder folder;
  const auto write_data = [&](double last) {
    std::ofstream data(folder.path("points.csv"));
    data << "speed [rpm],torque [N.m]\n0,0.8\n20,0.75\n40,0.6\n60,0.4\n80," << last << "\n";
  };
  const std::string path = write_study(folder, R"text(
  kind: calibrate
  data: points.csv
  variables: {kinetic_friction: {min: 0.05, max: 0.5}}
  starts: 2
)text");
  write_data(0.1);
  run_study(read_study_file(path), folder.path("out"));
  write_data(0.2);
  CHECK_THROWS_WITH(run_study(read_study_file(path), folder.path("out")),
                    Catch::Contains("content of a file"));
  write_data(0.1);
  CHECK(run_study(read_study_file(path), folder.path("out")).was_complete);
}

TEST_CASE("a study left before its first row makes way for another one", "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = read_study_file(write_study(folder, kGrid));
  std::filesystem::create_directory(folder.path("out"));
  {
    ResultStore store(folder.path("out/results.db"), {{"x", "1"}});
    store.set_fact("study", "kind: curve");
    store.set_fact("hash", "of another study");
  }
  std::ofstream(folder.path("out/study.yaml")) << "kind: curve\n";
  CHECK(run_study(file, folder.path("out")).evaluations == 6);
  CHECK(content(folder.path("out/study.yaml")).find("kind: sweep") != std::string::npos);
}

TEST_CASE("the page knows what reasons for missing answers mean", "[studies][run]") {
  const ScratchFolder folder;
  run_study(read_study_file(write_study(folder, kGrid)), folder.path("out"));
  for (const Reason& reason : reasons()) {
    const std::string entry =
        std::string("\"") + twum::to_string(reason.status) + "\":\"" + reason.meaning + "\"";
    CHECK(content(folder.path("out/report.html")).find(entry) != std::string::npos);
  }
}

TEST_CASE("a database left before its first fact is begun anew", "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = read_study_file(write_study(folder, kGrid));
  std::filesystem::create_directory(folder.path("out"));
  SECTION("without any content") { std::ofstream(folder.path("out/results.db")); }
  SECTION("with tables") { const ResultStore store(folder.path("out/results.db"), {{"x", "1"}}); }
  CHECK(run_study(file, folder.path("out")).evaluations == 6);
}
