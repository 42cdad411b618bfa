// SPDX-License-Identifier: Apache-2.0

#include "search_support.hpp"

#include <twum/core/motor.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const std::string kStallUnderNoLoad =
    "{kind: optimize, variables: {preload: {min: 60 N, max: 800 N}}, maximize: stall_torque, "
    "constraints: [no_load_speed >= ";

// The elastic layer's no-load limit at 0.9 of the crest speed.
constexpr double kShare = 0.9;

std::string speed_text(double speed) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g rad/s", speed);
  return text;
}

// No-load speed at kShare of the crest speed, stall torque to be large: the preload is that of the angle
// with sin(phi) / phi = kShare.
struct PreloadSearch {
  StudyFile file = study_of("elastic-layer", "", "{kind: curve}");
  ElasticLayer exact{file.motor.design};
  double speed = kShare * exact.crest_speed();
  double phi = exact.angle_of_no_load(speed);
  Search search{study_of("elastic-layer", "", kStallUnderNoLoad + speed_text(speed) + "]}")};
};

}  // namespace

TEST_CASE("the largest stall torque under a no-load limit is that of the closed form (C8.6)",
          "[studies][optimize]") {
  const PreloadSearch s;
  // The contact sticks as a whole at no-load, and stall is on the plateau: the formulas hold.
  const double compliance =
      s.file.motor.design.friction.kinetic * 3e9 /
      (1.1e9 * s.exact.wave_number() * s.file.motor.design.stator.neutral_plane_distance);
  REQUIRE(compliance >= 1 / s.phi - 1 / std::tan(s.phi));
  REQUIRE(compliance <= 1 / std::tan(s.phi));
  const OptimizeResult& r = s.search.optimum();
  CHECK(s.search.answer.outcome == "optimal");
  // The limit is met to 1e-8 of its change over the box, and the preload moves 6 times as much as the
  // no-load speed, relatively.
  CHECK_THAT(value(r.best.design, "preload"), WithinRel(s.exact.preload(s.phi), 1e-6));
  CHECK_THAT(value(r.best.metrics, "stall_torque"),
             WithinRel(s.exact.plateau_torque(s.exact.preload(s.phi)), 1e-6));
  CHECK(r.best.certificate.passed);
}

TEST_CASE("the multiplier of a limit is the gain of relaxing it", "[studies][optimize]") {
  const PreloadSearch s;
  const LimitState& limit = s.search.optimum().best.constraints.at(0);
  // dT/dOmega along the optimum: both are functions of phi alone.
  const double expected =
      s.exact.plateau_torque(s.exact.preload_slope(s.phi)) / -s.exact.no_load_slope(s.phi);
  CHECK(limit.active);
  CHECK_THAT(limit.multiplier, WithinRel(expected, 1e-5));
  CHECK_THAT(limit.gain_per_percent, WithinRel(0.01 * s.speed * expected, 1e-5));
}

TEST_CASE("a limit is broken beyond its tolerance, and without one beyond 1e-8 of it",
          "[studies][optimize]") {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  struct StoredRow {
    double limit, violation, tolerance;
    bool broken;
  };
  const StoredRow rows[] = {
      {0, 0, 0, false},
      {0, 1e-8, 2e-8, false},
      {0, 1e-8, 9e-9, true},
      {0, 1e-8, kUnknown, true},
      {100, 9e-5, 1e-3, false},
      {100, 2e-4, 1e-4, true},
      {100, 9e-7, kUnknown, false},
      {-5, 6e-8, kUnknown, true},
      {5, kUnknown, 1, true},
  };
  for (const StoredRow& row : rows) {
    CAPTURE(row.limit, row.violation, row.tolerance);
    DesignReport report;
    report.constraints.push_back({"torque_at(120 rpm) >= 0 N.m", "torque_at(120 rpm)", "N.m", true,
                                  row.limit - row.violation, row.limit, row.violation});
    report.constraints[0].tolerance = row.tolerance;
    CHECK(broken(report.constraints[0]) == row.broken);
    CHECK(keeps_limits(report) == !row.broken);
  }
  CHECK(keeps_limits(DesignReport()));
}

