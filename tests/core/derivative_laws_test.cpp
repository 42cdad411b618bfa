// SPDX-License-Identifier: Apache-2.0
#include "core/every_derivative.hpp"
#include "support/deviations.hpp"
#include "support/expect_derivatives.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Laws that derivatives obey, and those of a point in speed.
using namespace twum;
using namespace twum::test;

TEST_CASE(
    "a maximum where the torque jumps up from its plateau has the derivatives of its limit (T7.16)",
    "[core][derivative][differential][limit]") {
  // Beyond the jump the torque moves like the square root of the distance; two distances give the limit.
  const auto limits = [](const MotorDesign& design) {
    constexpr double kDistance = 1e-9;
    const Motor motor(design);
    const double end = evaluate(motor, {Metric::plateau_speed}).value;
    const auto torque = [&](double distance) {
      return motor.operating_point(end * (1 + distance)).torque;
    };
    const double limit = 2 * torque(kDistance) - torque(4 * kDistance);
    return std::vector<double>{limit, limit * end};
  };
  const std::vector<MetricRequest> requests{{Metric::max_torque}, {Metric::peak_power}};
  Deviation deviation("derivatives of maxima at a jump against differences of the limit, relative",
                      1e-6);
  Uniform random(77);
  int compared[2] = {0, 0};
  for (int i = 0; i < 300; ++i) {
    MotorDesign design = realistic_design(random);
    if (design.friction.threshold < 1.1 * design.friction.kinetic) continue;
    const auto exact = differentiate(Motor(design), requests);
    const std::vector<double> at = limits(design);
    for (const Parameter p : {Parameter::amplitude, Parameter::preload, Parameter::youngs_modulus,
                              Parameter::thickness, Parameter::kinetic_friction}) {
      const double x = get(design, p);
      std::vector<DifferenceQuotient> found;
      for (std::size_t k = 0; k < 2; ++k) {
        // a maximum elsewhere has other derivatives
        const double value = exact[k].value.value;
        const bool here =
            exact[k].smoothness == Smoothness::one_sided && std::abs(value - at[k]) <= 1e-6 * value;
        if (!here) continue;
        if (found.empty()) {
          found = central_differences([&](double y) { return limits(with(design, p, y)); }, x, x);
        }
        const double unit = value / x;
        if (!(found[k].error <= 1e-6 * unit)) continue;
        ++compared[k];
        CAPTURE(i, info(requests[k].metric).name, x, found[k].error / unit);
        // The limit is good to 1e-11: its differences over steps of a percent to 1e-8 or so, as they say
        // themselves, and what the square root leaves of two distances is of their order.
        CHECK(deviation.add(exact[k].gradient[index_of(p)], found[k].value, unit) <=
              1e-7 + 3 * found[k].error / unit);
      }
    }
  }
  CHECK(compared[0] >= 200);
  CHECK(compared[1] >= 10);
  CHECK(deviation.holds());
}

TEST_CASE("gradients obey the law of a longer track, the number of waves included",
          "[core][derivative][scaling]") {
  // n, r and F_N times the same factor: the same wave, contact and load on every length of a longer track. Torques go
  // with the second power of the factor, speeds with the power -1, so by Euler's theorem on homogeneous functions
  // n f_n + r f_r + F_N f_(F_N) = k f.
  const std::pair<Metric, double> degrees[] = {
      {Metric::stall_torque, 2},         {Metric::max_torque, 2},
      {Metric::holding_torque, 2},       {Metric::no_load_speed, -1},
      {Metric::plateau_speed, -1},       {Metric::peak_power, 1},
      {Metric::speed_at_peak_power, -1}, {Metric::torque_at_peak_power, 2},
      {Metric::contact_half_length, 0},  {Metric::contact_ratio, 0},
      {Metric::max_pressure, 0},         {Metric::contact_efficiency_at_peak_power, 0}};
  Deviation deviation("gradients against Euler's theorem for a longer track, relative", 1e-8);
  Uniform random(31);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const MotorDesign design = design_of(random, i);
    const Motor motor(design);
    for (const auto& [metric, degree] : degrees) {
      const MetricDerivative found = differentiate(motor, std::vector{MetricRequest{metric}})[0];
      if (found.smoothness == Smoothness::undefined) continue;
      double sum = 0, size = std::abs(found.value.value);
      for (const Parameter p :
           {Parameter::wavelengths, Parameter::contact_radius, Parameter::preload}) {
        const double term = get(design, p) * found.gradient[index_of(p)];
        sum += term;
        size = std::max(size, std::abs(term));
      }
      CAPTURE(i, info(metric).name, to_string(found.smoothness));
      ++compared;
      // The terms cancel; each is good to some 1e-10, speeds of peaks through f' / f'' a little less.
      CHECK(deviation.add(sum, degree * found.value.value, size) <= 1e-8);
    }
  }
  CHECK(compared > 500);
  CHECK(deviation.holds());
}

