// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/driven_motors.hpp"
#include "support/known_value.hpp"
#include "support/metric_requests.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/frequency_response.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

// A driver with an inductance and a resistance in series with each phase (theory of the driven stator, section 8).
namespace {

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Complex = std::complex<double>;
using M = Metric;

MotorDesign behind_series(double inductance, double resistance, double voltage = 60,
                          double frequency = 40.8e3) {
  MotorDesign design = driven_motor(voltage, frequency);
  design.driver = Driver{.inductance = inductance, .resistance = resistance};
  return design;
}

double metric_behind(const Motor& motor, Metric metric, double speed) {
  return known_value(motor, {metric, Argument::speed, speed});
}

double number_behind(const MotorDesign& design, Metric metric) {
  return known_value(design, {metric});
}

double rate_of_drive(const MotorDesign& design) { return 2 * kPi * drive_frequency(design); }

Complex impedance_of_series(const MotorDesign& d) {
  return {d.driver->resistance, rate_of_drive(d) * d.driver->inductance};
}

// A phase of the motor at a point, as its equivalent circuit with the contact in it (D4.4, D4.5) [1/ohm].
Complex admittance_of_phase(const Motor& motor, const OperatingPoint& point) {
  const MotorDesign& d = motor.design();
  const EquivalentCircuit loaded =
      with_contact(*equivalent_circuit(d), contact_circuit(motor, point));
  return admittance(loaded, d.stator.loss_tangent, drive_frequency(d));
}

}  // namespace

TEST_CASE("a motor behind a coil is its circuit in series with it (D8.1, D8.4, D8.5)",
          "[core][driven][closed-form]") {
  for (const auto& [inductance, resistance, voltage] : {std::tuple{1.3e-3, 5.0, 60.0},
                                                        {0.83e-3, 50.0, 80.0},
                                                        {0.0, 200.0, 150.0},
                                                        {0.5e-3, 0.0, 100.0}}) {
    const MotorDesign design = behind_series(inductance, resistance, voltage);
    const Motor motor(design);
    for (const double speed : {2.0, 8.0}) {
      CAPTURE(inductance, resistance, speed);
      const OperatingPoint p = motor.operating_point(speed);
      REQUIRE(p.status == PointStatus::ok);
      const Complex series = impedance_of_series(design),
                    phase = 1.0 / admittance_of_phase(motor, p);
      const Complex current = voltage / (series + phase), across = current * phase;
      // The motional branch has cancellations of a tenth; the solver leaves 1e-12 of the amplitude.
      const double near = 1e-10;
      CHECK_THAT(p.voltage, WithinRel(voltage, near));
      CHECK_THAT(p.phase_current, WithinRel(std::abs(current), near));
      CHECK_THAT(p.terminal_voltage, WithinRel(std::abs(across), near));
      CHECK_THAT(p.electrical_power, WithinRel(2 * voltage * current.real(), near));
      CHECK_THAT(p.driver_loss, WithinAbs(2 * resistance * std::norm(current), near));
      CHECK_THAT(p.power_factor, WithinRel(current.real() / std::abs(current), near));
      const double omega = rate_of_drive(design);
      CHECK_THAT(p.dielectric_loss, WithinRel(2 * omega * 8.5e-9 * 0.01 * std::norm(across), near));
      // The wave's velocity is the current of the motional branch, by which it lags behind the inverter.
      const Complex motional =
          (current - across * omega * 8.5e-9 * Complex{0.01, 1}) / (Complex{0, omega} * 0.55);
      CHECK_THAT(p.amplitude, WithinRel(std::sqrt(2.0) * std::abs(motional), near));
      CHECK_THAT(p.phase_lag, WithinRel(-std::arg(motional), near));
      CHECK_THAT(p.electrical_power,
                 WithinRel(p.output_power + p.friction_power + p.layer_loss + p.stator_loss +
                               p.dielectric_loss + p.driver_loss,
                           near));
      for (const auto& [metric, value] : {std::pair{M::phase_current_at, p.phase_current},
                                          {M::electrical_power_at, p.electrical_power},
                                          {M::driver_loss_at, p.driver_loss},
                                          {M::terminal_voltage_at, p.terminal_voltage},
                                          {M::dielectric_loss_at, p.dielectric_loss},
                                          {M::power_factor_at, p.power_factor},
                                          {M::phase_lag_at, p.phase_lag}})
        CHECK_THAT(metric_behind(motor, metric, speed), WithinAbs(value, near * std::abs(value)));
      CHECK_THAT(metric_behind(motor, M::apparent_power_at, speed),
                 WithinRel(2 * voltage * std::abs(current), near));
      // In parallel with inverter and coil, it takes what of the current leads the voltage.
      if (current.imag() > 0)
        CHECK_THAT(metric_behind(motor, M::matching_inductance_at, speed),
                   WithinRel(voltage / (omega * current.imag()), near));
    }
  }
}

