// SPDX-License-Identifier: Apache-2.0
#include <twum/core/motor.hpp>
#include <twum/io/result_store.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <cmath>
#include <fstream>
#include <set>

using namespace twum;
using namespace twum::studies;

namespace {

struct Curves {
  Curves(const std::string& motor, const std::string& entries) {
    const std::string path = folder.path("curve.yaml");
    std::ofstream(path) << "twum: 1\nmotor: " << test::motor_path(motor)
                        << "\nstudy:\n  kind: curve\n"
                        << entries;
    file = read_study_file(path);
    result = run_study(file, folder.path("out"), {});
    ResultStore(folder.path("out/results.db")).read([&](const StoredRow& row) {
      rows.push_back(row);
    });
  }
  const CurveResult& answer() const { return std::get<CurveResult>(result.answer); }
  double metric(std::size_t member, const std::string& name) const {
    for (const NamedValue& value : answer().members[member].metrics)
      if (value.name == name) return value.value;
    FAIL("no metric " << name);
    return 0;
  }

  test::ScratchFolder folder;
  StudyFile file{};
  StudyResult result;
  std::vector<StoredRow> rows;
};

}  // namespace

TEST_CASE("each row of a family is an operating point of its member", "[studies][curve]") {
  const Curves curves("ring-60", "  family: {h: [0.2 mm, 0.3 mm]}\n  points: 7\n");
  REQUIRE(curves.rows.size() == 14);
  CHECK(curves.answer().family->name == "thickness");
  for (const StoredRow& row : curves.rows) {
    CAPTURE(row.stage, row.index);
    MotorDesign design = curves.file.motor.design;
    design.layer.thickness = row.stage == 0 ? 0.2e-3 : 0.3e-3;
    const Motor motor(design);
    const double last =
        1.05 * evaluate(motor, MetricRequest{Metric::no_load_speed, Argument::none, 0}).value;
    CHECK(row.values[0] == design.layer.thickness);
    // Two products and a quotient, one rounding each.
    CHECK(row.values[1] == Approx(last * static_cast<double>(row.index) / 6).epsilon(1e-15));
    const OperatingPoint point = motor.operating_point(row.values[1]);
    CHECK(row.values[2] == point.torque);
    CHECK(row.values[3] == point.output_power);
    // P_in = P_out + P_fric + P_layer, to rounding of powers of the size of P_in (T7.10)
    CHECK(row.values[4] - row.values[3] - row.values[5] - row.values[6] ==
          Approx(0).margin(1e-11 * (1 + std::abs(row.values[4]))));
  }
}

TEST_CASE("a motor alone is a family of one", "[studies][curve]") {
  const Curves curves("ring-60", "  points: 3\n");
  CHECK(curves.rows.size() == 3);
  CHECK_FALSE(curves.answer().family);
  CHECK(curves.rows[0].values.size() == contact_columns().size());
  CHECK(curves.rows[0].values[0] == 0);
  CHECK(curves.rows[2].values[1] < 0);  // beyond no-load the torque brakes
}

TEST_CASE("a driven motor's rows balance at the terminals", "[studies][curve]") {
  const Curves curves("drive-60", "  family: {voltage: [50 V, 120 V]}\n  points: 15\n");
  const ResultStore store(curves.folder.path("out/results.db"));
  const auto at = [&](const StoredRow& row, const std::string& name) {
    for (std::size_t i = 0; i < store.columns().size(); ++i)
      if (store.columns()[i].name == name) return row.values[i];
    FAIL("no column " << name);
    return 0.0;
  };
  std::size_t answers = 0;
  for (const StoredRow& row : curves.rows) {
    if (row.status != "ok") continue;
    ++answers;
    const double parts = at(row, "output_power") + at(row, "friction_power") +
                         at(row, "layer_loss") + at(row, "stator_loss") +
                         at(row, "dielectric_loss");
    // The contact's powers balance to 1e-12 of some ten watts (T7.10).
    CHECK(at(row, "electrical_power") == Approx(parts).epsilon(1e-10).margin(1e-10));
    CHECK(at(row, "voltage") == (row.stage == 0 ? 50 : 120));
  }
  CHECK(answers > 15);
  std::set<std::string> names;
  for (const StoredColumn& column : store.columns()) CHECK(names.insert(column.name).second);
  CHECK(curves.rows[0].status == "pulled-out");
  CHECK(curves.metric(1, "start_voltage") > curves.metric(1, "hold_voltage"));
}

