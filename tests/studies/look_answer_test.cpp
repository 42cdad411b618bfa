// SPDX-License-Identifier: Apache-2.0
// What sweeps and curves say of numbers that are given.
#include "answer_support.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

SweepResult sweep() {
  SweepResult result;
  result.sampling = "grid";
  result.designs = 6;
  result.stored = 6;
  result.variables = {{"amplitude", "m"}, {"preload", "N"}};
  SweepResult::Metric torque;
  torque.column = {"stall_torque", "N.m"};
  torque.count = 6;
  torque.min = 0.4;
  torque.median = 0.5;
  torque.max = 0.8;
  torque.lowest = {0, {1e-6, 100}, {0.4}};
  torque.highest = {5, {2e-6, 200}, {0.8}};
  result.metrics.push_back(torque);
  return result;
}

CurveResult::Member member(double value, double torque, const std::string& status = "ok") {
  CurveResult::Member one;
  one.value = value;
  one.metrics = {{"stall_torque", "N.m", torque}, {"peak_power", "W", 3}, {"preload", "N", 160}};
  one.statuses = {status, "ok", "ok"};
  one.points = 51;
  one.last_speed = 15;
  return one;
}

}  // namespace

TEST_CASE("a sweep says where each metric is least and most", "[studies][sweep][words]") {
  const SweepResult result = sweep();
  CHECK(headline_text(result) ==
        "6 designs.\n"
        "The stall_torque ranges from 400 mN.m to 800 mN.m with amplitude 2 um, preload 200 N.\n");
  CHECK(barred(sections_text(result)) ==
        "Spread of the metrics\n"
        "metric | lowest | median | highest | designs\n"
        "stall_torque | 400 mN.m | 500 mN.m | 800 mN.m | 6\n\n"
        "Extremes\n"
        "metric | lowest at | highest at\n"
        "stall_torque | amplitude 1 um, preload 100 N | amplitude 2 um, preload 200 N\n");
  const Json json = answer_json(result);
  CHECK(json["units"] == Json{{"amplitude", "m"}, {"preload", "N"}, {"stall_torque", "N.m"}});
  const Json& torque = json["metrics"]["stall_torque"];
  CHECK(torque["count"] == 6);
  CHECK(torque["median"] == 0.5);
  CHECK(torque["highest"] == Json{{"row", 5},
                                  {"design", {{"amplitude", 2e-6}, {"preload", 200.0}}},
                                  {"metrics", {{"stall_torque", 0.8}}}});
}

TEST_CASE("a sweep that is not over counts what it has", "[studies][sweep][words]") {
  SweepResult result = sweep();
  result.stored = 4;
  result.failed = 1;
  CHECK_THAT(headline_text(result), StartsWith("4 designs, 1 of them failed or incomplete.\n"));
  CHECK_THAT(sections_text(result), Contains("\n4 of 6 designs are computed.\n"));
  CHECK(answer_json(result)["stored"] == 4);
  result.stored = 0;
  CHECK(sections_text(result).empty());
  result.stored = result.designs = 1;
  CHECK_THAT(headline_text(result), StartsWith("1 design, 1 of them failed"));
}

TEST_CASE("a metric that never changes, and one without a value, have no design to name",
          "[studies][sweep][words]") {
  SweepResult result = sweep();
  result.metrics[0].min = result.metrics[0].max;
  CHECK_THAT(headline_text(result), EndsWith("\nThe stall_torque is the same in all: 800 mN.m.\n"));
  CHECK_THAT(barred(sections_text(result)),
             EndsWith("\nstall_torque | the same in all designs | the same in all designs\n"));
  result.metrics[0] = {{"stall_torque", "N.m"}, 0, kNaN, kNaN, kNaN, {}, {}};
  CHECK_THAT(barred(sections_text(result)),
             Contains("\nstall_torque | - | - | - | 0\n") &&
                 EndsWith("\nstall_torque | no design has a value | no design has a value\n"));
  const Json json = answer_json(result);
  CHECK(json["metrics"]["stall_torque"]["min"].is_null());
  CHECK(json["metrics"]["stall_torque"]["lowest"].is_null());
}

TEST_CASE("a motor by itself has one column, the metrics that curves are compared by first",
          "[studies][curve][words]") {
  CurveResult result;
  result.members.push_back(member(kNaN, 0.6));
  CHECK(barred(sections_text(result)) ==
        "Metrics\nmetric | motor\nstall_torque | 600 mN.m\npeak_power | 3 W\npreload | 160 N\n");
  const Json json = answer_json(result);
  CHECK_FALSE(json.contains("family"));
  CHECK_FALSE(json["curves"][0].contains("missing"));
  CHECK(json["curves"][0]["metrics"] ==
        Json{{"stall_torque", 0.6}, {"peak_power", 3.0}, {"preload", 160.0}});
  CHECK(json["units"]["last_speed"] == "rad/s");
  CHECK(json["units"]["preload"] == "N");
}

TEST_CASE("a family says which of its curves lack something", "[studies][curve][words]") {
  CurveResult result;
  result.family = StoredColumn{"amplitude", "m"};
  result.members = {member(1e-6, 0.5), member(2e-6, kNaN, "lift-off")};
  result.members[1].failed = 7;
  CHECK(barred(sections_text(result)) ==
        "Metrics\n"
        "amplitude 2 um: 7 of 51 points could not be computed.\n"
        "metric | amplitude 1 um | amplitude 2 um\n"
        "stall_torque | 500 mN.m | - (lift-off)\n"
        "peak_power | 3 W | 3 W\n"
        "preload | 160 N | 160 N\n");
  const Json json = answer_json(result);
  CHECK(json["family"] == Json{{"parameter", "amplitude"}, {"unit", "m"}});
  CHECK(json["curves"][1]["amplitude"] == 2e-6);
  CHECK(json["curves"][1]["failed_points"] == 7);
  CHECK(json["curves"][1]["missing"] == Json{{"stall_torque", "lift-off"}});
  CHECK(json["curves"][1]["metrics"]["stall_torque"].is_null());
}

TEST_CASE("no curve yet is nothing said", "[studies][curve][words]") {
  CHECK(sections_text(CurveResult{}).empty());
  CHECK(answer_json(CurveResult{})["curves"].empty());
  CHECK(answer_json(CurveResult{})["units"] == Json{{"last_speed", "rad/s"}});
}
