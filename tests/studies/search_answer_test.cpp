// SPDX-License-Identifier: Apache-2.0
// What a search says of a design that is given: bounds, limits, verdict, and why there is none.
#include "answer_support.hpp"
#include "results/search_words.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

LimitState limit(const std::string& text, double value, double bound, double violation = 0) {
  LimitState state;
  state.text = text;
  state.metric = "max_pressure";
  state.unit = "Pa";
  state.value = value;
  state.limit = bound;
  state.violation = violation;
  return state;
}

LimitState active(LimitState state, double multiplier, double gain_per_percent) {
  state.active = true;
  state.multiplier = multiplier;
  state.gain_per_percent = gain_per_percent;
  return state;
}

// The largest peak power, at the largest amplitude and at a pressure that binds.
OptimizeResult optimum() {
  OptimizeResult result;
  result.goal = {"peak_power", "W", true};
  result.found = true;
  result.best.design = {{"amplitude", "m", 2e-6}, {"preload", "N", 180}, {"thickness", "m", 3e-4}};
  result.best.metrics = {{"peak_power", "W", 5}, {"max_pressure", "Pa", 2e6}};
  result.best.constraints = {active(limit("max_pressure <= 2 MPa", 2e6, 2e6), 1e-6, 0.02),
                             limit("contact_ratio <= 0.5", 0.4, 0.5)};
  result.best.constraints[0].tolerance = 0.02;
  result.best.constraints[1].unit = "1";
  result.best.bounds = {{{"amplitude", "m"}, true, 2e-6, 1e6, 0.02},
                        {{"thickness", "m"}, false, 3e-4, 0, 0}};
  result.best.certificate.passed = true;
  result.best.certificate.infeasibility = 0;
  result.best.certificate.stationarity = 1.2e-7;
  result.best.certificate.second_order = true;
  result.best.certificate.gain = 3e-9;
  result.best.certificate.weights = {1};
  result.best.certificate.prices = {1};
  result.before_design = {{"amplitude", "m", 1.6e-6}, {"preload", "N", 160}};
  result.before_metrics = {{"peak_power", "W", 4}, {"max_pressure", "Pa", 1.5e6}};
  result.solver = "nlopt:slsqp";
  result.stages = {{0, "nlopt:slsqp", "XTOL_REACHED", 4, true, 5, 30},
                   {1, "nlopt:slsqp", "XTOL_REACHED", 4, true, 5, 31},
                   {2, "ipopt", "Solve_Succeeded", 0, true, 4.5, 40},
                   {3, "", "", 0, false, kNaN, 0}};
  return result;
}

RelaxationState relaxation(const std::string& text, bool at_least, double amount, double alone) {
  return {text, "stall_torque", "N.m", at_least, 1, amount, alone};
}

}  // namespace

TEST_CASE("an optimum says what it is, what holds it, and who found it",
          "[studies][optimize][words]") {
  const OptimizeResult result = optimum();
  CHECK(barred(sections_text(result)) ==
        "Limits\n"
        "max_pressure <= 2 MPa: 1 % looser, at 2.02 MPa, changes peak_power by +20 mW (+0.4 %).\n"
        "amplitude <= 2 um, the end of its range: 1 % looser, at 2.02 um, changes peak_power by "
        "+20 mW (+0.4 %).\n"
        "thickness >= 300 um, the end of its range: it is met, but loosening it by 1 % changes "
        "nothing to first order.\n"
        "limit | state | value | to spare | kept within\n"
        "max_pressure <= 2 MPa | binds | 2 MPa | 0 Pa | 20 mPa\n"
        "amplitude <= 2 um | binds | 2 um | 0 m | -\n"
        "thickness >= 300 um | binds | 300 um | 0 m | -\n"
        "contact_ratio <= 0.5 | holds | 0.4 | 0.1 | -\n\n"
        "Design\n"
        "parameter | before | best\n"
        "amplitude | 1.6 um | 2 um\n"
        "preload | 160 N | 180 N\n"
        "thickness | - | 300 um\n\n"
        "Metrics\n"
        "metric | before | best\n"
        "peak_power | 4 W | 5 W\n"
        "max_pressure | 1.5 MPa | 2 MPa\n\n"
        "Verification\n"
        "Certified by exact derivatives, independent of the solver: no small change within the "
        "limits improves it (the slope is zero up to this share of its terms: 1.2e-07; a step "
        "could gain at most 3 nW).\n"
        "It is a local optimum: 2 of 3 solver runs from different starts ended at this value, and "
        "none found a better one within the limits. A better design far from all of them is still "
        "possible.\n\n"
        "Solver runs\n"
        "The answer was found by nlopt:slsqp.\n"
        "stage | solver | return code | peak_power | keeps limits | evaluations\n"
        "0 | nlopt:slsqp | XTOL_REACHED | 5 W | yes | 30\n"
        "1 | nlopt:slsqp | XTOL_REACHED | 5 W | yes | 31\n"
        "2 | ipopt | Solve_Succeeded | 4.5 W | yes | 40\n"
        "3 | - | - | - | no | 0\n");
}