TEST_CASE("the voltages of start and hold are extrema of the inverter's (D8.3)",
          "[core][driven][oracle]") {
  // Voltage of the inverter that a wave at rest needs, by complex numbers from the contact's force alone.
  const MotorDesign design = behind_series(1.3e-3, 5);
  MotorDesign given = design;
  given.stator.voltage.reset();
  const double omega = rate_of_drive(design), free = 2 * kPi * 39e3;
  const Complex Z = impedance_of_series(design), Y = omega * 8.5e-9 * Complex{0.01, 1};
  const auto voltage = [&](double amplitude) {
    given.stator.amplitude = amplitude;
    const OperatingPoint p = Motor(given).operating_point(0);
    const Complex own{0.025 * (free - omega) * (free + omega) * amplitude + p.reactive_force,
                      omega * 40 * amplitude + p.stator_power / (omega * amplitude)};
    const Complex across = own / 0.55;
    const double inverter =
        std::abs(across * (1.0 + Z * Y) + Z * Complex{0, omega} * 0.55 * amplitude) /
        std::sqrt(2.0);
    CHECK_THAT(p.voltage, WithinRel(inverter, 1e-12));
    return inverter;
  };
  std::vector<double> needed;
  for (double a = 0.05e-6; a < 3e-6; a *= 1.002) needed.push_back(voltage(a));
  const auto top = std::adjacent_find(needed.begin(), needed.end(), std::greater<>());
  const double start = *top, hold = *std::min_element(top, needed.end());
  // Steps of 0.2 % miss an extremum by up to 1e-6 of its height.
  CHECK_THAT(number_behind(design, M::start_voltage), WithinRel(start, 3e-6));
  CHECK_THAT(number_behind(design, M::hold_voltage), WithinRel(hold, 3e-6));
  // At the frequency of a threshold the voltage is the one of the file.
  for (const auto& [frequency, level] : {std::pair{M::start_frequency, M::start_voltage},
                                         {M::pull_out_frequency, M::hold_voltage}}) {
    const double f = number_behind(design, frequency);
    CAPTURE(f);
    CHECK_THAT(number_behind(with(design, Parameter::frequency, f), level), WithinRel(60.0, 1e-9));
  }
}

TEST_CASE("the lag behind the inverter passes half a turn without a jump (D8.2)",
          "[core][driven][limit]") {
  // From below the resonance of coil and phases to beyond it, where the inverter's voltage turns round.
  double last = std::numeric_limits<double>::quiet_NaN();
  bool beyond = false;
  for (double inductance = 1.2e-3; inductance < 2.2e-3; inductance += 2e-5) {
    const Motor motor(behind_series(inductance, 1, 120));
    const double lag = metric_behind(motor, M::phase_lag_at, 5);
    CAPTURE(inductance, lag);
    if (!std::isnan(last)) CHECK(std::fabs(lag - last) < 0.5);
    // Both find the wave by themselves, as above.
    CHECK_THAT(motor.operating_point(5).phase_lag, WithinRel(lag, 1e-10));
    beyond = beyond || lag > kPi;
    last = lag;
  }
  CHECK(beyond);
}

TEST_CASE("a large resistance impresses the current (D8.2)", "[core][driven][limit]") {
  // |Z| of a phase is about 500 ohm: 5e-3 of the resistance.
  const double resistance = 1e5, current = 0.2;
  const MotorDesign design = behind_series(0, resistance, 1);
  MotorDesign impressed = design;
  impressed.stator.voltage = current * resistance;
  const Motor motor(impressed);
  const OperatingPoint p = motor.operating_point(5);
  REQUIRE(p.status == PointStatus::ok);
  CHECK_THAT(p.phase_current, WithinRel(current, 0.01));
  CHECK_THAT(p.driver_loss, WithinRel(2 * resistance * current * current, 0.02));
}

