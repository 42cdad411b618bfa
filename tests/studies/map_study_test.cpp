// SPDX-License-Identifier: Apache-2.0
#include "telling/contours.hpp"
#include "telling/map_surface.hpp"

#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/source.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/telling.hpp>

#include <catch2/catch.hpp>

#include "support/driven_motors.hpp"
#include "support/motor_files.hpp"

#include <cmath>

// Maps over speed and torque: held points (Y2.1 to Y2.3) within the envelope (Y2.5).
using namespace twum;
using namespace twum::studies;

namespace {

StudyResult mapped(const MapStudy& asked, const MotorDesign& design = test::driven_motor()) {
  return run_study({.motor = {"motor", design}, .asked = asked});
}

const MapResult& map_of(const StudyResult& result) { return std::get<MapResult>(result.answer); }

double value(const MapResult& map, const MapResult::Point& point, std::string_view column) {
  for (std::size_t i = 0; i < map.columns.size(); ++i)
    if (map.columns[i].name == column) return point.values[i];
  return std::nan("");
}

std::string error_of(const std::string& entries) {
  try {
    read_study(Source("map.yaml", "twum: 1\nmotor: " + test::motor_path("drive-60") +
                                      "\nstudy:\n  kind: map\n" + entries),
               ".");
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

// Of the largest torque: without load the envelope ends at the largest speed, where rounding decides what is left.
constexpr double kRounding = 1e-9;

}  // namespace

TEST_CASE("a point of a map put back as a wave carries its torque, and its losses add up",
          "[studies][map][identity]") {
  const MotorDesign design = test::driven_motor();
  const StudyResult result = mapped({.points = {7, 5}}, design);
  const MapResult& map = map_of(result);
  REQUIRE(map.members.size() == 1);
  REQUIRE(map.members[0].points.size() == 35);
  std::size_t held = 0;
  for (const MapResult::Point& point : map.members[0].points) {
    CAPTURE(point.speed, point.torque, point.status);
    if (point.status != "ok") continue;
    ++held;
    MotorDesign put_back = with(design, Parameter::amplitude, value(map, point, "amplitude"));
    put_back.stator.frequency = value(map, point, "drive_frequency");
    const OperatingPoint at = Motor(put_back).operating_point(point.speed);
    CHECK(at.torque == Approx(point.torque).margin(1e-9));
    // (D4.2): what the terminals give is lost, or leaves through the shaft; rounding of a sum of five.
    const double sum = value(map, point, "output_power") + value(map, point, "friction_power") +
                       value(map, point, "layer_loss") + value(map, point, "stator_loss") +
                       value(map, point, "dielectric_loss");
    const double power = value(map, point, "electrical_power");
    CHECK(sum == Approx(power).epsilon(1e-8));
    CHECK(value(map, point, "overall_efficiency") ==
          Approx(point.torque * point.speed / power).margin(1e-9));
  }
  CHECK(held > 15);
}

TEST_CASE("the envelope of a map separates what is held from what is not", "[studies][map]") {
  const MotorDesign design = test::driven_motor();
  const MapResult map = map_of(mapped({.points = {12, 9}}, design));
  for (const MapResult::Corner& corner : map.members[0].envelope) {
    CAPTURE(corner.speed, corner.torque);
    if (!(corner.torque > kRounding * map.torque)) continue;
    CHECK(held_point(design, 0.999 * corner.torque, corner.speed).status == HeldStatus::ok);
    CHECK(held_point(design, 1.001 * corner.torque, corner.speed).status != HeldStatus::ok);
  }
  for (const MapResult::Point& point : map.members[0].points) {
    const auto i = static_cast<std::size_t>(std::lround(12 * point.speed / map.speed)) - 1;
    CAPTURE(point.speed, point.torque, point.status);
    if (point.torque > 1.001 * map.members[0].envelope[i].torque + kRounding * map.torque)
      CHECK(point.status != "ok");
  }
  // Without load the motor turns as fast as its drive holds: the end of the axis.
  CHECK(map.speed == map.members[0].largest_speed);
  CHECK(held_point(design, 0, 0.999 * map.speed).status == HeldStatus::ok);
  CHECK(held_point(design, 0, 1.001 * map.speed).status == HeldStatus::voltage_too_low);
}

TEST_CASE("a map of a motor with an amplitude has no terminals, and follows by the amplitude",
          "[studies][map]") {
  const MapResult map = map_of(mapped({.points = {4, 3}}, test::ring_motor()));
  CHECK(map.columns[map.shown].name == "efficiency");
  const MapResult::Point& point = map.members[0].points[4];
  REQUIRE(point.status == "ok");
  CHECK(value(map, point, "amplitude") <= test::ring_motor().stator.amplitude);
  CHECK(std::isnan(value(map, point, "electrical_power")));  // no such column
}

TEST_CASE("a duty of a map says what would do where it is not held", "[studies][map]") {
  MapStudy asked{.points = {3, 3}};
  asked.duty = {{0.3, 10}, {5, 10}, {0.3, 200}};
  const StudyResult result = mapped(asked);
  const std::vector<MapResult::Duty>& duty = map_of(result).members[0].duty;
  REQUIRE(duty.size() == 3);
  CHECK(duty[0].at.status == "ok");
  CHECK(std::isnan(duty[0].needed));
  CHECK(duty[0].torque_left > 0);
  CHECK(duty[1].at.status == "torque-out-of-reach");
  const MotorDesign design = test::driven_motor();  // mu F_N r
  CHECK(duty[1].needed ==
        Approx(design.friction.kinetic * design.preload * design.stator.contact_radius)
            .epsilon(1e-6));
  CHECK(duty[2].at.status == "voltage-too-low");
  MotorDesign enough = design;
  enough.stator.voltage = 1.0001 * duty[2].needed;
  CHECK(held_point(enough, 0.3, 200).status == HeldStatus::ok);
  const telling::Headline told = telling::headline(result);
  CHECK(told.look == telling::Headline::Look::bad);
  CHECK(telling::written(told.sentences[1], telling::Writing::typed) ==
        "It holds 1 of 3 duty points.");
}

TEST_CASE("a map on which the drive holds no load says so, not that its best efficiency is nothing",
          "[studies][map]") {
  // The least torque of the map beyond 0 is half of a million newton metres.
  const StudyResult result = mapped({.torque = 1e6, .points = {3, 3}});
  CHECK(result.outcome == "done");
  const telling::Headline told = telling::headline(result);
  CHECK(told.look == telling::Headline::Look::bad);
  CHECK(telling::written(told.sentences[0], telling::Writing::typed) ==
        "The drive holds no load at the points of the map.");
}

TEST_CASE("a duty that only a controller holds says so", "[studies][map]") {
  // A drive that follows by voltage holds its speed below the resonance, too; what stays there is told by the point itself.
  MapResult answer;
  answer.columns = {{"efficiency", "1"}, {"held_by_control_only", "1"}};
  answer.speeds = answer.torques = 2, answer.speed = answer.torque = 1;
  MapResult::Member member;
  member.largest_speed = 1;
  for (const double speed : {0.5, 1.0}) {
    for (const double torque : {0.0, 1.0}) member.points.push_back({speed, torque, "ok", {0.3, 0}});
    member.envelope.push_back({speed, 1, {0.3, 0}});
  }
  for (const double controlled : {0.0, 1.0})
    member.duty.push_back({{0.5, 0.5, "ok", {0.3, controlled}}, std::nan(""), "", 0.5});
  answer.members = {member};
  StudyResult result;
  result.answer = answer;
  const std::vector<telling::Section> sections = telling::sections(result);
  const telling::Table& table = sections.at(1).tables.at(0);
  CHECK(telling::written(table.rows[0][2], telling::Writing::typed) == "held");
  CHECK(telling::written(table.rows[1][2], telling::Writing::typed) ==
        "held only with speed control: with a constant drive this point is unstable");
}

TEST_CASE("a quantity that is no column of a map becomes one", "[studies][map]") {
  const MotorDesign design = test::driven_motor();
  const MapResult map =
      map_of(mapped({.points = {3, 3}, .quantity = Metric::max_pressure_at}, design));
  CHECK(map.columns[map.shown].name == "max_pressure");
  const MapResult::Point& point = map.members[0].points[1];
  REQUIRE(point.status == "ok");
  // The indentation at the crest under a wave is that of the preload at its amplitude.
  const Motor wave(with(design, Parameter::amplitude, value(map, point, "amplitude")));
  CHECK(value(map, point, "max_pressure") ==
        Approx(evaluate(wave, {Metric::max_pressure, Argument::none, 0}).value).epsilon(1e-9));
  CHECK(
      map_of(mapped({.points = {3, 3}, .quantity = Metric::electrical_power_at})).columns.size() ==
      map.columns.size() - 1);
}

TEST_CASE("wrong maps are refused with place and remedy", "[studies][map]") {
  CHECK(error_of("  points: 60\n").find("such as 60x40") != std::string::npos);
  CHECK(error_of("  points: 1x40\n").find("each 2 to 1000") != std::string::npos);
  CHECK(error_of("  points: 60x4000\n").find("each 2 to 1000") != std::string::npos);
  const std::string infinite = error_of("  speed: .inf\n");  // told once
  CHECK(infinite.find("study.speed") == infinite.rfind("study.speed"));
  CHECK(error_of("  torque: 0 N.m\n").find("more than 0") != std::string::npos);
  CHECK(error_of("  speed: -3 rpm\n").find("more than 0") != std::string::npos);
  CHECK(error_of("  quantity: stall_torque\n").find("quantity") != std::string::npos);
  CHECK(error_of("  quantity: overal_efficiency_at\n").find("did you mean") != std::string::npos);
  CHECK(error_of("  duty:\n    - {torque: 1 N.m, speed: 0 rpm}\n").find("at rest") !=
        std::string::npos);
}

TEST_CASE("contour lines of a cone are its circles, and those of a plane are straight",
          "[studies][map][contours]") {
  telling::ValueGrid grid{101, 81, -1, 1, -1, 1, {}};
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      grid.values.push_back(
          std::hypot(grid.x(static_cast<double>(i)), grid.y(static_cast<double>(j))));
  const std::vector<telling::ContourLine> circles = telling::contour_lines(grid, 0.5);
  REQUIRE(circles.size() == 1);
  const telling::ContourLine& circle = circles[0];
  CHECK(circle.x.front() == circle.x.back());
  CHECK(circle.y.front() == circle.y.back());
  for (std::size_t k = 0; k < circle.x.size(); ++k)  // a chord of a step of 1/40: h^2 / (8 r)
    CHECK(std::hypot(circle.x[k], circle.y[k]) == Approx(0.5).margin(0.025 * 0.025 / 4));
  // Beyond the inscribed circle four pieces are left, each in a corner.
  CHECK(telling::contour_lines(grid, 1.2).size() == 4);
  CHECK(telling::contour_lines(grid, 2).empty());
  for (std::size_t k = 0; k < grid.values.size(); ++k) {
    const double x = grid.x(static_cast<double>(k % grid.columns));
    grid.values[k] = x > 0.503 ? std::nan("") : x;
  }
  const std::vector<telling::ContourLine> lines = telling::contour_lines(grid, 0.25);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].x.size() == grid.rows);
  for (const double x : lines[0].x) CHECK(x == Approx(0.25).margin(1e-12));
}