TEST_CASE("an optimum at a limit of 0 keeps it", "[studies][optimize]") {
  // The least no-load speed of a motor that still does not brake at 120 rpm: it is at no load there.
  const Search s(study_of("ring-60", "",
                          "{kind: optimize, variables: {preload: {min: 60 N, max: 300 N}, "
                          "amplitude: {min: 0.5 um, max: 2 um}}, minimize: no_load_speed, "
                          "constraints: ['torque_at(120 rpm) >= 0 N.m'], solver: 'nlopt:cobyla'}"));
  CHECK(s.answer.outcome == "optimal");
  const OptimizeResult& r = s.optimum();
  // The search meets limits to 1e-8 of their slope over the box, here some N m; the torque falls by
  // 0.3 N m for each rad/s before no load, so that the speed is met to 1e-7 of 12.6 rad/s.
  CHECK_THAT(r.best.constraints.at(0).value, WithinAbs(0, 1e-7));
  CHECK(keeps_limits(r.best));
  CHECK(s.text().find("broken by") == std::string::npos);
  CHECK_THAT(value(r.best.metrics, "no_load_speed"), WithinRel(120 * 2 * M_PI / 60, 1e-6));
}

TEST_CASE("a search that was cut short does not claim to keep its limits", "[studies][optimize]") {
  const Search s(study_of("ring-60", "",
                          "{kind: optimize, variables: {preload: {min: 60 N, max: 300 N}}, "
                          "minimize: no_load_speed, constraints: ['torque_at(120 rpm) >= 5 N.m'], "
                          "solver: {name: 'nlopt:cobyla', max_evaluations: 2}}"));
  CHECK(s.answer.outcome == "budget");
  CHECK_FALSE(keeps_limits(s.optimum().best));
  CHECK(s.kind_json()["best"]["certificate"]["infeasibility"].is_null());
  CHECK(s.text().find("broken by") != std::string::npos);
}

TEST_CASE("limits that fight are named with the relaxation that would do", "[studies][optimize]") {
  const StudyFile motor = study_of("elastic-layer", "", "{kind: curve}");
  const ElasticLayer exact{motor.motor.design};
  const double torque = 3.0;
  const double speed = 0.95 * exact.crest_speed();
  const Search s(study_of("elastic-layer", "",
                          kStallUnderNoLoad + speed_text(speed) + ", stall_torque >= 3 N.m]}"));
  CHECK(s.answer.outcome == "infeasible");
  const OptimizeResult& r = s.optimum();
  REQUIRE(r.explanation.limits.size() == 2);
  CHECK(r.explanation.conflict.size() == 2);
  // Alone: the speed of the preload that carries the torque, or the torque of the angle with the speed.
  const double phi_of_torque = exact.angle_of_preload(torque / exact.plateau_torque(1));
  const double phi_of_speed = exact.angle_of_no_load(speed);
  CHECK(r.explanation.limits[0].metric == "no_load_speed");
  CHECK_THAT(r.explanation.limits[0].amount_alone,
             WithinRel(speed - exact.no_load(phi_of_torque), 1e-5));
  CHECK_THAT(r.explanation.limits[1].amount_alone,
             WithinRel(torque - exact.plateau_torque(exact.preload(phi_of_speed)), 1e-5));
  CHECK(s.text().find("cannot hold together") != std::string::npos);
  CHECK(s.kind_json().contains("relaxation"));
}

TEST_CASE("a layer that acts through E / h alone leaves a valley, which is named",
          "[studies][optimize]") {
  // No inertia, no damping: E and h enter as E / h. The pressure limit binds along a curve of E / h.
  const Search s(study_of("ring-60", "{inertia: 0 Pa.s^2, shear_viscosity: 0 Pa.s}",
                          "{kind: optimize, variables: {thickness: {min: 0.1 mm, max: 1 mm}, "
                          "youngs_modulus: {min: 0.5 GPa, max: 20 GPa}}, maximize: no_load_speed, "
                          "constraints: [max_pressure <= 5 MPa]}"));
  CHECK(s.answer.outcome == "optimal");
  const auto& findings = s.optimum().best.certificate.findings;
  const auto valley = std::find_if(findings.begin(), findings.end(), [](const auto& f) {
    return f.kind == optim::Degeneracy::flat_direction;
  });
  REQUIRE(valley != findings.end());
  CHECK(valley->names == std::vector<std::string>{"thickness", "youngs_modulus"});
  CHECK(s.text().find("Flat direction: thickness and youngs_modulus") != std::string::npos);
}

