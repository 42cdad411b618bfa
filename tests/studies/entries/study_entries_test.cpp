// SPDX-License-Identifier: Apache-2.0
// Entries of a study that name something: solvers' options, parameters, rows of what it stored.
#include "entries_support.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/found_motors.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/result_store.hpp>
#include <twum/optim/solvers.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

using Lines = std::vector<std::string>;

Lines complaints(const std::string& study) {
  const ScratchFolder folder;
  Lines lines;
  try {
    study_in(folder, study);
  } catch (const FileError& error) {
    for (const Diagnostic& one : error.diagnostics())
      lines.push_back(one.entry + ": " + one.found + "; " + one.expected);
  }
  return lines;
}

// A value that the range of an option has in it.
std::string value_of(const optim::SolverOption& option) {
  const std::string range = option.range();  // "1e-14 to 0.1" or "monotone|adaptive"
  return range.substr(0, range.find_first_of(" |"));
}

// "min: smallest value" and so on of all entries below a schema, at any depth.
Lines texts_below(const Schema& schema) {
  Lines lines;
  const auto add = [&](const Schema& inner) {
    const Lines more = texts_below(inner);
    lines.insert(lines.end(), more.begin(), more.end());
  };
  for (const SchemaEntry& entry : schema.entries) {
    lines.push_back(entry.name + ": " + entry.schema.text);
    add(entry.schema);
  }
  for (const Schema& one : schema.alternatives) add(one);
  for (const Schema& one : schema.items) add(one);
  return lines;
}

}  // namespace

TEST_CASE("entries below a parameter have the same texts for every parameter",
          "[studies][schema]") {
  // One row of the reference page, such as tolerances.NAME.from, describes the entry of all parameters.
  int compared = 0;
  for (std::size_t kind = 0; kind < study_kinds().size(); ++kind)
    for (const SchemaEntry& entry : study_schema(static_cast<StudyKind>(kind)).entries) {
      if (entry.schema.entries.empty() || !entry.schema.entries[0].alias_counts) continue;
      const Lines first = texts_below(entry.schema.entries[0].schema);
      for (const SchemaEntry& parameter : entry.schema.entries) {
        CAPTURE(study_kinds()[kind], entry.name, parameter.name);
        CHECK(texts_below(parameter.schema) == first);
        ++compared;
      }
    }
  // Twelve kinds at least have variables, tolerances or a family; each lists every parameter.
  CHECK(compared >= 12 * static_cast<int>(parameter_table().size()));
}

TEST_CASE("every option of a solver is one of its own, and none of another's",
          "[studies][study][error]") {
  for (const optim::SolverOption& option : optim::solver_options()) {
    for (const std::string solver : {"nlopt:slsqp", "ipopt"}) {
      CAPTURE(option.name, solver);
      bool own = false;
      for (const optim::SolverOption& other : optim::solver_options())
        own = own || (other.name == option.name && solver.starts_with(other.solver));
      const Lines lines = complaints(
          "{kind: optimize, maximize: peak_power, variables: {preload: {min: 1 N, max: 2 N}}, "
          "solver: {name: \"" +
          solver + "\", options: {" + option.name + ": " + value_of(option) + "}}}");
      if (own)
        CHECK(lines.empty());
      else
        CHECK(lines == Lines{"study.solver.options." + option.name + ": no option of '" + solver +
                             "'; 'twum solvers' lists them by solver"});
    }
  }
}

TEST_CASE("what is no parameter is said once, whatever would be asked of a parameter",
          "[studies][study][error]") {
  const auto unknown = [](const Lines& lines) {
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0], StartsWith("study.variables.wavelngths: unknown entry; did you mean "
                                    "'wavelengths'?"));
  };
  const std::string range = "variables: {wavelngths: {min: 8, max: 9, points: 3}}";
  const std::string plain = "variables: {wavelngths: {min: 8, max: 9}}";
  unknown(complaints("{kind: sweep, sampling: grid, metrics: [stall_torque], " + range + "}"));
  unknown(complaints("{kind: calibrate, data: x.csv, " + plain + "}"));
  unknown(
      complaints("{kind: pareto, objectives: [{maximize: peak_power}, {minimize: "
                 "max_pressure}], " +
                 plain + "}"));
  unknown(complaints("{kind: uncertainty, metrics: [stall_torque], " + plain + "}"));
  CHECK(complaints("{kind: sweep, sampling: grid, metrics: [stall_torque]}").size() == 1);
  CHECK(complaints("{kind: sweep, sampling: grid, metrics: [stall_torque], variables: [preload]}")
            .size() == 1);
  CHECK(complaints("{kind: calibrate, data: x.csv}").size() == 1);
}

