// SPDX-License-Identifier: Apache-2.0
// What a sensitivity study says of indices that are given: which sentence follows from which numbers.
#include "answer_support.hpp"
#include "studies/statistics/study_text.hpp"

#include <catch2/catch.hpp>

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

SensitivityResult frame(SensitivityMethod method) {
  SensitivityResult result;
  result.method = method;
  result.samples = 1024;
  result.variables = {{"amplitude", "m"}, {"preload", "N"}, {"kinetic_friction", "1"}};
  MetricSensitivity metric;
  metric.metric = {"stall_torque", "N.m"};
  metric.samples = 1024;
  metric.value = 0.6;
  metric.sd = 0.05;
  result.metrics.push_back(metric);
  return result;
}

SensitivityResult sobol(MetricSensitivity::Sobol shares) {
  SensitivityResult result = frame(SensitivityMethod::sobol);
  result.metrics[0].effects = std::move(shares);
  return result;
}

SensitivityResult morris(MetricSensitivity::Morris effects) {
  SensitivityResult result = frame(SensitivityMethod::morris);
  result.samples = 20;
  result.metrics[0].effects = std::move(effects);
  return result;
}

SensitivityResult local(MetricSensitivity::Local effects) {
  SensitivityResult result = frame(SensitivityMethod::local);
  result.motor = {1.6e-6, 160, 0.2};
  result.metrics[0].sd = kNaN;
  result.metrics[0].effects = std::move(effects);
  return result;
}

// An index without an interval round it.
SobolShares sharp(double first, double total) {
  const double rest = total - first;
  return {{first, first, first}, {total, total, total}, {rest, rest, rest}, {}};
}

ElementaryEffect effect(Estimate mu_star, Estimate sigma) { return {0, mu_star, sigma}; }

}  // namespace

TEST_CASE("Sobol indices are told from the largest total on, then what they add up to",
          "[studies][sensitivity][words]") {
  // No interactions are seen of the amplitude and the friction: both of their indices are the better known one.
  SensitivityResult result =
      sobol({{{0, -0.001, 0.001}, {0.0004, 0, 0.0015}, {0.0004, -0.001, 0.002}, {}},
             {{0.3, 0.25, 0.36}, {0.45, 0.4, 0.5}, {0.15, 0.05, 0.25}, {0.6, 0.5, 0.7}},
             {{0.5, 0.45, 0.55}, {0.62, 0.5, 0.7}, {0.12, -0.02, 0.26}, {}}});
  result.width = 0.05;
  result.narrow = false;
  // The first indices add up to 0.8, and their upper ends to 0.111 more: less than the 0.2 that is left.
  CHECK(headline_text(result) ==
        "stall_torque: kinetic_friction has the largest influence (50 % of its variance), then "
        "preload.\n");
  CHECK(barred(sections_text(result)) ==
        "stall_torque\n"
        "Mean 600 mN.m, standard deviation 50 mN.m.\n"
        "kinetic_friction has the largest influence: alone it explains 50 % of the variance.\n"
        "Interactions explain 20 %.\n"
        "amplitude has almost no influence (below 1 %).\n"
        "variable | total | low | high | first order | low | high\n"
        "kinetic_friction | 50 % | 45 % | 55 % | 50 % | 45 % | 55 %\n"
        "preload | 45 % | 40 % | 50 % | 30 % | 25 % | 36 %\n"
        "amplitude | 0.04 % | 0 % | 0.15 % | 0.04 % | 0 % | 0.15 %\n\n"
        "How the effects were computed\n"
        "Shares of the variance (Sobol), 1024 base samples; intervals of 95 %.\n"
        "Some intervals are still wider than the 0.05 requested: raise max_samples.\n");

  const Json json = answer_json(result);
  CHECK(json["method"] == "sobol");
  CHECK(json["samples"] == 1024);
  CHECK(json["confidence"] == 0.95);
  CHECK(json["width"] == 0.05);
  CHECK(json["narrow"] == false);
  CHECK_FALSE(json.contains("at"));
  CHECK(json["units"] == Json{{"amplitude", "m"},
                              {"preload", "N"},
                              {"kinetic_friction", "1"},
                              {"stall_torque", "N.m"}});
  const Json& preload = json["indices"]["stall_torque"]["preload"];
  CHECK(preload["first"] == Json{{"value", 0.3}, {"low", 0.25}, {"high", 0.36}});
  CHECK(preload["interactions"] == Json{{"value", 0.15}, {"low", 0.05}, {"high", 0.25}});
  CHECK(preload["derivative_bound"] == Json{{"value", 0.6}, {"low", 0.5}, {"high", 0.7}});
  CHECK_FALSE(json["indices"]["stall_torque"]["amplitude"].contains("derivative_bound"));
  CHECK(json["metrics"]["stall_torque"]["mean"] == 0.6);
  CHECK(json["metrics"]["stall_torque"]["sd"] == 0.05);
}

