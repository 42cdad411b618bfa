// SPDX-License-Identifier: Apache-2.0
// Parts of a search: what stands in its rows, where it starts, and what it tells on the way.
#include "entries_support.hpp"
#include "kinds/rows/earlier_result.hpp"
#include "kinds/rows/search_rows.hpp"
#include "problem/motor_responses.hpp"
#include "support/constants.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/sizing.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using P = Parameter;

namespace {

MotorDesign elastic() {
  const ScratchFolder folder;
  return study_in(folder, "{kind: curve, points: 3}").motor.design;
}

DesignProblem question() {
  DesignProblem problem{elastic()};
  problem.vary(P::preload, 60, 300).vary(P::kinetic_friction, 0.1, 0.4);
  return problem;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::vector<std::string> names(const std::vector<StoredColumn>& columns) {
  std::vector<std::string> list;
  for (const StoredColumn& column : columns) list.push_back(column.name);
  return list;
}

}  // namespace

TEST_CASE("a search has a column for each variable and each distinct metric",
          "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque").limit("preload <= 200 N").limit("stall_torque <= 2 N.m");
  using Names = std::vector<std::string>;
  CHECK(names(SearchRows(problem).columns()) ==
        Names{"preload", "kinetic_friction", "stall_torque"});
  // Wherever the known one stands among those before it.
  const Names metrics{"max_torque", "no_load_speed", "peak_power", "max_pressure", "contact_ratio"};
  Names expected{"preload", "kinetic_friction", "stall_torque"};
  for (const std::string& metric : metrics) {
    problem.limit(metric + (metric == "contact_ratio"   ? " <= 1"
                            : metric == "max_pressure"  ? " <= 9 MPa"
                            : metric == "no_load_speed" ? " >= 1 rpm"
                            : metric == "peak_power"    ? " >= 1 W"
                                                        : " >= 0.1 N.m"));
    expected.push_back(metric);
    for (const std::string& again : expected) {
      DesignProblem twice = problem;
      twice.objectives.push_back({parse_metric(again), true});
      // A further goal stands before the limits, so the order may be another one.
      CHECK(SearchRows(twice).columns().size() == expected.size());
    }
    CHECK(names(SearchRows(problem).columns()) == expected);
  }
}

TEST_CASE("a row holds what the solver saw, kinks and all", "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque").limit("max_pressure <= 10 MPa");
  const SearchRows rows(problem);
  optim::Evaluation seen;
  seen.values = {0.5, 3e6};
  seen.jacobian = {1, 2, kNaN, 4};
  seen.kinks = {{0, 1, optim::Slope::one_sided, -1.5, 2.5},
                {1, 0, optim::Slope::undefined, 0, 0},   // told by the NaN above
                {1, 1, optim::Slope::undefined, 7, 8}};  // not told by it
  const std::vector<double> design{100, 0.2};
  const StoredRow row = rows.row(3, 9, design, true, seen);
  CHECK(row.stage == 3);
  CHECK(row.index == 9);
  CHECK(row.status == "ok");
  CHECK(row.values == std::vector<double>{100, 0.2, 0.5, 3e6});
  CHECK(rows.asked_gradient(row));
  const optim::Evaluation back = evaluation_of(row);
  CHECK(back.ok());
  CHECK(back.values == seen.values);
  REQUIRE(back.jacobian.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(same(back.jacobian[i], seen.jacobian[i]));
  REQUIRE(back.kinks.size() == 2);
  CHECK(back.kinks[0].response == 0);
  CHECK(back.kinks[0].variable == 1);
  CHECK(back.kinks[0].slope == optim::Slope::one_sided);
  CHECK(back.kinks[0].left == -1.5);
  CHECK(back.kinks[0].right == 2.5);
  CHECK(back.kinks[1].slope == optim::Slope::undefined);
  CHECK(back.kinks[1].right == 8);
  CHECK_FALSE(rows.asked_gradient(rows.row(3, 9, design, false, seen)));
}

