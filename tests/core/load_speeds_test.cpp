// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/deviations.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

// The speed at which a load is carried (T7.15), at the special cases of the search over speed.
namespace {

using namespace twum;
using namespace twum::test;

// What a root in speed leaves of the torque: a few eps of the speed, times slopes of up to 1e5 scales per V0 / r.
constexpr double kLeft = 1e-9;  // of mu_0 F_N r

// No speed beyond `speed` carries the load.
void check_none_beyond(const Motor& motor, double load, double speed, int places) {
  const double free = ask(motor, Metric::no_load_speed).value;
  double most = -std::numeric_limits<double>::infinity();
  int seen = 0;
  for (int k = 1; k <= places; ++k) {
    const OperatingPoint point = motor.operating_point(speed + (free - speed) * k / places);
    if (point.status != PointStatus::ok)
      continue;  // with mu_0 > mu or without loss there may be none
    most = std::fmax(most, point.torque);
    ++seen;
  }
  CHECK(2 * seen > places);
  CHECK(most <= load + kLeft * motor.holding_torque());
}

struct Tops {
  int motors{0}, loads{0};
};

// Loads up to the largest torque of a motor that has it at some speed above rest.
void check_near_top(const MotorDesign& design, Tops& tops) {
  const Motor motor(design);
  const MetricValue top = ask(motor, Metric::max_torque), stall = ask(motor, Metric::stall_torque);
  if (top.status != MetricStatus::ok || !(top.value > stall.value * (1 + 1e-6))) return;
  ++tops.motors;
  const double unit = motor.holding_torque();
  for (const double below : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
    const double load = top.value * (1 - below);
    const MetricRequest request{Metric::speed_at, Argument::torque, load};
    const MetricDerivative found = differentiated(motor, request);
    CAPTURE(below, found.value.value / motor.crest_speed(), top.value / stall.value);
    if (design.layer.loss_factor == 0 && found.value.status == MetricStatus::not_converged)
      continue;  // without loss what the layer forgets may be nothing
    REQUIRE(found.value.status == MetricStatus::ok);
    ++tops.loads;
    CHECK(std::abs(motor.operating_point(found.value.value).torque - load) <= kLeft * unit);
    check_none_beyond(motor, load, found.value.value, 200);
    // More load than the largest torque no speed carries, so the speed ends there, with slope infinite.
    if (below == 0) CHECK(found.smoothness == Smoothness::undefined);
  }
}

}  // namespace

TEST_CASE("a load just below the largest torque is met beyond its maximum (T7.13, T7.15)",
          "[core][metrics][brute_force]") {
  // Few motors with mu_0 = mu have their largest torque above rest: of 2,100 drawn these five, with light losses.
  const std::set<int> risers{733, 1802, 1868, 1992, 2022};
  Tops tops;
  Uniform random(3);
  for (int i = 0; i <= *risers.rbegin(); ++i) {
    const MotorDesign design = box_motor(random);
    CAPTURE(i);
    if (risers.contains(i)) check_near_top(design, tops);
  }
  CHECK(tops.motors == 5);
  CHECK(tops.loads >= 5 * tops.motors);
}

TEST_CASE(
    "a load between the plateau and a higher maximum is met beyond the maximum (T7.13, T7.15)",
    "[core][metrics][brute_force]") {
  Uniform random(11);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    const MotorDesign design = holding_motor(random, i);
    if (i % 2 == 1) continue;
    const Motor motor(design);
    const double stall = ask(motor, Metric::stall_torque).value,
                 top = ask(motor, Metric::max_torque).value;
    if (!(top > stall * (1 + 1e-3)) || !(ask(motor, Metric::plateau_speed).value > 0)) continue;
    const double load = 0.5 * (stall + top), unit = motor.holding_torque();
    const MetricValue found = ask_at_torque(motor, Metric::speed_at, load);
    CAPTURE(i, top / stall);
    REQUIRE(found.status == MetricStatus::ok);
    ++met;
    // Torque may jump past the load there: then the nearest speeds are on either side of it.
    CHECK(motor.operating_point(found.value * (1 - 1e-12)).torque >= load - kLeft * unit);
    CHECK(motor.operating_point(found.value * (1 + 1e-12)).torque <= load + kLeft * unit);
    check_none_beyond(motor, load, found.value, 150);
    // The side of a jump that still carries the load is the answer.
    CHECK(ask_at_torque(motor, Metric::output_power_at, load).value >=
          found.value * (load - kLeft * unit));
  }
  CHECK(met >= 8);
}

TEST_CASE("a load that is the torque of some round speed is met at that speed, smoothly (T7.15)",
          "[core][metrics][identity]") {
  // Searches look at round speeds, where nothing is left between the torque and such a load.
  Deviation deviation("speed at the torque of a round speed, of V0 / r", 1e-9);
  Uniform random(11);
  int met = 0;
  for (int i = 0; i < 24; ++i) {
    const MotorDesign design = ringing_motor(random, i);
    const Motor motor(i % 3 == 2 ? elastic(design) : design);
    const double step = motor.crest_speed() / 20;
    double speed = 0;
    for (int k = 1; k < 20; ++k) {
      speed += step;
      for (const double at : {speed, k * motor.crest_speed() / 20}) {
        const SpeedDerivative there = differentiate_in_speed(motor, at);
        const double load = there.point.torque;
        // Where torque falls by more than 1e-3 scales per V0 / r, the speed is known to 1e-9 as the torque is to 1e-12.
        if (there.smoothness != Smoothness::smooth || !(load > 0) ||
            !(there.torque * motor.crest_speed() < -1e-3 * motor.holding_torque()))
          continue;
        const MetricDerivative found =
            differentiated(motor, {Metric::speed_at, Argument::torque, load});
        CAPTURE(i, k);
        REQUIRE(found.value.status == MetricStatus::ok);
        if (found.value.value > at + 1e-6 * motor.crest_speed())
          continue;  // a faster one carries it too
        ++met;
        CHECK(deviation.add(found.value.value, at, motor.crest_speed()) <= 1e-9);
        CHECK(found.smoothness == Smoothness::smooth);
      }
    }
  }
  CHECK(met >= 100);
  CHECK(deviation.holds());
}

