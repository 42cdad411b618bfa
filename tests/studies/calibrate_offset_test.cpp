// SPDX-License-Identifier: Apache-2.0
// Calibrations to columns of which one has an offset (L4.2).
#include "calibrate_benches.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

// The table with a number added to a column. Of it the heading and empty cells stay.
std::string shifted(const std::string& csv, std::size_t column, double by) {
  std::istringstream lines(csv);
  std::string all;
  std::string line;
  for (bool heading = true; std::getline(lines, line); heading = false) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (k == column && !heading && !cell.empty()) cell = number(std::stod(cell) + by);
      all += (k > 0 ? "," : "") + cell;
    }
    all += "\n";
  }
  return all;
}

struct OffsetCase {
  const Bench& bench;
  std::string scatter;
  std::size_t column;
  double by;

  Run run(std::uint64_t seed) const {
    BenchCase one(bench);
    one.more = "starts: 1, scatter: " + scatter;
    Noise noise(seed);
    return Run(one.file(shifted(bench.csv(truth_of(bench), noise, 1), column, by)));
  }
};

struct Shares {
  int poor{0};
  int offset{0};  // with an offset that chance gives one time in a hundred
};

Shares shares(const OffsetCase& one, int trials) {
  Shares found;
  for (int trial = 1; trial <= trials; ++trial) {
    const Run run = one.run(static_cast<std::uint64_t>(trial));
    const CalibrateResult& result = run.result();
    found.poor += result.poor() ? 1 : 0;
    found.offset += result.offset && result.offset->p < 0.01 ? 1 : 0;
  }
  return found;
}

}  // namespace

TEST_CASE(
    "a column whose readings share an offset is not fitted, though its scatter is estimated (L4.2)",
    "[studies][calibrate]") {
  // No-load speeds that are all 2.5 rpm too large, five of their standard deviations.
  const Run run = OffsetCase{kMixture, "by-column", 3, 2.5}.run(1);
  CHECK(run.answer.outcome == "poor");
  REQUIRE(run.result().offset);
  CHECK(run.result().offset->p < 1e-6);
  CHECK(run.result().offset->count == 13);
  CHECK_THAT(
      run.text(),
      Contains("Offset of no_load_speed (points.csv): the 13 readings fit best if each is ") &&
          Contains("The fit is poor: the residuals of no_load_speed (points.csv) share an offset"));
  CHECK_THAT(run.json(), Contains("\"offset\":{") && Contains("\"table\":\"points.csv\""));
  const Run none = OffsetCase{kMixture, "by-column", 3, 0}.run(1);
  CHECK(none.answer.outcome == "fitted");
  CHECK_THAT(none.text(), !Contains("Offset of"));
}

TEST_CASE("offsets of columns are found as often as validation says - many times",
          "[studies][calibrate][statistics][.long]") {
  const struct {
    const char* name;
    OffsetCase one;
    double most;   // of false alarms
    double least;  // found
  } cases[] = {
      {"mixture, by column", {kMixture, "by-column", 3, 0}, 0.025, 0},
      {"mixture, by column, 2 deviations", {kMixture, "by-column", 3, 1}, 1, 0.5},
      {"mixture, by column, 5 deviations", {kMixture, "by-column", 3, 2.5}, 1, 0.98},
      {"short mixture, by column", {kShortMixture, "by-column", 3, 0}, 0.025, 0},
      {"short mixture, by column, 5 deviations", {kShortMixture, "by-column", 3, 2.5}, 1, 0.5},
      {"circle, by column", {kCircle, "by-column", 3, 0}, 0.025, 0},
      {"circle, by column, 2 deviations", {kCircle, "by-column", 3, 4e-5}, 1, 0},
      {"mixture, estimated", {kMixture, "estimated", 3, 0}, 0.025, 0},
      {"mixture, stated", {kMixture, "stated", 3, 0}, 0.025, 0},
      {"mixture, stated, 2 deviations", {kMixture, "stated", 3, 1}, 1, 0.5}};
  for (const auto& [name, one, most, least] : cases) DYNAMIC_SECTION(name) {
      constexpr int kTrials = 1000;
      const Shares found = shares(one, kTrials);
      WARN(name << ": poor " << 0.1 * found.poor << " %, offset " << 0.1 * found.offset << " %");
      CHECK(found.offset <= most * kTrials);
      CHECK(found.poor >= least * kTrials);
    }
}