TEST_CASE("what a sample of the whole range said is told", "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.scan = {512, 40, 0, false, 5};
  CHECK_THAT(
      sections_text(result),
      Contains(
          "None of 512 designs sampled over the whole range (40 keep the limits) is better.\n"));
  CHECK(
      answer_json(result)["scan"] ==
      Json{
          {"designs", 512}, {"feasible", 40}, {"better", 0}, {"replaced", false}, {"before", 5.0}});
  result.scan = {512, 40, 3, true, 4.5};
  CHECK_THAT(
      sections_text(result),
      Contains(
          "3 of 512 designs sampled over the whole range (40 keep the limits) were better than the "
          "4.5 W of the searches; a search from the best of them found this design.\n"));
  result.scan.replaced = false;
  CHECK_THAT(
      sections_text(result),
      Contains("(40 keep the limits) are better, but the search from the best of them found "
               "no answer; raise max_evaluations, or start from that row of results.csv.\n"));
  result.best.constraints.clear();
  result.scan.better = 0;
  CHECK_THAT(sections_text(result),
             Contains("None of 512 designs sampled over the whole range is better.\n"));
}

TEST_CASE("a check that holds whole numbers as they are says so", "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.best.design.push_back({"wavelengths", "1", 9});
  CHECK_THAT(
      sections_text(result),
      Contains("independent of the solver, with wavelengths held: no small change within the "
               "limits improves it (the slope") &&
          Contains("is still possible. Each run keeps wavelengths unchanged; the effect of the "
                   "limits above is for the value found.\n"));
  result.best.certificate.second_order = false;
  CHECK_THAT(sections_text(result), Contains("within the limits improves it to first order ("));
  result.whole_ends = {{{"wavelengths", "1"}, true, 9}};
  CHECK_THAT(
      sections_text(result),
      Contains("\nwavelengths <= 9, the end of its range: whole numbers have no slope. Try a "
               "wider range.\n"));
}

TEST_CASE("an optimum in summary.json has its evidence beside it", "[studies][optimize]") {
  OptimizeResult result = optimum();
  result.best.certificate.curvature = kNaN;
  result.best.certificate.findings = {{optim::Degeneracy::kink, "Derivatives differ", {"preload"}}};
  result.without_influence = {"width"};
  const Json json = answer_json(result);
  CHECK(json["objective"] == Json{{"metric", "peak_power"}, {"sense", "maximize"}});
  const Json& best = json["best"];
  CHECK(best["design"]["preload"] == 180);
  CHECK(best["metrics"]["peak_power"] == 5);
  CHECK(best["constraints"][0]["active"] == true);
  CHECK(best["constraints"][0]["multiplier"] == 1e-6);
  CHECK_FALSE(best["constraints"][0].contains("gains"));  // one goal: the multiplier says it
  CHECK(best["constraints"][1]["active"] == false);
  CHECK(best["bounds"][0]["side"] == "upper");
  CHECK(best["bounds"][1]["side"] == "lower");
  CHECK(best["certificate"]["passed"] == true);
  CHECK(best["certificate"]["curvature"].is_null());
  CHECK(best["certificate"]["findings"][0] ==
        Json{{"kind", "kink"}, {"text", "Derivatives differ"}, {"names", {"preload"}}});
  CHECK(json["before"]["design"] == Json{{"amplitude", 1.6e-6}, {"preload", 160.0}});
  CHECK(json["variables_without_influence"] == Json::array({"width"}));
  CHECK(json["stages"][2]["word"] == "Solve_Succeeded");
  CHECK(json["stages"][3]["objective"].is_null());
  CHECK(json["units"]["peak_power"] == "W");
  CHECK_FALSE(json.contains("relaxation"));
  result.goal.maximize = false;
  CHECK(answer_json(result)["objective"]["sense"] == "minimize");
}

