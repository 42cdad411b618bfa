// SPDX-License-Identifier: Apache-2.0
// Kinds of study at motors without an answer, at rows that are damaged, and at several motors at once.
#include "entries_support.hpp"
#include "kinds/rows/stored_medians.hpp"
#include "kinds/sample/found_motors.hpp"
#include "kinds/sensitivity/metric_gradients.hpp"
#include "support/constants.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/run_study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

// The elastic layer carries mu F_N r on its plateau.
double plateau(double friction, double preload) { return friction * preload * 0.0265; }

StudyResult run_in_memory(const std::string& study, const std::string& motor = "elastic-layer") {
  const ScratchFolder folder;
  return run_study(study_in(folder, study, motor));
}

const SensitivityResult& sensitivity(const StudyResult& result) {
  return std::get<SensitivityResult>(result.answer);
}

// A calibration with whatever rows are stored already.
struct Fit {
  ScratchFolder folder;
  std::unique_ptr<StudyKindRun> kind;

  explicit Fit(const std::string& variables, const std::string& starts = "4") {
    std::string csv = "speed [rpm],torque [N.m]\n";
    for (int i = 1; i <= 6; ++i)
      csv += std::to_string(i) + "," + std::to_string(plateau(0.25, 160) + (i % 2) * 1e-3) + "\n";
    write(folder.path("points.csv"), csv);
    kind = make_kind(study_in(folder, "{kind: calibrate, data: points.csv, starts: " + starts +
                                          ", variables: {" + variables + "}}"));
  }

  KindAnswer run(ResultStore& store) const {
    ThreadExecutor executor(*kind);
    RunContext context{store, executor, {}, {}};
    return kind->run(context);
  }
  std::vector<StoredRow> rows() const {
    ResultStore store(":memory:", kind->columns());
    run(store);
    std::vector<StoredRow> rows;
    store.read([&](const StoredRow& row) { rows.push_back(row); });
    return rows;
  }
  std::string complaint(const std::vector<StoredRow>& stored) const {
    ResultStore store(":memory:", kind->columns());
    for (const StoredRow& row : stored) store.add(row);
    try {
      run(store);
    } catch (const StoreError& error) {
      return error.what();
    }
    return {};
  }
};

}  // namespace

TEST_CASE("a metric that is zero has a slope, and no elasticity", "[studies][sensitivity]") {
  // The elastic layer has no modal damping.
  const StudyResult result = run_in_memory(
      "{kind: sensitivity, method: local, metrics: [modal_damping, stall_torque], variables: "
      "{modal_damping: {min: 0 N.s/m, max: 10 N.s/m}, preload: {min: 100 N, max: 200 N, start: 120 "
      "N}}}");
  CHECK(result.outcome == "done");
  const auto& damping = std::get<MetricSensitivity::Local>(sensitivity(result).metrics[0].effects);
  CHECK(damping[0].gradient == 1);
  CHECK(std::isnan(damping[0].elasticity));
  CHECK(damping[1].gradient == 0);
  // mu F_N r is proportional to the preload, at the 120 N asked for.
  CHECK(sensitivity(result).metrics[1].value == Approx(plateau(0.2, 120)).epsilon(1e-9));
  const auto& torque = std::get<MetricSensitivity::Local>(sensitivity(result).metrics[1].effects);
  CHECK(torque[1].elasticity == Approx(1).epsilon(1e-9));
}

TEST_CASE("where a motor has no value there is no sensitivity, and the reason is said",
          "[studies][sensitivity]") {
  // It carries 0.848 N.m, so 10 N.m has no speed.
  const StudyResult unreachable = run_in_memory(
      "{kind: sensitivity, method: local, metrics: [speed_at(10 N.m)], variables: {preload: {min: "
      "100 N, max: 200 N}}}");
  CHECK(unreachable.outcome == "failed");
  const MetricSensitivity& metric = sensitivity(unreachable).metrics[0];
  CHECK(metric.note == "no value at this motor (speed_at(10 N.m): unreachable)");
  CHECK(metric.dropped == 1);
  CHECK(metric.samples == 0);
  // A static friction of 0.1 with a kinetic one of 0.2 is no motor.
  const StudyResult none = run_in_memory(
      "{kind: sensitivity, method: local, metrics: [stall_torque, peak_power], variables: "
      "{static_friction: {min: 0.05, max: 0.3, start: 0.1}}}");
  CHECK(none.outcome == "failed");
  CHECK_THAT(sensitivity(none).metrics[1].note, StartsWith("no value at this motor (static"));
}

