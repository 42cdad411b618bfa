// SPDX-License-Identifier: Apache-2.0
#include "calibrate_support.hpp"
#include "studies/statistics/coverage.hpp"

#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <stop_token>
#include <utility>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// How often the intervals of repeated noisy measurements cover the truth. Intervals of one trial are not
// independent of each other, so that each parameter counts by itself.
void check_coverage(int trials) {
  const Case one;
  const MotorDesign truth = with(one.design(), kTruth);
  std::vector<test::Coverage> covered(kTruth.size());
  for (int trial = 0; trial < trials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(trial) + 1;
    const Run run(one.file(points_of(truth, 4e-3, seed)));
    REQUIRE((run.answer.outcome == "fitted" || run.answer.outcome == "poor"));
    for (std::size_t j = 0; j < kTruth.size(); ++j) {
      const auto& estimate = run.result().estimates[j];
      covered[j].count({estimate.parameter.value, estimate.low, estimate.high}, kTruth[j].second);
    }
  }
  for (const test::Coverage& c : covered) {
    CHECK(c.hits >= c.fewest(0.95));
    CHECK(c.hits <= c.most(0.95));
  }
}

// "ok", or the message with the folder left out.
std::string complaint(const std::string& csv, const std::string& variables = kThree) {
  Case one;
  one.variables = variables;
  try {
    make_kind(one.file(csv));
    return "ok";
  } catch (const InputError& error) {
    std::string text = error.what();
    const std::string folder = one.folder.folder() + "/";
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }
}

}  // namespace

TEST_CASE("points without noise give the parameters back", "[studies][calibrate][inverse]") {
  Case one;
  one.more = "starts: 4";
  const Run run(one.file(points_of(with(one.design(), kTruth))));
  CHECK(run.answer.outcome == "fitted");
  const CalibrateResult& result = run.result();
  REQUIRE(result.estimates.size() == kTruth.size());
  // Torques are right to about 1e-13 of theirs (points and fit round differently), the parameters to
  // that times the condition of the columns, below 1e3 for these three.
  for (std::size_t j = 0; j < kTruth.size(); ++j)
    CHECK_THAT(result.estimates[j].parameter.value, WithinRel(kTruth[j].second, 1e-10));
  CHECK(result.exact);
  CHECK_FALSE(result.poor());
  CHECK(result.undetermined.empty());
  CHECK_THAT(run.text(), Contains("The points lie on the curve to rounding."));
  for (const auto& point : result.data) CHECK_THAT(point.fitted, WithinAbs(point.value, 1e-10));
}

TEST_CASE("intervals cover the true parameters as often as they say",
          "[studies][calibrate][statistics]") {
  check_coverage(100);
}

TEST_CASE("intervals cover the true parameters as often as they say, many times",
          "[studies][calibrate][statistics][.long]") {
  check_coverage(3000);
}

TEST_CASE("modulus and thickness of an elastic layer act only in combination",
          "[studies][calibrate][closed-form]") {
  Case one;
  one.motor = "elastic-layer";
  one.set = "{poisson_ratio: 0.35}";  // G then follows E, and only E / h is left
  one.variables =
      "youngs_modulus: {min: 1 GPa, max: 10 GPa}, thickness: {min: 0.1 mm, max: 1 mm}, "
      "kinetic_friction: {min: 0.05, max: 0.5}";
  const std::vector<ParameterValue> truth{{Parameter::youngs_modulus, 3.3e9},
                                          {Parameter::thickness, 0.36e-3},
                                          {Parameter::kinetic_friction, 0.23}};
  const Run run(one.file(points_of(with(one.design(), truth))));
  const CalibrateResult& result = run.result();
  REQUIRE(result.undetermined.size() == 1);
  CHECK(result.undetermined[0].names == std::vector<std::string>{"youngs_modulus", "thickness"});
  CHECK_THAT(result.undetermined[0].undone_by, WithinAbs(1, 1e-8));  // E / h stays
  const double ratio = result.estimates[0].parameter.value / result.estimates[1].parameter.value;
  CHECK_THAT(ratio, WithinRel(3.3e9 / 0.36e-3, 1e-9));
  CHECK_THAT(result.estimates[2].parameter.value, WithinRel(0.23, 1e-10));
  CHECK(std::isnan(result.estimates[0].low));
  CHECK(std::isnan(result.estimates[1].high));
  CHECK(std::isfinite(result.estimates[2].low));
  CHECK_THAT(run.text(), Contains("youngs_modulus and thickness act only in combination"));
  CHECK_THAT(run.text(), Contains("1 % more youngs_modulus is compensated by 1 % more thickness"));
}

