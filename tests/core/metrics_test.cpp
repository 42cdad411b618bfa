// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "core/scanned_motors.hpp"
#include "support/deviations.hpp"
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
#include <set>
#include <vector>

// Metrics against their definitions in theory section 7, by scanning operating points.
using namespace twum;
using namespace twum::test;

TEST_CASE("the metric table has one row for each metric, in order", "[core][metrics][identity]") {
  REQUIRE(metric_table().size() == kMetricCount);
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricInfo& row = metric_table()[i];
    CHECK(static_cast<std::size_t>(row.metric) == i);
    CHECK(&info(row.metric) == &row);
    CHECK(find_metric(row.name) == row.metric);
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.text.empty());
    CHECK_FALSE(row.unit.empty());
  }
  CHECK_FALSE(find_metric("torque").has_value());
}

TEST_CASE("each status has a word of its own", "[core][metrics]") {
  std::set<std::string> words;
  for (const auto status :
       {MetricStatus::ok, MetricStatus::undefined, MetricStatus::unreachable,
        MetricStatus::no_periodic_state, MetricStatus::not_converged, MetricStatus::resonance,
        MetricStatus::unresolved, MetricStatus::inaccurate, MetricStatus::out_of_range,
        MetricStatus::pulled_out, MetricStatus::no_running_branch, MetricStatus::no_dead_branch,
        MetricStatus::unstable_amplitude, MetricStatus::backward_wave_unknown,
        MetricStatus::does_not_pull_out})
    CHECK(words.insert(to_string(status)).second);
  // A point without an answer and a metric that needs it give the same reason.
  for (const auto status :
       {PointStatus::ok, PointStatus::no_periodic_state, PointStatus::not_converged,
        PointStatus::resonance, PointStatus::unresolved, PointStatus::inaccurate,
        PointStatus::pulled_out, PointStatus::no_running_branch, PointStatus::no_dead_branch,
        PointStatus::unstable_amplitude})
    CHECK(words.contains(to_string(status)));
  std::set<std::string> smoothness;
  for (const auto kind :
       {Smoothness::smooth, Smoothness::flat, Smoothness::one_sided, Smoothness::undefined})
    CHECK(smoothness.insert(to_string(kind)).second);
}

TEST_CASE("torque falls through zero at the no-load speed (T7.14)", "[core][metrics][identity]") {
  std::vector<Motor> tested = motors(1, 60, false);
  Uniform random(51);
  for (int i = 0; i < 60; ++i) {  // thick layers, whose torque may ripple
    MotorDesign design = realistic_design(random);
    design.friction.threshold = design.friction.kinetic;
    design.layer.thickness *= random(1.5, 4);
    tested.emplace_back(design);
  }
  Deviation torque("torque at the no-load speed", 1e-9);
  for (const Motor& motor : tested) {
    const MetricValue free = ask(motor, Metric::no_load_speed);
    REQUIRE(free.status == MetricStatus::ok);
    REQUIRE(free.value > 0);
    // The root is found to a few eps of the speed; torque falls by up to its scale within 1e-4 of it
    // for the narrowest contacts, hence 1e-16 * 1e4, and a margin.
    CHECK(torque.add(motor.operating_point(free.value).torque, 0, motor.holding_torque()) <= 1e-9);
    CHECK(motor.operating_point(free.value * (1 - 1e-6)).torque > 0);
    CHECK(motor.operating_point(free.value * (1 + 1e-6)).torque < 0);
    for (const OperatingPoint& point : scan(motor, 200).points) CHECK(point.torque > 0);
  }
  CHECK(torque.holds());
}

TEST_CASE("stall torque is the torque just above rest (T7.12)", "[core][metrics][limit]") {
  for (const Motor& motor : motors(2, 60, true)) {
    const MetricValue stall = ask(motor, Metric::stall_torque);
    REQUIRE(stall.status == MetricStatus::ok);
    const double near = motor.operating_point(1e-9 * motor.crest_speed()).torque;
    // torque changes by at most some hundred scales per V0 / r
    CHECK(std::abs(stall.value - near) <= 1e-6 * motor.holding_torque());
  }
}

