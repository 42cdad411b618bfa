// SPDX-License-Identifier: Apache-2.0
// What is said of a front that is given: its ends and knee, what binds, and what a limit is worth.
#include "answer_support.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

LimitState pressure(bool active, double multiplier, double gain_per_percent) {
  LimitState state;
  state.text = "max_pressure <= 2 MPa";
  state.metric = "max_pressure";
  state.unit = "Pa";
  state.limit = 2e6;
  state.active = active;
  state.multiplier = multiplier;
  state.gain_per_percent = gain_per_percent;
  return state;
}

ParetoResult::Point point(double power, double torque, double preload, bool passed) {
  ParetoResult::Point one;
  one.goals = {power, torque};
  one.report.design = {{"preload", "N", preload}};
  one.report.metrics = {{"peak_power", "W", power}};
  one.report.constraints = {pressure(false, 0, 0)};
  one.report.certificate.passed = passed;
  one.report.certificate.infeasibility = 0;
  one.report.certificate.weights = {0.5, 0.5};
  one.report.certificate.prices = {1, 4};
  return one;
}

// Largest power against smallest torque, in three points.
ParetoResult front() {
  ParetoResult result;
  result.goals = {{"peak_power", "W", true}, {"stall_torque", "N.m", false}};
  result.front = {point(3, 0.2, 100, true), point(4, 0.3, 150, true), point(5, 0.8, 200, false)};
  result.knee = 1;
  result.ends = {2, 0};
  result.hypervolume = 1.5;
  result.reference_point = {2, 1};
  result.before_design = {{"preload", "N", 160}};
  result.before_metrics = {{"peak_power", "W", 3.5}};
  return result;
}

}  // namespace

TEST_CASE("a front is a table, in which ends and knee are named", "[studies][pareto][words]") {
  ParetoResult result = front();
  result.front.insert(result.front.begin() + 1, point(3.5, 0.25, 125, true));
  result.knee = 2;
  result.ends = {3, 0};
  CHECK_THAT(barred(sections_text(result)),
             EndsWith("\nThe front as a table\n"
                      "point | peak_power | stall_torque | preload\n"
                      "1 (smallest stall_torque) | 3 W | 200 mN.m | 100 N\n"
                      "2 | 3.5 W | 250 mN.m | 125 N\n"
                      "3 (knee) | 4 W | 300 mN.m | 150 N\n"
                      "4 (largest peak_power) | 5 W | 800 mN.m | 200 N\n"));
  while (result.front.size() < 22) result.front.push_back(result.front.back());
  CHECK_THAT(sections_text(result), EndsWith("\nand 2 more rows, see the report\n"));
}

TEST_CASE("the knee of a front and its ends stand side by side", "[studies][pareto][words]") {
  const ParetoResult result = front();
  CHECK(result.has_knee());
  CHECK_THAT(barred(sections_text(result)),
             Contains("\nKnee and ends\n"
                      " | knee | smallest stall_torque | largest peak_power\n"
                      "peak_power | 4 W | 3 W | 5 W\n"
                      "stall_torque | 300 mN.m | 200 mN.m | 800 mN.m\n"
                      "preload | 150 N | 100 N | 200 N\n"));
  const Json json = answer_json(result);
  CHECK(json["objectives"][1] == Json{{"metric", "stall_torque"}, {"sense", "minimize"}});
  CHECK(json["front"].size() == 3);
  CHECK(json["front"][1]["design"] == Json{{"preload", 150.0}});
  CHECK(json["knee"] == 1);
  CHECK(json["ends"] == Json::array({2, 0}));
  CHECK(json["hypervolume"] == 1.5);
  CHECK(json["reference_point"] == Json::array({2.0, 1.0}));
  CHECK(json["units"] == Json{{"preload", "N"}, {"peak_power", "W"}});
  CHECK_FALSE(json.contains("relaxation"));
}

