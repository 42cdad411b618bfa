// SPDX-License-Identifier: Apache-2.0
// What an uncertainty study says of spreads that are given.
#include "answer_support.hpp"

#include <catch2/catch.hpp>

#include <limits>

#include <string>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

UncertaintyResult spread() {
  UncertaintyResult result;
  result.samples = 1000;
  result.variables = {{"preload", "N"}};
  UncertaintyResult::Metric torque;
  torque.column = {"stall_torque", "N.m"};
  torque.count = 1000;
  torque.mean = {0.6, 0.59, 0.61};
  torque.sd = {0.05, 0.04, 0.06};
  torque.quantiles = {{0.05, {0.5, 0.49, 0.51}}, {0.5, {0.6, 0.585, 0.615}}};
  result.metrics.push_back(torque);
  return result;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

UncertaintyResult with_limits() {
  UncertaintyResult result = spread();
  result.limits = {{"stall_torque >= 0.5 N.m", "stall_torque", 0.5, kInfinity, {0.95, 0.93, 0.97}},
                   {"max_pressure <= 2 MPa", "max_pressure", -kInfinity, 2e6, {0.9, 0.88, 0.92}}};
  result.yield = Estimate{0.875, 0.85, 0.9};
  return result;
}

}  // namespace

TEST_CASE("spreads stand above their intervals", "[studies][uncertainty][words]") {
  const UncertaintyResult result = spread();
  CHECK(headline_text(result) ==
        "Mean and standard deviation: stall_torque 600 mN.m +- 50 mN.m.\n");
  CHECK(barred(sections_text(result)) ==
        "Spread\n"
        "1000 motors drawn; intervals of 95 %.\n"
        "metric | mean | standard deviation | 5 % quantile | 50 % quantile\n"
        "stall_torque | 600 mN.m | 50 mN.m | 500 mN.m | 600 mN.m\n"
        "\n"
        "metric | motors without a value\n"
        "stall_torque | 0\n"
        "\n"
        "metric | statistic | at least | at most\n"
        "stall_torque | mean | 590 mN.m | 610 mN.m\n"
        "stall_torque | standard deviation | 40 mN.m | 60 mN.m\n"
        "stall_torque | 5 % quantile | 490 mN.m | 510 mN.m\n"
        "stall_torque | 50 % quantile | 585 mN.m | 615 mN.m\n");
  const Json json = answer_json(result);
  CHECK(json["samples"] == 1000);
  CHECK(json["confidence"] == 0.95);
  CHECK(json["units"] == Json{{"preload", "N"}, {"stall_torque", "N.m"}});
  const Json& torque = json["metrics"]["stall_torque"];
  CHECK(torque["mean"] == 0.6);
  CHECK(torque["mean_interval"] == Json{{"low", 0.59}, {"high", 0.61}});
  CHECK(torque["sd_interval"] == Json{{"low", 0.04}, {"high", 0.06}});
  CHECK(torque["quantiles"] == Json{{"0.05", 0.5}, {"0.5", 0.6}});
  CHECK(torque["quantile_intervals"]["0.05"] == Json{{"low", 0.49}, {"high", 0.51}});
  CHECK(torque["missing"] == 0);
  for (const char* absent : {"start", "yield", "limits", "without_value", "inadmissible", "parts"})
    CHECK_FALSE(json.contains(absent));
}

TEST_CASE("nothing drawn is nothing said", "[studies][uncertainty][words]") {
  UncertaintyResult result = spread();
  result.samples = 0;
  CHECK(sections_text(result).empty());
}

TEST_CASE("motors without an answer are counted where they are missed",
          "[studies][uncertainty][words]") {
  UncertaintyResult result = spread();
  result.failed = 40;
  result.metrics[0].count = 970;
  CHECK_THAT(
      sections_text(result),
      Contains("\n"
               "stall_torque: 30 motors have no value; the statistics are those of the others.\n"));
  CHECK(answer_json(result)["metrics"]["stall_torque"]["missing"] == 30);
  result.metrics[0].count = 999;
  CHECK_THAT(
      sections_text(result),
      Contains("\n"
               "stall_torque: 1 motor has no value; the statistics are those of the others.\n"));
  // All of them: there are no others.
  result.metrics[0] = {{"stall_torque", "N.m"}, 0, {}, {}, {{0.5, {}}}};
  CHECK_THAT(barred(sections_text(result)), Contains("\nstall_torque: no motor has a value.\n") &&
                                                Contains("\nstall_torque | - | - | - | 1000\n"));
  CHECK(answer_json(result)["metrics"]["stall_torque"]["mean"].is_null());
}

TEST_CASE("a distribution beyond the admissible range says by how much",
          "[studies][uncertainty][words]") {
  UncertaintyResult result = spread();
  result.start = "../size";
  result.inadmissible = {{"preload", 0.0123}};
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "1.23 % of the distribution of preload lies outside the permitted range of "
                      "the parameter; such motors have no value and violate every limit.\n"));
  CHECK(answer_json(result)["inadmissible"] == Json{{"preload", 0.0123}});
  CHECK(answer_json(result)["start"] == "../size");
}

