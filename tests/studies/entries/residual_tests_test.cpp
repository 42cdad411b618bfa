// SPDX-License-Identifier: Apache-2.0
// What chance says of the residuals of several kinds of data, on made residuals (theory of calibration, section 4).
#include "kinds/calibrate/residual_tests.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
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

// Tests these residuals as of a fit without parameters.
void tested(CalibrateResult& result, bool deviations) {
  optim::Residuals residuals;
  for (const auto& point : result.data) residuals.values.push_back(-point.residual);
  result.neighbours.reset();
  result.offset.reset();
  test_residuals(result, residuals, {}, deviations, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

TEST_CASE("a kind that misses its deviations does not hide behind the others",
          "[studies][calibrate][closed_form]") {
  CalibrateResult result = with_powers(3, -3, 2);
  tested(result, true);
  REQUIRE(result.chi_square);
  CHECK(*result.chi_square == Approx(20 * 0.01 + 18));
  CHECK(result.chi_square_p > 0.5);  // 18.2 with 22 degrees of freedom
  REQUIRE(result.worst_kind);
  CHECK(result.worst_kind->quantity == "electrical_power_at");
  CHECK(result.worst_kind->count == 2);
  // The tail of two numbers is exp(-x / 2); one of two kinds is as bad twice as often. 10 digits of the library's tail.
  CHECK(result.worst_kind->p == Approx(2 * std::exp(-9)).epsilon(1e-10));

  CalibrateResult good = with_powers(1, -1, 2);
  tested(good, true);
  CHECK_FALSE(good.worst_kind);  // 2 exp(-1) = 0.7
}

TEST_CASE("neighbours are compared in each kind by itself, in the order of the speed",
          "[studies][calibrate][closed_form]") {
  // Of two independent normal numbers (cos u, sin u) every angle is equally likely. Their ratio (cos u - sin u)^2 = 1 - sin 2u
  // is at most that of a < pi/4 where 2a <= 2u <= pi - 2a: for the part 1/2 - 2a / pi of the angles.
  CalibrateResult result = with_powers(0.3, 0.2, 2);
  std::swap(result.data[20], result.data[21]);
  tested(result, false);
  REQUIRE(result.neighbours);
  CHECK(result.neighbours->count == 2);
  CHECK(result.neighbours->correlation == Approx(1).epsilon(1e-12));
  const double angle = std::atan(0.2 / 0.3);
  // One of two kinds is as rare twice as often.
  CHECK(result.neighbours->p == Approx(2 * (0.5 - 2 * angle / std::numbers::pi)).epsilon(1e-9));
  CHECK(result.neighbours_of.quantity == "electrical_power_at");
  CHECK(result.neighbours_of.over == "speed");
  CHECK_FALSE(result.chi_square);
}

TEST_CASE("readings of another table or setting are no neighbours", "[studies][calibrate]") {
  // Two torque curves that lie on either side of the motor. One after the other by speed they change signs all the time.
  CalibrateResult result;
  for (int i = 0; i < 8; ++i) {
    for (const double side : {0.2, -0.2}) {
      result.data.push_back(read("torque_at", i, side));
      result.data.back().set = {{"preload", "N", side > 0 ? 120.0 : 180.0}};
    }
  }
  result.degrees_of_freedom = result.data.size();
  CalibrateResult tables = result;
  for (auto& point : tables.data) {
    point.where = point.residual > 0 ? "a.csv:1" : "b.csv:1";
    point.set.clear();
  }
  for (CalibrateResult* one : {&result, &tables}) {
    tested(*one, false);
    REQUIRE(one->neighbours);
    CHECK(one->neighbours->correlation == Approx(1).epsilon(1e-12));
    CHECK(one->neighbours->p < 1e-4);
  }
  for (auto& point : result.data) point.set.clear();
  tested(result, false);
  CHECK(result.neighbours->correlation == Approx(-1).epsilon(1e-12));
  CHECK(result.neighbours->p > 0.999);
}

TEST_CASE("readings of one column that share an offset are found by their own scatter (L4.2, L4.3)",
          "[studies][calibrate][closed_form]") {
  // Four powers read at one place: their neighbours do not differ from other ones, but 1, 2, 3, 2 has the mean 2 and the
  // standard deviation sqrt(2 / 3).
  CalibrateResult result = with_powers(1, 2, 4);
  for (std::size_t i = 20; i < 24; ++i) result.data[i].argument = Argument::none;
  result.data[22].residual = 3;
  result.columns = {{"torque_at", "N.m", "", 20, 1}, {"electrical_power_at", "W", "", 4, 1}};
  tested(result, false);
  CHECK(result.neighbours_of.quantity == "torque_at");
  REQUIRE(result.offset);
  CHECK(result.offset->quantity == "electrical_power_at");
  CHECK(result.offset->count == 4);
  CHECK(result.offset->offset == Approx(2).epsilon(1e-12));
  // Student's distribution with 3 degrees of freedom in closed form; one of two columns is as rare twice as often.
  const double part = 2 / std::sqrt(2.0 / 3 / 4) / std::sqrt(3.0);
  const double p = 1 - 2 / std::numbers::pi * (std::atan(part) + part / (1 + part * part));
  CHECK(result.offset->p == Approx(2 * p).epsilon(1e-9));
  CHECK_FALSE(result.shifted());  // 3.3 %
  for (std::size_t i = 20; i < 24; ++i) result.data[i].residual += 4;
  tested(result, false);
  CHECK(result.shifted());
  CHECK(result.poor());

  CalibrateResult even = with_powers(2, -2, 4);
  even.columns = result.columns;
  tested(even, false);
  CHECK_FALSE(even.offset);
  CalibrateResult single = with_powers(1, 2, 0);
  single.data.resize(1);
  tested(single, false);  // one number leaves no scatter to compare an offset with
  CHECK_FALSE(single.offset);
}

TEST_CASE("residuals that are rounding are not tested", "[studies][calibrate]") {
  CalibrateResult result = with_powers(3, -3, 2);
  result.exact = true;
  tested(result, true);
  CHECK_FALSE(result.neighbours);
  CHECK_FALSE(result.chi_square);
  CHECK_FALSE(result.worst_kind);
}
