// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/io/value_error.hpp>
#include <twum/motors/statistic.hpp>

#include <cmath>

using namespace twum::studies;
using Kind = StatisticRequest::Kind;

TEST_CASE("limits on statistics are read", "[studies][robust]") {
  const StatisticLimit yield = parse_statistic_limit(" yield >= 99 % ");
  CHECK(yield.text == "yield >= 99 %");
  CHECK(yield.statistic.kind == Kind::yield);
  CHECK(yield.lower == Approx(0.99).epsilon(1e-15));
  CHECK(std::isinf(yield.upper));

  const auto probability = parse_statistic_limit("probability(no_load_speed >= 100 rpm) >= 0.95");
  CHECK(probability.statistic.kind == Kind::probability);
  REQUIRE(probability.statistic.limit.has_value());
  CHECK(probability.statistic.limit->text == "no_load_speed >= 100 rpm");
  CHECK(probability.lower == 0.95);

  const auto mean = parse_statistic_limit("mean(peak_power) >= 5 W");
  CHECK(mean.statistic.kind == Kind::mean);
  CHECK(mean.statistic.metric.text == "peak_power");
  CHECK(mean.lower == 5);

  const auto sd = parse_statistic_limit("sd(no_load_speed) <= 3 rpm");
  CHECK(sd.upper == Approx(3 * 2 * 3.14159265358979 / 60).epsilon(1e-14));

  const auto quantile = parse_statistic_limit("quantile(torque_at(100 rpm), 5 %) >= 0.5 N.m");
  CHECK(quantile.statistic.kind == Kind::quantile);
  CHECK(quantile.statistic.metric.text == "torque_at(100 rpm)");
  CHECK(quantile.statistic.probability == Approx(0.05).epsilon(1e-15));
}

TEST_CASE("what is no limit on a statistic is refused, with its place", "[studies][robust]") {
  const struct {
    const char* text;
    std::size_t position;
  } cases[] = {{"yield", 5},
               {"yield >= 120 %", 9},
               {"yield <= 99 %", 6},
               {"yield >= 99 W", 9},
               {"mean peak_power >= 5 W", 4},
               {"mean(peak_power >= 5 W", 4},
               {"mean(peak_pwr) >= 5 W", 5},
               {"mean(peak_power) >= 5 rpm", 20},
               {"quantile(peak_power) >= 5 W", 9},
               {"quantile(peak_power, 130 %) >= 5 W", 21}};
  for (const auto& c : cases) {
    CAPTURE(c.text);
    try {
      parse_statistic_limit(c.text);
      FAIL("was read");
    } catch (const ValueError& error) {
      CHECK(error.position() == c.position);
      CHECK_FALSE(std::string(error.expected()).empty());
    }
  }
}

TEST_CASE("metrics are no statistics", "[studies][robust]") {
  CHECK_FALSE(is_statistic("peak_power >= 5 W"));
  CHECK_FALSE(is_statistic("yielding >= 5 W"));
  CHECK(is_statistic("yield >= 99 %"));
  CHECK(is_statistic("mean(peak_power) >= 5 W"));
}
