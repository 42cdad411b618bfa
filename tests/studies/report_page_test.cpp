// SPDX-License-Identifier: Apache-2.0
// The data that a report page carries for each kind of study, and what is no result.
#include "answer_support.hpp"
#include "support/scratch_folder.hpp"

#include <twum/studies/report/report.hpp>
#include <twum/studies/run/run_study.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
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

// The data of the page of a study with this summary, and without rows.
Json page_data(const std::string& entries, const std::string& summary,
               const std::string& text = "twum: 1\n") {
  const ResultStore store(":memory:", {{"preload", "N"}});
  const std::string page = report_html(study_of(entries), text, summary, store);
  const std::string begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

std::vector<std::string> labels(const Json& data) {
  std::vector<std::string> list;
  for (const Json& curve : data["curves"]) list.push_back(curve["label"]);
  return list;
}

std::string refusal(const std::string& summary) {
  const ResultStore store(":memory:", {{"preload", "N"}});
  try {
    report_html(study_of("{kind: curve}"), "", summary, store);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("a page is made of a summary, and of nothing else", "[studies][report][errors]") {
  const std::string refused = "the summary of the result cannot be read: it is no summary.json";
  CHECK(refusal("{") == refused);
  CHECK(refusal("[]") == refused);
  CHECK(refusal("{}") == refused);
  CHECK(refusal(R"({"kind": "curve"})") == "accepted");
}

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
  CHECK(refused() == folder.folder() + ": holds no result of a study: summary.json cannot be read");
  std::ofstream(folder.path("summary.json")) << "{}";
  CHECK(refused() == folder.folder() + ": holds no result of a study: study.yaml cannot be read");
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

TEST_CASE("no text of a study ends the data of the page", "[studies][report]") {
  const std::string hostile = "# </script><script>alert(1)</script> <!-- /*SCRIPT*/ /*DATA*/\n";
  const Json data = page_data("{kind: curve}", R"({"kind": "curve"})", hostile);
  CHECK(data["study"] == hostile);
  CHECK(data["motor"]["name"] == "elastic-layer");
  CHECK(data["motor"]["design"]["preload"] == 160);
  CHECK(data["parameters"]["amplitude"]["part"] == "stator");
  CHECK(data["parameters"]["wavelengths"]["integer"] == true);
  CHECK(data["metrics"]["stall_torque"]["unit"] == "N.m");
  CHECK(data["ranges"].empty());
  CHECK(data["rows"]["count"] == 0);
  CHECK_FALSE(data.contains("fit"));
  CHECK_FALSE(data.contains("row_curves"));
}

TEST_CASE("a family has a curve for each member that is a motor", "[studies][report]") {
  // A value that is missing or no number leaves the motor as it is; one that makes no motor is left out.
  const Json data = page_data("{kind: curve, family: {preload: [100 N, 200 N]}}",
                              R"({"kind": "curve", "family": {"parameter": "preload"}, "curves": [
                                  {"preload": 100}, {"preload": null}, {}, {"preload": -1}]})");
  REQUIRE(labels(data) == Labels(3, "preload"));
  CHECK(data["curves"][0]["design"]["preload"] == 100);
  CHECK(data["curves"][1]["design"]["preload"] == 160);
  CHECK(data["curves"][2]["design"]["preload"] == 160);
  const Json alone = page_data("{kind: curve}", R"({"kind": "curve", "curves": [{"preload": 1}]})");
  REQUIRE(labels(alone) == Labels{""});
  CHECK(alone["curves"][0]["design"]["preload"] == 160);  // no family: nothing is varied
  // Damaged: no list where one should be.
  CHECK(page_data("{kind: curve}", R"({"kind": "curve", "curves": 3})")["curves"].empty());
}

TEST_CASE("an optimum has its curve beside that of the start", "[studies][report]") {
  const std::string entries =
      std::string("{kind: optimize, ") + kVariables + ", maximize: stall_torque}";
  const Json data =
      page_data(entries, R"({"kind": "optimize", "before": {"design": {"preload": 160}},
                   "best": {"design": {"preload": 200}}})");
  CHECK(labels(data) == Labels{"before", "best"});
  CHECK(data["curves"][1]["design"]["preload"] == 200);
  CHECK(data["ranges"] == Json{{"preload", {{"min", 100.0}, {"max", 200.0}}}});
  // No design was found: the start is all there is. A start that is no motor has no curve either.
  CHECK(labels(page_data(entries, R"({"kind": "optimize", "best": null})")) == Labels{"before"});
  CHECK(labels(page_data(entries, R"({"kind": "optimize", "before": {"design": {"preload": -5}},
                                      "best": {"design": {"preload": 150}}})")) == Labels{"best"});
}

TEST_CASE("a front has a curve for each point, in its place", "[studies][report]") {
  const Json data = page_data(
      std::string("{kind: pareto, ") + kVariables +
          ", objectives: [{maximize: stall_torque}, {maximize: no_load_speed}]}",
      R"({"kind": "pareto", "front": [{"design": {"preload": 100}}, {"design": {"preload": -1}},
                                      {"design": {"preload": 200}}]})");
  REQUIRE(data["curves"].size() == 3);
  CHECK(data["curves"][0]["design"]["preload"] == 100);
  CHECK(data["curves"][1].is_null());  // no motor, but the place is kept
  CHECK(data["curves"][2]["design"]["preload"] == 200);
  CHECK(data["curves"][2]["fields"].is_null());
  CHECK(data["ranges"]["preload"]["max"] == 200);
}

TEST_CASE("a fit has its curve and its band, where something was estimated", "[studies][report]") {
  const std::string entries =
      std::string("{kind: calibrate, data: points.csv, ") + kVariables + "}";
  const std::string points = R"("data": [{"speed": -1}, {"speed": 3}, {}])";
  const Json data = page_data(entries, R"({"kind": "calibrate", "estimates": {
      "preload": {"value": 120}, "amplitude": {"value": null}, "thickness": {}}, )" +
                                           points + "}");
  CHECK(labels(data) == Labels{"fitted"});
  CHECK(data["curves"][0]["design"]["preload"] == 120);
  CHECK(data["curves"][0]["design"]["amplitude"] == 1.6e-6);
  CHECK(data["fit"]["gradients"].size() == 1);  // of what was estimated only
  CHECK(data["fit"]["gradients"].contains("preload"));
  const Json none = page_data(entries, R"({"kind": "calibrate", "estimates": {}, )" + points + "}");
  CHECK(none["fit"].is_null());
}

TEST_CASE("studies that look at many motors show the curve of their own", "[studies][report]") {
  const std::string metrics = ", metrics: [stall_torque]}";
  const std::string entries = GENERATE_REF(
      Catch::Generators::as<std::string>{},
      "{kind: sensitivity, method: local, " + std::string(kVariables) + metrics,
      "{kind: uncertainty, variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}" +
          metrics);
  CAPTURE(entries);
  const Json data = page_data(entries, R"({"kind": "any"})");
  REQUIRE(labels(data) == Labels{"motor"});
  CHECK(data["curves"][0]["design"]["preload"] == 160);
  CHECK(data["ranges"].empty());
}
