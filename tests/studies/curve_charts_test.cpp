// SPDX-License-Identifier: Apache-2.0
// What stands on the charts of a curve: marks and limits at closed forms, shares that add up, and which motors have curves.
#include "telling/curve_charts.hpp"
#include "answer_support.hpp"
#include "search_support.hpp"
#include "support/motor_files.hpp"

#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;
using namespace twum::studies::telling;
using Catch::Matchers::WithinRel;

namespace {

constexpr double kRpm = std::numbers::pi / 30;

ElasticLayer elastic() {
  return {read_motor_file(TWUM_SOURCE_DIR "/examples/motors/elastic-layer.yaml").design};
}

MotorDesign driven_design() { return read_motor_file(motor_path("drive-60")).design; }

std::vector<MotorCurve> curves_of(const MotorDesign& design) {
  return {*motor_curve("x", design, {}, 101)};
}

const Mark& mark_that(const Chart& chart, const std::string& begins) {
  const auto found = std::ranges::find_if(chart.marks, [&](const Mark& mark) {
    return written(mark.text, Writing::read).starts_with(begins);
  });
  REQUIRE(found != chart.marks.end());
  return *found;
}

LimitState limit_on(const std::string& metric, double limit, const std::string& unit) {
  LimitState state;
  state.text = metric + " >= LIMIT";
  state.metric = metric;
  state.unit = unit;
  state.at_least = true;
  state.limit = limit;
  state.value = 2 * limit;
  return state;
}

}  // namespace

TEST_CASE("a curve is marked where it stalls and where it runs without load (C8.5, C8.6)",
          "[studies][telling]") {
  const ElasticLayer exact = elastic();
  const double preload = exact.motor.preload;
  const Chart chart = torque_chart(curves_of(exact.motor));
  CHECK(mark_that(chart, "stall ").x == 0);
  // A few products and a sum over zones; a root that is solved to about 1e-12.
  CHECK_THAT(mark_that(chart, "stall ").y, WithinRel(exact.plateau_torque(preload), 1e-12));
  CHECK_THAT(mark_that(chart, "no load ").x,
             WithinRel(exact.no_load(exact.angle_of_preload(preload)), 1e-10));
  CHECK(mark_that(chart, "no load ").y == 0);
  CHECK(chart.x.low == 0);
  CHECK(chart.x.high > mark_that(chart, "no load ").x);
}

TEST_CASE("limits stand in the plane of speed and torque where they are asked",
          "[studies][telling]") {
  DesignReport report;
  report.constraints = {
      limit_on("torque_at(80 rpm)", 0.3, "N.m"), limit_on("speed_at(0.2 N.m)", 50 * kRpm, "rad/s"),
      limit_on("stall_torque", 0.4, "N.m"), limit_on("no_load_speed", 90 * kRpm, "rad/s"),
      limit_on("max_pressure", 1e6, "Pa")};
  const Chart chart = torque_chart(curves_of(elastic().motor), curve_limits(report, {}));
  REQUIRE(chart.bounds.size() == 4);  // the pressure has no place there
  const double places[][3] = {{80, 0.3, 0}, {50, 0.2, 1}, {0, 0.4, 0}, {90, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_THAT(chart.bounds[i].x / kRpm, WithinRel(places[i][0], 1e-14));
    CHECK(chart.bounds[i].y == places[i][1]);
    CHECK(chart.bounds[i].upright == (places[i][2] == 1));
    CHECK_FALSE(chart.bounds[i].broken);
  }
  CHECK(written(chart.bounds[0].text, Writing::typed) == ">= 300 mN.m at 80 rpm");
  CHECK(written(chart.bounds[2].text, Writing::typed) == "stall >= 400 mN.m");
}

TEST_CASE("the shares of the electrical power add up to it", "[studies][telling]") {
  const std::vector<MotorCurve> curves = curves_of(driven_design());
  const Chart power = curve_charts(curves)[1];
  REQUIRE(power.series.size() == 5);
  for (std::size_t i = 0; i < curves[0].points.size(); ++i) {
    double sum = 0;
    for (const Series& series : power.series) {
      CHECK(series.stroke == Stroke::stack);
      sum += series.y.values[i];
    }
    // The balance of power holds to the accuracy of the periodic state.
    CHECK_THAT(sum, WithinRel(curves[0].points[i].electrical_power, 1e-9));
  }
}

TEST_CASE("an efficiency ends with 0 at no load and falls on its way there", "[studies][telling]") {
  const ElasticLayer exact = elastic();
  const Chart chart = curve_charts(curves_of(exact.motor)).back();
  const Series& series = chart.series.front();
  CHECK(series.y.values.back() == 0);
  CHECK_THAT(series.x.values.back(),
             WithinRel(exact.no_load(exact.angle_of_preload(exact.motor.preload)), 1e-10));
  CHECK(std::ranges::is_sorted(series.x.values));
  CHECK(std::ranges::max(series.y.values) < 1);
  CHECK(chart.y.high == 1);
}

TEST_CASE("the most complete efficiency that all motors have is told", "[studies][telling]") {
  const MotorCurve contact = curves_of(elastic().motor).front();
  const MotorCurve damped = curves_of(read_motor_file(motor_path("ring-60")).design).front();
  const MotorCurve driven = curves_of(driven_design()).front();
  const auto name = [](const std::vector<MotorCurve>& curves) {
    return std::string(efficiency_kind(curves).name);
  };
  CHECK(name({driven, driven}) == "overall efficiency");
  CHECK(name({driven, damped}) == "efficiency");
  CHECK(name({contact, contact}) == "contact efficiency");
}

TEST_CASE("of two curves the one that was asked for has its marks named", "[studies][telling]") {
  std::vector<MotorCurve> curves = curves_of(elastic().motor);
  curves.push_back(*motor_curve("y", elastic().motor, {{"preload", "N", 100}}, 101));
  curves.back().place = 1;
  const Chart chart = torque_chart(curves);
  REQUIRE(chart.series.size() == 2);
  CHECK(chart.series[1].name == "y");
  CHECK(chart.series[1].y.where == "motors/1/torque");
  for (const Mark& mark : chart.marks) CHECK(mark.text.empty() == (mark.colour == "c0"));
}

TEST_CASE("a motor without width has no comparison with one slice", "[studies][telling]") {
  CHECK(torque_chart(curves_of(elastic().motor)).more.empty());
  const MotorDesign wide =
      with(read_motor_file(motor_path("ring-60")).design, Parameter::radial_slices, 4);
  const Chart chart = torque_chart(curves_of(wide));
  REQUIRE(chart.more.size() == 1);
  CHECK(chart.more[0].y.where == "motors/0/one_slice_torque");
}