TEST_CASE("derivatives of a point in speed are those of differences",
          "[core][derivative][differential]") {
  Deviation deviation("derivatives of points in speed against Richardson differences, relative",
                      1e-7);
  Uniform random(32);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Motor motor(design_of(random, i));
    const double speed = motor.crest_speed() * random(-0.2, 1.3);
    const SpeedDerivative exact = differentiate_in_speed(motor, speed);
    if (exact.smoothness != Smoothness::smooth) continue;
    const auto numbers = [&](double at) {
      const OperatingPoint p = motor.operating_point(at);
      return std::vector<double>{p.torque,         p.output_power, p.stator_power,
                                 p.friction_power, p.layer_loss,   p.stick_fraction};
    };
    const double slopes[] = {exact.torque,         exact.output_power, exact.stator_power,
                             exact.friction_power, exact.layer_loss,   exact.stick_fraction};
    const std::vector<double> values = numbers(speed);
    const auto found = central_differences(numbers, speed, motor.crest_speed());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double unit = std::max(std::abs(values[k] / speed), std::abs(found[k].value));
      if (!(found[k].error <= 1e-8 * unit)) continue;
      CAPTURE(i, k, speed / motor.crest_speed());
      ++compared;
      CHECK(deviation.add(slopes[k], found[k].value, unit) <= 1e-7);
    }
  }
  CHECK(compared > 100);
  CHECK(deviation.holds());
}

TEST_CASE("in full contact, too, derivatives are those of differences",
          "[core][derivative][differential]") {
  Tally tally;
  Deviation deviation("derivatives in full contact against Richardson differences, relative", 1e-7);
  Uniform random(34);
  for (int i = 0; i < 6; ++i) {
    MotorDesign design = design_of(random, i);
    design.preload = full_contact_load(design) * random(1.1, 1.6);
    const Motor motor(design);
    REQUIRE(motor.contact().full);
    std::vector<MetricRequest> requests;
    for (const Metric metric :
         {Metric::torque_at, Metric::stator_power_at, Metric::friction_power_at,
          Metric::layer_loss_at, Metric::stick_fraction_at}) {
      for (const double share : {0.4, 0.9})
        requests.push_back({metric, Argument::speed, share * motor.crest_speed()});
    }
    for (const Metric metric : {Metric::max_pressure, Metric::stall_torque, Metric::no_load_speed})
      requests.push_back({metric});
    check_gradients(design, requests, tally, deviation);
  }
  CAPTURE(tally.total_sharp(), tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.total_sharp() > 200);
  CHECK(deviation.holds());
}

TEST_CASE("the speed of a peak that cannot move has derivative zero", "[core][derivative][limit]") {
  // Without drive there is no power, at no speed.
  MotorDesign design = ring_motor();
  design.stator.amplitude = 0;
  const auto still = differentiate(
      Motor(design),
      std::vector{MetricRequest{Metric::peak_power}, MetricRequest{Metric::speed_at_peak_power}});
  CHECK(still[1].value.value == 0);
  CHECK(still[1].smoothness == Smoothness::flat);
  for (const double each : still[1].gradient) CHECK(each == 0);
}