TEST_CASE("a parameter without influence is named alone", "[studies][calibrate]") {
  Case one;
  one.variables =
      "kinetic_friction: {min: 0.05, max: 0.5}, modal_damping: {min: 1 N.s/m, max: 99 N.s/m}";
  const Run run(one.file(points_of(one.design())));
  REQUIRE(run.result().undetermined.size() == 1);
  CHECK(run.result().undetermined[0].names == std::vector<std::string>{"modal_damping"});
  CHECK_THAT(run.text(), Contains("The data do not determine modal_damping"));
}

TEST_CASE("standard deviations weigh like 1 / s^2 (L1.1), and the scatter is tested against them",
          "[studies][calibrate][statistics]") {
  Case one;
  const std::string plain = points_of(with(one.design(), kTruth), 4e-3);
  std::string weights = "speed,torque,weight\n";
  std::string right = "speed,torque,torque_sd [mN.m]\n";
  std::string wrong = right;
  int i = 0;
  for (std::size_t at = plain.find('\n') + 1; at < plain.size(); at = plain.find('\n', at) + 1) {
    const std::string line = plain.substr(at, plain.find('\n', at) - at);
    const bool twice = ++i % 2 == 0;
    weights += line + (twice ? ",0.25" : ",1") + "\n";
    right += line + (twice ? ",8" : ",4") + "\n";
    wrong += line + (twice ? ",0.8" : ",0.4") + "\n";
  }
  const Run by_weight(one.file(weights));
  const Run by_deviation(one.file(right));
  const Run too_sure(one.file(wrong));
  for (std::size_t j = 0; j < 3; ++j) {
    // The search ends within 1e-9 of the step; the weights agree to rounding.
    CHECK_THAT(by_weight.result().estimates[j].parameter.value,
               WithinRel(by_deviation.result().estimates[j].parameter.value, 1e-7));
    CHECK_THAT(by_weight.result().estimates[j].high,
               WithinRel(too_sure.result().estimates[j].high, 1e-6));
  }
  CHECK_FALSE(by_weight.result().chi_square);
  REQUIRE(by_deviation.result().chi_square);
  // Ten times smaller deviations make chi-square a hundred times larger.
  CHECK_THAT(*too_sure.result().chi_square,
             WithinRel(100 * *by_deviation.result().chi_square, 1e-6));
  CHECK(by_deviation.result().chi_square_p > 0.01);
  CHECK(too_sure.result().poor());
  CHECK_THAT(too_sure.text(), Contains("The fit is poor"));
}

TEST_CASE("starts that end in different places are told apart", "[studies][calibrate]") {
  const DesignVariable range{Parameter::kinetic_friction, 0.05, 0.5};
  Case one;
  const MeasuredFit fit(one.design(), {FitParameter(range)},
                        {torque_point(1, 0.8), torque_point(2, 0.9), torque_point(3, 0.85)});
  const auto ended = [](double value, double sum, optim::Outcome outcome) {
    optim::LeastSquaresResult result;
    result.outcome = outcome;
    result.estimates = {{"kinetic_friction", value, 0.01, value - 0.02, value + 0.02, false}};
    result.correlation = {1};
    result.sum_of_squares = sum;
    result.degrees_of_freedom = 2;
    return result;
  };
  using optim::Outcome;
  const KindAnswer answer = calibration({fit}, {ended(0.4, 0.3, Outcome::optimal),
                                                ended(0.2, 0.1, Outcome::optimal),
                                                ended(0.2000001, 0.1, Outcome::optimal),
                                                ended(0.1, 0.2, Outcome::budget),
                                                {}});
  const auto& result = std::get<CalibrateResult>(answer.answer);
  // The other place misses the points by 37 % of the largest torque: it is listed, and is no rival.
  CHECK(result.equals() == 1);
  CHECK(result.estimates[0].parameter.value == 0.2);
  REQUIRE(result.optima.size() == 2);
  CHECK(result.optima[0].starts == 2);
  CHECK(result.optima[1].values[0] == 0.4);
  const std::string text = headline_text(result, "fitted");
  CHECK_THAT(text, Contains("5 starts ended in 2 different optima"));
  CHECK_THAT(text, Contains("2 of 5 starts did not reach an optimum"));
  CHECK(calibration({fit}, {{}, {}}).outcome == "failed");
}