TEST_CASE("an override that is wrong is said once, and the others are looked at",
          "[studies][study][error]") {
  const auto set = [](const std::string& overrides) {
    Lines lines;
    try {
      read_study(Source("s.yaml", "twum: 1\nmotor: " TWUM_SOURCE_DIR
                                  "/examples/motors/elastic-layer.yaml\nset: {" +
                                      overrides + "}\nstudy: {kind: curve}\n"),
                 "");
    } catch (const FileError& error) {
      for (const Diagnostic& one : error.diagnostics())
        lines.push_back(one.entry + ": " + one.found + "; " + one.expected);
    }
    return lines;
  };
  CHECK(set("preload: 100 N").empty());
  CHECK(set("preloads: 100 N") == Lines{"set.preloads: unknown entry; did you mean 'preload'?"});
  CHECK(set("preload: 100 m").at(0).starts_with("set.preload: '100 m' is a length [m]"));
  CHECK(set("static_friction: 0.1").at(0).starts_with("set: static"));  // less than the kinetic 0.2
}

TEST_CASE("a row that no study asks for cannot be computed anew", "[studies][verify]") {
  const ScratchFolder folder;
  const std::string variables = "metrics: [stall_torque], variables: {preload: ";
  const std::vector<std::string> studies{
      "{kind: curve, points: 4}",
      "{kind: sweep, sampling: lhs, samples: 4, " + variables + "{min: 1 N, max: 2 N}}}",
      "{kind: uncertainty, samples: 4, " + variables +
          "{distribution: uniform, min: 1 N, max: 2 N}}}",
      "{kind: sensitivity, method: local, " + variables + "{min: 100 N, max: 200 N}}}",
      "{kind: sensitivity, method: morris, samples: 2, " + variables + "{min: 1 N, max: 2 N}}}",
      "{kind: sensitivity, method: sobol, samples: 256, " + variables + "{min: 1 N, max: 2 N}}}"};
  const std::vector<std::uint64_t> rows{4, 4, 4, 1, 4, 768};
  for (std::size_t i = 0; i < studies.size(); ++i) {
    CAPTURE(studies[i]);
    const auto kind = make_kind(study_in(folder, studies[i]));
    StoredRow row;
    row.index = rows[i] - 1;
    CHECK(kind->recompute(row).has_value());
    row.index = rows[i];
    CHECK_FALSE(kind->recompute(row).has_value());
    row.index = 0;
    row.stage = 40;
    CHECK_FALSE(kind->recompute(row).has_value());
    CHECK_FALSE(
        kind->certify(std::vector<double>{1.5}, {}).has_value());  // these kinds have no optimum
  }
}

TEST_CASE("a design that is none is a row with the reason, without the values it found",
          "[studies][run]") {
  const RowEvaluator rows({MotorDesign{}, {Parameter::preload, Parameter::static_friction}, {}},
                          {parse_metric("stall_torque")});
  const auto status = [&](double preload, double static_friction) {
    StoredRow row;
    rows.evaluate(std::vector<double>{preload, static_friction}, row);
    CHECK(row.values[0] == preload);
    CHECK(std::isnan(row.values[2]) == (row.status != "ok"));
    return row.status;
  };
  CHECK(status(160, 0.3) == "ok");
  CHECK(status(-5, 0.3) == "preload must be at least 0 N");
  CHECK(status(-6, 0.3) == status(-5, 0.3));  // so that rows can be counted by it
  CHECK(status(160, 0.1) == status(160, 0.15));
  CHECK_THAT(status(160, 0.1), StartsWith("static_friction") && !Contains("0.1"));
}

TEST_CASE("each doubt about members of a family is told once", "[studies][run]") {
  // Each is outside of where the solver is tested, whatever the others are.
  const std::vector<std::pair<Parameter, double>> odd{{Parameter::frequency, 200e3},
                                                      {Parameter::amplitude, 6e-6},
                                                      {Parameter::neutral_plane_distance, 12e-3},
                                                      {Parameter::contact_radius, 0.15},
                                                      {Parameter::wavelengths, 31},
                                                      {Parameter::youngs_modulus, 600e9},
                                                      {Parameter::kinetic_friction, 1.5}};
  const ScratchFolder folder;
  StudyFile file = study_in(
      folder, "{kind: curve, points: 2, family: {modal_damping: [1 N.s/m, 2 N.s/m, 3 N.s/m]}}");
  const auto about = [](const std::vector<std::string>& notes, Parameter parameter) {
    std::size_t count = 0;
    for (const std::string& note : notes)
      count += note.find(": " + std::string(info(parameter).name) + " ") != std::string::npos &&
                       note.ends_with("; the same for 2 others")
                   ? 1
                   : 0;
    return count;
  };
  const MotorDesign usual = file.motor.design;
  for (std::size_t first = 0; first < odd.size(); ++first) {
    file.motor.design = usual;
    for (std::size_t i = first; i < odd.size(); ++i) {
      file.motor.design = with(file.motor.design, odd[i].first, odd[i].second);
      const std::vector<std::string> notes = run_study(file).model_notes;
      CAPTURE(notes);
      for (std::size_t k = first; k <= i; ++k) CHECK(about(notes, odd[k].first) == 1);
    }
  }
}