TEST_CASE("a design that is not certified says why, and what is odd about it",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.best.certificate.passed = false;
  result.best.certificate.reason = "the evaluations ran out";
  result.solver.clear();
  result.stages.clear();
  result.best.constraints.clear();
  result.without_influence = {"width", "thickness"};
  result.best.certificate.findings = {
      {optim::Degeneracy::flat_direction, "unused", {"preload", "thickness", "width"}},
      {optim::Degeneracy::flat_direction, "unused", {"preload"}},
      {optim::Degeneracy::kink, "Derivatives differ", {"preload", "amplitude"}},
      {optim::Degeneracy::flat_objective, "The goal has no slope", {}}};
  result.best.bounds.clear();
  const std::string text = sections_text(result);
  CHECK_THAT(text, !Contains("1 % looser"));
  CHECK_THAT(text, EndsWith("\n\n"
                            "Verification\n"
                            "Not certified as an optimum: the evaluations ran out.\n"
                            "To first order, neither the goal nor an active limit depends here on width or thickness.\n"
                            "Flat direction: preload, thickness and width can change together "
                            "without changing the answer; "
                            "this design is one of many.\n"
                            "Flat direction: preload can change without changing the answer; this "
                            "design is one of many.\n"
                            "Derivatives differ: preload and amplitude.\n"
                            "The goal has no slope.\n"));
}

TEST_CASE("limits that are broken, or that have no value, say so", "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.best.certificate.infeasibility = 0.1;
  result.best.constraints = {active(limit("max_pressure <= 2 MPa", 2.2e6, 2e6, 0.2e6), 1, 1),
                             limit("contact_ratio <= 1", kNaN, 1, kNaN),
                             active(limit("stall_torque <= 1 N.m", 1, 1), 1, 0),
                             limit("max_torque <= 2 N.m", 2e6, 2e6, 1)};
  // The last is off by 1 Pa of 2 MPa, which its tolerance allows.
  result.best.constraints[3].tolerance = 2;
  CHECK_THAT(barred(sections_text(result)),
             Contains("\nmax_pressure <= 2 MPa | broken by 200 kPa | 2.2 MPa | -200 kPa | -\n") &&
                 Contains("\ncontact_ratio <= 1 | cannot be reached | - | - | -\n") &&
                 Contains("\nstall_torque <= 1 N.m | binds | 1 Pa | 0 Pa | -\n") &&
                 Contains("\nmax_torque <= 2 N.m | holds | 2 MPa | 0 Pa | 2 Pa\n"));
  CHECK(broken(result.best.constraints[0]));
  CHECK_FALSE(keeps_limits(result.best));
  // What the limit tolerates is not broken, but a missing value still is.
  result.best.constraints[0].tolerance = 0.3e6;
  CHECK_FALSE(broken(result.best.constraints[0]));
  CHECK_FALSE(keeps_limits(result.best));
  result.best.constraints.erase(result.best.constraints.begin() + 1);
  CHECK(keeps_limits(result.best));
}

TEST_CASE("no design at all is one sentence", "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.found = false;
  CHECK(headline_text(result, "failed") == "No design could be evaluated.\n");
  CHECK(headline_text(result, "budget") ==
        "The search ended before it found a design with a value.\n");
  CHECK(sections_text(result).empty());
  CHECK(answer_json(result)["best"].is_null());
}

TEST_CASE("a design without a certificate is not called an optimum, and its limits have no prices",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.best.constraints = {active(limit("max_pressure <= 2 MPa", 2e6, 2e6), 1e-6, 0.02)};
  CHECK_THAT(sections_text(result), Contains("1 % looser"));
  result.best.certificate.passed = false;
  result.best.certificate.stationarity = 0.1;
  CHECK_THAT(sections_text(result), !Contains("looser"));
  CHECK_THAT(headline_text(result, "budget"), Contains("max_pressure <= 2 MPa: it is met."));
  result.best.constraints.clear();
  result.best.bounds.clear();
  CHECK_THAT(headline_text(result, "budget"),
             Contains("a longer search or another start may find a better one"));
  result.best.certificate.passed = true;
  CHECK_THAT(headline_text(result), Contains("it is an optimum inside the ranges"));
}