TEST_CASE("levels are round and contain the values", "[studies][map][contours]") {
  CHECK(telling::round_levels({3, 3}).empty());
  CHECK(telling::round_levels({120, 120 + 1e-10}).empty());  // one value but for rounding
  CHECK(telling::round_levels({std::nan("")}).empty());
  const std::vector<double> levels = telling::round_levels({0.013, 0.46, std::nan("")});
  CHECK(levels.front() == 0);
  CHECK(levels.back() == Approx(0.5).margin(1e-12));
  CHECK(levels.size() == 11);
  const std::vector<double> both = telling::round_levels({-1, 1});
  CHECK(both.front() <= -1);
  CHECK(both.back() >= 1);
}

TEST_CASE("the surface of a map meets its points, and ends where the envelope does",
          "[studies][map][contours]") {
  const MapResult map = map_of(mapped({.points = {9, 7}}));
  const MapResult::Member& member = map.members[0];
  const telling::MapSurface surface(map, member, map.efficiency);
  std::size_t met = 0;
  for (std::size_t i = 0; i < map.speeds; ++i)
    for (std::size_t j = 0; j < map.torques; ++j) {
      const MapResult::Point& point = member.points[i * map.torques + j];
      if (point.status != "ok" || !(point.torque < member.envelope[i].torque)) continue;
      CHECK(surface.at(point.speed, point.torque) ==
            Approx(point.values[map.efficiency]).margin(1e-12));
      ++met;
    }
  CHECK(met > 20);
  for (const MapResult::Corner& corner : member.envelope) {
    if (!(corner.torque > kRounding * map.torque)) continue;
    CHECK(std::isnan(surface.at(corner.speed, 1.0001 * corner.torque)));
    CHECK(std::isfinite(surface.at(corner.speed, 0.9999 * corner.torque)));
  }
  CHECK(std::isnan(surface.at(1.01 * map.speed, 0)));
}
