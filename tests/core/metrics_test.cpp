// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

// Metrics against their definitions in theory section 7, by scanning operating points.
namespace {

using namespace twum;
using namespace twum::test;

MetricValue at_speed(const Motor& motor, Metric which, double speed) {
  return evaluate(motor, {which, Argument::speed, speed});
}

struct Scan {
  std::vector<OperatingPoint> points;  // from rest to the no-load speed
  double free;
};

Scan scan(const Motor& motor, int count) {
  Scan found{{}, ask(motor, Metric::no_load_speed).value};
  for (int i = 1; i < count; ++i)
    found.points.push_back(motor.operating_point(found.free * i / count));
  return found;
}

// Motors with an ordinary characteristic, every kind of layer.
std::vector<Motor> motors(std::uint64_t seed, int count, bool threshold) {
  Uniform random(seed);
  std::vector<Motor> made;
  for (int i = 0; i < count; ++i) {
    MotorDesign design = realistic_design(random);
    if (!threshold) design.friction.static_ = design.friction.kinetic;
    if (i % 3 == 1) design = damped(design);
    if (i % 3 == 2) design = elastic(design);
    made.emplace_back(design);
  }
  return made;
}

}  // namespace

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
  Deviation torque("torque at the no-load speed", 1e-9);
  for (const Motor& motor : motors(1, 60, false)) {
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

TEST_CASE("the speed at the torque of the plateau is where the plateau ends (T7.15, T7.17)",
          "[core][metrics][identity]") {
  int plateaus = 0;
  for (const Motor& motor : motors(8, 40, false)) {
    const double torque = ask(motor, Metric::stall_torque).value;
    const double end = ask(motor, Metric::plateau_speed).value;
    const double top = ask(motor, Metric::max_torque).value;
    if (!(end > 0) || top > torque * (1 + 1e-12)) continue;
    ++plateaus;
    const MetricValue found =
        evaluate(motor, MetricRequest{Metric::speed_at, Argument::torque, torque});
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(found.value == end);
  }
  CHECK(plateaus > 5);
}

TEST_CASE("efficiencies have no value exactly where no power is put in (T7.6, T7.7)",
          "[core][metrics][identity]") {
  int braking = 0, helped = 0;
  for (Motor motor : motors(9, 12, true)) {
    MotorDesign design = motor.design();
    design.stator.modal_damping = 20;
    motor = Motor(design);
    for (int i = -2; i <= 15; ++i) {
      const double speed = 0.1 * i * motor.crest_speed();
      const OperatingPoint point = motor.operating_point(speed);
      if (point.status != PointStatus::ok) continue;
      CAPTURE(i, point.stator_power, point.stator_loss);
      const double velocity =
          2 * std::numbers::pi * design.stator.frequency * design.stator.amplitude;
      CHECK(point.stator_loss == Approx(20 * velocity * velocity).epsilon(1e-14));
      const auto status = [&](Metric which) { return at_speed(motor, which, speed).status; };
      const bool contact = point.stator_power > 0;
      const bool whole = point.stator_power + point.stator_loss > 0;
      CHECK((status(Metric::contact_efficiency_at) == MetricStatus::ok) == contact);
      CHECK((status(Metric::efficiency_at) == MetricStatus::ok) == whole);
      CHECK(std::isnan(point.contact_efficiency()) == !contact);
      CHECK(std::isnan(point.efficiency()) == !whole);
      for (const Metric which : {Metric::torque_at, Metric::output_power_at, Metric::layer_loss_at})
        CHECK(status(which) == MetricStatus::ok);
      braking += !contact;
      helped += whole && !contact;
    }
  }
  CHECK(braking > 20);
  CHECK(helped > 5);
}

TEST_CASE("a motor that is locked at rest has a no-load speed and a peak that stay at zero",
          "[core][metrics][limit]") {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1e7;
  design.layer.given_inertia = 0;
  design.preload = 8 * full_contact_load(design);
  const Motor motor(design);
  REQUIRE(motor.locks_at_rest());
  for (const auto& [which, smoothness] :
       {std::pair{Metric::no_load_speed, Smoothness::one_sided},
        std::pair{Metric::speed_at_peak_power, Smoothness::flat}}) {
    const MetricDerivative at_rest = differentiated(motor, MetricRequest{which});
    CHECK(at_rest.value.value == 0);
    CHECK(at_rest.smoothness == smoothness);
    for (const double each : at_rest.gradient) CHECK(each == 0);
  }
  // A request that names no speed is about rest.
  CHECK(evaluate(motor, MetricRequest{Metric::torque_at}).value == motor.operating_point(0).torque);
}

TEST_CASE("a peak of power where the torque jumps up moves with the plateau's end (T7.16, T7.17)",
          "[core][metrics][identity]") {
  Uniform random(52);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    design.friction.static_ = design.friction.kinetic * random(1.2, 2.5);
    const Motor motor(design);
    const double end = ask(motor, Metric::plateau_speed).value;
    const double best = ask(motor, Metric::speed_at_peak_power).value;
    if (!(end > 0) || std::abs(best - end) > 1e-9 * end) continue;
    const MetricDerivative of_end = differentiated(motor, MetricRequest{Metric::plateau_speed}),
                           of_best =
                               differentiated(motor, MetricRequest{Metric::speed_at_peak_power});
    if (of_end.smoothness == Smoothness::undefined) continue;
    ++found;
    CHECK(of_best.smoothness == Smoothness::one_sided);
    for (std::size_t j = 0; j < kParameterCount; ++j)
      CHECK(of_best.gradient[j] == of_end.gradient[j]);
  }
  CHECK(found > 3);
}

