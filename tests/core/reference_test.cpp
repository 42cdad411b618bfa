// SPDX-License-Identifier: Apache-2.0
#include "support/brute_force.hpp"
#include "support/deviations.hpp"
#include "support/ode_solver.hpp"
#include "support/point_checks.hpp"
#include "support/reference_cases.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

// The reference cases come from two programs that are not ours; their digits are good to 1e-12 of the
// torque's scale and 1e-11 of the powers' (tests/data/reference/README.md).
namespace {

using namespace twum;
using namespace twum::test;

const std::vector<ReferenceCase>& reference() {
  static const auto cases = read_reference_cases(TWUM_TEST_DATA "/reference");
  return cases;
}

template <typename Check>
void for_each_point(Check check) {
  for (const ReferenceCase& motor : reference()) {
    for (const Row& row : motor.points) {
      CAPTURE(motor.number, row.at("speed"));
      check(motor.design, row);
    }
  }
}

}  // namespace

TEST_CASE("torque of the reference motors (T4.5)", "[core][point][differential]") {
  Deviation torque("torque of the reference cases", 1e-9);
  for_each_point([&](const MotorDesign& design, const Row& row) {
    const auto point = Motor(design).operating_point(row.at("speed"));
    REQUIRE(point.status == PointStatus::ok);
    // 1e-9 is asked for; the printed digits allow 1e-12.
    CHECK(torque.add(point.torque, row.at("torque"), torque_scale(design)) <= 1e-9);
  });
  CHECK(torque.holds());
}

TEST_CASE("powers of the reference motors (T7.1, T7.2, T7.3, T7.4)",
          "[core][point][differential]") {
  Deviation powers("powers of the reference cases", 1e-8);
  for_each_point([&](const MotorDesign& design, const Row& row) {
    const Motor motor(design);
    const auto point = motor.operating_point(row.at("speed"));
    REQUIRE(point.status == PointStatus::ok);
    const double scale = power_scale(motor, point.speed);
    // 1e-8 is asked for; the printed digits allow 1e-11.
    CHECK(powers.add(point.output_power, row.at("output_power"), scale) <= 1e-8);
    CHECK(powers.add(point.stator_power, row.at("stator_power"), scale) <= 1e-8);
    CHECK(powers.add(point.friction_power, row.at("friction_power"), scale) <= 1e-8);
    CHECK(powers.add(point.layer_loss, row.at("layer_loss"), scale) <= 1e-8);
  });
  CHECK(powers.holds());
}

TEST_CASE("stick fraction of the reference motors", "[core][contact][differential]") {
  Deviation fraction("stick fraction of the reference cases", 1e-7);
  for_each_point([&](const MotorDesign& design, const Row& row) {
    const auto point = Motor(design).operating_point(row.at("speed"));
    // Zone borders are roots, some nearly double: an error e of the state moves such a border by
    // sqrt(e), 1e-7 for e = 1e-14. The file has ten digits after the point.
    CHECK(fraction.add(point.stick_fraction, row.at("stick_fraction"), 1) <= 1e-7);
  });
  CHECK(fraction.holds());
}

// Motors whose plateau ends in a jump or kink that carries the maximum. There the slip velocity dips through
// zero for a moment, and the reference program sees the dip once it is deep enough: its plateau ends up to 7e-8
// late (see "the plateau ends where the slip velocity first dips through zero"). The slope of torque beyond
// makes that 6e-7 of the maximum, and 2e-5 of the efficiency, which jumps.
bool maximum_at_a_jump(int number) {
  return number == 1 || number == 16 || number == 22 || number == 25;
}