TEST_CASE("variables without influence are named", "[studies][optimize]") {
  // On the plateau the stall torque is mu F_N r, whatever amplitude and layer (theory section 8).
  const Search s(study_of("elastic-layer", "",
                          "{kind: optimize, variables: {preload: {min: 60 N, max: 200 N}, "
                          "amplitude: {min: 1.5 um, max: 2 um}}, maximize: stall_torque}"));
  CHECK(s.answer.outcome == "optimal");
  CHECK(s.optimum().without_influence == std::vector<std::string>{"amplitude"});
  CHECK_THAT(value(s.optimum().best.design, "preload"), WithinRel(200.0, 1e-9));
}

TEST_CASE("NLopt and Ipopt find the same motor, and no random one is better",
          "[studies][optimize]") {
  const StudyFile file = narrow_example("optimize-ring-60.yaml");
  const Search nlopt(file, 2);
  const Search ipopt(narrow_example("optimize-ring-60-ipopt.yaml"), 2);
  CHECK(nlopt.answer.outcome == "optimal");
  CHECK(ipopt.answer.outcome == "optimal");
  CHECK(nlopt.optimum().best.certificate.passed);
  CHECK(ipopt.optimum().best.certificate.passed);
  const double best = value(nlopt.optimum().best.metrics, "peak_power");
  CHECK_THAT(value(ipopt.optimum().best.metrics, "peak_power"), WithinRel(best, 1e-6));
  for (const NamedValue& v : nlopt.optimum().best.design)
    CHECK_THAT(value(ipopt.optimum().best.design, v.name), WithinRel(v.value, 1e-6));

  const auto& question = std::get<OptimizeStudy>(file.asked);
  const std::vector<DesignVariable>& ranges = question.variables;
  const std::vector<MotorLimit>& limits = question.constraints;
  std::vector<MetricExpression> asked{parse_metric("peak_power")};
  for (const MotorLimit& limit : limits) asked.push_back(limit.metric);
  const ExpressionEvaluator evaluator(asked);
  int feasible = 0;
  for (std::uint64_t i = 0; feasible < 1000 && i < 200000; ++i) {
    optim::Random random(7, 0, i);
    std::vector<ParameterValue> design;
    for (const DesignVariable& range : ranges)
      design.emplace_back(range.parameter, range.min + random.uniform() * (range.max - range.min));
    std::vector<MetricValue> values(asked.size());
    evaluator.evaluate(Motor(with(file.motor.design, design)), values);
    bool holds = true;
    for (std::size_t k = 0; k < limits.size(); ++k) {
      const double v = values[k + 1].value;
      holds = holds && values[k + 1].status == MetricStatus::ok && limits[k].holds(v);
    }
    if (!holds) continue;
    ++feasible;
    CHECK(values[0].value <= best);
  }
  CHECK(feasible == 1000);
}

TEST_CASE("an optimize study is the same for any number of threads, however it was interrupted",
          "[studies][optimize]") {
  const StudyFile file = narrow_example("optimize-ring-60.yaml");
  const Search whole(file, 1);
  const std::vector<StoredRow> rows = whole.rows();
  for (const unsigned jobs : {2U, 8U}) {
    const Search other(file, jobs);
    CHECK(other.json() == whole.json());
    CHECK(same_rows(other.rows(), rows));
  }
  // What a killed run leaves: a beginning of each stage that had begun.
  for (std::uint64_t kill = 0; kill < 5; ++kill) {
    optim::Random random(3, 0, kill);
    std::vector<StoredRow> stored;
    const std::uint64_t last_stage = random.below(rows.back().stage + 1);
    const std::uint64_t last_index = random.below(30);
    for (const StoredRow& row : rows) {
      if (row.stage < last_stage || (row.stage == last_stage && row.index < last_index))
        stored.push_back(row);
    }
    const Search resumed(file, 2, stored);
    CHECK(resumed.json() == whole.json());
    CHECK(same_rows(resumed.rows(), rows));
  }
}

TEST_CASE("a search that is asked to stop says so, and goes on from there", "[studies][optimize]") {
  const StudyFile file = example_study("optimize-ring-60.yaml");
  std::stop_source stop;
  stop.request_stop();
  const Search stopped(file, 1, {}, stop.get_token());
  CHECK(stopped.answer.outcome == "interrupted");
  const Search whole(file);
  const Search resumed(file, 1, stopped.rows());
  CHECK(resumed.json() == whole.json());
}

