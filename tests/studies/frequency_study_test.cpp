// SPDX-License-Identifier: Apache-2.0
#include <twum/core/frequency_response.hpp>
#include <twum/io/result_store.hpp>
#include <twum/motors/frequency_points.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <cmath>
#include <fstream>

using namespace twum;
using namespace twum::studies;

namespace {

struct Sweeps {
  explicit Sweeps(const std::string& entries, const std::string& motor = "drive-60") {
    const std::string path = folder.path("sweep.yaml");
    std::ofstream(path) << "twum: 1\nmotor: " << test::motor_path(motor)
                        << "\nstudy:\n  kind: frequency\n"
                        << entries;
    file = read_study_file(path);
    result = run_study(file, folder.path("out"), {});
    ResultStore(folder.path("out/results.db")).read([&](const StoredRow& row) {
      rows.push_back(row);
    });
  }
  const FrequencyResult& answer() const { return std::get<FrequencyResult>(result.answer); }

  test::ScratchFolder folder;
  StudyFile file{};
  StudyResult result;
  std::vector<StoredRow> rows;
};

}  // namespace

TEST_CASE("each row of a frequency study is a wave of its member", "[studies][frequency]") {
  const Sweeps sweeps("  family: {voltage: [65 V, 120 V]}\n  speed: 0 rpm\n  points: 9\n");
  CHECK(sweeps.result.outcome == "done");
  REQUIRE(sweeps.rows.size() == 2 * 2 * 9);  // members, directions, points
  for (const StoredRow& row : sweeps.rows) {
    CAPTURE(row.stage, row.index);
    CHECK(row.values[0] == (row.stage < 2 ? 65 : 120));
    CHECK(row.values[1] == (row.stage % 2 == 0 ? 1 : -1));
    REQUIRE(row.status == "ok");  // at rest some wave is always steady
    const double frequency = row.values[2];
    MotorDesign design = with(sweeps.file.motor.design, Parameter::voltage, row.values[0]);
    const Motor motor(with(design, Parameter::frequency, frequency));
    bool met = false;
    for (const WaveState& wave : motor.wave_states(0))
      met |= wave.stable && std::fabs(wave.amplitude - row.values[3]) < 1e-8 * wave.amplitude;
    CHECK(met);
  }
  for (const FrequencyResult::Member& member : sweeps.answer().members)
    CHECK(member.jumps.size() == 2);
}

TEST_CASE("a frequency study keeps to its range, direction and load", "[studies][frequency]") {
  const Sweeps sweeps(
      "  from: 40 kHz\n  to: 42 kHz\n  points: 5\n  torque: 0.3 N.m\n  direction: down\n");
  REQUIRE(sweeps.rows.size() == 5);
  for (const StoredRow& row : sweeps.rows) {
    CHECK(row.values[0] == -1);
    CHECK(row.values[1] == Approx(42e3 - 500.0 * static_cast<double>(row.index)).epsilon(1e-15));
    CHECK(row.values[4] == 0.3);
  }
}

TEST_CASE("what makes no frequency study says why", "[studies][frequency]") {
  CHECK_THROWS_WITH(Sweeps("  points: 5\n", "ring-60"), Catch::Contains("voltage"));
  CHECK_THROWS_WITH(Sweeps("  torque: 1 N.m\n  speed: 1 rpm\n"),
                    Catch::Contains("cannot be given together with 'torque'"));
  CHECK_THROWS_WITH(Sweeps("  from: 42 kHz\n  to: 40 kHz\n"), Catch::Contains("from"));
}

TEST_CASE("a family over the load is a sweep under each of its loads", "[studies][frequency]") {
  const std::string range = "  from: 40 kHz\n  to: 43 kHz\n  points: 5\n";
  const Sweeps family("  torque: [0 N.m, 0.3 N.m]\n" + range), one("  torque: 0.3 N.m\n" + range);
  REQUIRE(family.rows.size() == 2 * one.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    const std::vector<double>&got = family.rows[one.rows.size() + i].values,
          &alone = one.rows[i].values;
    REQUIRE(got.size() == alone.size() + 1);
    CHECK(got[0] == 0.3);
    for (std::size_t k = 0; k < alone.size(); ++k)
      CHECK((got[k + 1] == alone[k] || (std::isnan(got[k + 1]) && std::isnan(alone[k]))));
  }
  CHECK(family.answer().family->name == "load_torque");
  CHECK(verify_study(family.folder.path("out")).complaints.empty());
  CHECK_THROWS_WITH(Sweeps("  family: {voltage: [65 V, 120 V]}\n  torque: [0 N.m, 0.3 N.m]\n"),
                    Catch::Contains("several loads cannot be given together with 'family'"));
}