TEST_CASE("a search that found no motor within the limits leaves none", "[studies][run]") {
  const ScratchFolder folder;
  // The elastic layer carries mu F_N r, 1.06 N.m at 200 N.
  const StudyFile file =
      study_in(folder,
               "{kind: optimize, maximize: peak_power, constraints: [stall_torque >= 2 N.m], "
               "variables: {preload: {min: 100 N, max: 200 N}}}");
  const StudyResult infeasible = run_study(file);
  CHECK(infeasible.outcome == "infeasible");
  CHECK(found_motors(file, infeasible).empty());
  StudyResult nothing = infeasible;
  std::get<OptimizeResult>(nothing.answer).found = false;
  CHECK(found_motors(file, nothing).empty());
  StudyResult interrupted = infeasible;
  interrupted.outcome = "interrupted";
  CHECK(found_motors(file, interrupted).empty());
}

TEST_CASE("a point of a curve without an answer is counted, and named by its status",
          "[studies][curve]") {
  // The wave passes each point of a standing rotor with omega, and m omega^2 = G is the resonance of
  // the undamped layer; a rotor that turns is passed at another frequency.
  const ScratchFolder folder;
  StudyFile file = study_in(folder, "{kind: curve, points: 5}");
  const double omega = 2 * std::numbers::pi * 40e3;
  file.motor.design =
      with(file.motor.design, Parameter::inertia, 1.1e9 / (omega * omega));  // G is 1.1 GPa
  const auto kind = make_kind(file);
  ResultStore store(":memory:", kind->columns());
  ThreadExecutor executor(*kind);
  RunContext context{store, executor, {}, {}};
  const KindAnswer answer = kind->run(context);
  CHECK(answer.outcome == "done");
  const CurveResult::Member& member = std::get<CurveResult>(answer.answer).members.at(0);
  CHECK(member.points == 5);
  CHECK(member.failed == 1);
  CHECK(member.metrics.at(0).name == "stall_torque");
  CHECK(std::isnan(member.metrics[0].value));
  CHECK(member.statuses[0] != "ok");
  std::size_t row = 0;
  store.read([&](const StoredRow& one) {
    CHECK((one.status == "ok") == (row++ > 0));
    CHECK(std::isnan(one.values[1]) == (one.status != "ok"));
  });
}

TEST_CASE("goals that rise together have one best design, which is the whole front",
          "[studies][pareto]") {
  const ScratchFolder folder;
  const StudyResult result = run_study(study_in(
      folder,
      "{kind: pareto, objectives: [{maximize: stall_torque}, {maximize: preload}], points: "
      "5, variables: {preload: {min: 100 N, max: 200 N}}}"));
  const auto& answer = std::get<ParetoResult>(result.answer);
  REQUIRE(answer.front.size() == 1);
  CHECK(answer.front[0].goals[1] == Approx(200).epsilon(1e-6));
  CHECK(answer.knee == 0);
  CHECK(answer.ends == std::vector<std::size_t>{0, 0});
}

TEST_CASE("torque against preload is a straight front, of as many points as asked",
          "[studies][pareto]") {
  const ScratchFolder folder;
  for (std::size_t points = 2; points <= 6; ++points) {
    CAPTURE(points);
    const StudyResult result = run_study(
        study_in(folder,
                 "{kind: pareto, objectives: [{maximize: stall_torque}, {minimize: preload}], "
                 "variables: {preload: {min: 100 N, max: 200 N}}, points: " +
                     std::to_string(points) + "}"));
    const auto& answer = std::get<ParetoResult>(result.answer);
    REQUIRE(answer.front.size() == points);
    double least = answer.front[0].goals[1];
    double largest = least;
    for (const ParetoResult::Point& point : answer.front) {
      CHECK(point.goals[0] == Approx(0.2 * 0.0265 * point.goals[1]).epsilon(1e-6));
      least = std::min(least, point.goals[1]);
      largest = std::max(largest, point.goals[1]);
    }
    CHECK(least == Approx(100).epsilon(1e-6));
    CHECK(largest == Approx(200).epsilon(1e-6));
  }
}

TEST_CASE("a copy of the results needs a folder for temporary files", "[studies][verify]") {
  const ScratchFolder folder;
  run_study(study_in(folder, "{kind: curve, points: 2}"), folder.path("out"));
  const char* before = std::getenv("TMPDIR");
  const std::string saved = before == nullptr ? "" : before;
  std::string text;
  ::setenv("TMPDIR", folder.path("none").c_str(), 1);
  try {
    verify_study(folder.path("out"));
  } catch (const StoreError& error) {
    text = error.what();
  }
  if (before == nullptr)
    ::unsetenv("TMPDIR");
  else
    ::setenv("TMPDIR", saved.c_str(), 1);
  CHECK_THAT(text, Contains("No such file or directory") && EndsWith("set TMPDIR to another one"));
  CHECK(verify_study(folder.path("out")).holds());
}
