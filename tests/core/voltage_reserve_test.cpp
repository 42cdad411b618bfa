// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include "support/driven_motors.hpp"

#include <cmath>
#include <random>
#include <vector>

using namespace twum;

namespace {

MetricRequest reserve_at_torque(double torque) {
  return {Metric::voltage_reserve_at, Argument::torque, torque};
}
MetricRequest reserve_at_speed(double speed) {
  return {Metric::voltage_reserve_at, Argument::speed, speed};
}

double least_voltage(const MotorDesign& design, const MetricRequest& request) {
  const MetricValue reserve = evaluate(Motor(design), request);
  return reserve.status == MetricStatus::ok ? *design.stator.voltage / (1 + reserve.value) : NAN;
}

bool answers(const MotorDesign& design, double voltage, const MetricRequest& request) {
  return evaluate(Motor(with(design, Parameter::voltage, voltage)), request).status ==
         MetricStatus::ok;
}

std::vector<MotorDesign> random_drives(std::size_t count) {
  std::mt19937_64 random(17);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  std::vector<MotorDesign> list;
  while (list.size() < count) {
    MotorDesign design = test::driven_motor_with_layer();
    for (const Parameter p : {Parameter::preload, Parameter::thickness, Parameter::youngs_modulus,
                              Parameter::kinetic_friction, Parameter::contact_width})
      design = with(design, p, get(design, p) * between(0.6, 1.5));
    design = with(design, Parameter::frequency,
                  get(design, Parameter::resonance_frequency) * between(1.005, 1.06));
    list.push_back(design);
  }
  return list;
}

}  // namespace

TEST_CASE("a motor carries a torque from the least voltage on, and not below it (Y5.4)",
          "[core][held][limit]") {
  for (const MotorDesign& design : random_drives(40)) {
    for (const double share : {0.0, 0.3, 0.7}) {
      const double torque = share * largest_held_torque(design);
      const double least = least_voltage(design, reserve_at_torque(torque));
      CAPTURE(share, least, get(design, Parameter::frequency), get(design, Parameter::preload));
      REQUIRE(least > 0);
      const MetricRequest speed{Metric::speed_at, Argument::torque, torque};
      // Just above it the two speeds of the torque lie close together, so that a search may miss them; a search asks for 2e-3.
      CHECK(answers(design, least * (1 + 2e-3), speed));
      CHECK_FALSE(answers(design, least * (1 - 1e-3), speed));
    }
  }
}

TEST_CASE("a wave runs at a speed from the least voltage on, at rest from the hold voltage (Y5.4)",
          "[core][held][limit]") {
  for (const MotorDesign& design : random_drives(40)) {
    const double hold = evaluate(Motor(design), {Metric::hold_voltage}).value;
    CAPTURE(get(design, Parameter::frequency), get(design, Parameter::preload), hold);
    const double at_rest = least_voltage(design, reserve_at_speed(0));
    if (hold > 0) CHECK(at_rest == Approx(hold).epsilon(1e-12));  // the same fold
    for (const double speed : {1.0, 5.0}) {
      const double least = least_voltage(design, reserve_at_speed(speed));
      if (!(least > 0)) continue;  // one wave at every voltage
      const MetricRequest torque{Metric::torque_at, Argument::speed, speed};
      CHECK(answers(design, least * (1 + 1e-3), torque));
      CHECK_FALSE(answers(design, least * (1 - 1e-3), torque));
    }
  }
}

TEST_CASE("derivatives of the voltage reserve agree with differences (Y5.5)",
          "[core][held][derivative]") {
  const MotorDesign design = test::driven_motor_with_layer();
  const double largest = largest_held_torque(design);
  for (const MetricRequest& request : {reserve_at_torque(0.0), reserve_at_torque(0.4 * largest),
                                       reserve_at_speed(0), reserve_at_speed(4)}) {
    const MetricDerivative d = differentiate(Motor(design), request);
    CAPTURE(static_cast<int>(request.argument), request.at, to_string(d.value.status));
    REQUIRE(d.value.status == MetricStatus::ok);
    for (const Parameter p :
         {Parameter::preload, Parameter::kinetic_friction, Parameter::contact_radius,
          Parameter::thickness, Parameter::frequency, Parameter::modal_damping,
          Parameter::quality_factor, Parameter::force_factor, Parameter::voltage}) {
      if (!in_use(design, p)) continue;
      const double x = get(design, p), h = 1e-4 * x;
      const auto at = [&](double value) {
        return evaluate(Motor(with(design, p, value)), request).value;
      };
      const double difference =
          (8 * (at(x + h) - at(x - h)) - (at(x + 2 * h) - at(x - 2 * h))) / (12 * h);
      CAPTURE(info(p).name, static_cast<int>(request.argument), request.at);
      // The place of the minimum is known to 2^-20, which the derivative sees once; the step's fourth power lies below.
      CHECK(std::fabs(d.gradient[index_of(p)] - difference) * x <=
            1e-5 * (1 + d.value.value + std::fabs(difference * x)));
    }
  }
}

TEST_CASE("where the least voltage is not known, there is no reserve", "[core][held][edge]") {
  const MotorDesign drive = test::driven_motor_with_layer();
  // A load that drives: the speeds up to no-load carry none, as speed_at says.
  CHECK(evaluate(Motor(drive), reserve_at_torque(-0.3)).status == MetricStatus::unreachable);
  CHECK(evaluate(Motor(drive), {Metric::speed_at, Argument::torque, -0.3}).status ==
        MetricStatus::unreachable);
  // With mu_0 > mu the wave ends at a jump of H.
  const MotorDesign sticking = with(drive, Parameter::static_friction, 0.32);
  CHECK(evaluate(Motor(sticking), reserve_at_speed(5)).status == MetricStatus::undefined);
  CHECK(evaluate(Motor(sticking), reserve_at_torque(0.4)).status == MetricStatus::ok);
  // Far above all speeds the wave at the minimum is unstable, as torque_at says.
  CHECK(evaluate(Motor(drive), reserve_at_speed(1e8)).status == MetricStatus::unstable_amplitude);
  CHECK(evaluate(Motor(drive), {Metric::torque_at, Argument::speed, 1e8}).status ==
        MetricStatus::unstable_amplitude);
  // No force, no wave; no voltage, no reserve at all.
  CHECK(evaluate(Motor(with(drive, Parameter::preload, 0)), reserve_at_torque(0.1)).status ==
        MetricStatus::torque_out_of_reach);
  CHECK(evaluate(Motor(with(drive, Parameter::voltage, 0)), reserve_at_torque(0.1)).value == -1);
}

TEST_CASE("a reserve of the voltage needs a voltage", "[core][held][error]") {
  CHECK(evaluate(Motor(test::ring_motor()), reserve_at_torque(0.1)).status ==
        MetricStatus::undefined);
  const MotorDesign drive = test::driven_motor_with_layer();
  CHECK(evaluate(Motor(drive), {Metric::voltage_reserve_at, Argument::both, 5, 0.1}).status ==
        MetricStatus::undefined);
}
