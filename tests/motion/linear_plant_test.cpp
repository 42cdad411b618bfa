// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include "support/csv_rows.hpp"

#include <catch2/catch.hpp>

#include <twum/core/contact_slopes.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <array>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

TEST_CASE("steady state, poles and gains are those of another program (M7.1, M7.2)",
          "[motion][linear][reference]") {
  for (const CsvRow& row : csv_rows("motion/linear.csv")) {
    CAPTURE(row.word("case"));
    const LinearPlant plant = linearize(motor_of_row(row, "f", "V_rms"), row["TL"]);
    CHECK(plant.states[0].steady == Approx(row["A"]).epsilon(1e-8));
    CHECK(std::remainder(plant.states[1].steady - row["phi"], 2 * std::numbers::pi) ==
          Approx(0).margin(1e-8 * std::abs(row["phi"])));
    CHECK(plant.states[2].steady == Approx(row["Omega"]).epsilon(1e-8));
    for (const char* name : {"p1", "p2", "p3"}) {
      const std::complex<double> asked{row[std::string(name) + "_re"],
                                       row[std::string(name) + "_im"]};
      const auto distance = [&](const auto& pole) { return std::abs(pole - asked); };
      const auto nearest = std::ranges::min_element(plant.poles, {}, distance);
      // The program's poles are of differences of its rates: good to 4e-5.
      CHECK(distance(*nearest) < 2e-4 * std::abs(asked));
    }
    const std::array<std::pair<const char*, const char*>, 3> outputs{
        {{"speed", "dOmega"}, {"amplitude", "dA"}, {"phase_lag", "dphi"}}};
    for (const auto& [output, column] : outputs) {
      const std::vector<double>& gains = plant.gains[row_of_gains(plant, output)];
      CHECK(gains[0] == Approx(row[std::string(column) + "_dV"]).epsilon(2e-4));
      // The phase hardly follows the frequency in case 30: two terms a thousand times as large cancel there.
      CHECK(gains[1] == Approx(row[std::string(column) + "_df"])
                            .epsilon(2e-4)
                            .margin(1e-8 * (output == std::string("phase_lag"))));
      CHECK(gains[2] == Approx(row[std::string(column) + "_dTL"]).epsilon(2e-4));
    }
  }
}

// Steady state of the engine under other inputs.
MotionSample steady_sample(const MotorDesign& d, double voltage, double frequency, double torque) {
  MotionTask task{.duration = 1e-6};
  task.initial.steady = true;
  task.voltage = voltage, task.frequency = frequency, task.load_torque = torque;
  task.output_times = {0};
  return simulate(d, task).samples.at(0);
}

TEST_CASE("gains are differences of steady states", "[motion][linear][identity]") {
  // A real layer: its derivatives pass through damping and inertia.
  MotorDesign d = driven_motor_with_layer(130);
  d.rotor.inertia = 1e-4;
  d.load = ShaftLoad{.damping = 1e-3};
  d.stator.sensor = Sensor{0.03, 0.5e-9, 0.2e-9, 50e3, 1.2};
  const double torque = 0.2, voltage = 130, frequency = 40.8e3;
  const LinearPlant plant = linearize(d, torque);
  const double steps[] = {1e-3, 0.1, 1e-5};
  for (std::size_t input = 0; input < 3; ++input) {
    CAPTURE(input);
    const double h = steps[input];
    const auto at = [&](double sign) {
      return steady_sample(d, voltage + (input == 0) * sign * h,
                           frequency + (input == 1) * sign * h, torque + (input == 2) * sign * h);
    };
    const MotionSample low = at(-1), high = at(1);
    const auto gain = [&](const char* output) {
      return plant.gains[row_of_gains(plant, output)][input];
    };
    // Steps of 1e-5 of the inputs: their squares, and rounding of the states over the step, leave some 1e-6.
    CHECK(gain("speed") == Approx((high.speed - low.speed) / (2 * h)).epsilon(1e-5));
    CHECK(gain("amplitude") == Approx((high.amplitude - low.amplitude) / (2 * h)).epsilon(1e-5));
    CHECK(gain("phase_lag") == Approx((high.phase_lag - low.phase_lag) / (2 * h)).epsilon(1e-5));
    CHECK(gain("phase_current") ==
          Approx((high.phase_current - low.phase_current) / (2 * h)).epsilon(1e-5));
  }
  const MotionSample here = steady_sample(d, voltage, frequency, torque);
  for (const Signal& one : plant.outputs) {
    if (one.name == "speed") CHECK(one.steady == Approx(here.speed).epsilon(1e-10));
    if (one.name == "phase_current") CHECK(one.steady == Approx(here.phase_current).epsilon(1e-10));
  }
}

