// SPDX-License-Identifier: Apache-2.0
// The data that a report page carries for each kind of study, and what is no result.
#include "answer_support.hpp"
#include "support/scratch_folder.hpp"

#include <twum/studies/report.hpp>
#include <twum/studies/run_study.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::test;

namespace {

constexpr const char* kVariables = "variables: {preload: {min: 100 N, max: 200 N}}";

StudyFile study_of(const std::string& entries) {
  const ScratchFolder folder;
  std::ofstream(folder.path("points.csv")) << "speed,torque\n1,0.8\n2,0.8\n3,0.8\n";
  std::ofstream(folder.path("study.yaml"))
      << "twum: 1\nmotor: " TWUM_SOURCE_DIR "/examples/motors/elastic-layer.yaml\nstudy: "
      << entries << "\n";
  return read_study_file(folder.path("study.yaml"));
}

// The data of the page of a study with this answer, and without rows.
Json page_data(const std::string& entries, Answer answer, const std::string& text = "twum: 1\n") {
  const ResultStore store(":memory:", {{"preload", "N"}});
  const StudyFile study = study_of(entries);
  StudyResult result;
  result.kind = study.kind();
  result.motor = study.motor.name;
  result.answer = std::move(answer);
  const std::string page = report_html(study, text, result, store);
  const std::string begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

std::vector<std::string> labels(const Json& data) {
  std::vector<std::string> list;
  for (const Json& curve : data["curves"]) list.push_back(curve["label"]);
  return list;
}

NamedValue preload(double newtons) { return {"preload", "N", newtons}; }

using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("a folder without a result has no report", "[studies][report][errors]") {
  const ScratchFolder folder;
  const auto refused = [&]() -> std::string {
    try {
      write_report(folder.folder());
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(
      refused() ==
      folder.folder() +
          ": not a result directory: it has no study.yaml; give a directory that 'twum run' wrote");
  std::ofstream(folder.path("study.yaml")) << "twum: 1\n";
  CHECK(refused() ==
        folder.folder() +
            ": holds no complete result: there is no summary.json; complete the study with "
            "'twum run STUDY -o " +
            folder.folder() + "'");
}

TEST_CASE("a report is written beside its result, and again the same", "[studies][report]") {
  const ScratchFolder folder;
  run_study(study_of(std::string("{kind: sweep, samples: 4, sampling: sobol, ") + kVariables +
                     ", metrics: [stall_torque]}"),
            folder.path("out"), {});
  CHECK(write_report(folder.path("out")) == folder.path("out") + "/report.html");
  const auto content = [&] {
    std::ostringstream text;
    text << std::ifstream(folder.path("out/report.html"), std::ios::binary).rdbuf();
    return text.str();
  };
  const std::string first = content();
  CHECK(first.find("\"row_curves\":{\"every\":1,\"points\":24") != std::string::npos);
  std::filesystem::remove(folder.path("out/report.html"));
  write_report(folder.path("out"));
  CHECK((content() == first));  // without printing both
}

TEST_CASE("no text of a study can end the data element of the page", "[studies][report]") {
  const std::string hostile = "# </script><script>alert(1)</script> <!-- /*SCRIPT*/ /*DATA*/\n";
  const Json data = page_data("{kind: curve}", CurveResult{}, hostile);
  CHECK(data["study"] == hostile);
  CHECK(data["motor"]["name"] == "elastic-layer");
  CHECK(data["motor"]["design"]["preload"] == 160);
  CHECK(data["parameters"]["amplitude"]["entry"] == "stator.amplitude");
  CHECK(data["parameters"]["wavelengths"]["integer"] == true);
  CHECK(data["metrics"]["stall_torque"]["unit"] == "N.m");
  CHECK(data["rows"]["count"] == 0);
  CHECK_FALSE(data.contains("row_curves"));
}

TEST_CASE("a family has a curve for each member that is a motor", "[studies][report]") {
  CurveResult family;
  family.family = StoredColumn{"preload", "N"};
  for (const double newtons : {100.0, 120.0, -1.0}) {
    family.members.emplace_back();
    family.members.back().value = newtons;
  }
  const Json data = page_data("{kind: curve, family: {preload: [100 N, 200 N]}}", family);
  REQUIRE(labels(data) ==
          Labels{"preload 100 N", "preload 120 N"});  // one is not a valid motor and is left out
  CHECK(data["curves"][0]["design"]["preload"] == 100);
  CHECK(data["curves"][1]["design"]["preload"] == 120);
  CurveResult alone;
  alone.members.emplace_back();
  const Json motor = page_data("{kind: curve}", alone);
  REQUIRE(labels(motor) == Labels{"elastic-layer"});
  CHECK(motor["curves"][0]["design"]["preload"] == 160);  // no family: nothing is varied
}

TEST_CASE("an optimum has its curve beside that of the start", "[studies][report]") {
  const std::string entries =
      std::string("{kind: optimize, ") + kVariables + ", maximize: stall_torque}";
  OptimizeResult found;
  found.found = true;
  found.before_design = {preload(160)};
  found.best.design = {preload(200)};
  const Json data = page_data(entries, found);
  CHECK(labels(data) == Labels{"before", "best design"});
  CHECK(data["curves"][1]["design"]["preload"] == 200);
  CHECK_THAT(data["sections"].dump(), Catch::Matchers::Contains("100 N to 200 N"));
  // No design was found: the start is all there is. A start that is no motor has no curve either.
  OptimizeResult none = found;
  none.found = false;
  CHECK(labels(page_data(entries, none)) == Labels{"before"});
  OptimizeResult no_start = found;
  no_start.before_design = {preload(-5)};
  CHECK(labels(page_data(entries, no_start)) == Labels{"best design"});
}

TEST_CASE("a front has a curve for each point, in its place", "[studies][report]") {
  ParetoResult front;
  front.goals = {{"stall_torque", "N.m", true}, {"no_load_speed", "rad/s", true}};
  for (const double newtons : {100.0, -1.0, 200.0}) {
    front.front.emplace_back();
    front.front.back().goals = {newtons, 1 / newtons};
    front.front.back().report.design = {preload(newtons)};
  }
  const Json data =
      page_data(std::string("{kind: pareto, ") + kVariables +
                    ", objectives: [{maximize: stall_torque}, {maximize: no_load_speed}]}",
                front);
  REQUIRE(data["curves"].size() == 3);
  CHECK(data["curves"][0]["design"]["preload"] == 100);
  CHECK(data["curves"][1].is_null());  // no motor, but the place is kept
  CHECK(data["curves"][2]["design"]["preload"] == 200);
  CHECK_FALSE(data["curves"][2].contains("fields"));
  REQUIRE(data["points"].size() == 3);
  const Json torque = data["points"][2]["sections"][0]["charts"][0]["series"][0];
  CHECK(torque["y"] == "motors/2/torque");
  CHECK(data["points"][1]["sections"][0]["charts"].empty());
}

TEST_CASE("a fit has its curve and its band, where something was estimated", "[studies][report]") {
  const std::string entries =
      std::string("{kind: calibrate, data: points.csv, ") + kVariables + "}";
  CalibrateResult fit;
  fit.estimates.resize(1);
  fit.estimates[0].parameter = preload(120);
  fit.correlation = {1.0};
  fit.data.resize(2);
  fit.data[0].at = -1, fit.data[1].at = 3;
  const Json data = page_data(entries, fit);
  CHECK(labels(data) == Labels{"fitted motor"});
  CHECK(data["curves"][0]["design"]["preload"] == 120);
  CHECK(data["curves"][0]["design"]["amplitude"] == 1.6e-6);
  const Json& chart = data["sections"][0]["charts"][0];
  CHECK(chart["name"] == "fit");
  CHECK(chart["x"]["unit"] == "rad/s");
  CHECK(chart["series"][1]["x"] == Json{-1.0, 3.0});  // the points
  fit.estimates.clear(), fit.correlation.clear();
  CHECK(page_data(entries, fit)["sections"][0]["charts"].empty());
}

TEST_CASE("studies that look at many motors show the curve of their own", "[studies][report]") {
  const std::string metrics = ", metrics: [stall_torque]}";
  const auto [entries, answer] = GENERATE_REF(table<std::string, Answer>(
      {{"{kind: sensitivity, method: local, " + std::string(kVariables) + metrics,
        SensitivityResult{}},
       {"{kind: uncertainty, variables: {preload: {distribution: "
        "normal, mean: 160 N, sd: 8 N}}" +
            metrics,
        UncertaintyResult{}}}));
  CAPTURE(entries);
  const Json data = page_data(entries, answer);
  REQUIRE(labels(data) == Labels{"elastic-layer"});
  CHECK(data["curves"][0]["design"]["preload"] == 160);
}
