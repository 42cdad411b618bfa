// SPDX-License-Identifier: Apache-2.0
// Studies with every default written out, and in what two of them differ.
#include "entries/resolved_study.hpp"
#include "entries_support.hpp"

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/run_study.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

std::string entry(const ResolvedStudy& study, const std::string& name) {
  const YamlNode* node = study.study.find(name);
  return node == nullptr ? "(none)" : node->scalar;
}

constexpr const char* kBox = "variables: {preload: {min: 100 N, max: 200 N}}";

}  // namespace

TEST_CASE("a default that holds for some words only is written out for these", "[studies][run]") {
  const ScratchFolder folder;
  const auto resolved = [&](const std::string& study) { return resolve(study_in(folder, study)); };
  const auto samples = [&](const std::string& sampling) {
    return entry(resolved("{kind: sweep, metrics: [stall_torque], sampling: " + sampling + ", " +
                          kBox + "}"),
                 "samples");
  };
  CHECK(samples("lhs") == "1000");
  CHECK(samples("sobol") == "1000");
  CHECK(samples("grid") == "(none)");
}

TEST_CASE("a default that is words stays unsaid", "[studies][run]") {
  const ScratchFolder folder;
  const ResolvedStudy resolved = resolve(
      study_in(folder, std::string("{kind: optimize, maximize: peak_power, ") + kBox + "}"));
  CHECK(entry(resolved, "constraints") == "(none)");  // "none"
  CHECK(entry(resolved, "start") == "(none)");        // "the motor as it is"
  CHECK(entry(resolved, "minimize") == "(none)");
}

TEST_CASE("a solver by its name becomes one with all its options", "[studies][run]") {
  const ScratchFolder folder;
  const auto solver = [&](const std::string& text) {
    const ResolvedStudy resolved =
        resolve(study_in(folder, std::string("{kind: optimize, maximize: peak_power, ") + kBox +
                                     ", solver: " + text + "}"));
    return *resolved.study.find("solver");
  };
  const YamlNode by_name = solver("nlopt:slsqp");
  const YamlNode by_mapping = solver("{name: nlopt:slsqp}");
  for (const char* option : {"name", "starts", "tolerance", "max_evaluations", "seed"}) {
    CAPTURE(option);
    REQUIRE(by_name.find(option) != nullptr);
    REQUIRE(by_mapping.find(option) != nullptr);
    CHECK(by_name.find(option)->scalar == by_mapping.find(option)->scalar);
  }
  CHECK(by_name.find("name")->scalar == "nlopt:slsqp");
  CHECK(by_name.find("starts")->scalar == "8");
  CHECK(solver("{starts: 3}").find("starts")->scalar == "3");
  CHECK(solver("{starts: 3}").find("name")->scalar == "auto");
}

TEST_CASE("symbols and names of parameters are one study", "[studies][run]") {
  const ScratchFolder folder;
  const auto hash = [&](const std::string& name) {
    return resolve(study_in(folder,
                            "{kind: sweep, sampling: grid, metrics: [stall_torque], "
                            "variables: {" +
                                name + ": [100 N, 120 N]}}"))
        .hash();
  };
  CHECK(hash("F_N") == hash("preload"));
}

TEST_CASE("the study knows what a file it names holds, not where it lies", "[studies][run]") {
  const ScratchFolder folder;
  const std::string points = "speed [rpm],torque [N.m]\n1,0.8\n2,0.8\n";
  const auto study = [&](const std::string& data) {
    return study_in(
        folder, "{kind: calibrate, variables: {kinetic_friction: {min: 0.1, max: 0.3}}, data: " +
                    data + "}");
  };
  write(folder.path("points.csv"), points);
  write(folder.path("same.csv"), points);
  write(folder.path("other.csv"), points + "3,0.7\n");
  CHECK(resolve(study("points.csv")).hash() == resolve(study("same.csv")).hash());
  CHECK(resolve(study("points.csv")).hash() != resolve(study("other.csv")).hash());
  CHECK_THROWS_WITH(resolve(study("none.csv")), Contains("none.csv: cannot be read"));
  std::filesystem::create_directory(folder.path("folder.csv"));
  CHECK_THROWS_WITH(resolve(study("folder.csv")), Contains("folder.csv: cannot be read"));
  // A directory of results names its copy.
  CHECK_THAT(resolve(study("points.csv")).text(folder.path("out")),
             Contains("data: inputs/points.csv\n"));
}

TEST_CASE("files of one name have copies of their own, and one that is too large has none",
          "[studies][run]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("other"));
  const std::string points = "speed [rpm],torque [N.m]\n20,0.8\n100,0.8\n";
  write(folder.path("points.csv"), points);
  write(folder.path("other/points.csv"),
        "#" + std::string(9'999'999 - points.size() - 1, 'x') + "\n" + points);
  const auto study = [&] {
    return study_in(folder, std::string("{kind: calibrate, ") + kBox +
                                ", data: [points.csv, other/points.csv]}");
  };
  std::string text = resolve(study()).text(folder.path("out"));
  CHECK_THAT(text, Contains("inputs/points.csv") && Contains("inputs/2/points.csv"));
  write(folder.path("other/points.csv"),
        "#" + std::string(10'000'000 - points.size() - 1, 'x') + "\n" + points);
  text = resolve(study()).text(folder.path("out"));
  CHECK_THAT(text, Contains("inputs/points.csv") && Contains("../other/points.csv"));
}

