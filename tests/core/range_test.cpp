// SPDX-License-Identifier: Apache-2.0
#include "support/box_survey.hpp"
#include "support/heat_motors.hpp"
#include "support/plate_motors.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

// The ranges of parameters, and that within them `ok` means that the laws hold.
namespace {

using namespace twum;
using namespace twum::test;
using P = Parameter;

std::vector<MotorDesign> layers() {
  return {ring_motor(), elastic(ring_motor()), damped(ring_motor())};
}

std::string broken_at(const MotorDesign& design, double share) {
  const Motor motor(design);
  return broken_law(motor, motor.operating_point(share * motor.crest_speed()), kPromised);
}

}  // namespace

// Each of these once gave numbers that broke a law under the status ok: an efficiency of 1.03, a negative friction power,
// powers that were off by 23 %, infinity.
TEST_CASE("values that no motor has are refused with the range", "[core][design][error]") {
  const std::vector<ParameterValue> impossible{{P::thickness, 1e-24},
                                               {P::thickness, 1e-30},
                                               {P::poisson_ratio, -1 + 1e-12},
                                               {P::poisson_ratio, -1 + 1e-15},
                                               {P::contact_width, 1e-20},
                                               {P::contact_radius, 1e-299},
                                               {P::neutral_plane_distance, 1e-299},
                                               {P::frequency, 1e-299},
                                               {P::youngs_modulus, 1e-299},
                                               {P::shear_modulus, 1e-299}};
  for (const auto& [parameter, value] : impossible) {
    CAPTURE(info(parameter).name, value);
    CHECK(complaint(parameter, value).find("must be at least") == 0);
    for (const MotorDesign& design : layers())
      CHECK_THROWS_AS(with(design, parameter, value), InputError);
  }
}

TEST_CASE("small numbers beside zero keep the laws or have a status (T7.10, C8.1)",
          "[core][design][limit]") {
  for (const MotorDesign& design : layers()) {
    for (const ParameterInfo& row : parameter_table()) {
      if (row.min != 0 || of_driven_stator(row.parameter) || of_geometry(row.parameter) ||
          of_heat(row.parameter))
        continue;
      for (const double value : {1e-299, 1e-100, 1e-30}) {
        if (!complaint(row.parameter, value).empty()) continue;
        if (row.parameter == P::static_friction) continue;  // below the kinetic one
        for (const double share : {0.0, 0.5, 1.0}) {
          CAPTURE(row.name, value, share);
          CHECK(broken_at(with(design, row.parameter, value), share) == "");
        }
      }
    }
  }
}

// A track that reaches the axis is no track: the ends of radius and width are met by one as narrow or as large.
MotorDesign with_track(MotorDesign design, P parameter, double value) {
  if (parameter == P::contact_radius)
    design.stator.contact_width = std::min(design.stator.contact_width, value);
  if (parameter == P::contact_width)
    design.stator.contact_radius = std::max(design.stator.contact_radius, value);
  return with(design, parameter, value);
}

TEST_CASE("ends of ranges keep the laws or have a status (T7.10, C8.1)", "[core][design][limit]") {
  for (const MotorDesign& design : layers()) {
    for (const ParameterInfo& row : parameter_table()) {
      if (of_driven_stator(row.parameter) || of_geometry(row.parameter) || of_heat(row.parameter))
        continue;
      for (const double value : {row.min, row.max}) {
        if (row.parameter == P::static_friction && value < design.friction.kinetic) continue;
        for (const double share : {0.0, 0.3, 0.8, 1.0, 1.2}) {
          CAPTURE(row.name, value, share);
          CHECK(broken_at(with_track(design, row.parameter, value), share) == "");
        }
      }
    }
  }
}

// A contact pressed together by 1e13 times the wave's own pressure: its zones are shorter than rounding.
TEST_CASE("an answer that rounding spoils is inaccurate, and so is a metric that needs it",
          "[core][design][limit]") {
  const std::array<ParameterValue, 2> values{{{P::youngs_modulus, 1e3}, {P::preload, 1e11}}};
  const Motor motor(with(ring_motor(), values));
  const double speed = 0.3 * motor.crest_speed();
  const OperatingPoint point = motor.operating_point(speed);
  CHECK(point.status == PointStatus::inaccurate);
  CHECK(std::isnan(point.torque));
  const MetricValue torque = evaluate(motor, {Metric::torque_at, Argument::speed, speed});
  CHECK(torque.status == MetricStatus::inaccurate);
  CHECK(std::isnan(torque.value));
}

// A stator that loses next to nothing: the efficiency at no-load is a quotient of two powers that vanish there.
TEST_CASE("an efficiency made of rounding is inaccurate", "[core][metrics][limit]") {
  const Motor motor(with(elastic(ring_motor()), P::modal_damping, 1e-24));
  CHECK(evaluate(motor, {Metric::max_efficiency}).status == MetricStatus::inaccurate);
  CHECK(evaluate(motor, {Metric::speed_at_max_efficiency}).status == MetricStatus::inaccurate);
}

TEST_CASE("a layer may be rigid in shear, whatever its Young's modulus (C8.1)",
          "[core][design][limit]") {
  for (const double E : {1e3, 3e9, 1e13}) {
    for (const MotorDesign& design : layers()) {
      const MotorDesign rigid = with(with(design, P::youngs_modulus, E), P::shear_modulus, 1e13);
      for (const double share : {0.0, 0.5, 0.9, 1.2}) {
        CAPTURE(E, share);
        CHECK(broken_at(rigid, share) == "");
      }
    }
  }
}

TEST_CASE(
    "all over the ranges of parameters an answer keeps the laws or has a status (T7.10, C8.1)",
    "[.long][core][design][identity]") {
  const BoxSurvey found = survey_ranges(1, 1500);
  CAPTURE(found.designs, found.statuses, found.metrics, found.broken, found.examples);
  CHECK(found.designs > 5000);
  CHECK(found.broken.empty());
  CHECK(found.metrics_broken == 0);
  CHECK(found.slowest.front().value < 2.0);
}