TEST_CASE("a failure in a row is one when it is read back", "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque");
  const SearchRows rows(problem);
  optim::Evaluation failed;
  failed.failure = "stall_torque: resonance";
  const StoredRow row = rows.row(0, 0, std::vector<double>{100, 0.2}, true, failed);
  CHECK(row.status == "stall_torque: resonance");
  CHECK(std::isnan(row.values[2]));
  CHECK(evaluation_of(row).failure == "stall_torque: resonance");
  CHECK(evaluation_of(row).values.empty());
}

TEST_CASE("a metric at a load that the motor does not carry has no value in a row",
          "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("efficiency_at(0.6 N.m)").limit("speed_at(0.6 N.m) >= 1 rpm");
  const SearchRows rows(problem);
  REQUIRE(motor_problem(problem).responses() >= 3);  // with max_torque >= 0.6 N.m
  optim::Evaluation seen;
  seen.values.assign(motor_problem(problem).responses(), 0.5);
  const std::vector<double> design{100, 0.2};
  CHECK(std::isnan(rows.row(0, 0, design, false, seen).values[2]));  // 0.5 is less than 0.6
  for (std::size_t i = 2; i < seen.values.size(); ++i) seen.values[i] = 0.7;
  CHECK(rows.row(0, 0, design, false, seen).values[2] == 0.5);
  CHECK(rows.row(0, 0, design, false, seen).status == "ok");
}

TEST_CASE("stored evaluations that are too short are damage, wherever they end",
          "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque");
  const SearchRows rows(problem);
  optim::Evaluation seen;
  seen.values = {0.5};
  seen.jacobian = {1, 2};
  seen.kinks = {{0, 1, optim::Slope::one_sided, -1, 1}};
  StoredRow row = rows.row(0, 0, std::vector<double>{100, 0.2}, true, seen);
  const std::string whole = row.detail;
  CHECK_NOTHROW(evaluation_of(row));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    row.detail = whole.substr(0, size);
    CHECK_THROWS_WITH(evaluation_of(row), "the stored evaluations are damaged: a row is too short");
  }
  CHECK_THROWS_AS(rows.asked_gradient(StoredRow{}), StoreError);
}

TEST_CASE("a question to the evaluator is its design to the bit, and what was wanted",
          "[studies][problem]") {
  const std::vector<double> zero{0.0};
  const std::vector<double> minus_zero{-0.0};
  CHECK(SearchRows::key(zero, true) == SearchRows::key(zero, true));
  CHECK(SearchRows::key(zero, true) != SearchRows::key(zero, false));
  CHECK(SearchRows::key(zero, true) != SearchRows::key(minus_zero, true));
}

TEST_CASE("a search tells the best feasible value so far", "[studies][problem]") {
  DesignProblem problem = question();
  problem.limit("max_pressure <= 3 MPa").limit("preload >= 100 N");
  const bool maximize = GENERATE(true, false);
  problem.objectives = {{parse_metric("stall_torque"), maximize}};
  ResultStore store(":memory:", SearchRows(problem).columns());
  std::vector<RunProgress> told;
  const ScriptedKind kind;
  ThreadExecutor executor(kind);
  RunContext context{store, executor, {}, [&](const RunProgress& now) { told.push_back(now); }};
  SearchLog log(problem, context);
  const optim::Observer observe = log.observer(40);
  std::uint64_t index = 0;
  const auto tell = [&](double torque, double pressure, double preload,
                        const std::string& failure = {}) {
    const std::vector<double> design{preload, 0.2};
    optim::Evaluation evaluation;
    evaluation.failure = failure;
    if (failure.empty()) evaluation.values = {torque, pressure, preload};
    observe({0, index++, design, false, evaluation});
    return told.back().best;
  };
  CHECK(tell(0.5, 0, 0, "stall_torque: resonance").empty());
  CHECK(tell(0.5, 4e6, 150).empty());  // breaks the upper limit
  CHECK(tell(0.5, 2e6, 90).empty());   // breaks the lower limit
  CHECK(tell(0.5, 2e6, 150) == "stall_torque 500 mN.m");
  CHECK(tell(0.4, 3e6, 100) == (maximize ? "stall_torque 500 mN.m" : "stall_torque 400 mN.m"));
  CHECK(tell(0.6, 2e6, 150) == (maximize ? "stall_torque 600 mN.m" : "stall_torque 400 mN.m"));
  CHECK(told.back().done == 6);
  CHECK(told.back().total == 40);
  CHECK(told.back().budget);
  CHECK(store.rows() == 6);
}