TEST_CASE("metrics of the reference motors (T7.12, T7.13, T7.14, T7.16)",
          "[core][metrics][differential]") {
  Deviation metrics("metrics of the reference cases", 1e-8);
  Deviation at_jumps("metrics of the reference cases where a maximum lies at a jump", 1e-6);
  Deviation speeds("speed at peak power of the reference cases", 1e-5);
  for (const ReferenceCase& entry : reference()) {
    const Motor motor(entry.design);
    for (const auto& [name, expected] : entry.metrics) {
      if (name == "design") continue;
      CAPTURE(entry.number, name);
      const auto metric = find_metric(name);
      REQUIRE(metric.has_value());
      const MetricValue found = evaluate(motor, MetricRequest{*metric});
      REQUIRE(found.status == MetricStatus::ok);
      if (name == "speed_at_peak_power") {
        // The peak is flat: an error e of the power moves it by sqrt(e); the file is good to 1e-7.
        CHECK(speeds.add(found.value, expected, std::abs(expected)) <= 1e-5);
      } else if (name == "contact_efficiency_at_peak_power") {
        // It has a slope at the peak, so it inherits the relative error of the speed there, 1e-7.
        const double tolerance = maximum_at_a_jump(entry.number) ? 3e-5 : 1e-6;
        CHECK(std::abs(found.value - expected) <= tolerance * std::abs(expected));
      } else if (maximum_at_a_jump(entry.number)) {
        CHECK(at_jumps.add(found.value, expected, std::abs(expected)) <= 1e-6);
      } else {
        CHECK(metrics.add(found.value, expected, std::abs(expected)) <= 1e-8);
      }
    }
  }
  CHECK(metrics.holds());
  CHECK(speeds.holds());
}

TEST_CASE("the plateau ends where the slip velocity first dips through zero (T7.17, E3.1, E3.4)",
          "[slow][core][metrics][differential]") {
  // The ODE solver takes steps so short that a dip of 1e-8 of V0, 1e-4 rad wide, spans several.
  OdeOptions fine;
  fine.max_step = 2e-5;
  Deviation torque("torque beside the plateau's end against the ODE solver", 1e-10);
  for (const ReferenceCase& entry : reference()) {
    if (!maximum_at_a_jump(entry.number)) continue;
    const Motor motor(entry.design);
    const double end = evaluate(motor, MetricRequest{Metric::plateau_speed}).value;
    for (const double offset : {-1e-7, -1e-8, 1e-8, 1e-7}) {
      const double speed = end * (1 + offset);
      CAPTURE(entry.number, offset);
      CHECK((motor.zones(speed).size() == 1) == (offset < 0));
      const auto oracle = ode_solver_run(entry.design, speed, fine);
      CHECK(torque.add(motor.operating_point(speed).torque, oracle.torque,
                       torque_scale(entry.design)) <= 1e-10);
    }
  }
  CHECK(torque.holds());
}

TEST_CASE("the brute-force oracle finds the reference torques", "[core][oracle][differential]") {
  Deviation torque("brute force against the reference cases, in units of its own error estimate",
                   1);
  for_each_point([&](const MotorDesign& design, const Row& row) {
    if (row.at("design") >= 12) return;  // a share is enough, chosen by number
    const auto found = brute_force(design, row.at("speed"));
    CHECK(found.converged);
    CHECK(torque.add(found.torque, row.at("torque"), found.torque_error) <= 1);
  });
  CHECK(torque.holds());
}

TEST_CASE("the ODE oracle finds the reference torques", "[core][oracle][differential]") {
  Deviation torque("ODE solver against the reference cases, torque", 1e-10);
  for_each_point([&](const MotorDesign& design, const Row& row) {
    const auto problem = contact_problem(design, row.at("speed"));
    if (problem.damping == 0 && problem.inertia == 0) return;
    if (problem.inertia > 0 && problem.stiffness > 1e4 * problem.inertia)
      return;  // slow, same path
    const auto found = ode_solver_run(design, row.at("speed"));
    CHECK(found.converged);
    // A lap takes some hundreds of steps of 1e-13 each.
    CHECK(torque.add(found.torque, row.at("torque"), problem.torque_scale) <= 1e-10);
  });
  CHECK(torque.holds());
}
