// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"

#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// More amplitude widens the contact less and drives faster, so the whole front is at the largest.
const std::string kElasticFront =
    "{kind: pareto, variables: {preload: {min: 100 N, max: 800 N}, "
    "amplitude: {min: 1.4 um, max: 1.6 um}}, "
    "objectives: [{maximize: stall_torque}, {maximize: no_load_speed}], points: 20}";

}  // namespace

TEST_CASE("the front of stall torque and no-load speed is that of the closed form (C8.5, C8.6)",
          "[studies][pareto]") {
  const StudyFile file = study_of("elastic-layer", "", kElasticFront);
  const ElasticLayer exact{file.motor.design};  // has the largest amplitude
  const Search s(file);
  const ParetoResult& front = s.front();
  CHECK(s.answer.outcome == "optimal");
  REQUIRE(front.front.size() == 20);
  for (const ParetoResult::Point& point : front.front) {
    CHECK(point.report.certificate.passed);
    const double phi = exact.angle_of_preload(point.goals[0] / exact.plateau_torque(1));
    // Points lie on the front up to the solver's tolerance of 1e-6 of the front's span.
    CHECK_THAT(point.goals[1], WithinRel(exact.no_load(phi), 1e-6));
    CHECK_THAT(value(point.report.design, "amplitude"), WithinRel(1.6e-6, 1e-6));
  }
  // Its ends are the bounds of the preload, up to the room that the search leaves the first goal when
  // it improves the second.
  CHECK_THAT(front.front[front.ends[0]].goals[0], WithinRel(exact.plateau_torque(800), 1e-6));
  CHECK_THAT(front.front[front.ends[1]].goals[0], WithinRel(exact.plateau_torque(100), 1e-6));
}

TEST_CASE("what a limit is worth along a front is that of the closed form, each goal by itself",
          "[studies][pareto]") {
  const StudyFile file = study_of("elastic-layer", "", kElasticFront);
  const ElasticLayer exact{file.motor.design};
  const double amplitude = 1.6e-6;
  const Search s(file);
  const ParetoResult& f = s.front();
  const auto angle_of = [&](const ParetoResult::Point& point) {
    return exact.angle_of_preload(point.goals[0] / exact.plateau_torque(1));
  };
  // Crest speed and the force of a contact angle are both proportional to the amplitude. So with the
  // preload held d(no load)/dA has a part at fixed angle and one by the angle, and with the no-load
  // speed held the preload follows.
  const auto faster = [&](double phi) {
    return (exact.no_load(phi) -
            exact.no_load_slope(phi) * exact.preload(phi) / exact.preload_slope(phi)) /
           amplitude;
  };
  const auto stronger = [&](double phi) {
    return exact.plateau_torque(exact.preload(phi) - exact.preload_slope(phi) * exact.no_load(phi) /
                                                         exact.no_load_slope(phi)) /
           amplitude;
  };
  for (std::size_t i = 1; i + 1 < f.front.size(); ++i) {
    const DesignReport& report = f.front[i].report;
    REQUIRE(report.bounds.size() == 1);
    const std::vector<double> each = gains(report.bounds[0].multiplier, report.certificate);
    const double phi = angle_of(f.front[i]);
    // The points lie on the front to 1e-6 of its span, which moves these slopes by as little.
    CHECK_THAT(each[0], WithinRel(stronger(phi), 1e-4));
    CHECK_THAT(each[1], WithinRel(faster(phi), 1e-4));
  }
  // At the ends a range of the preload stops one goal; the amplitude does nothing for stall torque.
  REQUIRE(f.single_goal_ends.size() == 2);
  const auto worth = [](const DesignReport& report, const std::string& name) {
    for (const BoundState& bound : report.bounds)
      if (bound.variable.name == name) return bound.multiplier;
    return 0.0;
  };
  CHECK_THAT(worth(f.single_goal_ends[0], "preload"), WithinRel(exact.plateau_torque(1), 1e-6));
  CHECK(worth(f.single_goal_ends[0], "amplitude") == 0);
  const double phi = angle_of(f.front[f.ends[1]]);
  CHECK_THAT(worth(f.single_goal_ends[1], "preload"),
             WithinRel(-exact.no_load_slope(phi) / exact.preload_slope(phi), 1e-4));
  CHECK_THAT(worth(f.single_goal_ends[1], "amplitude"), WithinRel(faster(phi), 1e-4));
}

