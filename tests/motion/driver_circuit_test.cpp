// SPDX-License-Identifier: Apache-2.0
// Motions behind an inductance and a resistance in series with each phase (M3.1).
#include "motion/motion_motors.hpp"

#include "support/csv_rows.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <complex>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;
using M = Metric;
using P = Parameter;

constexpr double kTwoPi = 2 * std::numbers::pi;

MotorDesign behind_coil(double inertia, double inductance = 1.3e-3, double resistance = 5,
                        double voltage = 60) {
  MotorDesign d = elastic_60(inertia, voltage);
  d.driver = Driver{.inductance = inductance, .resistance = resistance};
  return d;
}

TEST_CASE("a start behind a coil follows a direct integration of wave and circuit (M3.1)",
          "[motion][reference]") {
  std::vector<CsvRow> rows;
  for (const CsvRow& row : csv_rows("motion/direct.csv"))
    if (row["Ls"] > 0) rows.push_back(row);
  REQUIRE(rows.size() == 5);
  const CsvRow& first = rows.front();
  MotorDesign d = behind_coil(first["J"], first["Ls"], first["Rs"], first["V"]);
  d.stator.blocked_capacitance = first["C0"];
  MotionTask task = steady_drive(d, rows.back()["t"]);
  for (const CsvRow& row : rows) task.output_times.push_back(row["t"]);
  const Motion averaged = simulate(d, task);
  task.engine = MotionEngine::oscillating;
  const Motion oscillating = simulate(d, task);
  REQUIRE(averaged.status == "ok");
  REQUIRE(oscillating.status == "ok");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    CAPTURE(row.word("t"));
    // What averaging and the periodic contact leave, of the theory's section on verification.
    CHECK(averaged.samples[i].amplitude == Approx(row["A"]).margin(0.04 * 1.39e-6));
    CHECK(averaged.samples[i].speed == Approx(row["Omega"]).margin(0.015 * 11.4));
    CHECK(averaged.samples[i].angle == Approx(row["theta"]).margin(5e-4));
    CHECK(oscillating.samples[i].amplitude == Approx(row["A"]).margin(4 * row["A_tol"]));
    CHECK(oscillating.samples[i].speed == Approx(row["Omega"]).margin(4 * row["Omega_tol"]));
    CHECK(oscillating.samples[i].angle == Approx(row["theta"]).margin(4 * row["theta_tol"]));
  }
  CHECK(averaged.last.amplitude == Approx(rows.back()["A"]).epsilon(1e-4));
  CHECK(averaged.last.speed == Approx(rows.back()["Omega"]).epsilon(1e-4));
}

TEST_CASE("a motion behind a coil ends in the steady state of its circuit (M3.1, M3.2)",
          "[motion][identity]") {
  for (const auto& [inductance, resistance] :
       {std::pair{1.3e-3, 5.0}, {0.0, 100.0}, {0.5e-3, 300.0}}) {
    CAPTURE(inductance, resistance);
    MotorDesign d = behind_coil(1e-4, inductance, resistance, 140);
    d.stator.loss_tangent = 0.01;
    MotionTask task = steady_drive(d, 0.04);
    task.load_torque = 0.2;
    for (const bool steady : {false, true}) {
      task.initial.steady = steady;
      const Motion m = simulate(d, task);
      REQUIRE(m.status == "ok");
      const Motor motor(d);
      const double speed = evaluate(motor, {M::speed_at, Argument::torque, 0.2}).value;
      const OperatingPoint p = motor.operating_point(speed);
      // 1e-6: the tolerance of the integration.
      CHECK(m.last.speed == Approx(speed).epsilon(1e-6));
      CHECK(m.last.amplitude == Approx(p.amplitude).epsilon(1e-6));
      CHECK(m.last.voltage == Approx(p.terminal_voltage).epsilon(1e-6));
      CHECK(m.last.phase_current == Approx(p.phase_current).epsilon(1e-6));
      CHECK(m.last.electrical_power == Approx(p.electrical_power).epsilon(1e-5));
      CHECK(std::remainder(m.last.phase_lag - p.phase_lag, kTwoPi) == Approx(0).margin(1e-6));
    }
  }
}