TEST_CASE("one metric with values is an answer, whichever it is", "[studies][sensitivity]") {
  // The first k of the metrics ask for more than the motor carries.
  for (int count = 1; count <= 6; ++count) {
    for (int place = -1; place < count; ++place) {
      std::string metrics;
      for (int i = 0; i < count; ++i)
        metrics += (metrics.empty() ? "" : ", ") +
                   (i == place ? std::string("stall_torque")
                               : "speed_at(" + std::to_string(10 + i) + " N.m)");
      CAPTURE(metrics);
      const std::string rest =
          "metrics: [" + metrics + "], variables: {preload: {min: 100 N, max: 200 N}}}";
      const std::string expected = place < 0 ? "failed" : "done";
      CHECK(run_in_memory("{kind: sensitivity, method: local, " + rest).outcome == expected);
      CHECK(run_in_memory("{kind: sensitivity, method: morris, samples: 2, " + rest).outcome ==
            expected);
      const std::string tolerance =
          "metrics: [" + metrics +
          "], variables: {preload: {distribution: uniform, min: 100 N, max: 200 N}}}";
      CHECK(run_in_memory("{kind: uncertainty, samples: 2, " + tolerance).outcome == expected);
    }
  }
}

TEST_CASE("a variable without influence leaves nothing to share out", "[studies][sensitivity]") {
  // Friction has no part in the width of the contact.
  const StudyResult result = run_in_memory(
      "{kind: sensitivity, method: sobol, metrics: [contact_ratio, stall_torque], variables: "
      "{kinetic_friction: {min: 0.1, max: 0.3}}}");
  CHECK(sensitivity(result).metrics[0].note ==
        "the same over the whole ranges: no variable has an influence");
  CHECK(std::holds_alternative<MetricSensitivity::Sobol>(sensitivity(result).metrics[1].effects));
}

TEST_CASE("blocks with a motor that is none are dropped, and named if they are too many",
          "[studies][sensitivity]") {
  // Static friction below the kinetic 0.2 gives an invalid motor: a third of the box. A block holds two points
  // of one variable, so (2/3)^2 of 256 blocks have both of them; a sequence in base 2 is within a few.
  const StudyResult result = run_in_memory(
      "{kind: sensitivity, method: sobol, samples: 256, metrics: [preload], variables: "
      "{static_friction: {min: 0.1, max: 0.4}}}");
  const MetricSensitivity& metric = sensitivity(result).metrics[0];
  CHECK(metric.samples + metric.dropped == 256);
  CHECK(static_cast<double>(metric.samples) == Approx(256 * 4.0 / 9).margin(10));
  CHECK_THAT(metric.note, StartsWith(std::to_string(metric.dropped) + " of 256 samples have a"));
  CHECK(result.failures.size() == 1);
}

TEST_CASE("motors without a torque are rows of a fit, which goes on the same way from them",
          "[studies][calibrate]") {
  // Fits that begin or come where static friction is below the kinetic one have no residuals there.
  const Fit fit(
      "kinetic_friction: {min: 0.1, max: 0.4, start: 0.3}, "
      "static_friction: {min: 0.05, max: 0.5, start: 0.1}");
  const std::vector<StoredRow> whole = fit.rows();
  const auto failed = [](const StoredRow& row) { return row.status.starts_with("not a motor: "); };
  const StoredRow& first = whole.front();
  CHECK(failed(first));
  CHECK(std::isnan(first.values.back()));
  CHECK(std::any_of(whole.begin(), whole.end(),
                    [](const StoredRow& row) { return row.status == "ok"; }));
  // Computed anew, and gone on with from any row, it is the same.
  const StoredRow again = fit.kind->recompute(first).value();
  CHECK(again.status == first.status);
  CHECK(again.detail == first.detail);
  for (const std::size_t kept : {std::size_t{1}, whole.size() / 2, whole.size()}) {
    ResultStore store(":memory:", fit.kind->columns());
    for (std::size_t i = 0; i < kept; ++i) store.add(whole[i]);
    fit.run(store);
    std::vector<StoredRow> rows;
    store.read([&](const StoredRow& row) { rows.push_back(row); });
    REQUIRE(rows.size() == whole.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i].status == whole[i].status);
      CHECK(rows[i].detail == whole[i].detail);
    }
  }
}