TEST_CASE("rows of a search can be computed anew, to the bit", "[studies][optimize]") {
  const Search s(narrow_example("optimize-ring-60.yaml"), 2);
  const std::vector<StoredRow> rows = s.rows();
  REQUIRE(rows.size() > 20);
  for (std::size_t i = 0; i < rows.size(); i += 7) {
    const auto again = s.kind->recompute(rows[i]);
    REQUIRE(again);
    CHECK(again->status == rows[i].status);
    CHECK(again->detail == rows[i].detail);
    CHECK(same_bits(again->values, rows[i].values));
  }
  std::vector<double> best;
  for (const NamedValue& v : s.optimum().best.design) best.push_back(v.value);
  const auto certificate = s.kind->certify(best, {});
  REQUIRE(certificate);
  CHECK(certificate->passed);
}

TEST_CASE("evaluations are limited by max_evaluations", "[studies][optimize]") {
  for (const char* name : {"auto", "nlopt:slsqp", "ipopt"}) {
    const Search s(study_of("ring-60", "",
                            std::string("{kind: optimize, variables: {preload: {min: 60 N, max: "
                                        "300 N}, amplitude: {min: 1 um, max: 2 um}}, maximize: "
                                        "peak_power, solver: {name: '") +
                                name + "', max_evaluations: 7}}"));
    CAPTURE(name);
    CHECK(s.rows().size() <= 7);
    CHECK(!s.rows().empty());
  }
}

TEST_CASE("a study starts from what another one found", "[studies][optimize]") {
  const ScratchFolder folder;
  const PreloadSearch first;
  Json summary = first.search.kind_json();
  std::ofstream(folder.path("summary.json")) << summary.dump();
  const double preload = value(first.search.optimum().best.design, "preload");
  const std::string start = ", start: '" + folder.folder() + "'";
  // Varied: the search begins there. Not varied: it is the motor's value now, and is reported.
  const Search again(study_of("elastic-layer", "",
                              kStallUnderNoLoad + speed_text(first.speed) + "]" + start + "}"));
  CHECK(again.rows().front().values.front() == preload);
  const Search other(study_of("elastic-layer", "",
                              "{kind: optimize, variables: {amplitude: {min: 1.5 um, max: 2 um}}, "
                              "maximize: no_load_speed" +
                                  start + "}"));
  CHECK(value(other.optimum().best.design, "preload") == preload);
  CHECK_THROWS_AS(make_search(study_of("ring-60", "",
                                       "{kind: optimize, variables: {preload: {min: 60 N, max: "
                                       "300 N}}, maximize: peak_power, start: nowhere}")),
                  InputError);
}

TEST_CASE("an optimum with a whole number inside its range is certified again with it held",
          "[studies][optimize]") {
  const StudyFile file = test::study_of(
      "ring-60", "",
      "{kind: optimize, variables: {preload: {min: 150 N, max: 300 N}, wavelengths: {min: 5, max: "
      "14}}, maximize: no_load_speed + 1 rpm * preload / 100 N, constraints: [plateau_speed <= 110 "
      "rpm]}");
  const test::Search search(file);
  REQUIRE(search.answer.outcome == "optimal");
  const std::vector<NamedValue>& best = search.optimum().best.design;
  const std::vector<double> design{test::value(best, "preload"), test::value(best, "wavelengths")};
  CHECK(design[1] > 5);
  CHECK(design[1] < 14);
  const auto again = search.kind->certify(design, {});
  REQUIRE(again);
  CHECK(again->passed);
}

TEST_CASE("a whole number at the end of its range is told", "[studies][optimize]") {
  const StudyFile file =
      test::study_of("ring-60", "",
                     "{kind: optimize, variables: {preload: {min: 150 N, max: 300 N}, wavelengths: "
                     "{min: 8, max: 10}}, maximize: no_load_speed}");
  const test::Search search(file);
  REQUIRE(search.optimum().whole_ends.size() == 1);
  CHECK(search.optimum().whole_ends[0].variable.name == "wavelengths");
  CHECK(search.optimum().whole_ends[0].upper);
  CHECK(search.text().find("whole numbers have no slope") != std::string::npos);
}