TEST_CASE("amplitude raises the speed and leaves the stall torque of an elastic layer alone",
          "[studies][curve][closed_form]") {
  const Curves curves("elastic-layer", "  family: {A: [1.6 um, 2 um, 3 um]}\n  points: 2\n");
  const MotorDesign& design = curves.file.motor.design;
  // Plateau of theory section 8: the whole contact slips one way, T = mu F r.
  const double bound = design.friction.kinetic * design.preload * design.stator.contact_radius;
  for (std::size_t i = 0; i < 3; ++i) {
    // Rounding of the closed forms, about a hundred operations.
    CHECK(curves.metric(i, "stall_torque") == Approx(bound).epsilon(1e-13));
    CHECK(curves.metric(i, "max_torque") == Approx(bound).epsilon(1e-13));
  }
  CHECK(curves.metric(0, "no_load_speed") < curves.metric(1, "no_load_speed"));
  CHECK(curves.metric(1, "no_load_speed") < curves.metric(2, "no_load_speed"));
}

TEST_CASE("curves show what the paper says of its figures 4 to 6", "[studies][curve][published]") {
  const auto run = [](const std::string& name) {
    return run_study(
        read_study_file(TWUM_SOURCE_DIR "/examples/studies/paper-figure-" + name + ".yaml"));
  };
  const auto values = [](const StudyResult& result, const std::string& name) {
    std::vector<double> list;
    for (const auto& member : std::get<CurveResult>(result.answer).members)
      for (const NamedValue& value : member.metrics)
        if (value.name == name) list.push_back(value.value);
    REQUIRE(list.size() == 5);
    return list;
  };
  const StudyResult amplitude = run("4");
  const StudyResult preload = run("5");
  const StudyResult thickness = run("6");
  const auto by_amplitude = values(amplitude, "no_load_speed");
  const auto by_preload = values(preload, "no_load_speed");
  const auto by_thickness = values(thickness, "no_load_speed");
  for (std::size_t i = 1; i < 5; ++i) {
    CHECK(by_amplitude[i] > by_amplitude[i - 1]);
    CHECK(by_preload[i] < by_preload[i - 1]);
    CHECK(by_thickness[i] < by_thickness[i - 1]);
    CHECK(values(preload, "max_torque")[i] > values(preload, "max_torque")[i - 1]);
    CHECK(values(preload, "contact_ratio")[i] > values(preload, "contact_ratio")[i - 1]);
    // "independent": the largest torque is mu F r, up to what stick takes at rest; the paper's words
    // are read as 1 %.
    CHECK(values(amplitude, "max_torque")[i] ==
          Approx(values(amplitude, "max_torque")[0]).epsilon(0.01));
    CHECK(values(thickness, "max_torque")[i] ==
          Approx(values(thickness, "max_torque")[0]).epsilon(0.01));
  }
}

TEST_CASE("a value that gives an invalid motor is refused before anything runs",
          "[studies][curve][error]") {
  CHECK_THROWS_WITH(Curves("ring-60", "  family: {static_friction: [0.3, 0.1]}\n"),
                    Catch::Contains("study.family: static_friction = 0.1"));
}

TEST_CASE("what a family stored is verified from its directory alone", "[studies][curve][verify]") {
  const Curves curves("ring-60", "  family: {F_N: [80 N, 160 N]}\n  points: 11\n");
  const Verification found = verify_study(curves.folder.path("out"));
  CAPTURE(found.complaints);
  CHECK(found.holds());
  CHECK(found.rows_checked == 22);
  CHECK(found.designs == 2);
  CHECK(found.deviation == 0);
}