TEST_CASE("indices that add up to one leave nothing to interactions",
          "[studies][sensitivity][words]") {
  SensitivityResult result = sobol({sharp(0, 0), sharp(0.25, 0.25), sharp(0.75, 0.75)});
  CHECK_THAT(
      barred(sections_text(result)),
      Contains(
          "kinetic_friction has the largest influence: alone it explains 75 % of the variance.\n"
          "amplitude has almost no influence (below 1 %).\n"));
  CHECK_THAT(sections_text(result), !Contains("max_samples"));
  CHECK_FALSE(answer_json(result).contains("width"));  // none was asked for
  // What is left, 0.2, is less than the intervals leave open: it may be nothing.
  auto& shares = std::get<MetricSensitivity::Sobol>(result.metrics[0].effects);
  shares[1].first = {0.05, -0.2, 0.3};
  CHECK_THAT(sections_text(result), !Contains("Interactions"));
}

TEST_CASE("an index below zero is an estimate of nothing", "[studies][sensitivity][words]") {
  const SensitivityResult result = sobol({sharp(-0.01, 0.9), sharp(0, 0.5), sharp(0, 0.4)});
  CHECK_THAT(sections_text(result),
             Contains("amplitude has the largest influence: alone it explains 0 % of the variance, "
                      "with its interactions 90 %.\n"
                      "Interactions explain 101 %.\n"));
}

TEST_CASE("variables that do not matter are listed in one sentence",
          "[studies][sensitivity][words]") {
  SensitivityResult result = sobol({sharp(0, 0), sharp(0, 0), sharp(1, 1)});
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "amplitude and preload have almost no influence (below 1 %).\n"));
  result.variables.push_back({"thickness", "m"});
  std::get<MetricSensitivity::Sobol>(result.metrics[0].effects).push_back(sharp(0, 0));
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "amplitude, preload and thickness have almost no influence (below 1 %).\n"));
  // Below a hundredth as a whole: an interval that reaches to it leaves it open.
  SobolShares& thickness = std::get<MetricSensitivity::Sobol>(result.metrics[0].effects)[3];
  thickness.first.high = thickness.total.high = 0.01;
  CHECK_THAT(sections_text(result),
             Contains("\n"
                      "amplitude and preload have almost no influence (below 1 %).\n"));
}

TEST_CASE("indices that there are none of are dashes, and lead to no sentence",
          "[studies][sensitivity][words]") {
  const SensitivityResult result = sobol({SobolShares{}, SobolShares{}, SobolShares{}});
  CHECK_THAT(barred(sections_text(result)),
             Contains("deviation 50 mN.m.\n"
                      "variable | total | low | high | first order | low | high\n"
                      "amplitude | - | - | - | - | - | -\n"
                      "preload | - | - | - | - | - | -\n"
                      "kinetic_friction | - | - | - | - | - | -\n"));
  CHECK(answer_json(result)["indices"]["stall_torque"]["preload"]["total"]["value"].is_null());
}