TEST_CASE("a front promises no more than its certificates", "[studies][pareto][words]") {
  using Look = telling::Headline::Look;
  ParetoResult result = front();
  const std::string promise = "can be improved in one goal without loss in another";
  const auto told = [&](std::size_t certified, const std::string& outcome) {
    for (std::size_t i = 0; i < result.front.size(); ++i)
      result.front[i].report.certificate.passed = i < certified;
    return telling::headline(result_of(result, outcome));
  };
  CHECK(told(3, "optimal").look == Look::good);
  CHECK(told(3, "optimal").badge == "every point certified");
  CHECK_THAT(headline_text(result, "optimal"),
             StartsWith("3 best compromises: none of them " + promise));
  CHECK(told(2, "feasible").look == Look::bad);
  CHECK_THAT(headline_text(result, "feasible"),
             StartsWith("3 compromises, 2 of them certified: none of these " + promise));
  CHECK(told(0, "feasible").look == Look::bad);
  CHECK_THAT(headline_text(result, "feasible"), StartsWith("3 compromises, not certified: "));
  CHECK_THAT(headline_text(result, "feasible"), !Contains(promise));
}

TEST_CASE("a front that bends the other way has no knee", "[studies][pareto][words]") {
  ParetoResult result = front();
  result.knee = 2;
  CHECK_FALSE(result.has_knee());
  CHECK_THAT(sections_text(result), !Contains("knee"));
  CHECK(answer_json(result)["knee"].is_null());
}

TEST_CASE("what binds along a front is counted", "[studies][pareto][words]") {
  ParetoResult result = front();
  result.front[0].report.constraints[0].active = true;
  result.front[1].report.constraints[0].active = true;
  result.front[2].report.bounds = {{{"preload", "N"}, true, 200, 0.01, 0.02}};
  CHECK_THAT(sections_text(result),
             Contains("\nmax_pressure <= 2 MPa binds at 2 of 3 points.\n"
                      "preload is at an end of its range at 1 of 3 points.\n"));
  result.front.resize(1);
  result.ends = {0, 0};
  result.knee = 0;
  CHECK_THAT(sections_text(result), Contains("\nmax_pressure <= 2 MPa binds at 1 of 1 point.\n"));
}

TEST_CASE("variables at a bound are found among others", "[studies][pareto][words]") {
  ParetoResult result = front();
  for (ParetoResult::Point& point : result.front)
    point.report.design = {{"a", "1", 1}, {"b", "1", 1}, {"c", "1", 1}, {"d", "1", 1},
                           {"e", "1", 1}, {"f", "1", 1}, {"g", "1", 1}};
  const auto hold = [&](std::size_t point, const std::vector<std::string>& names) {
    for (const std::string& name : names)
      result.front[point].report.bounds.push_back({{name, "1"}, true, 1, 0, 0});
  };
  hold(0, {"a", "b", "c", "d", "e", "f"});
  hold(1, {"a", "b", "c", "d", "e"});
  hold(2, {"g", "f", "a"});
  std::string expected;
  for (const auto& [name, count] :
       {std::pair{"a", 3}, {"b", 2}, {"c", 2}, {"d", 2}, {"e", 2}, {"f", 2}, {"g", 1}})
    expected += std::string(name) + " is at an end of its range at " + std::to_string(count) +
                " of 3 points.\n";
  CHECK_THAT(sections_text(result), Contains("Along the front\n" + expected + "\n"));
}

TEST_CASE("many limits are in order of the gain of 1 %, equals in theirs",
          "[studies][pareto][words]") {
  ParetoResult result = front();
  result.single_goal_ends = {result.front[2].report, result.front[0].report};
  result.single_goal_ends[0].certificate.weights =
      result.single_goal_ends[0].certificate.prices = {1};
  result.single_goal_ends[0].constraints.clear();
  for (int i = 0; i < 40; ++i) {  // 1 W to 20 W, each twice
    LimitState limit = pressure(true, 1, 1 + 7 * i % 20);
    limit.text = "max_pressure <= " + std::to_string(i + 1) + " MPa";
    result.single_goal_ends[0].constraints.push_back(limit);
  }
  std::string expected;
  for (int watts = 20; watts > 0; --watts) {
    for (int i = 0; i < 40; ++i) {
      if (1 + 7 * i % 20 == watts)
        expected += "max_pressure <= " + std::to_string(i + 1) +
                    " MPa: 1 % looser, at 2 MPa, changes peak_power by +" + std::to_string(watts) +
                    " W (+" + std::to_string(20 * watts) + " %).\n";  // of 5 W
    }
  }
  CHECK_THAT(sections_text(result),
             Contains("Limits at the largest peak_power\n" + expected + "\n"));
}