TEST_CASE("a motor without friction, preload or freedom carries nothing (T7.12 to T7.18)",
          "[core][metrics][limit]") {
  MotorDesign frictionless = ring_motor(), unloaded = ring_motor(), locked = ring_motor();
  frictionless.friction = {0, 0};
  unloaded.preload = 0;
  locked.layer.given_shear_modulus = 1e7;
  locked.layer.given_inertia = 0;
  locked.preload = 8 * full_contact_load(locked);
  REQUIRE(Motor(locked).locks_at_rest());
  for (MotorDesign design : {frictionless, unloaded, locked}) {
    design.stator.modal_damping = 45;
    const Motor motor(design);
    for (const Metric which :
         {Metric::max_torque, Metric::max_efficiency, Metric::speed_at_max_efficiency})
      CHECK(ask(motor, which).status == MetricStatus::undefined);
    CHECK(ask_at_torque(motor, Metric::speed_at, 0.1).status == MetricStatus::unreachable);
    for (const MetricValue& still :
         {ask_at_torque(motor, Metric::speed_at, 0), ask(motor, Metric::no_load_speed),
          ask(motor, Metric::plateau_speed)}) {
      CHECK(still.status == MetricStatus::ok);
      CHECK(still.value == 0);
    }
  }
}

TEST_CASE(
    "the speed at a load that just stalls the motor moves as soon as the motor can do more (T7.15)",
    "[core][metrics][limit]") {
  // Motors with their largest torque at rest and no plateau: what adds to it lets the load move, what takes from
  // it leaves the load without an answer.
  MotorDesign ring = ring_motor();
  ring.layer.given_shear_modulus = 60e9;
  ring.preload = 0.7 * full_contact_load(ring);
  for (const MotorDesign& design : {elastic_ring(3.0, 0.3), ring}) {
    const Motor motor(design);
    const double stall = ask(motor, Metric::stall_torque).value;
    REQUIRE(stall > 0);
    REQUIRE(ask(motor, Metric::plateau_speed).value == 0);
    REQUIRE(ask(motor, Metric::max_torque).value == stall);
    const MetricRequest request{Metric::speed_at, Argument::torque, stall};
    const MetricDerivative found = differentiated(motor, request);
    CHECK(found.value.value == 0);
    CHECK(found.smoothness == Smoothness::one_sided);
    const MetricDerivative most = differentiated(motor, {Metric::stall_torque});
    for (const Parameter p : {Parameter::preload, Parameter::amplitude, Parameter::thickness}) {
      const double x = get(design, p), slope = found.gradient[index_of(p)];
      const double side = most.gradient[index_of(p)] > 0 ? 1 : -1;
      CAPTURE(info(p).name, slope * x / motor.crest_speed());
      const auto quotient = [&](double step) {
        const Motor moved(with(design, p, x * (1 + side * step)));
        return evaluate(moved, request).value / (side * step * x);
      };
      CHECK(evaluate(Motor(with(design, p, x * (1 - side * 1e-4))), request).status ==
            MetricStatus::unreachable);
      // The quotients err by a power series in the step: the first term drops out, and the second is the square of
      // 1e-4 times a curvature that may be some hundred times the slope.
      CHECK(2 * quotient(1e-4) - quotient(2e-4) == Approx(slope).epsilon(1e-5));
    }
  }
}

TEST_CASE(
    "a load equal to a largest torque beyond a jump or a kink has a speed without a derivative",
    "[core][metrics][limit]") {
  // A little more load, and no speed carries it; the largest torque itself has one-sided derivatives at best.
  Uniform random(11);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    const Motor motor(holding_motor(random, i));
    const double stall = ask(motor, Metric::stall_torque).value;
    const MetricValue top = ask(motor, Metric::max_torque);
    if (top.status != MetricStatus::ok || !(top.value > stall * (1 + 1e-6))) continue;
    ++met;
    CAPTURE(i, top.value / stall);
    const auto at = [&](double load) {
      return differentiated(motor, {Metric::speed_at, Argument::torque, load});
    };
    CHECK(at(top.value).value.status == MetricStatus::ok);
    CHECK(at(top.value).smoothness == Smoothness::undefined);
    CHECK(at(top.value * (1 + 1e-9)).value.status == MetricStatus::unreachable);
  }
  CHECK(met >= 10);
}

TEST_CASE("under one wave the torque has one zero (E6.7)", "[core][load]") {
  Uniform random(2024);
  int motors = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    design.friction.threshold = design.friction.kinetic;
    const Motor motor(design);
    const MetricValue free = ask(motor, Metric::no_load_speed);
    if (free.status != MetricStatus::ok || !(free.value > 0)) continue;
    ++motors;
    constexpr int kPlaces = 300;
    int signs = 0, wrong = 0;
    for (int k = 0; k <= kPlaces; ++k) {
      const double speed = 1.2 * motor.crest_speed() * k / kPlaces;
      const OperatingPoint point = motor.operating_point(speed);
      if (point.status != PointStatus::ok) continue;
      ++signs;
      // no place is so close to no-load that rounding decides its sign
      if ((point.torque > 0) != (speed < free.value)) ++wrong;
    }
    CAPTURE(i);
    CHECK(signs > kPlaces / 2);
    CHECK(wrong == 0);
  }
  CHECK(motors > 40);
}
