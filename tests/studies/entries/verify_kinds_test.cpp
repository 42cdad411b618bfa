// SPDX-License-Identifier: Apache-2.0
// Every kind of study is computed again from its directory alone, and damage there is noticed.
#include "entries_support.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/verify_study.hpp>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace fs = std::filesystem;

// Points of the elastic layer on its plateau: mu F_N r = 0.2 * 160 N * 0.0265 m, a little off.
constexpr const char* kPoints = "speed [rpm],torque [N.m]\n1,0.849\n2,0.847\n3,0.848\n4,0.8475\n";

struct Finished {
  ScratchFolder folder;
  StudyResult result;

  explicit Finished(const std::string& study, const std::string& motor = "elastic-layer") {
    write(folder.path("points.csv"), kPoints);
    result = run_study(study_in(folder, study, motor), out());
  }
  std::string out() const { return folder.path("out"); }
  std::string out(const std::string& name) const { return folder.path("out/" + name); }
};

void check_all_holds(const Finished& one) {
  const Verification found = verify_study(one.out());
  CAPTURE(found.complaints);
  CHECK(found.holds());
  CHECK(found.rows == one.result.evaluations);
  CHECK(found.rows_checked == std::min<std::uint64_t>(found.rows, 1000));
  CHECK(found.rows_skipped == 0);
  CHECK(found.deviation == 0);  // the same program: to the bit
  CHECK(found.answer_checked);
}

constexpr const char* kOptimize =
    "{kind: optimize, maximize: stall_torque, constraints: [preload <= 120 N], "
    "variables: {preload: {min: 60 N, max: 200 N}}, solver: nlopt:slsqp}";

}  // namespace

TEST_CASE("sensitivities of every method are verified from their directory",
          "[studies][verify][sensitivity]") {
  const std::string variables =
      ", variables: {preload: {min: 100 N, max: 200 N}, wavelengths: {min: 8, max: 10}}, "
      "metrics: [stall_torque, contact_ratio]}";
  const std::string method = GENERATE("local", "morris, samples: 8", "sobol, samples: 256",
                                      "sobol, samples: 256, width: 1e-4, max_samples: 512");
  CAPTURE(method);
  const Finished one("{kind: sensitivity, method: " + method + variables);
  CHECK(one.result.outcome == "done");
  check_all_holds(one);
  // 1 motor; 8 trajectories of 3; 256 blocks of 4; twice as many in two stages.
  const std::uint64_t rows = method == "local"                           ? 1
                             : method.starts_with("morris")              ? 24
                             : method.find("width") != std::string::npos ? 2048
                                                                         : 1024;
  CHECK(one.result.evaluations == rows);
}

TEST_CASE("tolerances are verified from their directory", "[studies][verify][uncertainty]") {
  const Finished one(
      "{kind: uncertainty, samples: 40, metrics: [stall_torque], variables: {preload: "
      "{distribution: triangular, min: 90 N, mode: 100 N, max: 120 N}, wavelengths: "
      "{distribution: uniform, min: 8, max: 10}}}");
  check_all_holds(one);
}

TEST_CASE("a fit is verified from its directory, and without the copy of its points it cannot be",
          "[studies][verify][calibrate]") {
  const Finished one(
      "{kind: calibrate, data: points.csv, starts: 2, variables: {kinetic_friction: {min: 0.1, "
      "max: 0.4}}}");
  CHECK(one.result.outcome == "fitted");
  check_all_holds(one);
  fs::remove(one.folder.path("points.csv"));
  check_all_holds(one);
  std::ofstream(one.out() + "/inputs/points.csv", std::ios::app) << "0,0.1\n";
  CHECK_THROWS_WITH(verify_study(one.out()), Contains("inputs/points.csv: has changed since"));
  fs::remove(one.out() + "/inputs/points.csv");
  CHECK_THROWS_WITH(
      verify_study(one.out()),
      StartsWith("the stored study cannot be evaluated again: ") && Contains("points.csv"));
  CHECK_THROWS_AS(verify_study(one.out()), StoreError);
}

TEST_CASE("a search is verified with its certificate, and its files with the answer",
          "[studies][verify][optimize]") {
  const Finished one(kOptimize);
  CHECK(one.result.outcome == "optimal");
  check_all_holds(one);
  CHECK(verify_study(one.out()).certificates == 1);

  const std::string table = content(one.out("results.csv"));
  SECTION("a table cut short") {
    write(one.out("results.csv"), table.substr(0, table.size() - 1));
    CHECK(verify_study(one.out()).complaints ==
          std::vector<std::string>{"results.csv: is not what results.db holds"});
  }
  SECTION("a table with more in it") {
    write(one.out("results.csv"), table + "\n");
    CHECK(verify_study(one.out()).failed == 1);
  }
  SECTION("a table with another letter") {
    REQUIRE(replace_in(one.out("results.csv"), "ok", "Ok"));
    CHECK(verify_study(one.out()).failed == 1);
  }
  SECTION("no table at all") {
    fs::remove(one.out("results.csv"));
    CHECK(verify_study(one.out()).failed == 1);
  }
  SECTION("another motor") {
    REQUIRE(replace_in(one.out("best.yaml"), "frequency: 40000", "frequency: 40001"));
    CHECK(verify_study(one.out()).complaints ==
          std::vector<std::string>{"best.yaml: frequency is not that of the best design"});
  }
  SECTION("a motor file that is gone") {
    fs::remove(one.out("best.yaml"));
    const Verification found = verify_study(one.out());
    REQUIRE(found.failed == 1);
    CHECK_THAT(found.complaints[0], StartsWith("best.yaml: ") && Contains(one.out("best.yaml")));
  }
  SECTION("a motor file that is none") {
    write(one.out("best.yaml"), "twum: 1\n");
    const Verification found = verify_study(one.out());
    REQUIRE(found.failed == 1);
    CHECK_THAT(found.complaints[0], StartsWith("best.yaml: ") && Contains("motor"));
  }
}

TEST_CASE("of an interrupted study only rows and designs are verified", "[studies][verify]") {
  ScratchFolder folder;
  std::stop_source stop;
  stop.request_stop();
  RunOptions options;
  options.stop = stop.get_token();
  const StudyFile file = study_in(folder,
                                  "{kind: sweep, sampling: grid, metrics: [stall_torque], "
                                  "variables: {preload: [100 N, 120 N]}}");
  CHECK(run_study(file, folder.path("out"), options).outcome == "interrupted");
  fs::remove(folder.path("out/results.csv"));  // nobody looks at it
  const Verification found = verify_study(folder.path("out"));
  CHECK(found.holds());
  CHECK_FALSE(found.answer_checked);
}

TEST_CASE("a study whose optimum is said to be certified has to be one", "[studies][verify]") {
  const Finished one(kOptimize);
  // 150 N breaks the limit of 120 N, so it cannot be certified.
  auto summary = nlohmann::ordered_json::parse(content(one.out("summary.json")));
  summary["best"]["design"]["preload"] = 150;
  write(one.out("summary.json"), summary.dump());
  const Verification found = verify_study(one.out());
  CHECK_FALSE(found.holds());
  bool named = false;
  for (const std::string& line : found.complaints)
    named = named || line.starts_with("summary.json: best: certified there, but now: ");
  CAPTURE(found.complaints);
  CHECK(named);
}
