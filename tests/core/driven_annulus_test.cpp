// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <vector>

// A contact with width under a wave that follows from voltage and load.
namespace {

using namespace twum;
using namespace twum::test;
using M = Metric;

MotorDesign sliced(MotorDesign design, int slices) {
  design.stator.radial_slices = slices;
  return design;
}

// A track over which the wave's shape and the rotor's face vary by tens of percent.
MotorDesign wide_motor(double voltage = 120) {
  MotorDesign design = sliced(driven_motor_with_layer(voltage), 8);
  design.stator.radial_shape = {1.5, 13e-3, {}};
  design.rotor.taper = 5e-5;
  return design;
}

// In units of their own size; the torque, which vanishes at no-load, in that of the largest.
std::vector<double> numbers_of(const OperatingPoint& p, const OperatingPoint& unit, double torque) {
  return {p.amplitude / unit.amplitude, p.phase_lag / unit.phase_lag, p.torque / torque,
          p.electrical_power / unit.electrical_power, p.reactive_force / unit.reactive_force};
}

}  // namespace

TEST_CASE("a narrow track under a voltage tends to one slice with order two in its width",
          "[core][driven][annulus][limit]") {
  for (const double voltage : {120.0, 50.0}) {  // the second is off its wave at rest
    std::vector<double> last;
    for (const double width : {1e-3, 0.5e-3, 0.25e-3}) {
      // An elastic layer as much stiffer as it is narrower: one slice is the same motor at every width.
      MotorDesign one = driven_motor(voltage);
      one.layer.youngs_modulus *= one.stator.contact_width / width;
      one.stator.contact_width = width;
      MotorDesign many = sliced(one, 8);
      many.stator.radial_shape = {1.5, 13e-3, {}};
      const double speed = 11.3;
      const Motor motor(one);
      const OperatingPoint a = motor.operating_point(speed), b = Motor(many).operating_point(speed);
      REQUIRE(a.status == PointStatus::ok);
      REQUIRE(b.status == PointStatus::ok);
      std::vector<double> off;
      const std::vector<double> p = numbers_of(a, a, motor.holding_torque()),
                                q = numbers_of(b, a, motor.holding_torque());
      for (std::size_t i = 0; i < p.size(); ++i) off.push_back(std::fabs(q[i] - p[i]));
      for (std::size_t i = 0; i < off.size(); ++i) {
        CAPTURE(voltage, width, i, off[i]);
        // The shape varies by 1.5 * (b / 2) / (r - 13 mm) over half the track; what is linear in it cancels in sums, and a
        // wave near its fold answers some ten times.
        const double vary = 1.5 * 0.5 * width / (one.stator.contact_radius - 13e-3);
        CHECK(off[i] < 20 * vary * vary);
        // Of order two: a fourth, within a tenth of it for the next order.
        if (!last.empty()) CHECK(off[i] < 0.28 * last[i] + 1e-9);
      }
      last = off;
    }
  }
}

TEST_CASE(
    "the powers of a wide contact under a voltage balance, and its wave is that of its amplitude",
    "[core][driven][annulus][identity]") {
  for (const double voltage : {120.0, 60.0}) {
    const MotorDesign design = wide_motor(voltage);
    const Motor motor(design);
    CHECK(motor.radial_slices() == 8);
    int met = 0;
    for (const double speed : {0.0, 5.0, 9.0, 11.3, 13.0, 16.0}) {
      const OperatingPoint p = motor.operating_point(speed);
      if (p.status != PointStatus::ok) continue;
      CAPTURE(voltage, speed);
      const double out =
          p.output_power + p.friction_power + p.layer_loss + p.stator_loss + p.dielectric_loss;
      const double scale = std::fabs(p.output_power) + p.friction_power + p.layer_loss +
                           p.stator_loss + p.dielectric_loss;
      CHECK(std::fabs(p.electrical_power - out) <= 1e-10 * scale);
      // The same wave prescribed gives the same contact, and asks for the same voltage.
      const Motor prescribed(with(design, Parameter::amplitude, p.amplitude));
      const OperatingPoint q = prescribed.operating_point(speed);
      CHECK(q.torque == Approx(p.torque).epsilon(1e-9));
      CHECK(q.voltage == Approx(voltage).epsilon(1e-9));
      CHECK(p.voltage == Approx(voltage).epsilon(1e-9));
      ++met;
    }
    CHECK(met >= 3);
  }
}