TEST_CASE("no point of a scan exceeds the suprema, and one comes near (T7.13, T7.16)",
          "[core][metrics][identity]") {
  const bool threshold = GENERATE(false, true);
  for (const Motor& motor : motors(3, 45, threshold)) {
    const double scale = motor.holding_torque();
    const MetricValue torque = ask(motor, Metric::max_torque);
    const MetricValue power = ask(motor, Metric::peak_power);
    REQUIRE(torque.status == MetricStatus::ok);
    REQUIRE(power.status == MetricStatus::ok);
    double best_torque = ask(motor, Metric::stall_torque).value;
    double best_power = 0;
    const Scan found = scan(motor, 2000);
    for (const OperatingPoint& point : found.points) {
      best_torque = std::max(best_torque, point.torque);
      best_power = std::max(best_power, point.output_power);
    }
    CAPTURE(best_torque / scale, best_power, threshold);
    CHECK(torque.value >= best_torque * (1 - 1e-12));
    CHECK(power.value >= best_power * (1 - 1e-12));
    // a grid of 2000 speeds misses a smooth peak by 1e-6, a kink by up to a step's worth
    CHECK(torque.value <= best_torque + 5e-3 * scale);
    CHECK(power.value <= best_power * (1 + 5e-3));
  }
}

TEST_CASE("peak power is torque times speed there (T7.16)", "[core][metrics][identity]") {
  for (const Motor& motor : motors(4, 45, true)) {
    const double speed = ask(motor, Metric::speed_at_peak_power).value;
    const double torque = ask(motor, Metric::torque_at_peak_power).value;
    CHECK(ask(motor, Metric::peak_power).value == Approx(speed * torque).epsilon(1e-12));
    CHECK(speed <= ask(motor, Metric::no_load_speed).value);
    const double efficiency = ask(motor, Metric::contact_efficiency_at_peak_power).value;
    CHECK(efficiency > 0);
    CHECK(efficiency <= 1);
  }
}

TEST_CASE("peak power is stationary where the characteristic is smooth (T7.16)",
          "[core][metrics][identity]") {
  const Motor motor(ring_motor());
  const double speed = ask(motor, Metric::speed_at_peak_power).value;
  const double step = 1e-5 * speed;
  const double slope = (motor.operating_point(speed + step).output_power -
                        motor.operating_point(speed - step).output_power) /
                       (2 * step);
  // the difference quotient of the parabola is exact but for rounding of 1e-15 / 1e-5
  CHECK(std::abs(slope) * speed <= 1e-6 * ask(motor, Metric::peak_power).value);
}

TEST_CASE("speed_at undoes torque_at on the stable side (T7.15)", "[core][metrics][identity]") {
  for (const Motor& motor : motors(5, 45, false)) {
    const double free = ask(motor, Metric::no_load_speed).value;
    const double stall = ask(motor, Metric::stall_torque).value;
    for (const double share : {0.1, 0.5, 0.9}) {
      const MetricValue speed = ask_at_torque(motor, Metric::speed_at, share * stall);
      REQUIRE(speed.status == MetricStatus::ok);
      CHECK(speed.value >= 0);
      CHECK(speed.value <= free * (1 + 1e-12));
      CHECK(std::abs(motor.operating_point(speed.value).torque - share * stall) <=
            1e-9 * motor.holding_torque());
      // nothing beyond carries as much
      for (int i = 1; i <= 50; ++i) {
        const double beyond = speed.value + (free - speed.value) * i / 50;
        CHECK(motor.operating_point(beyond).torque <=
              share * stall + 1e-9 * motor.holding_torque());
      }
    }
  }
}

