// SPDX-License-Identifier: Apache-2.0
// What a calibration says of a fit that is given: estimates, tests of the residuals, and doubts.
#include "answer_support.hpp"
#include "results/calibration_notes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

using Bound = CalibrateResult::Bound;

CalibrateResult::Estimate estimate(const std::string& name, const std::string& unit, double value,
                                   double low, double high) {
  CalibrateResult::Estimate one;
  one.parameter = {name, unit, value};
  one.deviation = (high - low) / 4;
  one.low = low;
  one.high = high;
  one.min = 0.5 * value;
  one.max = 2 * value;
  return one;
}

// Two parameters from four points that the motor misses by 1 mN.m at 0.5 N.m.
CalibrateResult fit() {
  CalibrateResult result;
  result.estimates = {estimate("kinetic_friction", "1", 0.2, 0.19, 0.21),
                      estimate("amplitude", "m", 1.5e-6, 1.4e-6, 1.6e-6)};
  result.correlation = {1, 0.5, 0.5, 1};
  result.data = {{1, 0.5, 1, 0.499, 0.001},
                 {2, 0.4, 1, 0.401, -0.001},
                 {3, 0.3, 1, 0.298, 0.002},
                 {4, 0.2, 1, 0.2, 0}};
  result.residual_rms = 0.001;
  result.residual_deviation = 0.0015;
  result.degrees_of_freedom = 2;
  result.student_t = 4.3;
  return result;
}

void start(CalibrateResult& result, optim::Outcome outcome, std::vector<double> values) {
  CalibrateResult::Start one;
  one.outcome = outcome;
  one.word = "said so";
  one.evaluations = 12;
  one.values = std::move(values);
  if (!one.values.empty()) one.residual_rms = 0.001;
  result.starts.push_back(one);
}

bool noted(const CalibrateResult& result, const std::string& sentence) {
  const std::vector<std::string> notes = calibration_notes(result);
  return std::find(notes.begin(), notes.end(), sentence) != notes.end();
}

// The note that begins so; empty if there is none.
std::string note(const CalibrateResult& result, const std::string& beginning) {
  for (const std::string& one : calibration_notes(result)) {
    if (one.starts_with(beginning)) return one;
  }
  return {};
}

// All torques of the fit, times a factor.
CalibrateResult fitted_by(double factor) {
  CalibrateResult result = fit();
  for (auto& point : result.data) {
    point.fitted = factor * point.value;
    point.residual = point.value - point.fitted;
  }
  result.residual_rms = 0.4;  // large against 0.5 N.m: poor
  return result;
}

}  // namespace

TEST_CASE("estimates stand with their intervals in one unit", "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  const std::string text = barred(sections_text(result));
  CHECK_THAT(text, StartsWith("Estimates with intervals of 95 %\n"
                              "parameter | value | low | high\n"
                              "kinetic_friction | 0.2 | 0.19 | 0.21\n"
                              "amplitude | 1.5 um | 1.4 um | 1.6 um\n"));
  CHECK_THAT(text, Contains("\n"
                            "Quality of the fit\n"
                            "4 points, residual rms 1 mN.m, largest 2 mN.m of torque_at(28.65 rpm) "
                            "(measured - fitted).\n"));
  // 3 rad/s are 3 * 30 / pi = 28.648 rpm.
  result.estimates[0].bound = Bound::max;
  result.estimates[0].followers = {{"amplitude", 0.5}, {"preload", -1}};
  result.estimates[1].low = result.estimates[1].high = kNaN;
  result.undetermined = {{{"amplitude"}, kNaN}};
  CHECK_THAT(barred(sections_text(result)),
             Contains("kinetic_friction | 0.2 | 0.19 | 0.21 | at its max\n"
                      "amplitude | 1.5 um | - | - | not determined\n"));
  CHECK_THAT(headline_text(result, "undetermined"),
             Contains("kinetic_friction 0.2 (at its max), amplitude 1.5 um (not determined)."));
  CHECK(
      noted(result,
            "kinetic_friction is at its max: the other estimates and their intervals are valid for "
            "0.2. If it were 1 % larger, they would change: +0.5 % amplitude and -1 % preload."));
  result.estimates[0].bound = Bound::min;
  result.estimates[0].followers.clear();
  CHECK(noted(result,
              "kinetic_friction is at its min: the other estimates and their intervals are valid "
              "for 0.2."));
}