TEST_CASE("a coil resonates with the blocked capacitance (D8.2)", "[core][driven][closed-form]") {
  // A stator that hardly couples and no rotor: a coil and a capacitor alone.
  MotorDesign design = behind_series(1.3e-3, 20, 10);
  design.preload = 0;
  design.stator.force_factor = 1e-9, design.stator.loss_tangent = 0;
  const double omega = rate_of_drive(design);
  const Complex divider = 1.0 + impedance_of_series(design) * Complex{0, omega * 8.5e-9};
  CHECK_THAT(metric_behind(Motor(design), M::terminal_voltage_at, 1),
             WithinRel(10 / std::abs(divider), 1e-12));
  // At 1 / sqrt(L C) the resistance alone limits it: V / (R omega C).
  const double resonance = 1 / std::sqrt(1.3e-3 * 8.5e-9);
  design.stator.frequency = resonance / (2 * kPi);
  CHECK_THAT(metric_behind(Motor(design), M::terminal_voltage_at, 1),
             WithinRel(10 / (20 * resonance * 8.5e-9), 1e-9));
  // The free wave is driven by that voltage.
  MotorDesign shorted = design;
  shorted.driver.reset();
  CHECK_THAT(
      number_behind(design, M::free_amplitude),
      WithinRel(number_behind(shorted, M::free_amplitude) / (20 * resonance * 8.5e-9), 1e-9));
}

TEST_CASE("a driver without inductance and resistance is ideal, to the bit (D8.2)",
          "[core][driven][identity]") {
  for (const MotorDesign& ideal : {driven_motor_with_layer(), unequal_motor()}) {
    MotorDesign given = ideal;
    given.driver = Driver{};
    const Motor a(ideal), b(given);
    for (const MetricRequest& request : every_metric(11.3, 0.45)) {
      CAPTURE(info(request.metric).name);
      const MetricValue one = evaluate(a, request), other = evaluate(b, request);
      CHECK(one.status == other.status);
      CHECK((one.value == other.value || (std::isnan(one.value) && std::isnan(other.value))));
    }
    CHECK(metric_behind(b, M::driver_loss_at, 5) == 0);
  }
}

TEST_CASE("gradients behind a coil are the limits of differences (D8.3)",
          "[core][driven][derivative]") {
  const auto compare = [](const MotorDesign& design) {
    // As of an ideal driver, but that the resonance of coil and capacitance counts a few times more.
    const GradientCheck check = against_differences(design, every_metric(8.3, 0.35), 5e-6);
    CAPTURE(check.where);
    CHECK(check.worst <= 2e-5);
    CHECK(check.compared > 500);
  };
  SECTION("with a coil") { compare(behind_series(1.3e-3, 5)); }
  SECTION("with a resistance") { compare(behind_series(0, 100, 150)); }
  SECTION("with a viscous layer whose viscosity follows the frequency") {
    MotorDesign design = driven_motor_with_layer(70, 41e3);
    design.driver = Driver{.inductance = 1e-3, .resistance = 10};
    compare(design);
  }
  SECTION("with unequal phases and modes, a rotor's mass and a sensor") {
    MotorDesign design = unequal_motor(driven_motor(60));
    design.driver = Driver{.inductance = 1.3e-3, .resistance = 5};
    compare(design);
  }
}