TEST_CASE("elementary effects carry the unit of the metric", "[studies][sensitivity][words]") {
  // Of 0.2 N.m, 2 mN.m are a hundredth: the amplitude does no more than that, the preload more.
  SensitivityResult result = morris({effect({1e-3, 0, 2e-3}, {0.5e-3, 0, 1e-3}),
                                     effect({0.05, 0.04, 0.06}, {0.01, 0.005, 0.02}),
                                     effect({0.2, 0.19, 0.21}, {0.02, 0.01, 0.03})});
  CHECK(headline_text(result) ==
        "stall_torque: kinetic_friction has the largest influence (200 mN.m across its range), "
        "then preload.\n");
  CHECK_THAT(
      barred(sections_text(result)),
      Contains("kinetic_friction has the largest influence: across its range it changes "
               "stall_torque by 200 mN.m on average.\n"
               "amplitude has almost no influence (below 1 %).\n"
               "variable | µ* | low | high | σ | low | high\n"
               "kinetic_friction | 200 mN.m | 190 mN.m | 210 mN.m | 20 mN.m | 10 mN.m | 30 mN.m\n"
               "preload | 50 mN.m | 40 mN.m | 60 mN.m | 10 mN.m | 5 mN.m | 20 mN.m\n"
               "amplitude | 1 mN.m | 0 N.m | 2 mN.m | 500 uN.m | 0 N.m | 1 mN.m\n") &&
          EndsWith("\nElementary effects across the ranges (Morris), 20 trajectories; intervals of "
                   "95 %.\n"));
  const Json json = answer_json(result);
  const Json& preload = json["indices"]["stall_torque"]["preload"];
  CHECK(preload["mu_star"] == 0.05);
  CHECK(preload["sigma"] == 0.01);
  CHECK(preload["mu"] == 0.0);
  CHECK(preload["mu_star_interval"] == Json{{"low", 0.04}, {"high", 0.06}});
  CHECK(preload["sigma_interval"] == Json{{"low", 0.005}, {"high", 0.02}});

  // One trajectory has no intervals, so nothing is known not to matter.
  result = morris(
      {effect({0, kNaN, kNaN}, {}), effect({0.1, kNaN, kNaN}, {}), effect({0.2, kNaN, kNaN}, {})});
  CHECK_THAT(barred(sections_text(result)), Contains("on average.\n"
                                                     "variable") &&
                                                Contains("preload | 100 mN.m | - | - | - | - | -"));
}

TEST_CASE("a metric that nothing changes says so", "[studies][sensitivity][words]") {
  const ElementaryEffect none = effect({0, 0, 0}, {0, 0, 0});
  CHECK_THAT(sections_text(morris({none, none, none})),
             Contains("\n"
                      "No variable has an influence.\n"));
}

TEST_CASE("local effects stand beside the motor where they hold", "[studies][sensitivity][words]") {
  // T = mu F_N r: 1 % more of either factor is 1 % more torque; dT/dF_N = T / F_N, dT/dmu = T / mu.
  SensitivityResult result = local({{0, 0}, {0.6 / 160, 1}, {0.6 / 0.2, 1}});
  CHECK(headline_text(result) ==
        "stall_torque: preload has the largest influence (1 % for 1 % more), then "
        "kinetic_friction.\n");
  CHECK(barred(sections_text(result)) ==
        "stall_torque: 600 mN.m\n"
        "preload has the largest influence: 1 % more of it changes stall_torque by 1 %.\n"
        "variable | elasticity | at | gradient\n"
        "preload | 1 % | 160 N | 3.75 mN.m per N\n"
        "kinetic_friction | 1 % | 0.2 | 3 N.m per 1\n"
        "amplitude | 0 % | 1.6 um | 0 N.m per m\n\n"
        "How the effects were computed\n"
        "Derivatives at the given motor.\n");
  const Json json = answer_json(result);
  CHECK(json["at"] == Json{{"amplitude", 1.6e-6}, {"preload", 160}, {"kinetic_friction", 0.2}});
  CHECK(json["metrics"]["stall_torque"] == Json{{"value", 0.6}, {"smoothness", "smooth"}});
  CHECK(json["indices"]["stall_torque"]["preload"] ==
        Json{{"gradient", 0.6 / 160}, {"elasticity", 1}});
  CHECK_FALSE(json.contains("samples"));
  CHECK_FALSE(json.contains("confidence"));

  // A metric and a variable without dimension.
  result.metrics[0].metric = {"contact_efficiency_at_peak_power", "1"};
  CHECK_THAT(barred(sections_text(result)), Contains("| 3 per 1\n"));
}