TEST_CASE("the yield names the limit that costs most", "[studies][uncertainty][words]") {
  UncertaintyResult result = with_limits();
  CHECK(headline_text(result) ==
        "87.5 % of the motors keep every limit (between 85 % and 90 % with 95 % confidence).\n"
        "The limit that costs the most yield is max_pressure <= 2 MPa: 90 % keep it.\n");
  CHECK_THAT(barred(sections_text(result)),
             StartsWith("Yield\n"
                        "limit | kept by | at least | at most\n"
                        "stall_torque >= 0.5 N.m | 95 % | 93 % | 97 %\n"
                        "max_pressure <= 2 MPa | 90 % | 88 % | 92 %\n"
                        "all limits | 87.5 % | 85 % | 90 %\n"));
  const Json json = answer_json(result);
  CHECK(json["yield"] == Json{{"value", 0.875}, {"low", 0.85}, {"high", 0.9}});
  CHECK(json["limits"][0]["sense"] == "at least");
  CHECK(json["limits"][1]["sense"] == "at most");
  CHECK(json["limits"][1]["limit"] == 2e6);
  CHECK(json["limits"][1]["lower"].is_null());
  CHECK(json["limits"][1]["kept"]["high"] == 0.92);
  CHECK(json["without_value"] == 0);

  result.limits[0].upper = 1;  // a limit with two ends
  CHECK(answer_json(result)["limits"][0]["sense"] == "between");
  CHECK(answer_json(result)["limits"][0]["limit"].is_null());

  result.no_value = 12;
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "12 motors have no value for a limit and count as failing.\n"));
  CHECK(answer_json(result)["without_value"] == 12);
  result.no_value = 1;
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "1 motor has no value for a limit and counts as failing.\n"));
}

TEST_CASE("where all motors keep the limits, no limit costs most",
          "[studies][uncertainty][words]") {
  UncertaintyResult result = with_limits();
  for (auto& limit : result.limits) limit.kept = {1, 0.99, 1};
  CHECK_THAT(headline_text(result), !Contains("costs most"));
}

TEST_CASE("a yield is good from 95 % of the motors on", "[studies][uncertainty][words]") {
  UncertaintyResult result = with_limits();
  CHECK(telling::headline(result_of(result)).look == telling::Headline::Look::bad);
  CHECK(telling::headline(result_of(result)).badge == "87.5 % keep the limits");
  result.yield = Estimate{0.96, 0.95, 0.97};  // its lower end decides
  CHECK(telling::headline(result_of(result)).look == telling::Headline::Look::good);
  result.yield = Estimate{0.96, 0.94, 0.97};
  CHECK(telling::headline(result_of(result)).look == telling::Headline::Look::bad);
}

TEST_CASE("limits without metrics have no table of spreads", "[studies][uncertainty][words]") {
  UncertaintyResult result = with_limits();
  result.metrics.clear();
  CHECK_THAT(sections_text(result), EndsWith("\nSpread\n1000 motors drawn; intervals of 95 %.\n"));
}

TEST_CASE("failing motors are told in a million, with what causes them",
          "[studies][uncertainty][words]") {
  UncertaintyResult result;
  result.samples = 16384;
  result.weighted = true;
  result.ways = 2;
  result.sought = 32768;
  result.variables = {{"preload", "N"}, {"kinetic_friction", "1"}};
  UncertaintyResult::Limit torque{"stall_torque >= 0.5 N.m", "stall_torque", 0.5, kInfinity};
  torque.broken = {2e-6, 1.8e-6, 2.2e-6};
  torque.kept = {1 - 2e-6, 1 - 2.2e-6, 1 - 1.8e-6};
  torque.index = 4.61;
  torque.likeliest = {148, 0.13};
  torque.causes = {{0.02, 0.01, 0.03}, {0.98, 0.97, 0.99}};
  result.limits = {torque};
  result.broken = torque.broken;
  result.yield = torque.kept;
  result.causes = torque.causes;
  result.tighter = {{1e-8, 0.9e-8, 1.1e-8}, {kNaN, kNaN, kNaN}};
  CHECK_THAT(
      headline_text(result),
      StartsWith(
          "2 in a million motors violate a limit (between 1.8 and 2.2 with 95 % confidence).\n"));
  const std::string text = barred(sections_text(result));
  CHECK_THAT(text, Contains("stall_torque >= 0.5 N.m | 2 | 1.8 | 2.2 | 4.61\n"));
  CHECK_THAT(text, Contains("stall_torque >= 0.5 N.m | preload 148 N, kinetic_friction 0.13\n"));
  CHECK_THAT(text, Contains("The tolerance of kinetic_friction causes most of the failures, 98 %"));
  CHECK_THAT(text, Contains("tolerance | of the failures | at least | at most\n"
                            "kinetic_friction | 98 % | 97 % | 99 %\n"
                            "preload | 2 % | 1 % | 3 %\n"));
  const Json json = answer_json(result);
  CHECK(json["method"] == "importance");
  CHECK(json["failing"]["per_million"]["value"] == Approx(2).epsilon(1e-12));
  CHECK(json["failing"]["causes"]["preload"]["value"] == 0.02);
  CHECK(json["limits"][0]["likeliest"]["preload"] == 148);
  CHECK(json["limits"][0]["index"] == 4.61);
  // Without a failing motor only what so many motors could miss is said.
  result.broken = {0, 0, 1.8e-3};
  result.causes.clear();
  CHECK_THAT(headline_text(result), StartsWith("No motor was found that violates a limit: with 95 "
                                               "% confidence fewer than 1800 in a million do."));
}