TEST_CASE("the first ohm and henry have slopes (D8.3)", "[core][driven][derivative]") {
  MotorDesign design = driven_motor(120);
  design.driver = Driver{};
  for (const auto& [parameter, step] :
       {std::pair{Parameter::driver_resistance, 1e-3}, {Parameter::driver_inductance, 1e-8}}) {
    for (const Metric metric : {M::amplitude_at, M::phase_current_at, M::electrical_power_at,
                                M::start_voltage, M::drive_voltage_at}) {
      const bool plain = info(metric).argument == Argument::none;
      const MetricRequest request{metric, plain ? Argument::none : Argument::speed, 5};
      const MetricDerivative found = differentiate(Motor(design), request);
      CAPTURE(info(metric).name, info(parameter).name);
      const double above = evaluate(Motor(with(design, parameter, step)), request).value,
                   far = evaluate(Motor(with(design, parameter, 2 * step)), request).value;
      // Forward differences of the second order.
      const double slope = (4 * above - 3 * found.value.value - far) / (2 * step);
      // The values are right to 1e-12, over a change of 1e-6 or so.
      const double doubt = 1e-11 * std::abs(found.value.value) / step;
      CHECK_THAT(found.gradient[index_of(parameter)],
                 WithinAbs(slope, 1e-5 * std::abs(slope) + doubt));
    }
  }
}

TEST_CASE("a held point keeps its torque under the inverter's voltage (D8.3)",
          "[core][driven][identity]") {
  const MotorDesign design = behind_series(1.3e-3, 5);
  for (const double torque : {0.1, 0.3}) {
    CAPTURE(torque);
    const HeldPoint held = held_point(design, torque, 6, DriveControl::frequency);
    REQUIRE(held.status == HeldStatus::ok);
    CHECK_THAT(held.voltage, WithinRel(60.0, 1e-10));
    const Motor there(with(design, Parameter::frequency, held.frequency));
    CHECK_THAT(there.operating_point(6).torque, WithinRel(torque, 1e-8));
    const HeldPoint by_voltage = held_point(design, torque, 6, DriveControl::voltage);
    REQUIRE(by_voltage.voltage > 0);
    MotorDesign other = design;
    other.stator.voltage = by_voltage.voltage;
    bool met = false;
    for (const WaveState& wave : Motor(other).wave_states(6))
      met = met || std::abs(wave.amplitude - by_voltage.amplitude) < 1e-8 * wave.amplitude;
    CHECK(met);
  }
}

TEST_CASE("metrics of held points behind a coil have the slopes of differences (D8.3)",
          "[core][driven][derivative]") {
  MotorDesign design = behind_series(1.3e-3, 5);
  for (const DriveControl control : {DriveControl::frequency, DriveControl::voltage}) {
    design.stator.control = control;
    for (const MetricRequest& request :
         {MetricRequest{M::drive_frequency_at, Argument::both, 6, 0.2},
          MetricRequest{M::electrical_power_at, Argument::both, 6, 0.2},
          MetricRequest{M::held_torque_limit_at, Argument::speed, 6},
          MetricRequest{M::drive_reserve_at, Argument::both, 6, 0.2}}) {
      const MetricDerivative found = differentiate(Motor(design), request);
      if (found.smoothness != Smoothness::smooth) continue;
      for (const Parameter parameter :
           {Parameter::driver_inductance, Parameter::driver_resistance,
            Parameter::blocked_capacitance, Parameter::voltage, Parameter::preload}) {
        const double q = get(design, parameter), step = 1e-4 * q;
        const auto at = [&](double value) {
          return evaluate(Motor(with(design, parameter, value)), request).value;
        };
        const double slope = (at(q + step) - at(q - step)) / (2 * step);
        CAPTURE(info(request.metric).name, info(parameter).name, static_cast<int>(control));
        // Central differences of 1e-4 leave 1e-8 of the third derivative, near the resonance 1e3 times the first, and 1e-11 of the
        // value over the step.
        CHECK_THAT(
            found.gradient[index_of(parameter)],
            WithinAbs(slope, 3e-5 * std::abs(slope) + 1e-6 * std::abs(found.value.value / q)));
      }
    }
  }
}

