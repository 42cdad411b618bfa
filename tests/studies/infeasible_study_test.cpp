// SPDX-License-Identifier: Apache-2.0
// Studies that no motor satisfies: the cause is named, and confirmed by moving that limit or range alone.
#include "search_support.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

// Local searches end within 1e-8 of a limit in proportion to its change over the ranges, which is of its own size.
constexpr double kSolver = 1e-6;

Search duty_study(const std::string& torque, const std::string& wear) {
  return Search(study_of("ring-60", "",
                         "{kind: size, variables: {amplitude: {min: 0.8 um, max: 2.2 um}, "
                         "preload: {min: 40 N, max: 300 N}}, duty: [{torque: " +
                             torque +
                             ", speed: 100 rpm}], limits: ['wear_intensity_at(100 rpm) <= " + wear +
                             "'], prefer: max_pressure, solver: {starts: 4}}"));
}

Search preload_study(const std::string& torque, const std::string& largest) {
  return Search(study_of("ring-60", "",
                         "{kind: optimize, variables: {preload: {min: 60 N, max: " + largest +
                             "}, amplitude: {min: 0.8 um, max: 2.2 um}}, minimize: max_pressure, "
                             "constraints: ['holding_torque >= " +
                             torque + "', max_pressure <= 5 MPa], solver: {starts: 4}}"));
}

// Torque of a motor whose whole contact slips in one direction, mu F_N r: the most that friction can give.
double friction_torque(double preload) {
  const MotorDesign motor = study_of("ring-60", "", "{kind: curve}").motor.design;
  return get(motor, Parameter::kinetic_friction) * preload * get(motor, Parameter::contact_radius);
}

}  // namespace

TEST_CASE("a duty beyond friction is the cause by itself, not together with the wear limit",
          "[studies][size][infeasible]") {
  const Search s = duty_study("5 N.m", "5 kW/m^2");
  REQUIRE(s.answer.outcome == "infeasible");
  const Explanation& told = s.optimum().explanation;
  CHECK(told.conflict == std::vector<std::string>{"torque_at(100 rpm) >= 5 N.m"});
  REQUIRE(told.impossible.size() == 1);
  CHECK(told.impossible[0].text == "torque_at(100 rpm) >= 5 N.m");
  CHECK_THAT(told.impossible[0].best, WithinRel(friction_torque(300), kSolver));  // 1.59 N.m
  REQUIRE(told.impossible[0].ends.size() == 1);
  const RangeState& end = told.ranges.at(told.impossible[0].ends[0]);
  CHECK(end.variable.name == "preload");
  CHECK(end.upper);
  CHECK(end.limit == 300);
  CHECK_THAT(s.text(),
             Contains("torque_at(100 rpm) >= 5 N.m cannot be reached: the most found within the "
                      "ranges is 1.59 N.m, at preload <= 300 N.\n"));
  // Moving the duty alone makes it possible, moving the wear limit alone does not.
  CHECK(duty_study("0.5 N.m", "5 kW/m^2").answer.outcome == "optimal");
  CHECK(duty_study("5 N.m", "1 GW/m^2").answer.outcome == "infeasible");
}

TEST_CASE("the range of the preload is named where it is the cause, with the preload that would do",
          "[studies][optimize][infeasible]") {
  const Search s = preload_study("0.8 N.m", "100 N");
  REQUIRE(s.answer.outcome == "infeasible");
  const Explanation& told = s.optimum().explanation;
  CHECK(told.conflict == std::vector<std::string>{"holding_torque >= 0.8 N.m"});
  REQUIRE(told.impossible.size() == 1);
  CHECK_THAT(told.impossible[0].best, WithinRel(friction_torque(100), kSolver));
  REQUIRE(told.ranges.size() == 1);
  CHECK(told.ranges[0].variable.name == "preload");
  CHECK(told.ranges[0].upper);
  CHECK(told.ranges[0].limit == 100);
  const double needed = 0.8 / friction_torque(1);
  CHECK_THAT(told.ranges[0].limit_alone, WithinRel(needed, kSolver));
  const Json json = s.kind_json()["relaxation"];
  CHECK(json["impossible"][0]["text"] == "holding_torque >= 0.8 N.m");
  CHECK(json["impossible"][0]["ends"] == Json::array({0}));
  CHECK(json["ranges"][0]["variable"] == "preload");
  CHECK(json["ranges"][0]["side"] == "upper");
  // 150.9 N: the end moved alone to 151 N is enough, to 150 N is not.
  CHECK(preload_study("0.8 N.m", "151 N").answer.outcome == "optimal");
  CHECK(preload_study("0.8 N.m", "150 N").answer.outcome == "infeasible");
}

TEST_CASE(
    "no design outside the ranges is stored, and a stored search is explained as the first was",
    "[studies][optimize][infeasible]") {
  const Search s = preload_study("0.8 N.m", "100 N");
  for (const StoredRow& row : s.rows()) CHECK((row.values[0] >= 60 && row.values[0] <= 100));
  auto stored = s.rows();
  stored.resize(stored.size() / 2);
  const Search again(study_of("ring-60", "",
                              "{kind: optimize, variables: {preload: {min: 60 N, max: 100 N}, "
                              "amplitude: {min: 0.8 um, max: 2.2 um}}, minimize: max_pressure, "
                              "constraints: ['holding_torque >= 0.8 N.m', max_pressure <= 5 MPa], "
                              "solver: {starts: 4}}"),
                     3, stored);
  CHECK(again.kind_json()["relaxation"] == s.kind_json()["relaxation"]);
  CHECK(again.rows().size() == s.rows().size());
}