TEST_CASE("a robust search that ends before motors are drawn tells no share of them",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  RobustReport report;
  report.largest_yield = kNaN;
  report.limits = {{"stall_torque >= 1 N.m", true, "yield", 3.2}};
  report.nominal_objective = 1;
  report.tolerances = {{"preload", "1", 0.02}};
  result.robust = report;
  CHECK_THAT(headline_text(result, "budget"), Contains("before any motors were drawn"));
  CHECK_THAT(sections_text(result), !Contains("Causes of failures") &&
                                        !Contains("tolerances cost") &&
                                        !Contains("if 1 % tighter"));
}

TEST_CASE("limits that no design keeps are named with what would do",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  result.explanation.conflict = {"stall_torque >= 1 N.m", "max_pressure <= 2 MPa"};
  result.explanation.limits = {relaxation("stall_torque >= 1 N.m", true, 0.1, 0.3),
                               relaxation("max_torque <= 1 N.m", false, 0, kNaN),
                               relaxation("peak_torque <= 1 N.m", false, 0.25, 0.5)};
  const std::string text = barred(sections_text(result));
  CHECK_THAT(text,
             StartsWith("What would make it possible\n"
                        "limit to loosen | value if all are loosened | value if only this one is\n"
                        "stall_torque >= 1 N.m | 900 mN.m | 700 mN.m\n"
                        "max_torque <= 1 N.m | as it is | does not help alone\n"
                        "peak_torque <= 1 N.m | 1.25 N.m | 1.5 N.m\n"
                        "\n"));
  CHECK_THAT(text, !Contains("Certified") && !Contains("Verification"));
  CHECK(
      headline_text(result, "infeasible") ==
      "No design keeps every limit. These cannot hold together: stall_torque >= 1 N.m; "
      "max_pressure <= 2 MPa.\n"
      "It would be possible with one of these limits loosened: stall_torque >= 1 N.m by 300 mN.m, "
      "to 700 mN.m; or peak_torque <= 1 N.m by 500 mN.m, to 1.5 N.m.\n");
  const Json json = answer_json(result)["relaxation"];
  CHECK(json["conflict"] == Json::array({"stall_torque >= 1 N.m", "max_pressure <= 2 MPa"}));
  CHECK(json["limits"][0] == Json{{"text", "stall_torque >= 1 N.m"},
                                  {"metric", "stall_torque"},
                                  {"unit", "N.m"},
                                  {"sense", "at least"},
                                  {"limit", 1.0},
                                  {"amount", 0.1},
                                  {"amount_alone", 0.3}});
  CHECK(json["limits"][1]["amount_alone"].is_null());

  // One limit that cannot be reached by itself, without a way out; and a way out without a conflict.
  result.explanation.conflict = {"stall_torque >= 1 N.m"};
  result.explanation.limits.clear();
  CHECK(
      headline_text(result, "infeasible") ==
      "No design keeps every limit. stall_torque >= 1 N.m cannot be reached.\n"
      "No loosening of a single limit and no move of one end of a range was found to be enough.\n");
  CHECK_THAT(sections_text(result), !Contains("What would make it possible"));
  CHECK(answer_json(result).contains("relaxation"));
  result.explanation.limits = {relaxation("stall_torque >= 1 N.m", true, 0.1, kNaN)};
  CHECK_THAT(headline_text(result, "infeasible"),
             Contains("the table shows how far several have to be loosened together"));
  result.explanation.conflict.clear();
  result.explanation.limits = {relaxation("stall_torque >= 1 N.m", true, 0.1, 0.1)};
  CHECK_THAT(sections_text(result), StartsWith("What would make it possible\nlimit to loosen"));
}

TEST_CASE("a limit whose two sides depend on the motor is loosened by an amount, to no value",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  RelaxationState start = relaxation("start_voltage <= voltage", false, 2, 3);
  start.limit = 0, start.of_two_sides = true;
  result.explanation.conflict = {start.text, "max_pressure <= 2 MPa"};
  result.explanation.limits = {start};
  CHECK_THAT(headline_text(result, "infeasible"),
             EndsWith("loosened: start_voltage <= voltage by 3 N.m.\n"));
  CHECK_THAT(barred(sections_text(result)),
             Contains("start_voltage <= voltage | by 2 N.m | by 3 N.m\n"));
  ImpossibleState impossible{start.text, "N.m", false, 0, 1.5, true, {}};
  impossible.of_two_sides = true;
  result.explanation.impossible = {impossible};
  CHECK_THAT(
      headline_text(result, "infeasible"),
      Contains("start_voltage <= voltage cannot be reached: the least of its left side minus its "
               "right side that was found within the ranges is 1.5 N.m"));
}

