// SPDX-License-Identifier: Apache-2.0
// Fronts under tolerances, against cases of reference/robust.csv.
#include "search_support.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

// Holding torque of ring-60 by C1: its 5 % quantile is proportional to the preload.
StudyFile torque_front(const std::string& objectives, const std::string& constraints = "") {
  return study_of("ring-60", "{static_friction: 0.2}",
                  "{kind: pareto, variables: {preload: {min: 120 N, max: 180 N}}, points: 5, "
                  "tolerances: {kinetic_friction: {distribution: lognormal, sd: 10 %}, preload: "
                  "{distribution: lognormal, sd: 3 %}}, objectives: [" +
                      objectives + "]" +
                      (constraints.empty() ? "" : ", constraints: [" + constraints + "]") + "}");
}

}  // namespace

TEST_CASE("a front of a quantile against a probability is that of the law", "[studies][robust]") {
  const StudyFile file = torque_front(
      "{maximize: 'quantile(holding_torque, 5 %)'}, "
      "{maximize: probability(holding_torque <= 1 N.m)}");
  const Search s(file, 2);
  const ParetoResult& front = s.front();
  REQUIRE(front.front.size() >= 4);
  CHECK(s.answer.outcome == "optimal");
  const double sigma = std::sqrt(std::log(1.01) + std::log1p(9e-4));
  for (const ParetoResult::Point& point : front.front) {
    const double preload = value(point.report.design, "preload");
    // C1 at 160 N. The quantile by 20,000 new random motors: standard error sqrt(p (1 - p) / N) over the density, 0.0013 N.m; four.
    CHECK(point.goals[0] == Approx(0.710609334595 * preload / 160).margin(4 * 0.0013));
    const double median = std::log(0.2 * preload * 26.5e-3) - 0.5 * sigma * sigma;
    const double share = 0.5 * std::erfc(median / sigma / std::sqrt(2.0));
    REQUIRE(point.yields.size() == 1);
    CHECK(point.yields[0].verdict.empty());
    CHECK(point.goals[1] ==
          Approx(share).margin(4 * std::sqrt(share * (1 - share) / 20'000) + 1e-4));
    CHECK(point.goals[1] == point.yields[0].share.value);
  }
  // Interrupted half way and resumed on more threads: the same.
  const std::vector<StoredRow> rows = s.rows();
  const std::vector<StoredRow> half(rows.begin(),
                                    rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2));
  CHECK(Search(file, 3, half).json() == s.json());
}

TEST_CASE("a front whose yield cannot be reached tells the largest one of a study",
          "[studies][robust]") {
  // Two ends, C9: the largest yield is 74.35 %.
  const Search s(torque_front("{maximize: preload}, {maximize: stall_torque}",
                              "0.75 N.m <= holding_torque <= 0.95 N.m, yield >= 99 %"));
  CHECK(s.answer.outcome == "infeasible");
  REQUIRE(s.front().largest_yield.has_value());
  CHECK(s.front().largest_yield->share.low <= 0.74350160751);
  CHECK(s.front().largest_yield->share.high >= 0.743487159677);
  CHECK(s.kind_json()["largest_yield"]["verdict"] == Json("broken"));
  CHECK(s.text().find("The required yield cannot be reached.") == 0);
}

TEST_CASE("every point of the example front holds 99 %", "[studies][robust]") {
  const Search s(example_study("pareto-robust-ring-60.yaml"), 2);
  CHECK(s.answer.outcome == "optimal");
  const ParetoResult& front = s.front();
  CHECK(front.front.size() >= 6);
  for (std::size_t i = 0; i < front.front.size(); ++i) {
    const ParetoResult::Point& point = front.front[i];
    CHECK(point.report.certificate.passed);
    CHECK(point.yields[0].verdict == "holds");
    CHECK(point.yields[0].share.low >= 0.99);
    if (i == 0) continue;
    CHECK(point.goals[0] > front.front[i - 1].goals[0]);
  }
  CHECK(s.text().find("yield >= 99 % holds at") != std::string::npos);
}