TEST_CASE("blocked phases charge through the coil as a circuit alone (M3.1)",
          "[motion][closed-form]") {
  // A stator that does not couple, no rotor that counts: L I' + R I + u = V cos wt, C u' = I, in the frame that turns with w.
  const double L = 1.3e-3, R = 400, C = 8.5e-9, V = 60, time = 40e-6, omega = kTwoPi * 40.8e3;
  MotorDesign d = behind_coil(1e-4, L, R, V);
  d.stator.force_factor = 1e-9;
  MotionTask task = steady_drive(d, time);
  task.output_times = times_to(time, 8);
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  // Rates of a resting circuit, and those seen in the frame.
  const std::complex<double> decay{-R / (2 * L), 0};
  const std::complex<double> swing = std::sqrt(decay * decay - 1 / (L * C));
  const std::complex<double> turn{0, omega}, source = std::sqrt(2.0) * V;
  const std::complex<double> settled = source / (1.0 + (R + turn * L) * turn * C);
  for (const MotionSample& s : m.samples) {
    // u + i omega u C is zero at the beginning, as is I / C: u' = -i omega u.
    const std::complex<double> a = decay + swing - turn, b = decay - swing - turn;
    const std::complex<double> c1 = (-turn * settled + settled * (b + turn)) / (a - b);
    const std::complex<double> c2 = -settled - c1;
    const std::complex<double> u = settled + c1 * std::exp(a * s.time) + c2 * std::exp(b * s.time);
    CAPTURE(s.time);
    // Steps that keep 1.5e-7 leave some 1e-6 over a hundred of them.
    CHECK(s.voltage == Approx(std::abs(u) / std::sqrt(2.0)).margin(3e-6 * V));
  }
  task.engine = MotionEngine::oscillating;
  task.duration = 2e-3, task.output_times.clear();
  CHECK(simulate(d, task).last.voltage ==
        Approx(std::abs(settled) / std::sqrt(2.0))
            .epsilon(2e-3));  // 100 steps a period: (omega dt)^2 / 2
}

TEST_CASE(
    "energy from the inverter is stored, given to the motor, or lost in the resistance (M3.1)",
    "[motion][identity]") {
  MotorDesign d = behind_coil(1e-4);
  d.stator.loss_tangent = 0.02;
  MotionTask task = steady_drive(d, 0.004);
  task.output_times = times_to(0.004, 80000);
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const double omega = kTwoPi * 40.8e3;
  double lost = 0, dielectric = 0, damped = 0, passed = 0, wave = 0, before = 0;
  const Motor motor(d);
  const double ms = *d.stator.modal_mass, ks = ms * std::pow(kTwoPi * 39e3, 2);
  for (std::size_t k = 0; k < m.samples.size(); ++k) {
    const MotionSample& s = m.samples[k];
    double stiffness = ks;
    if (s.amplitude > 1e-10)
      stiffness +=
          motor.operating_point({s.speed, s.amplitude, 40.8e3}).reactive_force / s.amplitude;
    const double factor = ms * omega * (omega + std::sqrt(stiffness / ms)) / 2;
    if (k > 0) {
      const MotionSample& p = m.samples[k - 1];
      const double dt = s.time - p.time;
      const auto mean = [&](auto of) { return 0.5 * (of(s) + of(p)) * dt; };
      lost +=
          mean([&](const MotionSample& x) { return 2 * 5 * x.phase_current * x.phase_current; });
      dielectric += mean(
          [&](const MotionSample& x) { return 2 * omega * 8.5e-9 * 0.02 * x.voltage * x.voltage; });
      damped += mean([&](const MotionSample& x) {
        return modal_damping(d) * std::pow(omega * x.amplitude, 2);
      });
      passed += mean([&](const MotionSample& x) { return x.stator_power; });
      wave += 0.5 * (factor + before) * (s.amplitude * s.amplitude - p.amplitude * p.amplitude);
    }
    before = factor;
  }
  // Coil and capacitor hold L I^2 / 2 + C u^2 / 2 of each phase, peak values. What (M2.1) leaves out of the wave's work,
  // Theta Re(u zeta'*), comes back in the mean; over the start it is 1e-3 of the turnover.
  const double stored = 1.3e-3 * m.last.phase_current * m.last.phase_current +
                        8.5e-9 * m.last.voltage * m.last.voltage;
  CHECK(lost > 0.01 * m.last.energy);
  CHECK(m.last.energy ==
        Approx(lost + dielectric + damped + passed + wave + 2 * stored / 2).epsilon(2e-3));
}