TEST_CASE("a motor without a plateau has none for its neighbours either (T7.17)",
          "[core][metrics][limit]") {
  // Contact beyond 90 degrees, where the crests' neighbours move backwards even at rest.
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 60e9;
  design.preload = 0.7 * full_contact_load(design);
  const Motor motor(design);
  REQUIRE(ask(motor, Metric::plateau_speed).value == 0);
  const MetricDerivative plateau = differentiated(motor, MetricRequest{Metric::plateau_speed});
  CHECK(plateau.smoothness == Smoothness::flat);
  for (const double each : plateau.gradient) CHECK(each == 0);
}

// With mu_0 > mu torque may jump: a maximum is the limit on its side of a jump.
TEST_CASE(
    "speeds and maxima are those of a fine scan, with mu_0 > mu too (T7.13, T7.14, T7.15, T7.16)",
    "[core][metrics][brute_force]") {
  Uniform random(51);
  int smooth = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = i % 2 == 0 ? realistic_design(random) : random_box_point(random).design;
    design.friction.static_ = design.friction.kinetic * (i % 4 == 3 ? 1 : random(1.05, 2.5));
    if (i % 3 == 1) design = damped(design);
    const Motor motor(design);
    if (motor.contact().full || !(ask(motor, Metric::stall_torque).value > 0)) continue;
    const double unit = motor.holding_torque(), free = ask(motor, Metric::no_load_speed).value;
    constexpr int kPlaces = 2000;
    std::vector<double> torques;
    bool answered = std::isfinite(free);
    for (int k = 1; k <= kPlaces && answered; ++k) {
      const OperatingPoint point = motor.operating_point(1.1 * free * k / kPlaces);
      answered = point.status == PointStatus::ok;
      torques.push_back(point.torque);
    }
    if (!answered) continue;
    const auto speed_of = [&](int k) { return 1.1 * free * (k + 1) / kPlaces; };
    const auto torque_at = [&](double speed) { return motor.operating_point(speed).torque; };
    CAPTURE(i, free);
    for (const double load : {0.0, 0.01 * unit, 0.1 * unit, 0.3 * unit}) {
      const MetricValue found = ask_at_torque(motor, Metric::speed_at, load);
      CAPTURE(load, found.value);
      if (*std::max_element(torques.begin(), torques.end()) < load) continue;
      REQUIRE(found.status == MetricStatus::ok);
      for (int k = 0; k < kPlaces; ++k)
        if (speed_of(k) > found.value * (1 + 1e-12))
          CHECK(torques[static_cast<std::size_t>(k)] <= load + 1e-9 * unit);
      const auto fall = [&](double share) {
        const double before = torque_at(found.value * (1 - share)),
                     after = torque_at(found.value * (1 + share));
        // Whatever its slope, torque is on either side of the load there, but for the root's own error.
        CHECK(before >= load - 1e-9 * unit);
        CHECK(after <= load + 1e-9 * unit);
        return before - after;
      };
      const double kept = fall(1e-11) / fall(1e-9);  // of a slope a hundredth, of a jump all
      if (kept < 0.02) CHECK(std::abs(torque_at(found.value) - load) <= 1e-9 * unit);
      const bool undefined =
          differentiated(motor, {Metric::speed_at, Argument::torque, load}).smoothness ==
          Smoothness::undefined;
      if (kept < 0.02) CHECK_FALSE(undefined);
      if (kept > 0.5) CHECK(undefined);
      smooth += kept < 0.02;
    }
    const MetricValue top = ask(motor, Metric::max_torque), peak = ask(motor, Metric::peak_power);
    REQUIRE(top.status == MetricStatus::ok);
    REQUIRE(peak.status == MetricStatus::ok);
    const double best = ask(motor, Metric::speed_at_peak_power).value;
    for (int k = 0; k < kPlaces; ++k) {
      const double torque = torques[static_cast<std::size_t>(k)];
      CHECK(torque <= top.value * (1 + 1e-12));
      CHECK(torque * speed_of(k) <= peak.value * (1 + 1e-12));
    }
    // Nothing is better nearby, and as good only there: beside a jump power moves like a square root at the most,
    // and the root of 1e-12 is a hundredth of what is allowed.
    double nearby = 0;
    for (int k = -500; k <= 500; ++k) {
      const double speed = best * (1 + 1e-6 * k);
      CHECK(torque_at(speed) * speed <= peak.value * (1 + 1e-9));
    }
    for (const double side : {-1e-12, 0.0, 1e-12})
      nearby = std::max(nearby, torque_at(best * (1 + side)) * best);
    CHECK(nearby >= peak.value * (1 - 1e-4));
  }
  CHECK(smooth > 30);
}