TEST_CASE("without a design that keeps the limits there are no prices",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  CHECK_THAT(sections_text(result), Contains("Limits\n") && Contains("1 % looser"));
  result.explanation.conflict = {"max_pressure <= 2 MPa"};
  CHECK_THAT(sections_text(result), !Contains("Limits\n") && !Contains("1 % looser") &&
                                        Contains("Limits at the design that violates them least"));
}

TEST_CASE("limits impossible alone come first, then those that exclude each other, then the ranges",
          "[studies][optimize][words]") {
  OptimizeResult result = optimum();
  Explanation& told = result.explanation;
  told.conflict = {"stall_torque >= 1 N.m", "a <= 2 m", "a >= 3 m"};
  told.ranges = {{{"preload", "N"}, true, 100, 180}, {{"amplitude", "m"}, false, 1e-6, kNaN}};
  told.impossible = {{"stall_torque >= 1 N.m", "N.m", true, 1, 0.5, true, {0, 1}}};
  told.limits = {relaxation("stall_torque >= 1 N.m", true, 0.5, kNaN)};
  CHECK_THAT(
      headline_text(result, "infeasible"),
      StartsWith(
          "No design keeps every limit. "
          "stall_torque >= 1 N.m cannot be reached: the most found within the ranges is 500 mN.m, "
          "at preload <= 100 N and amplitude >= 1 um. "
          "The others exclude each other as well: a <= 2 m; a >= 3 m.\n"
          "It would be possible with this limit loosened: the range of preload <= 100 N, to 180 "
          "N."));
  CHECK_THAT(barred(sections_text(result)),
             StartsWith("What would make it possible\n"
                        "limit to loosen | value if all are loosened | value if only this one is\n"
                        "stall_torque >= 1 N.m | 500 mN.m | does not help alone\n"
                        "\n"
                        "end of a range to move | value if only this one is\n"
                        "preload <= 100 N | 180 N\n"
                        "amplitude >= 1 um | none found\n"));
  const Json json = answer_json(result)["relaxation"];
  CHECK(json["impossible"] == Json::array({Json{{"text", "stall_torque >= 1 N.m"},
                                                {"unit", "N.m"},
                                                {"sense", "at least"},
                                                {"limit", 1.0},
                                                {"best", 0.5},
                                                {"certified", true},
                                                {"ends", {0, 1}}}}));
  CHECK(json["ranges"] == Json::array({Json{{"variable", "preload"},
                                            {"side", "upper"},
                                            {"limit", 100.0},
                                            {"limit_alone", 180.0}},
                                       Json{{"variable", "amplitude"},
                                            {"side", "lower"},
                                            {"limit", 1e-6},
                                            {"limit_alone", nullptr}}}));

  // An upper limit without an end where its best value is; nothing else excludes.
  told.conflict = {"max_pressure <= 1 MPa"};
  told.ranges.clear();
  told.limits.clear();
  told.impossible = {{"max_pressure <= 1 MPa", "Pa", false, 1e6, 2e6, false, {}}};
  CHECK_THAT(headline_text(result, "infeasible"),
             StartsWith("No design keeps every limit. max_pressure <= 1 MPa cannot be reached: the "
                        "least found within the ranges is 2 MPa.\n"));
}

TEST_CASE("names are enumerated, and looked up", "[studies][optimize][words]") {
  CHECK(enumeration({}).empty());
  CHECK(enumeration({"a"}) == "a");
  CHECK(enumeration({"a", "b"}) == "a and b");
  CHECK(enumeration({"a", "b", "c"}) == "a, b and c");
  const std::vector<NamedValue> values{{"preload", "N", 160}, {"amplitude", "m", 1e-6}};
  CHECK(value_of(values, "amplitude") == 1e-6);
  CHECK(std::isnan(value_of(values, "thickness")));
}
