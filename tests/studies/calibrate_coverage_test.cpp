// SPDX-License-Identifier: Apache-2.0
// Calibrations to noisy data of every kind: how often the intervals hold the truth.
#include "calibrate_benches.hpp"
#include "studies/statistics/coverage.hpp"

#include <catch2/catch.hpp>

#include <iterator>
#include <span>
#include <string>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

// As many as find an interval that is half as wide as it should be; a thousand, in the slow tests, find a tenth.
constexpr int kFewTrials = 16, kManyTrials = 1000;

// How often the intervals of repeated noisy measurements of one bench hold the truth.
void check_coverage(const Named& named, const std::string& scatter, int trials) {
  const Bench& bench = named.bench;
  const MotorDesign truth = truth_of(bench);
  BenchCase one(bench);
  one.more = "starts: 1, scatter: " + scatter;
  std::vector<test::Coverage> covered(bench.truth.size());
  for (int trial = 0; trial < trials; ++trial) {
    Noise noise(static_cast<std::uint64_t>(trial) + 1);
    const Run run(one.file(bench.csv(truth, noise, 1)));
    for (std::size_t j = 0; j < covered.size(); ++j) {
      const auto& estimate = run.result().estimates[j];
      covered[j].count({estimate.parameter.value, estimate.low, estimate.high},
                       bench.truth[j].second);
    }
  }
  for (std::size_t j = 0; j < covered.size(); ++j) {
    CAPTURE(named.name, scatter, bench.truth[j].first, covered[j].share());
    if (trials >= kManyTrials)
      WARN(named.name << ", scatter " << scatter << ", " << info(bench.truth[j].first).name << ": "
                      << 100 * covered[j].share() << " %");
    CHECK(covered[j].hits >= covered[j].fewest(0.95));
    CHECK(covered[j].hits <= covered[j].most(0.95));
  }
}

// With the scatter estimated and as stated; and of each column by itself, which takes long columns.
void check_coverage(std::span<const Named> benches, int trials) {
  for (const Named& named : benches)
    for (const std::string scatter : {"estimated", "stated", "by-column"})
      if (named.bench.long_columns || scatter != "by-column")
        DYNAMIC_SECTION(named.name << ", scatter " << scatter) {
          check_coverage(named, scatter, trials);
        }
}

std::span<const Named> of_few_numbers() { return std::span(kBenches).last(kFewNumbers); }
std::span<const Named> of_many_numbers() {
  return std::span(kBenches).first(std::size(kBenches) - kFewNumbers);
}

}  // namespace

TEST_CASE("intervals of data of every kind cover the truth as often as they say",
          "[studies][calibrate][statistics]") {
  check_coverage(of_many_numbers(), kFewTrials);
}

TEST_CASE("intervals of data of every kind cover the truth as often as they say - many times",
          "[studies][calibrate][statistics][.long]") {
  check_coverage(of_many_numbers(), kManyTrials);
}

TEST_CASE(
    "intervals of short columns and of single kinds of data cover the truth as often as they say",
    "[studies][calibrate][statistics]") {
  check_coverage(of_few_numbers(), kFewTrials);
}

TEST_CASE("intervals of short columns and of single kinds of data cover the truth - many times",
          "[studies][calibrate][statistics][.long]") {
  check_coverage(of_few_numbers(), kManyTrials);
}