TEST_CASE("stored evaluations of another fit, and damaged ones, are refused",
          "[studies][calibrate]") {
  const Fit fit("kinetic_friction: {min: 0.1, max: 0.4}", "2");
  const std::vector<StoredRow> whole = fit.rows();
  CHECK(fit.complaint(whole).empty());
  std::vector<StoredRow> other = whole;
  other[0].values[0] += 1e-6;
  CHECK(fit.complaint(other) == "the stored evaluations do not belong to this study");
  std::vector<StoredRow> cut = whole;
  cut[0].detail.resize(cut[0].detail.size() - sizeof(double));
  CHECK(fit.complaint(cut) == "the stored evaluations are damaged: a row has a wrong length");
}

TEST_CASE("fewer points than parameters are refused before anything is fitted",
          "[studies][calibrate]") {
  const ScratchFolder folder;
  const auto check = [&](const std::string& csv) {
    write(folder.path("points.csv"), csv);
    study_notes(study_in(folder,
                         "{kind: calibrate, data: points.csv, variables: {kinetic_friction: "
                         "{min: 0.1, max: 0.4}, amplitude: {min: 1 um, max: 2 um}}}"));
  };
  CHECK_THROWS_WITH(check("speed,torque\n1,0.8\n"),
                    EndsWith("points.csv: 1 point cannot determine 2 parameters; measure more "
                             "points or estimate fewer parameters"));
  CHECK_NOTHROW(check("speed,torque\n1,0.8\n2,0.8\n"));
}

TEST_CASE("a fit tells how far it is, and the least residuals so far", "[studies][calibrate]") {
  const Fit fit("kinetic_friction: {min: 0.1, max: 0.4}", "2");
  ResultStore store(":memory:", fit.kind->columns());
  std::vector<RunProgress> told;
  ThreadExecutor executor(*fit.kind);
  RunContext context{store, executor, {}, [&](const RunProgress& now) { told.push_back(now); }};
  fit.kind->run(context);
  REQUIRE(told.size() == store.rows());
  for (std::size_t i = 0; i < told.size(); ++i) CHECK(told[i].done == i + 1);
  // Two fits, then the two ends of the interval of one parameter.
  CHECK(told.front().stage == "fit 1 of 2");
  CHECK(told.front().fraction() == 0);
  CHECK(std::ranges::is_sorted(told, {}, &RunProgress::fraction));
  CHECK(told.back().stage == "intervals");
  CHECK(told.back().fraction() >= 0.5);
  CHECK(told.back().fraction() < 1);  // the last end is being looked for
  // Six points alternate by 1 mN.m: 0.5 mN.m off their mean.
  CHECK(told.back().best == "residual_rms 500 uN.m");
  // Where nothing could be evaluated there is no best.
  const Fit none("static_friction: {min: 0.05, max: 0.15, start: 0.1}", "1");
  ResultStore empty(":memory:", none.kind->columns());
  std::string best = "none yet";
  ThreadExecutor nobody(*none.kind);
  RunContext failing{empty, nobody, {}, [&](const RunProgress& now) { best = now.best; }};
  CHECK(none.kind->run(failing).outcome == "failed");
  CHECK(best.empty());
}

TEST_CASE("a limit that is also a metric is one column, wherever it stands",
          "[studies][uncertainty]") {
  const std::vector<std::string> metrics{"stall_torque",  "no_load_speed", "peak_power",
                                         "contact_ratio", "max_pressure",  "preload"};
  const std::vector<std::string> limits{" >= 1 mN.m", " >= 1 rpm", " >= 1 uW",
                                        " >= 0.001",  " >= 1 Pa",  " >= 1 N"};
  for (std::size_t count = 1; count <= metrics.size(); ++count) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + metrics[i];
    for (std::size_t place = 0; place < metrics.size(); ++place) {
      CAPTURE(list, metrics[place]);
      const StudyResult result =
          run_in_memory("{kind: uncertainty, samples: 3, metrics: [" + list + "], limits: [" +
                        metrics[place] + limits[place] +
                        "], variables: {kinetic_friction: {distribution: uniform, min: 0.1, "
                        "max: 0.2}}}");
      const auto& answer = std::get<UncertaintyResult>(result.answer);
      CHECK(answer.metrics.size() == std::max(count, count + (place < count ? 0U : 1U)));
      CHECK(answer.yield->value == 1);  // all of them are far above these limits
    }
  }
}