TEST_CASE("of several goals there is no best so far", "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque").maximize("no_load_speed");
  ResultStore store(":memory:", SearchRows(problem).columns());
  std::string best = "none yet";
  const ScriptedKind kind;
  ThreadExecutor executor(kind);
  RunContext context{store, executor, {}, [&](const RunProgress& now) { best = now.best; }};
  SearchLog log(problem, context);
  const std::vector<double> design{100, 0.2};
  optim::Evaluation evaluation;
  evaluation.values = {0.5, 10};
  log.observer(40)({0, 0, design, false, evaluation});
  CHECK(best.empty());
}

TEST_CASE("loads that metrics are asked at are limits, each once", "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque");
  std::vector<std::string> loads;
  for (int i = 1; i <= 6; ++i) {
    loads.push_back("0." + std::to_string(i) + " N.m");
    problem.limit("speed_at(" + loads.back() + ") >= 1 rpm");
    problem.limit("torque_at(" + std::to_string(i) + " rpm) >= 0 N.m");  // at a speed: no limit
    CHECK(implied_limits(problem).size() == loads.size());
    // The same load again, wherever it stands.
    for (const std::string& load : loads) {
      DesignProblem again = problem;
      again.limit("efficiency_at(" + load + ") >= 0");
      CHECK(implied_limits(again).size() == loads.size());
    }
  }
  CHECK_THAT(implied_limits(problem)[0].limit.text,
             StartsWith("max_torque >= 0.1 N.m for speed_at(0.1 N.m)"));
}

// A search keeps a limit to 1e-8 only, and a metric at a torque has no value for a motor that carries less.
TEST_CASE("the answer of a search carries the torque that its goal is asked at",
          "[studies][problem]") {
  DesignProblem problem = question();
  problem.minimize("stator_power_at(0.6 N.m)");
  const std::vector<ImpliedLimit> implied = implied_limits(problem);
  REQUIRE(implied.size() == 1);
  CHECK(implied[0].limit.lower * (1 - 1e-8) > 0.6);
  CHECK(implied[0].limit.lower < 0.6 * (1 + 1e-6));
  CHECK(implied[0].end() == 0.6);
  // By less than what a search may break the limit by, the row has its value.
  const SearchRows rows(problem);
  optim::Evaluation seen;
  seen.values.assign(motor_problem(problem).responses(), implied[0].limit.lower * (1 - 1e-8));
  CHECK(rows.row(0, 0, std::vector<double>{100, 0.2}, false, seen).values[2] == seen.values[0]);
}

TEST_CASE("the order of the frictions is a limit where it can be broken", "[studies][problem]") {
  const auto limits = [](double min, bool vary_kinetic) {
    DesignProblem problem{elastic()};  // with a kinetic friction of 0.2
    problem.vary(P::static_friction, min, 0.5).maximize("stall_torque");
    if (vary_kinetic) problem.vary(P::kinetic_friction, 0.1, 0.35);
    return implied_limits(problem).size();
  };
  CHECK(limits(0.15, false) == 1);
  CHECK(limits(0.2, false) == 0);
  CHECK(limits(0.3, true) == 1);
  CHECK(limits(0.35, true) == 0);
}

TEST_CASE("a motor that is none and a metric without an answer are failures of a search",
          "[studies][problem]") {
  DesignProblem problem = question();
  problem.maximize("stall_torque");
  const MotorResponses responses(problem);
  CHECK_THAT(responses.evaluate(std::vector<double>{-5, 0.2}, true).failure,
             StartsWith("not a motor: preload "));
  DesignProblem out_of_range = question();
  out_of_range.maximize("torque_at(-1e6 rad/s)");
  CHECK(MotorResponses(out_of_range).evaluate(std::vector<double>{100, 0.2}, true).failure ==
        "torque_at(-1e6 rad/s): out-of-range");
}