TEST_CASE("of an earlier result all but the time of its run counts", "[studies][run]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("first"));
  const auto hash = [&](const std::string& summary) {
    write(folder.path("first/summary.json"), summary);
    return resolve(study_in(folder, std::string("{kind: optimize, maximize: peak_power, ") + kBox +
                                        ", start: first}"))
        .hash();
  };
  const std::string design = R"("best": {"design": {"preload": 150}})";
  const std::string one = hash("{" + design + "}");
  CHECK(hash(R"({"started": "2026-01-01T00:00:00Z", "seconds": 3.5, )" + design + "}") == one);
  CHECK(hash(R"({"best": {"design": {"preload": 151}}})") != one);
  CHECK(hash("no JSON at all") != one);  // its maker says what is wrong with it
}

TEST_CASE("two studies differ in what one line for each entry says", "[studies][run]") {
  const auto lines = [](const std::string& a, const std::string& b) { return differences(a, b); };
  using Lines = std::vector<std::string>;
  CHECK(lines("a: 1\nb: {c: 2 N}\n", "a: 1\nb: {c: 2 N}\n").empty());
  CHECK(lines("b: {c: 2 N}\n", "b: {c: 3 N}\n") == Lines{"b.c: '2 N' there, '3 N' here"});
  CHECK(lines("a: 1\n", "b: 1\n") ==
        Lines{"a: '1' there, nothing here", "b: nothing there, '1' here"});
  CHECK(lines("a: [1, {x: 2}]\n", "a: [1, {x: 3}, 4]\n") ==
        Lines{"a[1].x: '2' there, '3' here", "a[2]: nothing there, '4' here"});
}

TEST_CASE("a directory of another study names the first differences and counts the others",
          "[studies][run]") {
  const ScratchFolder folder;
  const auto grid = [&](const std::string& preload) {
    return study_in(folder,
                    "{kind: sweep, sampling: grid, metrics: [stall_torque], variables: "
                    "{preload: [" +
                        preload + "]}}");
  };
  run_study(grid("101 N, 102 N"), folder.path("out"));
  // Nine more values, of which eight are shown.
  std::string text;
  try {
    run_study(grid("101 N, 102 N, 103 N, 104 N, 105 N, 106 N, 107 N, 108 N, 109 N, 110 N, 111 N"),
              folder.path("out"));
  } catch (const InputError& error) {
    text = error.what();
  }
  CHECK_THAT(text, Contains("study.variables.preload[2]: nothing there, '103 N' here"));
  CHECK_THAT(text, Contains("\n  and 1 more\n"));
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = text.find("\n  study.", at)) != std::string::npos; ++at) ++lines;
  CHECK(lines == 8);
}

TEST_CASE("a directory of another version of the program is refused", "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = study_in(folder,
                                  "{kind: sweep, sampling: grid, metrics: [stall_torque], "
                                  "variables: {preload: [100 N]}}");
  run_study(file, folder.path("out"));
  ResultStore(folder.path("out/results.db")).set_fact("version", "0.0.1");
  CHECK_THROWS_WITH(run_study(file, folder.path("out")),
                    Contains("twum: 0.0.1 there, " + std::string(version()) + " here"));
}

// 1e-9 is far above the rounding that another compiler may leave, and far below what a reader of the table would see.
TEST_CASE("rows of a program that computes other numbers are refused", "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = study_in(folder,
                                  "{kind: sweep, sampling: grid, metrics: [stall_torque], "
                                  "variables: {preload: [100 N, 110 N]}}");
  run_study(file, folder.path("out"));
  std::filesystem::create_directory(folder.path("other"));
  {
    const ResultStore ours(folder.path("out/results.db"));
    ResultStore theirs(folder.path("other/results.db"), ours.columns());
    for (const char* fact : {"version", "study", "files", "started", "hash"})
      theirs.set_fact(fact, ours.fact(fact));
    ours.read([&](const StoredRow& row) {
      StoredRow other = row;
      if (row.index == 1) other.values.back() *= 1 + 1e-9;
      theirs.add(other);
    });
  }
  CHECK_THROWS_WITH(run_study(file, folder.path("other")),
                    Contains("row 1: stall_torque is") && Contains("--fresh"));
}

TEST_CASE("a study that came from standard input is called study", "[studies][run]") {
  const ScratchFolder folder;
  StudyFile file = study_in(folder,
                            "{kind: sweep, sampling: grid, metrics: [stall_torque], variables: "
                            "{preload: [100 N]}}");
  const auto name = [&](const std::string& path) {
    file.path = path;
    return run_study(file).study;
  };
  CHECK(name("-") == "study");
  CHECK(name("") == "study");
  CHECK(name("folder.of/ring.grid.yaml") == "ring.grid");
}