TEST_CASE("a fit in summary.json has its estimates, tests and starts", "[studies][calibrate]") {
  CalibrateResult result = fit();
  result.chi_square = 3.5;
  result.chi_square_p = 0.17;
  result.neighbours = optim::NeighbourTest{3, -0.25, 1};
  result.estimates[1].bound = Bound::max;
  result.undetermined = {{{"kinetic_friction", "preload"}, -1}, {{"width"}, kNaN}};
  result.optima = {{{0.2, 1.5e-6}, 0.001, 1, true, {}}};
  start(result, optim::Outcome::optimal, {0.2, 1.5e-6});
  start(result, optim::Outcome::failed, {});
  const Json json = answer_json(result);
  CHECK(json["estimates"]["kinetic_friction"]["value"] == 0.2);
  CHECK(json["estimates"]["kinetic_friction"]["at_bound"].is_null());
  CHECK(json["estimates"]["kinetic_friction"]["remark"] == "not determined");
  CHECK(json["estimates"]["amplitude"]["at_bound"] == "max");
  CHECK(json["correlation"]["amplitude"]["kinetic_friction"] == 0.5);
  CHECK(json["fit"]["poor"] == false);
  CHECK(json["fit"]["chi_square"] == Json{{"value", 3.5}, {"degrees_of_freedom", 2}, {"p", 0.17}});
  CHECK(json["fit"]["neighbours"] == Json{{"quantity", "torque_at"},
                                          {"over", "speed"},
                                          {"count", 3},
                                          {"correlation", -0.25},
                                          {"p", 1.0}});
  CHECK(json["undetermined"][0] ==
        Json{{"parameters", {"kinetic_friction", "preload"}}, {"undone_by", -1.0}});
  CHECK(json["undetermined"][1]["undone_by"].is_null());
  CHECK(json["optima"][0]["design"] == Json{{"kinetic_friction", 0.2}, {"amplitude", 1.5e-6}});
  CHECK(json["starts"][0]["outcome"] == "optimal");
  CHECK(json["starts"][1]["design"].is_null());
  CHECK(json["starts"][1]["residual_rms"].is_null());
  CHECK(json["data"][0]["fitted"] == 0.499);
  CHECK(json["units"]["amplitude"] == "m");
  CHECK(json["units"]["residual_sd"] == "N.m");
  const std::string text = sections_text(result);
  CHECK_THAT(text, Contains("chi-square 3.5 with 2 degrees of freedom, p = 0.17.\n"));
  CHECK_THAT(text, Contains("order of speed: correlation -0.25 of 3 points, p = 1.\n"));
  CHECK(answer_json(fit())["fit"]["chi_square"].is_null());
  CHECK(answer_json(fit())["fit"]["neighbours"].is_null());
}

TEST_CASE("no start that could be evaluated is one sentence", "[studies][calibrate][words]") {
  CalibrateResult result;
  result.data = {{1, 0.5, 1, kNaN, kNaN}};
  start(result, optim::Outcome::failed, {});
  CHECK(headline_text(result, "failed") ==
        "No fit was found. The motor has no torque at one of the speeds measured.\n");
  CHECK_THAT(sections_text(result), StartsWith("Points\n"));  // and nothing else
  const Json json = answer_json(result);
  CHECK(json["estimates"].empty());
  CHECK(json["residual_rms"].is_null());
  CHECK(json["notes"].empty());
  CHECK(json["data"][0]["fitted"].is_null());
}