TEST_CASE(
    "a drive behind a coil that is switched off and on goes on as the oscillating engine does",
    "[motion][oscillating][differential]") {
  const MotorDesign d = [] {
    MotorDesign design = behind_coil(1e-4);
    design.driver->off_resistance = 459;
    return design;
  }();
  MotionTask task = steady_drive(d, 0.008);
  task.switched_off = {{0.003, 0.005}};
  task.output_times = times_to(0.008, 80);
  const Motion averaged = simulate(d, task);
  task.engine = MotionEngine::oscillating;
  const Motion oscillating = simulate(d, task);
  REQUIRE(averaged.status == "ok");
  REQUIRE(oscillating.status == "ok");
  for (std::size_t k = 0; k < averaged.samples.size(); ++k) {
    CAPTURE(averaged.samples[k].time);
    // A second start is some 20 us late, while the contact is full: 1.7 % of the largest speed, and 0.7 % with an ideal driver.
    CHECK(averaged.samples[k].speed == Approx(oscillating.samples[k].speed).margin(0.02 * 11.4));
    CHECK(averaged.samples[k].angle == Approx(oscillating.samples[k].angle).margin(5e-4));
  }
}

TEST_CASE("metrics of manoeuvres behind a coil have the slopes of differences (M10.1, M3.1)",
          "[motion][manoeuvres][derivative]") {
  for (const auto& [inductance, resistance] : {std::pair{1.3e-3, 20.0}, {0.0, 100.0}}) {
    MotorDesign d = behind_coil(1e-4, inductance, resistance, inductance > 0 ? 60 : 140);
    d.stator.loss_tangent = 0.01, d.driver->off_resistance = 300;
    for (const MetricRequest& request : {MetricRequest{M::start_time_at, Argument::torque, 0.1},
                                         MetricRequest{M::stop_angle_at, Argument::torque, 0.1},
                                         MetricRequest{M::move_energy, Argument::angle, 0.1}}) {
      const MetricDerivative found = differentiate(Motor(d), request);
      CAPTURE(info(request.metric).name, inductance);
      REQUIRE(found.smoothness == Smoothness::smooth);
      for (const P parameter : {P::driver_inductance, P::driver_resistance, P::voltage,
                                P::blocked_capacitance, P::force_factor, P::off_resistance}) {
        const double q = get(d, parameter), step = 1e-3 * q;
        if (q == 0) {
          CHECK(std::isnan(found.gradient[index_of(parameter)]));
          continue;
        }
        const auto at = [&](double x) {
          return evaluate(Motor(with(d, parameter, x)), request).value;
        };
        const double slope = (at(q + step) - at(q - step)) / (2 * step);
        CAPTURE(info(parameter).name);
        // 1e-3 of a slope that counts, as for an ideal driver; runs scatter by 1e-6 of the value over steps of 1e-3.
        CHECK(found.gradient[index_of(parameter)] ==
              Approx(slope).epsilon(1e-3).margin(2e-3 * std::abs(found.value.value / q)));
      }
    }
  }
}

TEST_CASE("gains behind a coil are differences of steady states (M7.1, M3.1)",
          "[motion][linear][identity]") {
  for (const auto& [inductance, resistance] : {std::pair{1.3e-3, 5.0}, {0.0, 100.0}}) {
    const MotorDesign d = behind_coil(1e-4, inductance, resistance, 100);
    const double torque = 0.2;
    const LinearPlant plant = linearize(d, torque);
    CHECK(plant.states.size() == (inductance > 0 ? 8 : 6));
    CHECK(plant.poles.size() + 1 == plant.states.size());
    const double steps[] = {1e-3, 0.1, 1e-5};
    for (std::size_t input = 0; input < 3; ++input) {
      CAPTURE(input, inductance);
      const double h = steps[input];
      const auto at = [&](double sign) {
        MotorDesign moved = with(d, P::voltage, 100 + (input == 0) * sign * h);
        moved = with(moved, P::frequency, 40.8e3 + (input == 1) * sign * h);
        const Motor motor(moved);
        const double speed =
            evaluate(motor, {M::speed_at, Argument::torque, torque + (input == 2) * sign * h})
                .value;
        return motor.operating_point(speed);
      };
      const OperatingPoint low = at(-1), high = at(1);
      const auto gain = [&](const char* output) {
        return plant.gains[row_of_gains(plant, output)][input];
      };
      // Steps of 1e-5 leave their square, near both resonances a hundredfold, and 1e-11 of the values over the step.
      CHECK(gain("speed") == Approx((high.speed - low.speed) / (2 * h)).epsilon(1e-4));
      CHECK(gain("amplitude") == Approx((high.amplitude - low.amplitude) / (2 * h)).epsilon(1e-4));
      CHECK(gain("phase_lag") == Approx((high.phase_lag - low.phase_lag) / (2 * h)).epsilon(1e-4));
      CHECK(gain("phase_current") ==
            Approx((high.phase_current - low.phase_current) / (2 * h)).epsilon(1e-4));
    }
    // A small step of the drive relaxes as the slowest pole says.
    MotionTask task = steady_drive(d, 0.01);
    task.initial.steady = true, task.load_torque = torque;
    task.frequency = Profile({{0, 40.8e3}, {0, 40.81e3}});
    task.output_times = {0.004, 0.0045, 0.01};
    const Motion m = simulate(d, task);
    REQUIRE(m.status == "ok");
    CHECK(m.last.speed - plant.states[2].steady ==
          Approx(10 * plant.gains[row_of_gains(plant, "speed")][1]).epsilon(0.03));
  }
}