TEST_CASE("efficiency has a maximum only if the stator loses power (T7.18)",
          "[core][metrics][limit]") {
  const MetricValue none = ask(Motor(ring_motor()), Metric::max_efficiency);
  CHECK(none.status == MetricStatus::undefined);
  CHECK(std::isnan(none.value));
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  const Motor motor(design);
  const double best = ask(motor, Metric::max_efficiency).value;
  const double speed = ask(motor, Metric::speed_at_max_efficiency).value;
  CHECK(motor.operating_point(speed).efficiency() == Approx(best).epsilon(1e-10));
  double seen = 0;
  for (const OperatingPoint& point : scan(motor, 3000).points)
    seen = std::max(seen, point.efficiency());
  CHECK(best >= seen * (1 - 1e-12));
  CHECK(best <= seen * (1 + 1e-5));
}

TEST_CASE(
    "the plateau of a layer that still rings at the next entry ends where its slip does (T7.17)",
    "[core][metrics][differential]") {
  int plateaus = 0;
  Deviation slopes("derivative of the plateau's end of a ringing layer, relative", 1e-6);
  for (int i = 0; i < 30; ++i) {
    MotorDesign design = ring_motor();
    design.layer.loss_factor = 0.002 * (1 + i % 5);
    design.layer.given_inertia = 1e-4 * (1 + i);
    const Motor motor(design);
    const double end = ask(motor, Metric::plateau_speed).value;
    if (!(end > 0)) continue;
    ++plateaus;
    CAPTURE(i, end / motor.crest_speed());
    CHECK(motor.zones(end * (1 - 1e-7)).size() == 1);
    CHECK(motor.zones(end * (1 + 1e-7)).size() > 1);
    // The end's derivative in the preload, by its values at a distance of 1e-4: the error of the difference is
    // 1e-8 of a third derivative, which may be some tens.
    const auto end_at = [&](double preload) {
      return ask(Motor(with(design, Parameter::preload, preload)), Metric::plateau_speed).value;
    };
    const double load = design.preload, step = 1e-4 * load;
    const double difference = (end_at(load + step) - end_at(load - step)) / (2 * step);
    const double slope = differentiate(motor, std::vector{MetricRequest{Metric::plateau_speed}})[0]
                             .gradient[index_of(Parameter::preload)];
    CHECK(slopes.add(slope * load, difference * load, end) <= 1e-6);
  }
  CHECK(plateaus > 5);
}

TEST_CASE("plateau speed is where the contact stops slipping one way (T7.17)",
          "[core][metrics][identity]") {
  for (const Motor& motor : motors(7, 45, true)) {
    const MetricValue plateau = ask(motor, Metric::plateau_speed);
    REQUIRE(plateau.status == MetricStatus::ok);
    const auto slips_one_way = [&](double speed) {
      const auto zones = motor.zones(speed);
      return zones.size() == 1 && zones[0].state == ZoneState::slip_plus;
    };
    CAPTURE(plateau.value / motor.crest_speed());
    if (plateau.value > 0) {
      for (int i = 0; i < 50; ++i) CHECK(slips_one_way(plateau.value * i / 50));
      CHECK(slips_one_way(plateau.value * (1 - 1e-9)));
    }
    CHECK_FALSE(slips_one_way(plateau.value * (1 + 1e-6) + 1e-6 * motor.crest_speed()));
  }
}

namespace {

void expect_same_alone(const Motor& motor) {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table()) {
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
    if (row.argument == Argument::speed || row.argument == Argument::speed_or_torque)
      requests.push_back({row.metric, Argument::speed, 0.9 * motor.crest_speed()});
    if (row.argument == Argument::torque || row.argument == Argument::speed_or_torque)
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
    if (!(box.design.friction.static_ > box.design.friction.kinetic)) continue;
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
          "[core][performance][identity]") {
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

TEST_CASE("a wave that no motor has is refused", "[core][performance][error]") {
  const Motor motor(ring_motor());
  CHECK_THROWS_AS(motor.operating_point({10, -1e-6, 40e3}), InputError);
  CHECK_THROWS_AS(motor.operating_point({10, 1e-6, 0}), InputError);
  CHECK_THROWS_AS(motor.operating_point({-1e5, 1e-6, 40e3}), InputError);
}