TEST_CASE("no load at all runs at the no-load speed (T7.14, T7.15)", "[core][metrics][limit]") {
  const Motor motor(ring_motor());
  CHECK(ask_at_torque(motor, Metric::speed_at, 0).value ==
        Approx(ask(motor, Metric::no_load_speed).value).epsilon(1e-10));
}

TEST_CASE("more than the motor can carry is unreachable, not an error (T7.15)",
          "[core][metrics][limit]") {
  const Motor motor(ring_motor());
  for (const Metric which :
       {Metric::speed_at, Metric::output_power_at, Metric::contact_efficiency_at}) {
    const MetricValue value = ask_at_torque(motor, which, 1.01 * motor.holding_torque());
    CHECK(value.status == MetricStatus::unreachable);
    CHECK(std::isnan(value.value));
  }
}

TEST_CASE("point metrics are the numbers of the operating point", "[core][metrics][identity]") {
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  const Motor motor(design);
  for (const double share : {0.2, 0.8, 0.93}) {
    const double speed = share * motor.crest_speed();
    const auto point = motor.operating_point(speed);
    CHECK(at_speed(motor, Metric::torque_at, speed).value == point.torque);
    CHECK(at_speed(motor, Metric::output_power_at, speed).value == point.output_power);
    CHECK(at_speed(motor, Metric::stator_power_at, speed).value == point.stator_power);
    CHECK(at_speed(motor, Metric::friction_power_at, speed).value == point.friction_power);
    CHECK(at_speed(motor, Metric::layer_loss_at, speed).value == point.layer_loss);
    CHECK(at_speed(motor, Metric::efficiency_at, speed).value == point.efficiency());
    CHECK(at_speed(motor, Metric::contact_efficiency_at, speed).value ==
          point.contact_efficiency());
    CHECK(at_speed(motor, Metric::wear_intensity_at, speed).value == point.wear_intensity);
    CHECK(at_speed(motor, Metric::stick_fraction_at, speed).value == point.stick_fraction);
  }
}

TEST_CASE("point metrics at a torque are those at its speed (T7.15)", "[core][metrics][identity]") {
  const Motor motor(ring_motor());
  const double load = 0.5 * ask(motor, Metric::stall_torque).value;
  const double speed = ask_at_torque(motor, Metric::speed_at, load).value;
  for (const Metric which :
       {Metric::output_power_at, Metric::stator_power_at, Metric::friction_power_at,
        Metric::layer_loss_at, Metric::wear_intensity_at, Metric::stick_fraction_at}) {
    CAPTURE(info(which).name);
    CHECK(ask_at_torque(motor, which, load).value ==
          Approx(at_speed(motor, which, speed).value).epsilon(1e-10));
  }
}

TEST_CASE("geometry metrics are those of the normal contact (T3.4)", "[core][metrics][identity]") {
  for (const Motor& motor : motors(6, 20, true)) {
    CHECK(ask(motor, Metric::contact_half_length).value == motor.contact().half_length);
    CHECK(ask(motor, Metric::contact_ratio).value == motor.contact().ratio);
    CHECK(ask(motor, Metric::max_pressure).value == motor.contact().max_pressure);
    CHECK(ask(motor, Metric::holding_torque).value == motor.holding_torque());
  }
}

namespace {

void expect_same_alone(const Motor& motor) {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table()) {
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
    const bool each = row.argument == Argument::speed_or_torque || row.argument == Argument::either;
    if (row.argument == Argument::speed || each)
      requests.push_back({row.metric, Argument::speed, 0.9 * motor.crest_speed()});
    if (row.argument == Argument::torque || each)
      requests.push_back({row.metric, Argument::torque, 0.35 * motor.holding_torque()});
  }
  const auto values = evaluate(motor, requests);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const MetricValue alone = evaluate(motor, requests[i]);
    CAPTURE(info(requests[i].metric).name);
    CHECK(values[i].status == alone.status);
    const bool same =
        values[i].value == alone.value || (std::isnan(values[i].value) && std::isnan(alone.value));
    CHECK(same);
  }
}

