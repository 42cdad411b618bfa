// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/driven_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/metrics.hpp>

#include <cmath>
#include <complex>

// The stator as a circuit: what an impedance analyser reads off it, and the motor that comes back.
namespace {

using namespace twum;
using namespace twum::test;

constexpr std::complex<double> kI(0, 1);

/// What an impedance analyser reads: series resonance and width of the circle, its diameter, capacitance at low frequency.
struct Reading {
  double series, bandwidth, conductance, low_capacitance;
};

/// Frequency between two others where a falling function of it changes its sign.
template <typename F>
double falling_root(const F& f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

/// Reads the free stator of a design without dielectric loss: from its modes by phasors of (D2.1), without circuit elements.
Reading read_impedance(const MotorDesign& design) {
  const Stator& s = design.stator;
  const double damping = modal_damping(design);
  const auto y = [&](double f) {
    const double omega = 2 * kPi * f, omega_r = 2 * kPi * *s.resonance_frequency;
    const std::complex<double> stiffness =
        *s.modal_mass * (omega_r - omega) * (omega_r + omega) + kI * omega * damping;
    const std::complex<double> displacement = *s.force_factor / stiffness;  // per volt
    return kI * omega * (s.blocked_capacitance + *s.force_factor * displacement);
  };
  const double f_r = *s.resonance_frequency, width = damping / (2 * kPi * *s.modal_mass);
  // On the circle B - omega C_0 falls through zero at its right end and is -+ G at top and bottom.
  const auto motional = [&](double f) { return y(f) - kI * 2.0 * kPi * f * s.blocked_capacitance; };
  const double series = falling_root([&](double f) { return motional(f).imag(); },
                                     f_r - 0.2 * width, f_r + 0.2 * width);
  const double above = falling_root(
      [&](double f) { return motional(f).imag() + motional(f).real(); }, f_r, f_r + 3 * width);
  const double below = falling_root(
      [&](double f) { return motional(f).imag() - motional(f).real(); }, f_r - 3 * width, f_r);
  constexpr double kLow = 1e-3;  // [Hz]
  const double low = y(kLow).imag() / (2 * kPi * kLow);
  return {series, above - below, y(series).real(), low};
}

/// The circuit of a reading, with the scale of the mechanical side.
EquivalentCircuit circuit_of(const Reading& reading, double force_factor) {
  const double resistance = 1 / reading.conductance;
  const double inductance = resistance / (2 * kPi * reading.bandwidth);
  const double omega = 2 * kPi * reading.series;
  const double capacitance = 1 / (omega * omega * inductance);
  return {resistance, inductance, capacitance, reading.low_capacitance - capacitance, force_factor};
}

MotorDesign with_circuit(const MotorDesign& design, const EquivalentCircuit& circuit) {
  const auto values = modal_data(circuit);
  return with(design, values);
}

}  // namespace

TEST_CASE("a circuit read off the impedance gives the motor back (D4.4)",
          "[core][driven][identity]") {
  MotorDesign design = driven_motor_with_layer();
  design.stator.loss_tangent = 0;
  const Reading reading = read_impedance(design);
  const EquivalentCircuit circuit = circuit_of(reading, *design.stator.force_factor);
  const auto direct = equivalent_circuit(design);
  REQUIRE(direct);
  // Differences of frequencies: 0.25 kHz of 39 kHz lose two digits, and C_0 is most of the capacitance.
  CHECK(circuit.motional_resistance == Approx(direct->motional_resistance).epsilon(1e-12));
  CHECK(circuit.motional_inductance == Approx(direct->motional_inductance).epsilon(1e-11));
  CHECK(circuit.motional_capacitance == Approx(direct->motional_capacitance).epsilon(1e-11));
  CHECK(circuit.blocked_capacitance == Approx(direct->blocked_capacitance).epsilon(1e-11));
  // A published figure of this motor: 132 ohm, 82.6 mH, 0.2015 nF, f_p = 39.460 kHz, to the digits printed.
  CHECK(direct->motional_resistance == Approx(132).epsilon(4e-3));
  CHECK(direct->motional_inductance == Approx(82.6e-3).epsilon(1e-3));
  CHECK(direct->motional_capacitance == Approx(0.2015e-9).epsilon(3e-4));
  CHECK(series_resonance(*direct) == Approx(39000).epsilon(1e-14));
  CHECK(parallel_resonance(*direct) == Approx(39460).epsilon(2e-5));
  CHECK(capacitance_ratio(*direct) ==
        Approx(evaluate(Motor(design), {Metric::capacitance_ratio}).value).epsilon(1e-14));
  CHECK(coupling_factor(*direct) ==
        Approx(evaluate(Motor(design), {Metric::coupling_factor}).value).epsilon(1e-14));

  const MotorDesign back = with_circuit(design, circuit);
  for (const double speed : {0.0, 6.0, 12.0}) {
    const OperatingPoint p = Motor(design).operating_point(speed),
                         q = Motor(back).operating_point(speed);
    // Data that are off by 1e-11 move a wave some hundred half widths off resonance by no more than a hundred times that.
    CHECK(q.amplitude == Approx(p.amplitude).epsilon(1e-9));
    CHECK(q.electrical_power == Approx(p.electrical_power).epsilon(1e-9));
  }
}

TEST_CASE("modal data of a circuit and back, to rounding (D4.4)", "[core][driven][identity]") {
  const EquivalentCircuit circuit{132, 82.6e-3, 0.2015e-9, 8.5e-9, 0.55};
  const auto back = equivalent_circuit(with_circuit(driven_motor(), circuit));
  REQUIRE(back);
  // Ten roundings of 1.1e-16 at most.
  CHECK(back->motional_resistance == Approx(circuit.motional_resistance).epsilon(2e-15));
  CHECK(back->motional_inductance == Approx(circuit.motional_inductance).epsilon(2e-15));
  CHECK(back->motional_capacitance == Approx(circuit.motional_capacitance).epsilon(2e-15));
  CHECK(back->blocked_capacitance == circuit.blocked_capacitance);
  CHECK(back->force_factor == circuit.force_factor);
  CHECK(!equivalent_circuit(ring_motor()));
}

TEST_CASE(
    "a factor on mass, damping, stiffness and the square of the force factor leaves the circuit "
    "and not the motor (D4.4)",
    "[core][driven][limit]") {
  const MotorDesign design = driven_motor_with_layer();
  EquivalentCircuit circuit = *equivalent_circuit(design);
  circuit.force_factor *= 1.5;
  const MotorDesign scaled = with_circuit(design, circuit);
  CHECK(*scaled.stator.modal_mass == Approx(2.25 * *design.stator.modal_mass).epsilon(1e-14));
  const Reading before = read_impedance(design), after = read_impedance(scaled);
  CHECK(after.series == Approx(before.series).epsilon(1e-14));
  CHECK(after.conductance == Approx(before.conductance).epsilon(1e-13));
  CHECK(after.bandwidth == Approx(before.bandwidth).epsilon(1e-11));
  CHECK(after.low_capacitance == Approx(before.low_capacitance).epsilon(1e-14));
  // The same contact against a force half as large again: the motor starts at two thirds of the voltage but for what
  // the modes' own force takes, which is small at the small amplitude of a start.
  const double start = evaluate(Motor(design), {Metric::start_voltage}).value;
  const double easier = evaluate(Motor(scaled), {Metric::start_voltage}).value;
  CHECK(easier < 0.9 * start);
}

TEST_CASE(
    "under load the circuit takes the current and the power of the terminals (D4.1, D4.2, D4.5)",
    "[core][driven][identity]") {
  MotorDesign given = driven_motor_with_layer();
  given.stator.voltage.reset();
  given.stator.amplitude = 1.7e-6;
  for (const MotorDesign& design : {driven_motor(), driven_motor_with_layer(95, 41.5e3), given}) {
    const Motor motor(design);
    for (const double speed : {0.0, 3.0, 9.0, 14.5}) {
      const OperatingPoint p = motor.operating_point(speed);
      REQUIRE(p.status == PointStatus::ok);
      const EquivalentCircuit loaded =
          with_contact(*equivalent_circuit(design), contact_circuit(motor, p));
      const std::complex<double> y =
          admittance(loaded, design.stator.loss_tangent, drive_frequency(design));
      // Reactances of the modes cancel to a few per cent; powers balance to 1e-12.
      CHECK(p.voltage * std::abs(y) == Approx(p.phase_current).epsilon(1e-11));
      CHECK(2 * p.voltage * p.voltage * y.real() == Approx(p.electrical_power).epsilon(1e-10));
    }
  }
}

TEST_CASE("the circuit under load resonates where the loaded stator does (D3.1, D4.5)",
          "[core][driven][identity]") {
  const MotorDesign design = driven_motor_with_layer();
  const Motor motor(design);
  const OperatingPoint no_load =
      motor.operating_point(evaluate(motor, {Metric::no_load_speed}).value);
  const EquivalentCircuit loaded =
      with_contact(*equivalent_circuit(design), contact_circuit(motor, no_load));
  CHECK(series_resonance(loaded) ==
        Approx(evaluate(motor, {Metric::loaded_resonance}).value).epsilon(1e-12));
  // At no load the contact takes no more than what the layer and the stator lose.
  CHECK(contact_circuit(motor, no_load).resistance < 0.1 * loaded.motional_resistance);
}

TEST_CASE("the admittance of the free stator is that of its modes (D4.4)",
          "[core][driven][identity]") {
  MotorDesign design = driven_motor();
  design.stator.loss_tangent = 0;
  const EquivalentCircuit circuit = *equivalent_circuit(design);
  const Reading reading = read_impedance(design);
  CHECK(admittance(circuit, 0, reading.series).real() ==
        Approx(reading.conductance).epsilon(1e-12));
  CHECK(admittance(circuit, 0, 1e-3).imag() / (2e-3 * kPi) ==
        Approx(reading.low_capacitance).epsilon(1e-12));
}