TEST_CASE("an earlier result is read from whatever kind of study it is", "[studies][run]") {
  const ScratchFolder folder;
  const auto designs = [&](const std::string& summary) {
    write(folder.path("summary.json"), summary);
    return earlier_designs(folder.folder());
  };
  using Design = EarlierDesign;
  CHECK(designs(R"({"best": {"design": {"F_N": 100, "colour": 1}}})") ==
        std::vector<Design>{{{P::preload, 100}}});
  CHECK(
      designs(
          R"({"front": [{"design": {"preload": 1}}, {"design": {}}, {"design": {"preload": 2}}]})") ==
      std::vector<Design>{{{P::preload, 1}}, {{P::preload, 2}}});
  CHECK(designs(R"({"estimates": {"preload": {"value": 7, "low": 6}, "amplitude": {"low": 1}}})") ==
        std::vector<Design>{{{P::preload, 7}}});
  for (const char* none : {"{}", R"({"best": null})", R"({"best": {"design": {}}})",
                           R"({"best": {"design": {"preload": null}}})", R"({"front": []})"}) {
    CHECK_THROWS_WITH(designs(none), Contains("has no design; expected an optimize, size, pareto"));
  }
  for (const char* broken : {"{", R"({"best": {}})", R"({"front": [1]})"})
    CHECK_THROWS_WITH(designs(broken), Contains("cannot be read; run that study again"));
  std::filesystem::remove(folder.path("summary.json"));
  CHECK_THROWS_WITH(earlier_designs(folder.folder()), Contains("study.start: no result in"));
}

TEST_CASE("a search starts from the best earlier design that keeps the limits", "[studies][run]") {
  // Stall torque and pressure of the elastic layer both rise with the preload.
  DesignProblem problem{elastic()};
  problem.vary(P::preload, 60, 300);
  const auto start = [&](const std::vector<double>& preloads) {
    std::vector<EarlierDesign> designs;
    for (const double preload : preloads) designs.push_back({{P::preload, preload}});
    return best_start(problem, designs).front().second;
  };
  problem.objectives = {{parse_metric("stall_torque"), true}};
  problem.limits = {parse_limit("preload <= 200 N")};
  CHECK(start({150, 180, 250}) == 180);  // the largest torque within the limit
  CHECK(start({180, 150}) == 180);
  CHECK(start({250, 220, 300}) == 220);  // the one that breaks it least
  // -5 N gives an invalid motor.
  CHECK(start({-5, 100}) == 100);
  CHECK(start({100, -5}) == 100);
  problem.objectives = {{parse_metric("stall_torque"), false}};
  problem.limits = {parse_limit("preload >= 100 N")};
  CHECK(start({150, 180, 90}) == 150);
  CHECK(start({50, 90, 30}) == 90);
  // 0.9 N.m is carried from mu F_N r = 0.9 N.m on, which is 170 N; a motor that does not carry it has no
  // such speed, be it wanted or limited.
  problem.limits = {parse_limit("speed_at(0.9 N.m) >= 0 rpm")};
  CHECK(start({100, 180, 120}) == 180);
  problem.limits.clear();
  problem.objectives = {{parse_metric("speed_at(0.9 N.m)"), true}};
  CHECK(start({100, 190, 120}) == 190);
}

TEST_CASE("tolerances round an earlier result are those of its one design", "[studies][run]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("first"));
  const auto run = [&](const std::string& summary) {
    write(folder.path("first/summary.json"), summary);
    return run_study(study_in(folder,
                              "{kind: uncertainty, start: first, samples: 20, metrics: "
                              "[stall_torque], variables: {kinetic_friction: {distribution: "
                              "uniform, min: 0.2, max: 0.200001}}}"));
  };
  const StudyResult result = run(R"({"best": {"design": {"preload": 100}}})");
  // mu F_N r with 100 N, not the 160 N of the file; friction is 0.2 to 5e-6 of it.
  const auto& torque = std::get<UncertaintyResult>(result.answer).metrics.at(0);
  CHECK(torque.mean.value == Approx(0.2 * 100 * 0.0265).epsilon(1e-5));
  CHECK_THROWS_WITH(run(R"({"front": [{"design": {"preload": 1}}, {"design": {"preload": 2}}]})"),
                    "study.start: 'first' holds a front of 2 designs; tolerances are those of one "
                    "motor: name one "
                    "of its motor files instead, such as 'motor: first/front/01.yaml'");
}
