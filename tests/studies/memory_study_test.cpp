// SPDX-License-Identifier: Apache-2.0
// A study in memory gives its rows.
#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/report.hpp>
#include <twum/studies/run_study.hpp>

#include "support/file_text.hpp"
#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::studies;

namespace {

StudyFile curve() {
  const MotorDesign motor = read_motor_file(twum::test::motor_path("ring-60")).design;
  return {.motor = {"m", motor}, .asked = CurveStudy{}};
}

std::size_t column(const std::vector<StoredColumn>& columns, const std::string& name) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return i;
  FAIL("no column " + name);
  return 0;
}

}  // namespace

TEST_CASE("the rows of a curve in memory are the motor's operating points", "[studies][run]") {
  const StudyFile file = curve();
  const StudyResult result = run_study(file);
  REQUIRE(result.rows != nullptr);
  const std::size_t speed = column(result.rows->columns(), "speed");
  const std::size_t torque = column(result.rows->columns(), "torque");
  const Motor motor(file.motor.design);
  std::size_t rows = 0;
  result.rows->read([&](const StoredRow& row) {
    ++rows;
    CHECK(row.values[torque] == motor.operating_point(row.values[speed]).torque);
  });
  CHECK(rows == std::get<CurveStudy>(file.asked).points);
}

TEST_CASE("the table of a run in memory is that of a run in a directory", "[studies][run]") {
  const twum::test::ScratchFolder folder;
  const StudyFile file = curve();
  const StudyResult kept = run_study(file, folder.path("out"));
  CHECK(results_csv(run_study(file)) == twum::test::content(folder.path("out/results.csv")));
  CHECK(kept.rows == nullptr);
  CHECK_THROWS_AS(results_csv(kept), InputError);
}

TEST_CASE("a run in memory has a page", "[studies][run]") {
  const StudyFile file = curve();
  const std::string page = report_html(file, run_study(file));
  CHECK_THAT(page, Catch::StartsWith("<!DOCTYPE html>"));
  CHECK_THAT(page, Catch::Contains("kind: curve"));
}