TEST_CASE("without an impedance the motion is that of an ideal driver, to the bit (M3.1)",
          "[motion][identity]") {
  MotorDesign ideal = elastic_60(1e-4);
  MotorDesign given = ideal;
  given.driver = Driver{};
  for (const MotionEngine engine : {MotionEngine::averaged, MotionEngine::oscillating}) {
    MotionTask task = steady_drive(ideal, 0.002);
    task.engine = engine;
    const Motion a = simulate(ideal, task), b = simulate(given, task);
    CHECK(a.last.speed == b.last.speed);
    CHECK(a.last.energy == b.last.energy);
    CHECK(a.steps == b.steps);
  }
}

TEST_CASE("a small series branch changes a start as much as its steady state (M3.1)",
          "[motion][limit]") {
  const auto end = [](double resistance) {
    MotorDesign d = behind_coil(1e-4, 0, resistance, 140);
    return simulate(d, steady_drive(d, 0.02)).last.speed;
  };
  const double ideal = end(0), one = end(0.5), two = end(1);
  // Twice the resistance counts twice; the tolerance of the motions is a thousandth of the change.
  CHECK(two - ideal == Approx(2 * (one - ideal)).epsilon(5e-3));
}

TEST_CASE(
    "the power of each vibration is that of the steady state down to a small resistance (M3.1)",
    "[motion][limit]") {
  // A resistance that charges the capacitance faster than a step must not feel the steps. The wave turns by 2 pi / 100 in a
  // step, whose square over 12 is 3e-4, and the steady state is reached to a thousandth.
  for (const double resistance : {1e-3, 1.0, 5.0, 50.0}) {
    CAPTURE(resistance);
    const MotorDesign d = behind_coil(1e-4, 0, resistance, 140);
    MotionTask task = steady_drive(d, 0.003);
    task.engine = MotionEngine::oscillating;
    task.load_torque = Profile({{0, 0.3}});
    task.initial.steady = true;
    task.output_times = {0.002, 0.003};
    const Motion motion = simulate(d, task);
    REQUIRE(motion.status == "ok");
    const double power = (motion.samples[1].energy - motion.samples[0].energy) / 0.001;
    const MetricValue steady = evaluate(Motor(d), {M::electrical_power_at, Argument::torque, 0.3});
    CHECK(power == Approx(steady.value).epsilon(3e-3));
  }
}

TEST_CASE("a circuit that rings as fast as the stator is no rate of the motor (M3.1, M7.1)",
          "[motion][linear]") {
  const double ideal =
      evaluate(Motor(elastic_60(1e-4, 140)), {M::settling_rate_at, Argument::torque, 0.2}).value;
  for (const double resistance : {0.0, 0.1, 5.0}) {
    CAPTURE(resistance);
    const MotorDesign d = behind_coil(1e-4, 1e-5, resistance, 140);
    // Ten microhenry at 40.8 kHz are 0.5 % of the reactance of the phases.
    const MetricValue found = evaluate(Motor(d), {M::settling_rate_at, Argument::torque, 0.2});
    CHECK(found.value == Approx(ideal).epsilon(0.1));
  }
}

TEST_CASE("a coil needs a capacitance, and a table an ideal driver", "[motion][errors]") {
  MotorDesign d = behind_coil(1e-4);
  CHECK_THROWS_WITH(tabulate(d), Catch::Matchers::Contains("driver_inductance"));
  d.stator.blocked_capacitance = 0;
  CHECK_THROWS_WITH(simulate(d, steady_drive(d, 0.001)),
                    Catch::Matchers::Contains("blocked_capacitance is 0 F"));
}

}  // namespace