TEST_CASE("what a gradient is good for is a sentence", "[studies][sensitivity][words]") {
  SensitivityResult result = local({{0, 0}, {0, 0}, {0, 0}});
  CHECK_THAT(sections_text(result), !Contains("matters most"));
  result.metrics[0].smoothness = Smoothness::flat;
  CHECK_THAT(
      sections_text(result),
      Contains("\n"
               "The metric is constant near this point: a gradient of zero holds only nearby.\n"));
  CHECK(answer_json(result)["metrics"]["stall_torque"]["smoothness"] == "flat");
  result.metrics[0].smoothness = Smoothness::one_sided;
  CHECK_THAT(
      sections_text(result),
      Contains("\n"
               "The metric has a kink or a jump here: the gradients are those of one side.\n"));
  result.metrics[0].smoothness = Smoothness::undefined;
  result.metrics[0].effects = MetricSensitivity::Local(3, LocalEffect{kNaN, kNaN});
  CHECK_THAT(barred(sections_text(result)), Contains("\n"
                                                     "The metric has no derivative here.\n") &&
                                                Contains("kinetic_friction | - | 0.2 | -\n"));
  CHECK(answer_json(result)["indices"]["stall_torque"]["preload"]["gradient"].is_null());
}

TEST_CASE("what is rounding of the largest elasticity is none", "[studies][sensitivity][words]") {
  // 1e-10 of the largest is less than the derivatives are exact to.
  const std::string text = barred(sections_text(local({{0.1, 1e-10}, {1, -1.5}, {0, kNaN}})));
  CHECK_THAT(text, Contains("\npreload | -1.5 % | 160 N | 1 N.m per N\n") &&
                       Contains("\namplitude | 0 % | 1.6 um | 0 N.m per m\n") &&
                       Contains("\nkinetic_friction | - | 0.2 | 0 N.m per 1\n"));
}

TEST_CASE("a variable that takes whole numbers has a derivative between them",
          "[studies][sensitivity][words]") {
  SensitivityResult result = local({{0, 0}, {0, 0}, {0, 0}});
  result.variables = {{"wavelengths", "1"}, {"preload", "N"}, {"not_a_parameter", "1"}};
  CHECK_THAT(sections_text(result), EndsWith("Derivatives at the given motor.\n"
                                             "wavelengths takes whole numbers only; its derivative "
                                             "is that of the continuous model between them.\n"));
}

TEST_CASE("samples that were dropped are counted, or explained by the note",
          "[studies][sensitivity][words]") {
  SensitivityResult result = sobol({sharp(0, 0), sharp(0, 0), sharp(1, 1)});
  result.metrics[0].dropped = 24;
  result.metrics[0].samples = 1000;
  CHECK_THAT(sections_text(result),
             Contains("deviation 50 mN.m; 24 of 1024 samples left out because they failed.\n"));
  result.metrics[0].note = "half of them";
  CHECK_THAT(sections_text(result), Contains("deviation 50 mN.m.\nhalf of them\n"));
  CHECK(answer_json(result)["metrics"]["stall_torque"]["note"] == "half of them");
  CHECK(answer_json(result)["metrics"]["stall_torque"]["dropped"] == 24);

  // No value, no effects: the name and the reason, and nothing that looks like a number.
  result.metrics[0].value = kNaN;
  result.metrics[0].effects = MetricSensitivity::Sobol();
  CHECK_THAT(sections_text(result), StartsWith("stall_torque\nhalf of them\n"));
  CHECK(headline_text(result) == "No effect could be computed.\n");
  CHECK(answer_json(result)["indices"]["stall_torque"].is_null());
  CHECK(answer_json(result)["metrics"]["stall_torque"]["mean"].is_null());
}

TEST_CASE("a study that was stopped before its first motor has no value to tell",
          "[studies][sensitivity][words]") {
  const std::string method =
      GENERATE(Catch::Generators::as<std::string>{}, "local", "morris", "sobol");
  CAPTURE(method);
  RunOptions options;
  std::stop_source stop;
  stop.request_stop();
  options.stop = stop.get_token();
  const StudyResult result =
      run_study(elastic_study("  kind: sensitivity\n  method: " + method +
                              "\n  variables:\n    preload: {min: 100 N, max: 200 N}\n"
                              "  metrics: [stall_torque]\n"),
                options);
  CHECK(result.outcome == "interrupted");
  CHECK(result.evaluations == 0);
  CHECK_THAT(summary_text(result), Contains("\n\nstall_torque\nnothing evaluated yet\n"));
  const Json metric = Json::parse(summary_json(result))["metrics"]["stall_torque"];
  CHECK(metric[method == "local" ? "value" : "mean"].is_null());
}
