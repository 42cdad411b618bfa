// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/workspace.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace twum;
using namespace twum::test;

std::array<std::uint64_t, 8> bits_of(const OperatingPoint& p) {
  return {
      std::bit_cast<std::uint64_t>(p.torque),         std::bit_cast<std::uint64_t>(p.stator_power),
      std::bit_cast<std::uint64_t>(p.friction_power), std::bit_cast<std::uint64_t>(p.layer_loss),
      std::bit_cast<std::uint64_t>(p.stick_fraction), std::bit_cast<std::uint64_t>(p.amplitude),
      std::bit_cast<std::uint64_t>(p.phase_current),  static_cast<std::uint64_t>(p.status)};
}

MotorDesign motor_in_slices(MotorDesign design, int slices) {
  design.stator.radial_slices = slices;
  return design;
}

MotorDesign any_motor() {
  const int slices = GENERATE(1, 8, int{kAutoSlices});
  return motor_in_slices(GENERATE(false, true) ? driven_motor_with_layer() : ring_motor(), slices);
}

}  // namespace

TEST_CASE("points and metrics of a workspace are the others to the bit", "[core][point][metrics]") {
  const Motor motor(any_motor());
  Workspace workspace;
  for (int i = -2; i <= 14; ++i) {
    const double speed = 0.1 * i * motor.crest_speed();
    CHECK(bits_of(motor.operating_point(speed, workspace)) ==
          bits_of(motor.operating_point(speed)));
  }
  const auto asked = every_metric(0.4 * motor.crest_speed(), 0.2);
  std::vector<MetricValue> values(asked.size());
  evaluate(motor, asked, values, workspace);
  const auto others = evaluate(motor, asked);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    CAPTURE(info(asked[i].metric).name);
    CHECK(std::bit_cast<std::uint64_t>(values[i].value) ==
          std::bit_cast<std::uint64_t>(others[i].value));
    CHECK(values[i].status == others[i].status);
  }
}

TEST_CASE("a point under conditions of its own may use a workspace", "[core][point]") {
  const Motor motor(motor_in_slices(ring_motor(), 8));
  Workspace workspace;
  const OperatingConditions at{10, 1.2e-6, 41e3};
  CHECK(bits_of(motor.operating_point(at, workspace)) == bits_of(motor.operating_point(at)));
}

// What a motor finds once it keeps, also where a workspace was at hand.
TEST_CASE("a motor outlives the workspace of its first point", "[core][point]") {
  const Motor motor(any_motor());
  const double speed = 10;
  std::optional<Workspace> workspace(std::in_place);
  const auto first = bits_of(motor.operating_point(speed, *workspace));
  workspace.reset();
  CHECK(bits_of(motor.operating_point(speed)) == first);
}

TEST_CASE("a workspace grows as it is needed, and no more", "[core][point]") {
  const Motor motor(motor_in_slices(driven_motor_with_layer(), kAutoSlices));
  Workspace workspace(0);
  CHECK(workspace.size() == 0);
  motor.operating_point(10, workspace);
  const std::size_t grown = workspace.size();
  CHECK(grown > 0);
  motor.operating_point(10, workspace);
  CHECK(workspace.size() == grown);
}

TEST_CASE("a workspace that was moved from serves from the heap", "[core][point]") {
  const Motor motor(motor_in_slices(ring_motor(), 8));
  Workspace workspace;
  const auto point = bits_of(motor.operating_point(10, workspace));
  Workspace other = std::move(workspace);
  CHECK(bits_of(motor.operating_point(10, other)) == point);
  CHECK(workspace.size() == 0);  // NOLINT: what a workspace is then is promised
  CHECK(bits_of(motor.operating_point(10, workspace)) == point);
  workspace = std::move(other);
  CHECK(bits_of(motor.operating_point(10, workspace)) == point);
}

TEST_CASE("metrics want as many places as requests", "[core][metrics]") {
  const Motor motor(ring_motor());
  Workspace workspace;
  std::vector<MetricValue> values(2);
  const std::array requests{MetricRequest{Metric::stall_torque}};
  CHECK_THROWS_AS(evaluate(motor, requests, values, workspace), InputError);
}