// Along the branch jumps are followed from wave to wave; a prescribed wave searches for them. They are told to 1e-9 of the track,
// where the torque changes by less than itself.
TEST_CASE("jumps followed along a branch are those of the prescribed wave (W4.5)",
          "[core][driven][annulus][identity]") {
  MotorDesign design = driven_motor_with_layer();
  design.friction.threshold = 1.3 * design.friction.kinetic;
  design.stator.radial_slices = kAutoSlices;
  const Motor motor(design);
  design.stator.radial_slices = motor.radial_slices();
  for (double speed = 0.5; speed < 14; speed += 0.45) {
    const OperatingPoint p = motor.operating_point(speed);
    CAPTURE(speed);
    REQUIRE(p.status == PointStatus::ok);
    const Motor prescribed(with(design, Parameter::amplitude, p.amplitude));
    const OperatingPoint q = prescribed.operating_point(speed);
    CHECK(q.torque == Approx(p.torque).epsilon(1e-9));
    CHECK(q.voltage == Approx(p.voltage).epsilon(1e-9));
  }
}

TEST_CASE("no wave of a wide contact is missed (D2.8, D2.10)",
          "[core][driven][annulus][brute_force]") {
  for (const double voltage : {25.0, 45.0, 60.0, 120.0}) {
    const MotorDesign design = wide_motor(voltage);
    const Motor motor(design);
    for (const double speed : {0.0, 6.0, 12.0}) {
      // Crossings of the voltage that prescribed amplitudes ask for, on a fine grid up to what the damping allows.
      int crossings = 0;
      double before = 0;
      for (double a = 2e-9; a < 1e-5; a *= 1.02) {
        const OperatingPoint p =
            Motor(with(design, Parameter::amplitude, a)).operating_point(speed);
        REQUIRE(p.status == PointStatus::ok);
        crossings += (p.voltage < voltage) != (before < voltage);
        before = p.voltage;
      }
      CAPTURE(voltage, speed);
      CHECK(static_cast<int>(motor.wave_states(speed).size()) == crossings);
    }
  }
}

TEST_CASE("a wave may be larger than an amplitude that a file may give",
          "[core][driven][annulus][limit]") {
  // 100 kV with a force factor 20 times that of the motor: without a contact k_s A = Q Theta u_0 gives centimetres.
  MotorDesign design = sliced(wide_motor(), kAutoSlices);
  design = with(design, Parameter::voltage, 1e5);
  design = with(design, Parameter::force_factor, 20 * *design.stator.force_factor);
  const Motor motor(design);
  const OperatingPoint point = motor.operating_point(0);
  CHECK(point.status == PointStatus::ok);
  CHECK(point.amplitude > info(Parameter::amplitude).max);
}

TEST_CASE("auto asks the wave that a motor under a voltage begins with how many slices it takes",
          "[core][driven][annulus]") {
  const MotorDesign design = sliced(wide_motor(), kAutoSlices);
  const Motor motor(design);
  REQUIRE(motor.radial_slices() < kAutoSlices);
  const Motor same(with(design, Parameter::radial_slices, motor.radial_slices()));
  CHECK(motor.operating_point(9).torque == same.operating_point(9).torque);
  const Motor fine(sliced(design, 64));
  // 1e-6 of the scale of torque at one amplitude (W4.2); a wave far from its fold answers less than ten times.
  CHECK(std::fabs(motor.operating_point(9).torque - fine.operating_point(9).torque) <
        1e-5 * fine.holding_torque());
}