TEST_CASE("torques in another unit are recognized by their size", "[studies][calibrate][words]") {
  // Root mean square of 0.5, 0.4, 0.3, 0.2: sqrt(0.54 / 4) = 0.3674.
  CHECK_THAT(note(fitted_by(0.25), "The measured torques are "),
             StartsWith("The measured torques are 4 times larger than those of the motor (root "
                        "mean squares 367 mN.m and 91.9 mN.m)"));
  CHECK_THAT(note(fitted_by(4), "The measured torques are "),
             StartsWith("The measured torques are 4 times smaller than those of the motor"));
  for (const double factor : {0.34, 2.9, 0.0}) {  // not far, or nothing to compare
    CHECK(fitted_by(factor).poor());
    CHECK(note(fitted_by(factor), "The measured torques are ").empty());
  }
  CalibrateResult still = fitted_by(1);
  for (auto& point : still.data) point.value = 0;
  still.neighbours = optim::NeighbourTest{20, 0.9, 1e-4};
  CHECK(still.poor());
  CHECK(note(still, "The measured torques are ").empty());
  CHECK(note(fit(), "The measured torques are ").empty());  // a good fit is not doubted
}

TEST_CASE("a motor that brakes where the points drive has speeds of another unit",
          "[studies][calibrate][words]") {
  CalibrateResult result = fitted_by(-1);
  CHECK_THAT(note(result, "At "), StartsWith("At 4 of 4 points the motor brakes where"));
  result.data[0].fitted = result.data[1].fitted = 0.1;  // half of them: as many speak against it
  CHECK(note(result, "At ").empty());
}

TEST_CASE("a poor fit says what makes it poor", "[studies][calibrate][words]") {
  CalibrateResult result = fitted_by(0.9);
  // 0.4 N.m of 0.5 N.m, the largest torque.
  CHECK_THAT(note(result, "The fit is poor"),
             StartsWith("The fit is poor: the residuals are large, 80 % of the largest torque"));
  result.neighbours = optim::NeighbourTest{20, 0.1, 0.3};
  CHECK_THAT(note(result, "The fit is poor"), Contains("residuals are large, 80 %"));
  result.neighbours->p = 0.001;
  CHECK_THAT(note(result, "The fit is poor"),
             Contains("residuals keep their sign over whole stretches of speed, 80 %"));
  result.chi_square = 3;
  result.chi_square_p = 0.4;
  CHECK_THAT(note(result, "The fit is poor"), Contains("keep their sign"));
  result.chi_square_p = 0.001;
  CHECK_THAT(note(result, "The fit is poor"),
             Contains("residuals are larger than the standard deviations given, 80 %"));
  CHECK(note(fit(), "The fit is poor").empty());
}

TEST_CASE("parameters that count only in combination: the text says which changes cancel",
          "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.undetermined = {{{"amplitude"}, kNaN}};
  CHECK(noted(result,
              "The data do not determine amplitude: give it in the motor; do not estimate it."));
  const std::string together =
      "kinetic_friction and preload act only in combination: the data cannot distinguish them. "
      "Give one of them in the motor; do not estimate it.";
  result.undetermined = {{{"kinetic_friction", "preload"}, -1}};
  CHECK(noted(result, together + " 1 % more kinetic_friction is compensated by 1 % less preload."));
  result.undetermined[0].undone_by = 2.5;
  CHECK(
      noted(result, together + " 1 % more kinetic_friction is compensated by 2.5 % more preload."));
  result.undetermined[0].undone_by = kNaN;
  CHECK(noted(result, together));
}

TEST_CASE("estimates that are hard to tell apart are named in pairs",
          "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.correlation = {1, -0.96, -0.96, 1};
  CHECK(
      noted(result, "kinetic_friction and amplitude are strongly correlated: coefficient -0.96."));
  result.correlation = {1, 0.95, 0.95, 1};
  CHECK(note(result, "kinetic_friction and amplitude").empty());
}

