// SPDX-License-Identifier: Apache-2.0
// What chance says of the residuals of several kinds of data, on made residuals (theory of calibration, section 4).
#include "kinds/residual_tests.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>

using namespace twum;
using namespace twum::studies;

namespace {

// A number read at a speed, in parts of its standard deviation.
CalibrateResult::Point read(const char* quantity, double speed, double residual) {
  CalibrateResult::Point point;
  point.quantity = quantity;
  point.at = speed;
  point.residual = residual;
  point.deviation = 1;
  return point;
}

// 20 torques that their motor meets to a tenth of the deviation, with changing signs, beside powers.
CalibrateResult with_powers(double first, double second, std::size_t count) {
  CalibrateResult result;
  for (int i = 0; i < 20; ++i) result.data.push_back(read("torque_at", i, i % 2 == 0 ? 0.1 : -0.1));
  for (std::size_t i = 0; i < count; ++i)
    result.data.push_back(
        read("electrical_power_at", static_cast<double>(i), i % 2 == 0 ? first : second));
  result.degrees_of_freedom = result.data.size();
  return result;
}

}  // namespace

TEST_CASE("a kind that misses its deviations does not hide behind the others",
          "[studies][calibrate][closed_form]") {
  CalibrateResult result = with_powers(3, -3, 2);
  test_residuals(result, true);
  REQUIRE(result.chi_square);
  CHECK(*result.chi_square == Approx(20 * 0.01 + 18));
  CHECK(result.chi_square_p > 0.5);  // 18.2 with 22 degrees of freedom
  REQUIRE(result.worst_kind);
  CHECK(result.worst_kind->quantity == "electrical_power_at");
  CHECK(result.worst_kind->count == 2);
  // The tail of two numbers is exp(-x / 2); one of two kinds is as bad twice as often. 10 digits of the library's tail.
  CHECK(result.worst_kind->p == Approx(2 * std::exp(-9)).epsilon(1e-10));

  CalibrateResult good = with_powers(1, -1, 2);
  test_residuals(good, true);
  CHECK_FALSE(good.worst_kind);  // 2 exp(-1) = 0.7
}

TEST_CASE("signs are counted in each kind by itself, in the order of the speed",
          "[studies][calibrate][closed_form]") {
  // Eight powers of one sign: none of seven changes, 2^-7; in one of two kinds as often again.
  CalibrateResult result = with_powers(0.2, 0.2, 8);
  std::swap(result.data[20], result.data[27]);
  test_residuals(result, false);
  REQUIRE(result.runs);
  CHECK(result.runs->runs == 1);
  CHECK(result.runs->count == 8);
  CHECK(result.runs->p == Approx(2.0 / 128).epsilon(1e-12));
  CHECK(result.runs_of.quantity == "electrical_power_at");
  CHECK(result.runs_of.over == "speed");
  CHECK_FALSE(result.chi_square);
}

TEST_CASE("residuals that are rounding are not tested", "[studies][calibrate]") {
  CalibrateResult result = with_powers(3, -3, 2);
  result.exact = true;
  test_residuals(result, true);
  CHECK_FALSE(result.runs);
  CHECK_FALSE(result.chi_square);
  CHECK_FALSE(result.worst_kind);
}