// A 30 mm ring whose layer loses nothing and holds longer than it slides: at most of its speeds it never
// repeats itself, and follows some thousand laps before that is known.
MotorDesign restless_motor() {
  MotorDesign design;
  design.stator.wavelengths = 6;
  design.stator.contact_radius = 13e-3;
  design.stator.contact_width = 2e-3;
  design.stator.neutral_plane_distance = 1.6e-3;
  design.stator.frequency = 62e3;
  design.stator.amplitude = 1e-6;
  design.stator.modal_damping = 18;
  design.layer.thickness = 0.01e-3;
  design.layer.youngs_modulus = 2.2e9;
  design.layer.poisson_ratio = 0.38;
  design.layer.density = 1500;
  design.layer.loss_factor = 0;
  design.friction = {0.18, 0.2};
  design.preload = 25;
  return design;
}

}  // namespace

TEST_CASE("metrics asked together are those asked alone", "[core][metrics][identity]") {
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  expect_same_alone(Motor(design));
  Uniform random(12);
  for (int i = 0; i < 8;) {
    const BoxPoint box = random_box_point(random);
    if (!(box.design.friction.threshold > box.design.friction.kinetic)) continue;
    CAPTURE(i++);
    expect_same_alone(Motor(box.design));
  }
}

TEST_CASE("a maximum among speeds that never repeat themselves is given up for a reason",
          "[core][metrics][edge_case]") {
  const Motor motor(restless_motor());
  CHECK(ask(motor, Metric::stall_torque).status == MetricStatus::ok);
  const MetricValue power = ask(motor, Metric::peak_power);
  CHECK(power.status == MetricStatus::no_periodic_state);
  CHECK(std::isnan(power.value));
  const std::vector<MetricRequest> both{{Metric::max_torque}, {Metric::peak_power}};
  CHECK(evaluate(motor, both)[1].status == power.status);  // each search has its own patience
}

// The same physics by another way in: the wave belongs to the conditions or to the design.
TEST_CASE("a motor under another wave is the motor made for that wave (T2.1, T2.2)",
          "[core][point][identity]") {
  Uniform random(31);
  for (int i = 0; i < 40; ++i) {
    MotorDesign design = realistic_design(random);
    design.layer.given_shear_viscosity = shear_viscosity(design);  // does not follow the frequency
    const double amplitude = design.stator.amplitude * random(0.1, 2);
    const double frequency = design.stator.frequency * random(0.9, 1.1);
    const std::array<ParameterValue, 2> wave{
        {{Parameter::amplitude, amplitude}, {Parameter::frequency, frequency}}};
    const Motor made(with(design, wave));
    const double speed = made.crest_speed() * random(-0.2, 1.3);
    const OperatingPoint expected = made.operating_point(speed);
    const OperatingPoint point = Motor(design).operating_point({speed, amplitude, frequency});
    CAPTURE(i, to_string(expected.status));
    CHECK(point.status == expected.status);
    if (expected.status != PointStatus::ok) continue;
    CHECK(point.torque == expected.torque);  // the same operations
    CHECK(point.friction_power == expected.friction_power);
    CHECK(point.stator_loss == expected.stator_loss);
    CHECK(point.stick_fraction == expected.stick_fraction);
  }
}

TEST_CASE("a wave that no motor has is refused", "[core][point][error]") {
  const Motor motor(ring_motor());
  CHECK_THROWS_AS(motor.operating_point({10, -1e-6, 40e3}), InputError);
  CHECK_THROWS_AS(motor.operating_point({10, 1e-6, 0}), InputError);
  CHECK_THROWS_AS(motor.operating_point({-1e5, 1e-6, 40e3}), InputError);
}