TEST_CASE("intervals are measured against the ranges that were searched",
          "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.estimates[0].high = 0.6;  // 0.41 wide; its range 0.1 to 0.4
  CHECK(noted(result,
              "The points hardly determine kinetic_friction: its interval is wider than "
              "its range."));
  CHECK_THAT(sections_text(result), Contains("wider than its range\n"));
  result.estimates[1].scale = optim::Scale::log;
  result.estimates[1].low = 0.7e-6;  // a ratio of 4.3; its range has one of 4
  result.estimates[1].high = 3e-6;
  CHECK(noted(result,
              "The points hardly determine kinetic_friction and amplitude: their intervals "
              "are wider than their ranges."));
  result.estimates[1].high = 2.7e-6;
  CHECK_FALSE(wider_than_range(result.estimates[1]));
}

TEST_CASE("an interval is of use if its ends are near each other, beside the value or the range",
          "[studies][calibrate]") {
  const auto of_use = [](double low, double high, double min, double max) {
    CalibrateResult::Estimate e = estimate("x", "1", 0.5 * (low + high), low, high);
    e.min = min;
    e.max = max;
    return CalibrateResult::of_use(e);
  };
  CHECK(of_use(0.1, 0.29, 0, 1));
  CHECK_FALSE(of_use(0.1, 0.31, 0, 1));    // more than a factor of 3, and a fifth of the range
  CHECK(of_use(-0.29, -0.1, -1, 1));       // of one sign
  CHECK_FALSE(of_use(-0.1, 0.15, -1, 1));  // an eighth of the range
  CHECK(of_use(-0.01, 0.02, -1, 1));       // near 0 the range is what counts
  CHECK(of_use(0, 0.002, 0, 0.1));
  CHECK_FALSE(of_use(0.2, std::numeric_limits<double>::infinity(), 0, 1));
  CHECK_FALSE(of_use(kNaN, kNaN, 0, 1));
  CalibrateResult::Estimate e = estimate("x", "1", 2, 1, 4);
  e.scale = optim::Scale::log;
  e.min = 1e-4;
  e.max = 1e4;  // 8 decades: a factor of 4 is less than a tenth of them
  CHECK(CalibrateResult::of_use(e));
  e.high_cut = true;
  CHECK(CalibrateResult::of_use(e));
  e.low_cut = true;  // the range says it, not the data
  CHECK_FALSE(CalibrateResult::of_use(e));
}

TEST_CASE("intervals of little use, and those that the range cuts off, are named",
          "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  CHECK(std::string(result.verdict()) == "fitted");
  result.estimates[0].low = 0.06;
  CHECK(noted(result,
              "The points determine only poorly kinetic_friction: the ends of its interval differ "
              "by more than a factor of 3."));
  CHECK(std::string(result.verdict()) == "undetermined");
  CHECK_THAT(sections_text(result), Contains("hardly determined\n"));
  result.estimates[0].low_cut = true;
  CHECK(noted(result,
              "The interval of kinetic_friction ends at the end of its range: the points allow "
              "values beyond it."));
  CHECK(answer_json(result)["estimates"]["kinetic_friction"]["cut_off"] == "low");
  result.estimates[0].high_cut = true;
  CHECK(
      noted(result,
            "The points hardly determine kinetic_friction: its interval is wider than its range."));
  CHECK(answer_json(result)["estimates"]["kinetic_friction"]["cut_off"] == "both");
}

