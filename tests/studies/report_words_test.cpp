// SPDX-License-Identifier: Apache-2.0
// What a report page is told of names and limits, so that it takes no text apart and judges nothing itself.
#include "report/names.hpp"
#include "results/standings.hpp"
#include "support/constants.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// torque_at(120 rpm) >= `limit` at a motor that has `value`.
LimitState torque_limit(double limit, double value) {
  LimitState state;
  state.text = "torque_at(120 rpm) >= LIMIT";
  state.metric = "torque_at(120 rpm)";
  state.unit = "N.m";
  state.at_least = true;
  state.value = value;
  state.limit = limit;
  state.lower = limit;
  state.upper = kInfinity;
  state.violation = std::isnan(value) ? kNaN : std::max(limit - value, 0.0);
  return state;
}

DesignReport report_of(std::vector<LimitState> limits, double infeasibility) {
  DesignReport report;
  report.constraints = std::move(limits);
  report.certificate.infeasibility = infeasibility;
  report.certificate.weights = {1};
  report.certificate.prices = {1};
  return report;
}

Goal most_power() { return {"peak_power", "W", true}; }
Goal least_wear() { return {"wear_intensity_at(80 rpm)", "W/m^2", false}; }

Json only(const DesignReport& report) {
  const Json list = standings_json(report, {most_power()});
  REQUIRE(list.size() == 1);
  return list[0];
}

}  // namespace

TEST_CASE("a limit at 0 is met as far as its tolerance says", "[studies][report]") {
  LimitState state = torque_limit(0, -1e-9);
  state.active = true;
  state.tolerance = 2e-9;
  const Json met = only(report_of({state}, 1e-9));
  CHECK(met["state"] == "binds");
  CHECK(met["slack"] == 0);
  CHECK(met["allowance"] == 1e-9);
  for (const double tolerance : {0.5e-9, kNaN}) {  // a millionth of 0 is nothing
    state.tolerance = tolerance;
    const Json broken = only(report_of({state}, 1e-9));
    CHECK(broken["state"] == "broken");
    CHECK(broken["violation"] == 1e-9);
    CHECK(broken["slack"] == -1e-9);
  }
}

TEST_CASE("a limit that holds has room, and one without a value cannot be reached",
          "[studies][report]") {
  const Json holds = only(report_of({torque_limit(0.5, 0.8)}, 0));
  CHECK(holds["state"] == "holds");
  CHECK_THAT(holds["slack"].get<double>(), WithinRel(0.3, 1e-15));
  CHECK(only(report_of({torque_limit(0.5, kNaN)}, 0))["state"] == "unreachable");
}

TEST_CASE("1 % of a limit changes the goal by the multiplier times that step",
          "[studies][report]") {
  LimitState state = torque_limit(0.5, 0.5);
  state.active = true;
  state.multiplier = 4;                // [W / N m]
  state.gain_per_percent = 4 * 0.005;  // [W]
  DesignReport report = report_of({state}, 0);
  report.bounds = {{{"preload", "N"}, true, 300, 0.01, 0.03}};  // dearer: 30 mW for 3 N
  const Json list = standings_json(report, {most_power()});
  REQUIRE(list.size() == 2);
  CHECK(list[0]["variable"] == "preload");  // the most valuable first
  CHECK(list[0]["side"] == "at most");
  CHECK(list[0]["moved"] == 303);
  CHECK_THAT(list[0]["changes"][0].get<double>(), WithinRel(0.03, 1e-15));
  CHECK_THAT(list[1]["moved"].get<double>(), WithinRel(0.495, 1e-15));
  CHECK_THAT(list[1]["changes"][0].get<double>(), WithinRel(0.02, 1e-15));
}

TEST_CASE("along a front a limit improves each goal, in the direction that is wanted",
          "[studies][report]") {
  LimitState state = torque_limit(0.5, 0.5);
  state.active = true;
  state.multiplier = 4;
  state.gain_per_percent = 0.02;
  DesignReport report = report_of({state, torque_limit(0.5, 0.9)}, 0);
  report.certificate.weights = {0.5, 0.5};
  report.certificate.prices = {1, 1e-3};  // 1 kW/m^2 of wear is worth 1 W
  const Json list = standings_json(report, {most_power(), least_wear()});
  CHECK_THAT(list[0]["changes"][0].get<double>(), WithinRel(0.02, 1e-15));
  CHECK_THAT(list[0]["changes"][1].get<double>(), WithinRel(-20.0, 1e-15));
  CHECK(list[1]["changes"] == Json::array({nullptr, nullptr}));  // it holds nothing back
  report.certificate.weights = {1, 0};  // at an end one goal does not trade
  CHECK(standings_json(report, {most_power(), least_wear()})[0]["changes"][1].is_null());
}

TEST_CASE("names are told as one reads them, metrics at a point with their place",
          "[studies][report]") {
  const Json columns = Json::parse(
      R"json([{"name": "speed_at(1 N.m)"}, {"name": "lining"}, {"name": "quantile(stall_torque, 5 %)"}])json");
  const Json names = names_json(columns);
  CHECK(names["speed_at(1 N.m)"] == Json{{"text", "speed at 1\u00a0N·m"}, {"metric", "speed_at"}});
  CHECK(names["quantile(stall_torque, 5 %)"]["text"] == "5 % quantile of the stall torque");
  CHECK(names["lining"] == Json{{"text", "lining"}});
  CHECK(names["thickness"] == Json{{"text", "contact layer thickness"}});
  CHECK(names["max_efficiency"]["text"] == "max efficiency (including stator loss)");
}

TEST_CASE("each reason of a missing answer is told once", "[studies][report]") {
  const Json summary = Json::parse(
      R"json({"failure_regions": [
          {"reason": "speed_at(0.9 N.m): unreachable; stall_torque: unreachable"},
          {"reason": "resonance"}, {"reason": "not admissible"}]})json");
  const Json told = failures_json(summary);
  CHECK(told["speed_at(0.9 N.m): unreachable; stall_torque: unreachable"] ==
        "the motor cannot carry this load");
  CHECK(told["resonance"].get<std::string>().find("resonance") != std::string::npos);
  CHECK(told["not admissible"] == "");
}