TEST_CASE("1 % of a limit is worth something of either goal, the most valuable first",
          "[studies][pareto][words]") {
  ParetoResult result = front();
  DesignReport& knee = result.front[1].report;
  // 1 % of 2 MPa is 20 kPa: at 1 uW/Pa it gains 20 mW, or a quarter of that in N.m, torque that goes.
  knee.constraints = {pressure(true, 1e-6, 0.02)};
  // 1 % of 150 N is 1.5 N: at 0.1 W/N it gains 150 mW, or 37.5 mN.m.
  knee.bounds = {{{"preload", "N"}, true, 150, 0.1, 0.15}, {{"width", "m"}, false, 1e-3, 0, 0}};
  result.single_goal_ends = {result.front[2].report, result.front[0].report};
  for (DesignReport& report : result.single_goal_ends)
    report.certificate.weights = report.certificate.prices = {1};
  result.single_goal_ends[0].constraints = {pressure(true, 2e-6, 0.04)};
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "Limits at the knee\n"
                      "preload <= 150 N, the end of its range: 1 % looser, at 151.5 N, changes "
                      "peak_power by +150 mW (+3.75 %) or stall_torque by -37.5 mN.m.\n"
                      "max_pressure <= 2 MPa: 1 % looser, at 2.02 MPa, changes peak_power by +20 "
                      "mW (+0.5 %) or stall_torque by -5 mN.m.\n"
                      "width >= 1 mm, the end of its range: it is met, but loosening it by 1 % "
                      "changes nothing to first order.\n") &&
                 Contains("\n"
                          "Limits at the smallest stall_torque\n"
                          "No limit restricts the smallest stall_torque.\n") &&
                 Contains("\n"
                          "Limits at the largest peak_power\n"
                          "max_pressure <= 2 MPa: 1 % looser, at 2.02 MPa, changes peak_power by "
                          "+40 mW (+0.8 %).\n"));
  const Json json = answer_json(result);
  CHECK(json["front"][1]["constraints"][0]["gains"] == Json::array({1e-6, 1e-6 / 4}));
  CHECK(json["front"][1]["bounds"][0]["gains"] == Json::array({0.1, 0.025}));
  CHECK_FALSE(json["front"][0]["constraints"][0].contains("gains"));  // it holds nothing back there
  CHECK(json["single_goal_ends"].size() == 2);
  CHECK_FALSE(json["single_goal_ends"][0]["constraints"][0].contains("gains"));  // one goal

  // A goal of no weight does not trade to first order.
  result.front[1].report.certificate.weights = {1, 0};
  CHECK_THAT(sections_text(result), Contains("changes peak_power by +20 mW (+0.5 %).\n"));
  CHECK(answer_json(result)["front"][1]["bounds"][0]["gains"][1].is_null());
  // Without a knee only the ends are asked.
  result.knee = 2;
  CHECK_THAT(sections_text(result), !Contains("Limits at the knee"));
  CHECK_THAT(sections_text(result), Contains("Limits at the largest peak_power"));
}

TEST_CASE("gains share a multiplier by the prices of the goals", "[studies][pareto]") {
  optim::Certificate certificate;
  certificate.weights = {0.5, 0.5, 1e-12};
  certificate.prices = {1, 4, 2};
  const std::vector<double> shares = gains(8, certificate);
  CHECK(shares[0] == 8);
  CHECK(shares[1] == 2);
  CHECK(std::isnan(shares[2]));
}

TEST_CASE("a front that no design is on says what stands in the way", "[studies][pareto][words]") {
  ParetoResult result;
  result.goals = front().goals;
  CHECK_FALSE(result.has_knee());
  CHECK(headline_text(result, "failed") == "No point of the front was found.\n");
  CHECK(sections_text(result).empty());
  CHECK(answer_json(result)["knee"].is_null());
  result.explanation.conflict = {"stall_torque >= 1 N.m"};
  CHECK_THAT(headline_text(result, "infeasible"),
             StartsWith("No design keeps every limit. stall_torque >= 1 N.m cannot be reached.\n"));
  CHECK(answer_json(result)["relaxation"]["conflict"] == Json::array({"stall_torque >= 1 N.m"}));
  result.explanation.conflict.clear();
  result.explanation.limits = {
      {"stall_torque >= 1 N.m", "stall_torque", "N.m", true, 1, 0.1, kNaN}};
  CHECK_THAT(barred(sections_text(result)),
             EndsWith("\nstall_torque >= 1 N.m | 900 mN.m | does not help alone\n"));
  CHECK(answer_json(result)["relaxation"]["limits"][0]["amount"] == 0.1);
}