TEST_CASE("what no motor can have of a tolerance is told where it is more than rounding",
          "[studies][uncertainty]") {
  const StudyResult result = run_in_memory(
      "{kind: uncertainty, samples: 3, metrics: [stall_torque], variables: {kinetic_friction: "
      "{distribution: normal, mean: 0.1, sd: 0.04}, preload: {distribution: normal, mean: 160 N, "
      "sd: 5 N}}}");
  const auto& outside = std::get<UncertaintyResult>(result.answer).inadmissible;
  REQUIRE(outside.size() == 1);
  CHECK(outside[0].variable == "kinetic_friction");
  // Friction is not below 0, which is 2.5 standard deviations off.
  CHECK(outside[0].share == Approx(std::erfc(2.5 / std::sqrt(2.0)) / 2).epsilon(1e-9));
}

TEST_CASE("the median of stored numbers is the lower middle one of their order",
          "[studies][sweep]") {
  const auto median = [](const std::vector<double>& values) {
    ResultStore store(":memory:", {{"x", "1"}, {"y", "1"}});
    for (std::size_t i = 0; i < values.size(); ++i) store.add({0, i, {0, values[i]}});
    return stored_medians(store, 0, 1).at(0);
  };
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(median({3, -1, 2}) == 2);
  CHECK(median({4, -1, 2, 3}) == 2);
  CHECK(median({-3, -1, -2}) == -2);  // below zero the order of the bits is the other way
  CHECK(median({-inf, 5, inf}) == 5);
  CHECK(median({kNaN, 7, kNaN}) == 7);
  CHECK(median({-1e-300, 1e-300, 1e300}) == 1e-300);
  CHECK(std::isnan(median({kNaN})));
  CHECK(std::isnan(median({})));
}

TEST_CASE("the motor file of a front's point has as many digits as the front needs",
          "[studies][run]") {
  CHECK(front_file(7, 9) == "front/07.yaml");
  CHECK(front_file(7, 99) == "front/07.yaml");
  CHECK(front_file(7, 100) == "front/007.yaml");
  CHECK(front_file(1234, 1234) == "front/1234.yaml");
}

TEST_CASE("a doubt that several motors share is told of the worst, with the number of others",
          "[studies][run]") {
  // An amplitude beyond 5 um, a frequency below 20 kHz: outside of where the solver is tested.
  const auto notes = [](const std::string& family) {
    return run_in_memory("{kind: curve, points: 2, family: {" + family + "}}").model_notes;
  };
  const auto one_about = [](const std::vector<std::string>& all, const std::string& what) {
    std::vector<std::string> found;
    for (const std::string& note : all) {
      if (note.find(what + " ") != std::string::npos &&
          note.find("is outside") != std::string::npos)
        found.push_back(note);
    }
    REQUIRE(found.size() == 1);
    return found[0];
  };
  const std::string rising = one_about(notes("amplitude: [6 um, 10 um, 7 um]"), "amplitude");
  CHECK_THAT(rising,
             StartsWith("motor with amplitude 10 um: amplitude 10 um is outside 50 nm to 5 um") &&
                 EndsWith("; the same for 2 others, to a smaller extent"));
  const std::string alone = one_about(notes("amplitude: [1.6 um, 6 um]"), "amplitude");
  CHECK_THAT(alone, StartsWith("motor with amplitude 6 um: ") && !Contains("the same for"));
  const std::string low = one_about(notes("frequency: [10 kHz, 40 kHz]"), "frequency");
  CHECK_THAT(low, Contains("frequency 10 kHz is outside 20 kHz to 150 kHz"));
  // The preload changes nothing about the thickness of the layer: equally far off.
  const ScratchFolder folder;
  StudyFile file =
      study_in(folder, "{kind: curve, points: 2, family: {modal_damping: [1 N.s/m, 2 N.s/m]}}");
  file.motor.design.stator.amplitude = 6e-6;
  CHECK_THAT(one_about(run_study(file).model_notes, "amplitude"),
             EndsWith("; the same for 1 other"));
}