TEST_CASE("no point of a front lies farther beyond the line through its ends than the knee",
          "[studies][pareto]") {
  for (const bool bulges : {true, false}) {
    const Search s(bulges ? narrow_example("pareto-power-wear.yaml")
                          : study_of("elastic-layer", "", kElasticFront));
    const ParetoResult& f = s.front();
    const auto& a = f.front[f.ends[0]].goals;
    const auto& b = f.front[f.ends[1]].goals;
    // Twice the area of the triangle over the line: proportional to the distance, in scaled goals
    // too. Both goals better is beyond, whatever their senses.
    const auto cross = [&](double x, double y) {
      return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const double beyond = cross(f.goals[0].maximize ? HUGE_VAL : -HUGE_VAL, b[1]) > 0 ? 1 : -1;
    double farthest = -HUGE_VAL;
    for (const ParetoResult::Point& point : f.front)
      farthest = std::max(farthest, beyond * cross(point.goals[0], point.goals[1]));
    const auto& knee = f.front[f.knee].goals;
    CHECK_THAT(beyond * cross(knee[0], knee[1]), WithinAbs(farthest, 1e-12 * std::fabs(farthest)));
    CHECK((f.knee != f.ends[0] && f.knee != f.ends[1]) == bulges);
    CHECK(f.has_knee() == bulges);
    CHECK(answer_json(f)["knee"].is_null() != bulges);
  }
}

TEST_CASE("a pareto study is the same for any number of threads, however it was interrupted",
          "[studies][pareto]") {
  const StudyFile file = study_of("elastic-layer", "", kElasticFront);
  const Search whole(file);
  const std::vector<StoredRow> rows = whole.rows();
  for (const unsigned jobs : {2U, 8U}) {
    const Search other(file, jobs);
    CHECK(other.json() == whole.json());
    CHECK(same_rows(other.rows(), rows));
  }
  for (std::uint64_t kill = 0; kill < 3; ++kill) {
    const std::uint64_t stage = optim::Random(5, 0, kill).below(rows.back().stage + 1);
    std::vector<StoredRow> stored;
    for (const StoredRow& row : rows) {
      if (row.stage < stage) stored.push_back(row);
    }
    const Search resumed(file, 2, stored);
    CHECK(resumed.json() == whole.json());
    CHECK(same_rows(resumed.rows(), rows));
  }
}

TEST_CASE("a front of a few whole numbers is found by nsga2", "[studies][pareto]") {
  const Search s(study_of("elastic-layer", "",
                          "{kind: pareto, variables: {wavelengths: {min: 7, max: 11}, preload: "
                          "{min: 100 N, max: 300 N}}, objectives: [{maximize: stall_torque}, "
                          "{maximize: no_load_speed}], points: 20, "
                          "solver: {name: nsga2, max_evaluations: 1000}}"));
  REQUIRE(!s.front().front.empty());
  for (const ParetoResult::Point& point : s.front().front) {
    const double n = value(point.report.design, "wavelengths");
    CHECK(n == std::round(n));
  }
}

TEST_CASE("the examples of fronts are found, and every point is certified", "[studies][pareto]") {
  for (const char* name : {"pareto-torque-speed.yaml", "pareto-power-wear.yaml"}) {
    CAPTURE(name);
    const Search s(example_study(name), 2);
    CHECK(s.answer.outcome == "optimal");
    REQUIRE(s.front().front.size() == 50);
    for (std::size_t i = 1; i < s.front().front.size(); ++i)
      CHECK(s.front().front[i].goals[0] < s.front().front[i - 1].goals[0]);
    CHECK(s.front().hypervolume > 0);
  }
}

TEST_CASE("a front goes over whole numbers, each point certified with its own",
          "[studies][pareto]") {
  const StudyFile file = test::study_of(
      "ring-60", "",
      "{kind: pareto, variables: {preload: {min: 60 N, max: 300 N}, amplitude: {min: 0.8 um, max: "
      "2.2 um}, wavelengths: {min: 8, max: 10}}, objectives: [{maximize: stall_torque}, {maximize: "
      "no_load_speed}], constraints: [max_pressure <= 3 MPa], points: 8}");
  const test::Search search(file);
  CHECK(search.answer.outcome == "optimal");
  const ParetoResult& front = search.front();
  CHECK(front.front.size() == 8);
  for (const auto& point : front.front) {
    const double whole = test::value(point.report.design, "wavelengths");
    CHECK(whole == std::round(whole));
    CHECK(point.report.certificate.passed);
    for (const BoundState& bound : point.report.bounds) CHECK(bound.variable.name != "wavelengths");
  }
  // The speed of the surface is a A k omega with k = n / r : the fastest motor has the most waves.
  CHECK(test::value(front.front[front.ends[1]].report.design, "wavelengths") == 10);
}