TEST_CASE("the sensor's rows are those of the metrics of the motor", "[motion][linear][identity]") {
  MotorDesign d = driven_motor(130);
  d.rotor.inertia = 1e-4;
  d.stator.sensor = Sensor{0.03, 0.5e-9, 0.2e-9, 50e3, 1.2};
  const auto metrics = [&](double voltage) {
    const Motor motor(with(d, Parameter::voltage, voltage));
    const MetricRequest asked[] = {{Metric::sensor_voltage_at, Argument::torque, 0.2},
                                   {Metric::sensor_phase_at, Argument::torque, 0.2}};
    const auto found = evaluate(motor, asked);
    return std::array{found[0].value, found[1].value};
  };
  const LinearPlant plant = linearize(d, 0.2);
  const double h = 1e-2;
  const auto low = metrics(130 - h), here = metrics(130), high = metrics(130 + h);
  const char* names[] = {"sensor_voltage", "sensor_phase"};
  for (std::size_t i = 0; i < 2; ++i) {
    CAPTURE(names[i]);
    const auto signal = std::ranges::find(plant.outputs, names[i], &Signal::name);
    REQUIRE(signal != plant.outputs.end());
    CHECK(std::remainder(signal->steady - here[i], 2 * std::numbers::pi) ==
          Approx(0).margin(1e-8 * std::abs(here[i])));
    // A step of 1e-4 of the voltage leaves 1e-7, the curve of the motor 1e-9 over it 1e-5.
    CHECK(plant.gains[row_of_gains(plant, names[i])][0] ==
          Approx((high[i] - low[i]) / (2 * h)).epsilon(3e-5));
  }
}

TEST_CASE("a small step follows the plant", "[motion][linear][identity]") {
  const MotorDesign d = elastic_60(1e-4);
  const LinearPlant plant = linearize(d, 0.3);
  const double volts = 1e-3, end = 1e-3;
  MotionTask task = steady_drive(d, end);
  task.initial.steady = true;
  task.tolerance = 1e-11;
  task.voltage = Profile({{0, 140}, {0, 140 + volts}});
  task.load_torque = 0.3;
  const Motion m = simulate(d, task);
  // x' = A x + B u by the classical method of Runge and Kutta: with 1000 steps and poles below 1e4 / s its error is 1e-9.
  std::array<double, 4> x{};
  const double h = end / 1000;
  const auto rates = [&](const std::array<double, 4>& at) {
    std::array<double, 4> dx{};
    for (std::size_t i = 0; i < 4; ++i) {
      dx[i] = plant.b[i][0] * volts;
      for (std::size_t j = 0; j < 4; ++j) dx[i] += plant.a[i][j] * at[j];
    }
    return dx;
  };
  const auto moved = [](std::array<double, 4> from, const std::array<double, 4>& by, double time) {
    for (std::size_t i = 0; i < 4; ++i) from[i] += time * by[i];
    return from;
  };
  for (int k = 0; k < 1000; ++k) {
    const auto k1 = rates(x), k2 = rates(moved(x, k1, h / 2)), k3 = rates(moved(x, k2, h / 2)),
               k4 = rates(moved(x, k3, h));
    for (std::size_t i = 0; i < 4; ++i) x[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  // The step is 7e-6 of the voltage: the square of it is 1e-5 of the response, as is the integrator's error over it.
  CHECK(m.last.amplitude - plant.states[0].steady == Approx(x[0]).epsilon(1e-4));
  CHECK(m.last.speed - plant.states[2].steady == Approx(x[2]).epsilon(1e-4));
}

TEST_CASE("slopes of the contact are differences of operating points", "[motion][linear]") {
  MotorDesign d = driven_motor_with_layer();
  d.stator.voltage.reset();
  d.stator.amplitude = 1.5e-6;
  d.stator.radial_slices = GENERATE(1, 4);
  const Motor motor(d);
  const OperatingConditions at{8, 1.5e-6, 40.5e3};
  const ContactSlopes slopes = contact_slopes(motor, at);
  const auto forces = [&](const OperatingConditions& where) {
    const OperatingPoint p = motor.operating_point(where);
    return std::array{p.torque, p.reactive_force,
                      p.stator_power / (2 * std::numbers::pi * where.frequency * where.amplitude)};
  };
  const ContactSlopes::Number* numbers[] = {&slopes.torque, &slopes.reactive_force,
                                            &slopes.active_force};
  const auto here = forces(at);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    const auto difference = [&](double OperatingConditions::*member) {
      const double h = 1e-5 * at.*member;
      OperatingConditions low = at, high = at;
      low.*member -= h, high.*member += h;
      return (forces(high)[i] - forces(low)[i]) / (2 * h);
    };
    // Central differences of relative steps of 1e-5: curvature leaves 1e-9, rounding of 1e-12 over the step 1e-7.
    CHECK(numbers[i]->value == Approx(here[i]).epsilon(1e-10));
    CHECK(numbers[i]->per_amplitude ==
          Approx(difference(&OperatingConditions::amplitude)).epsilon(1e-6));
    CHECK(numbers[i]->per_speed == Approx(difference(&OperatingConditions::speed)).epsilon(1e-6));
    CHECK(numbers[i]->per_frequency ==
          Approx(difference(&OperatingConditions::frequency)).epsilon(1e-6));
  }
}

TEST_CASE("a plant says what it lacks", "[motion][linear][input]") {
  MotorDesign d = elastic_60(1e-4);
  CHECK_THROWS_WITH(linearize(d, 3), Catch::Contains("no steady running state"));
  d.rotor.inertia.reset();
  CHECK_THROWS_WITH(linearize(d, 0), Catch::Contains("rotor_inertia"));
  MotorDesign given = elastic_60(1e-4);
  given.stator.voltage.reset();
  CHECK_THROWS_WITH(linearize(given, 0), Catch::Contains("under a voltage"));
}

}  // namespace