TEST_CASE("a fit whose columns have no settled scatter is not called fitted",
          "[studies][calibrate]") {
  Case one;
  const MeasuredFit fit(one.design(), {FitParameter{{Parameter::kinetic_friction, 0.05, 0.5}}},
                        {torque_point(1, 0.8), torque_point(2, 0.8), torque_point(3, 0.8)});
  optim::LeastSquaresResult best;
  best.outcome = optim::Outcome::optimal;
  best.estimates = {{"kinetic_friction", 0.189, 0.001, 0.187, 0.191, false}};
  best.correlation = {1};
  best.degrees_of_freedom = 2;
  CHECK(calibration({fit}, {best}).outcome == "fitted");
  CalibrationAsked asked{fit};
  asked.unsettled = "it went round and round";
  const KindAnswer answer = calibration(asked, {best});
  CHECK(answer.outcome == "feasible");
  CHECK_THAT(headline_text(answer.answer, answer.outcome),
             Contains("ended before it reached the smallest residuals: it went round and round."));
}

TEST_CASE("an evaluation takes as much room for many points as for few (L1.2)",
          "[studies][calibrate][store]") {
  const Case one;
  const MotorDesign truth = with(one.design(), kTruth);
  const std::string few = points_of(truth, 4e-3, 5);
  std::string many = few;
  for (std::uint64_t seed = 6; seed < 16; ++seed) {
    const std::string more = points_of(truth, 4e-3, seed);
    many += more.substr(more.find('\n') + 1);
  }
  // Three parameters: four rows of a residual and three slopes, 8 bytes each.
  for (const std::string& csv : {few, many})
    for (const StoredRow& row : Run(one.file(csv)).rows()) CHECK(row.detail.size() == 4 * 4 * 8);
}

TEST_CASE("threads and interruptions do not change a calibration",
          "[studies][calibrate][determinism]") {
  Case one;
  one.more = "starts: 5";
  const StudyFile file = one.file(points_of(with(one.design(), kTruth), 4e-3));
  const Run alone(file);
  const std::vector<StoredRow> rows = alone.rows();
  for (const unsigned jobs : {2U, 8U}) {
    const Run several(file, jobs);
    CHECK(several.json() == alone.json());
    CHECK(same_rows(several.rows(), rows));
  }
  // What a kill leaves of each start is its first rows.
  for (const std::uint64_t kept : {0U, 1U, 4U, 1000U}) {
    std::vector<StoredRow> stored;
    for (const StoredRow& row : rows)
      if (row.index < kept + row.stage) stored.push_back(row);
    const Run resumed(file, 2, stored);
    CHECK(resumed.json() == alone.json());
    CHECK(same_rows(resumed.rows(), rows));
  }
  for (const StoredRow& row : rows) {
    const auto again = alone.kind->recompute(row);
    REQUIRE(again);
    CHECK(same_rows({*again}, {row}));
  }
}

TEST_CASE("a calibration stopped at any evaluation goes on to the same end",
          "[studies][calibrate][determinism]") {
  Case one;
  one.more = "starts: 3";
  const StudyFile file = one.file(points_of(with(one.design(), kTruth), 4e-3));
  const Run whole(file);
  for (const std::uint64_t last : {1U, 7U, 20U}) {
    const auto kind = make_kind(file);
    ResultStore store(":memory:", kind->columns());
    std::stop_source stop;
    ThreadExecutor executor(*kind);
    RunContext context{store, executor, stop.get_token(), [&](const RunProgress& now) {
                         if (now.done == last) stop.request_stop();
                       }};
    kind->run(context);
    std::vector<StoredRow> rows;
    store.read([&](const StoredRow& row) { rows.push_back(row); });
    CHECK(rows.size() == last);  // what was in flight, and nothing begun after it
    CHECK(Run(file, 1, rows).json() == whole.json());
  }
}