TEST_CASE("a frequency response behind a coil has the waves of the motor at each frequency (D8.7)",
          "[core][driven][identity]") {
  const MotorDesign design = behind_series(1.3e-3, 5, 30);
  const FrequencyResponse response(design, {Argument::speed, 0.1}, std::pair{37e3, 43e3});
  int met = 0;
  for (const double frequency : {37.5e3, 39e3, 40.2e3, 40.8e3, 41.5e3, 42.8e3}) {
    const Motor motor(with(design, Parameter::frequency, frequency));
    const std::vector<WaveState> waves = motor.wave_states(0.1);
    const std::vector<ResponsePoint> found = response.at(frequency);
    CAPTURE(frequency, waves.size());
    REQUIRE(found.size() == waves.size());
    for (std::size_t k = 0; k < waves.size(); ++k) {
      CHECK_THAT(found[k].point.amplitude, WithinRel(waves[k].amplitude, 1e-9));
      CHECK(found[k].stable == waves[k].stable);
      ++met;
    }
  }
  CHECK(met >= 8);
  // Beyond the middle of both resonances the wave would grow again towards that of the coil.
  CHECK_THROWS_WITH(FrequencyResponse(design, {Argument::speed, 3}, std::pair{37e3, 47e3}),
                    Catch::Matchers::Contains("driver_inductance resonates") &&
                        Catch::Matchers::Contains("must end at"));
  // The same without computing it, with one end or both.
  CHECK_THROWS_WITH(FrequencyResponse::check(design, {}, 47e3),
                    Catch::Matchers::Contains("must end at"));
  CHECK_NOTHROW(FrequencyResponse::check(design, 37e3, 43.5e3));
  CHECK_NOTHROW(FrequencyResponse::check(design, {}, {}));
  const FrequencyResponse own(design, {Argument::speed, 3});
  CHECK(own.to() < 45e3);
}

TEST_CASE("open phases stiffen a free backward wave by Theta^2 / C_0 (D8.6)",
          "[core][backward-wave][limit]") {
  MotorDesign shorted = driven_motor();
  shorted.stator.loss_tangent = 0;
  shorted.stator.voltage.reset();
  shorted.stator.amplitude = 1.7e-6;
  shorted.rotor.mass = 0.1;
  const double resistance = 1e6, stiff = 0.55 * 0.55 / 8.5e-9;
  MotorDesign open = shorted;
  open.driver = Driver{.resistance = resistance};
  MotorDesign stiffened = shorted;
  const double k = 0.025 * std::pow(2 * kPi * 39e3, 2) + stiff;
  stiffened.stator.resonance_frequency = std::sqrt(k / 0.025) / (2 * kPi);
  for (const double speed : {1.0, 6.0}) {
    const BackwardWave a = Motor(open).backward_wave(speed),
                       b = Motor(stiffened).backward_wave(speed);
    REQUIRE(std::isfinite(a.squeal_rate));
    // The resistance still takes Theta^2 / (omega C_0)^2 / R = 0.064 N s/m, of the order of 1.3 / s; its frequency is right to a tenth.
    const double omega = 2 * kPi * 42e3;
    const double taken = 0.55 * 0.55 / std::pow(omega * 8.5e-9, 2) / resistance;
    CHECK_THAT(a.squeal_rate, WithinAbs(b.squeal_rate - taken / 0.05, 0.3));
    CHECK_THAT(a.fed_damping, WithinAbs(b.fed_damping, 0.01));
  }
}

TEST_CASE("a forced backward wave behind a coil keeps Kirchhoff's laws (D8.4, D8.6)",
          "[core][backward-wave][identity]") {
  // Behind a coil nearly equal phases have the currents of equal ones.
  const MotorDesign equal = behind_series(1.3e-3, 5);
  MotorDesign nearly = equal;
  nearly.stator.imbalance = Imbalance{1 + 1e-9, 1e-9, 0};
  for (const Metric metric : {M::phase_current_at, M::terminal_voltage_at, M::electrical_power_at,
                              M::driver_loss_at, M::matching_inductance_at})
    CHECK_THAT(metric_behind(Motor(nearly), metric, 5),
               WithinRel(metric_behind(Motor(equal), metric, 5), 1e-6));
  // An ideal driver whose voltages are those behind the coil drives the same backward wave: with a resistance so small that it
  // counts by its first order only, from both sides.
  MotorDesign unequal = unequal_motor(driven_motor(120));
  const auto ratio = [&](double resistance) {
    unequal.driver = Driver{.resistance = resistance};
    return metric_behind(Motor(unequal), M::backward_ratio_at, 5);
  };
  const double ideal = ratio(0), small = ratio(1e-3), twice = ratio(2e-3);
  CHECK_THAT(twice - ideal, WithinRel(2 * (small - ideal), 1e-3));
  CHECK(small != ideal);
}