TEST_CASE("a combination that the data do not determine is reported as a change of the motor",
          "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.combinations = {{{{"youngs_modulus", -10}, {"amplitude", -3.214}}, 0.25, false}};
  CHECK(noted(result,
              "A softer layer (youngs_modulus -10 %) with a smaller wave (amplitude -3.2 %) fits "
              "nearly as well: the measured numbers change by 0.25 standard deviations (root mean "
              "square)."));
  CHECK(answer_json(result)["combinations"][0] ==
        Json{{"words",
              "a softer layer (youngs_modulus -10 %) with a smaller wave (amplitude -3.2 %)"},
             {"percent", {{"youngs_modulus", -10.0}, {"amplitude", -3.214}}},
             {"effect", 0.25},
             {"unseen", false}});
  result.combinations[0].effect = 2;
  CHECK_THAT(note(result, "A softer layer"),
             Contains("is the change that the data determine least: the measured numbers"));
  result.combinations[0].effect = kNaN;
  CHECK_THAT(note(result, "A softer layer"),
             EndsWith("is the change that the data determine least."));
  result.combinations[0].unseen = true;
  CHECK_THAT(note(result, "A softer layer"),
             EndsWith("fits equally well: to first order no measured number changes."));
  result.combinations[0].parts = {{"teeth_height", 10}, {"preload", 5}};
  CHECK_FALSE(note(result, "More teeth_height (teeth_height +10 %) with more preload").empty());
}

TEST_CASE("starts are reported by where they ended", "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.optima = {{{0.2, 1.5e-6}, 0.001, 3, true, {}}};
  start(result, optim::Outcome::optimal, {0.2, 1.5e-6});
  CHECK(calibration_notes(result).empty());  // one start needs no report
  start(result, optim::Outcome::optimal, {0.2, 1.5e-6});
  CHECK(noted(result, "All 2 starts ended in the same optimum."));
  result.undetermined = {{{"kinetic_friction", "amplitude"}, kNaN}};
  CHECK(noted(result, "All 2 starts ended in the same valley."));
  result.undetermined.clear();
  start(result, optim::Outcome::budget, {});
  CHECK(note(result, "All ").empty());
  CHECK(noted(result, "1 of 3 starts did not reach an optimum; summary.json says why."));
  result.optima.push_back({{0.3, 1e-6}, 0.002, 1, false, {}});
  CHECK(noted(
      result,
      "3 starts ended in 2 different optima; the first in the table has the smallest residuals."));
  CHECK(noted(result, "With so many optima, more starts may find a better one: try starts: 20."));
  CHECK_THAT(barred(sections_text(result)),
             Contains("\nstarts | residual rms | kinetic_friction | amplitude | remark\n"
                      "3 | 1 mN.m | 0.2 | 1.5 um | the answer\n"
                      "1 | 2 mN.m | 0.3 | 1 um | -\n"));
  CHECK(result.equals() == 1);
  result.optima[1].fits_as_well = true;
  CHECK(std::string(result.verdict()) == "several");
  CHECK_FALSE(note(result, "The data cannot distinguish 2 different motors").empty());
  CHECK_THAT(barred(sections_text(result)),
             Contains("1 | 2 mN.m | 0.3 | 1 um | fits equally well\n"));
}

TEST_CASE("what leaves no doubt, or no way to tell, is said", "[studies][calibrate][words]") {
  CalibrateResult result = fit();
  result.degrees_of_freedom = 0;
  CHECK(noted(result,
              "There are as many points as parameters, so there are no residuals that show how "
              "good the estimates are."));
  result.exact = true;
  CHECK(noted(result, "The points lie on the curve to rounding."));
  CHECK(answer_json(result)["fit"]["exact"] == true);
  result.static_ratio = 1.25;
  CHECK(noted(
      result,
      "static_friction is 1.25 times kinetic_friction, as in the motor, and changed with it."));
  result.chi_square = 0;
  result.degrees_of_freedom = 1;
  CHECK_THAT(sections_text(result), Contains("with 1 degree of freedom"));
}

TEST_CASE("parameters that are all held leave nothing that was fitted",
          "[studies][calibrate][words]") {
  CalibrateResult result = fitted_by(0.25);
  for (auto& one : result.estimates) one.bound = Bound::max;
  const std::vector<std::string> notes = calibration_notes(result);
  REQUIRE(notes.size() == 2);  // neither a word on the misfit nor on each bound
  CHECK_THAT(notes[0], StartsWith("Every parameter is at an end of its range"));
  CHECK_THAT(notes[1], StartsWith("The measured torques are 4 times larger"));
}