TEST_CASE("wrong files of points are refused with place and remedy",
          "[studies][calibrate][errors]") {
  using Pair = std::pair<const char*, const char*>;
  const Pair pairs[] = {
      {"speed,torque\n1,2\n2,2\n3,1\n", "ok"},
      {"# remark\nspeed [rpm],torque [mN.m],weight\n1,2,1\n2,2,1\n3,1,.5\n", "ok"},
      {"", "points.csv:1:1: an empty file; expected a header such as 'speed [rpm],torque'"},
      {"speed,torque\n", "points.csv:1:1: no points below the header"},
      {"speed;torque\n1;2\n2;2\n3;1\n", "ok"},
      {"speed;torque\n1,2\n",
       "points.csv:2: columns separated by commas, but the headings by semicolons"},
      {"sped,torque\n1,2\n", "points.csv:1:1: unknown column 'sped'; did you mean 'speed'?"},
      {"torque\n1\n", "points.csv:1:1: no column 'speed'; expected one such as 'speed [rpm]'"},
      {"speed,weight\n1,1\n", "points.csv:1:1: no column 'torque'"},
      {"speed,torque [N]\n1,2\n", "points.csv:1:7: torque: 'N' is a force [N]"},
      {"speed,torque,speed\n1,2,3\n", "points.csv:1:14: speed: the column is given twice"},
      {"speed,torque,weight,torque_sd\n1,2,1,1\n",
       "points.csv:1:21: torque_sd: weights and standard deviations; give one of the two"},
      {"speed,torque\n1,2\n2,x\n", "points.csv:3:3: torque: 'x' is not a number"},
      {"speed [rpm],torque\n100 rpm,2\n",
       "points.csv:2:1: speed: '100 rpm' is not a number; expected a number in rpm"},
      {"speed,torque\n1,2\n2,\n", "points.csv:3:3: torque: empty cell"},
      {"speed,torque\n1,2,3\n", "points.csv:2:1: 3 cells; the header has 2"},
      {"speed,torque\n1,nan\n", "points.csv:2:3: torque: 'nan' is not a number"},
      {"speed,torque,weight\n1,2,0\n", "points.csv:2:5: weight: '0'; must be more than 0"},
      {"speed,torque,weight\n1,2,1e308\n2,2,1e-20\n3,1,1e308\n",
       "points.csv:3:5: weight: the weight of the point is negligible compared with the others"},
      {"speed,torque,torque_sd\n1,2,1\n2,2,1e-200\n3,1,1e-200\n",
       "points.csv:2:5: torque_sd: the weight of the point is negligible compared with the others"},
      {"speed,torque,torque_sd\n1,2,1e-150\n2,2,1e-300\n3,1,1e-200\n", "ok"},
      {"speed,torque\n1,\"2\"x\n", "points.csv:2:1: a quotation mark that cannot stand there"},
      {"speed,torque\n1,2\n2,2\n", "points.csv: 2 points cannot determine 3 parameters"},
  };
  for (const auto& [csv, message] : pairs) {
    CAPTURE(csv);
    CHECK_THAT(complaint(csv), Contains(message));
  }
  // All of them at once.
  const std::string all = complaint("speed,torque\nx,2\n1,y\n1\n");
  CHECK_THAT(all, Contains(":2:1: ") && Contains(":3:3: ") && Contains(":4:1: "));
  CHECK_THAT(complaint("speed,torque\n1,2\n", "wavelengths: {min: 5, max: 12}"),
             Contains("wavelengths") && Contains("whole numbers"));
  StudyFile file = Case().file("");
  file.folder = "/nowhere";
  CHECK_THROWS_WITH(make_kind(file), Contains("/nowhere/points.csv"));
}

TEST_CASE("the example finds what its data were made with", "[studies][calibrate][example]") {
  const Run run(read_study_file(TWUM_SOURCE_DIR "/examples/studies/calibrate.yaml"), 2);
  CHECK(run.answer.outcome == "fitted");
  CHECK_FALSE(run.result().poor());
  const double truth[] = {0.23, 2.2e9, 1.52e-6};  // as examples/studies/calibrate.yaml says
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& estimate = run.result().estimates[j];
    CHECK(estimate.low < truth[j]);
    CHECK(estimate.high > truth[j]);
  }
}
