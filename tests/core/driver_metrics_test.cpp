// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/driven_motors.hpp"
#include "support/known_value.hpp"
#include "support/plate_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>

#include <cmath>
#include <complex>

// What the maker of a driver or of a housing asks for.
namespace {

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinRel;

double at_speed(const MotorDesign& design, Metric metric, double speed) {
  return known_value(design, {metric, Argument::speed, speed});
}

MotorDesign without_rotor(MotorDesign design) {
  design.preload = 0;
  return design;
}

// Phasor of the displacement of a mode per volt of its phase.
std::complex<double> response(const MotorDesign& design, double omega) {
  const Stator& s = design.stator;
  const double k =
      2 * kPi * *s.resonance_frequency * 2 * kPi * *s.resonance_frequency * *s.modal_mass;
  return *s.force_factor /
         std::complex<double>(k - omega * omega * *s.modal_mass, omega * s.modal_damping);
}

}  // namespace

TEST_CASE("the free amplitude is that of a driven oscillator, whatever the rotor (D3.6)",
          "[core][driven]") {
  for (const double frequency : {38.2e3, 39.1e3, 40.8e3, 44e3}) {
    const MotorDesign design = driven_motor(120, frequency);
    const double omega = 2 * kPi * frequency;
    const double found = known_value(design, {Metric::free_amplitude});
    // k - omega^2 m cancels at most to a hundredth of k here: 1e2 roundings.
    CHECK_THAT(found, WithinRel(std::sqrt(2.0) * 120 * std::abs(response(design, omega)), 1e-12));
    // The wave that the solver of the balance finds where nothing touches the stator, to its tolerance.
    for (const double speed : {0.0, 3.0})
      CHECK_THAT(at_speed(without_rotor(design), Metric::amplitude_at, speed),
                 WithinRel(found, 1e-9));
    for (const double preload : {1.0, 170.0, 1e4}) {
      MotorDesign other = design;
      other.preload = preload;
      CHECK(known_value(other, {Metric::free_amplitude}) == found);
    }
  }
}

TEST_CASE("of unequal phases the share of the forward wave drives the free stator (D3.6)",
          "[core][driven]") {
  const MotorDesign design = unequal_motor();
  const Imbalance& unequal = *design.stator.imbalance;
  const double share = std::abs(1.0 + std::polar(unequal.voltage_ratio, unequal.phase_error)) / 2;
  CHECK_THAT(known_value(design, {Metric::free_amplitude}),
             WithinRel(share * known_value(driven_motor(), {Metric::free_amplitude}), 1e-13));
}

TEST_CASE("apparent power and matching inductance follow from a phase's current (D4.6, D4.7)",
          "[core][driven]") {
  for (const double frequency : {40.8e3, 42e3}) {
    const MotorDesign design = driven_motor_with_layer(120, frequency);
    for (const double speed : {0.0, 5.0, 12.0}) {
      const double power = at_speed(design, Metric::electrical_power_at, speed);
      const double current = at_speed(design, Metric::phase_current_at, speed);
      const double apparent = at_speed(design, Metric::apparent_power_at, speed);
      CHECK_THAT(apparent, WithinRel(2 * 120 * current, 1e-13));
      CHECK_THAT(apparent * at_speed(design, Metric::power_factor_at, speed),
                 WithinRel(power, 1e-12));
      // Pythagoras: what of the current carries no power, through the reactance of the inductance. The difference of
      // squares loses as many digits as the power factor takes.
      const double active = power / 240, reactive = std::sqrt(current * current - active * active);
      const double inductance = at_speed(design, Metric::matching_inductance_at, speed);
      CHECK_THAT(inductance, WithinRel(120 / (2 * kPi * frequency * reactive), 1e-11));
    }
  }
}

TEST_CASE("of unequal phases both powers count, and the first phase is matched (D4.6, D4.7)",
          "[core][driven]") {
  const MotorDesign equal = driven_motor();
  MotorDesign nearly = equal;
  nearly.stator.imbalance = Imbalance{1 + 1e-9, 1e-9, 0};
  // Differences of 1e-9 of the voltage change the current by about as much, ten times more near the resonance.
  for (const Metric metric : {Metric::apparent_power_at, Metric::matching_inductance_at})
    CHECK_THAT(at_speed(nearly, metric, 5), WithinRel(at_speed(equal, metric, 5), 1e-7));
  // A second phase at twice the voltage has about twice the blocked current, which is most of it: 1 + 2 * 2 in place of 2.
  MotorDesign twice = equal;
  twice.stator.loss_tangent = 0;
  twice.stator.force_factor = 1e-3;  // hardly a motional current
  twice.stator.voltage = 120 * 550;  // and the same force
  MotorDesign once = twice;
  twice.stator.imbalance = Imbalance{2, 0, 0};
  const double omega = 2 * kPi * 40.8e3, blocked = omega * 8.5e-9 * 66e3 * 66e3;
  // The motional current is (1e-3 / 0.55)^2 of the blocked one's size.
  CHECK_THAT(at_speed(once, Metric::apparent_power_at, 5), WithinRel(2 * blocked, 1e-4));
  CHECK_THAT(at_speed(twice, Metric::apparent_power_at, 5), WithinRel(5 * blocked, 1e-4));
  for (const MotorDesign& design : {once, twice})
    CHECK_THAT(at_speed(design, Metric::matching_inductance_at, 5),
               WithinRel(1 / (omega * omega * 8.5e-9), 1e-4));
}

TEST_CASE("an inductive current cannot be matched by an inductance (D4.7)", "[core][driven]") {
  // Between its series and its parallel resonance, 39 and 39.46 kHz, the free stator is inductive.
  const MotorDesign design = without_rotor(driven_motor(120, 39.2e3));
  const MetricRequest request{Metric::matching_inductance_at, Argument::speed, 0};
  CHECK(evaluate(Motor(design), request).status == MetricStatus::undefined);
  CHECK(differentiate(Motor(design), request).smoothness == Smoothness::undefined);
}

TEST_CASE("metrics of the driver need modal data, and a voltage where it acts", "[core][driven]") {
  for (const Metric metric : {Metric::stator_mass, Metric::free_amplitude})
    CHECK(evaluate(Motor(ring_motor()), {metric}).status == MetricStatus::undefined);
  MotorDesign given = driven_motor();  // an amplitude in place of the voltage, which follows
  given.stator.voltage.reset();
  CHECK(evaluate(Motor(given), {Metric::free_amplitude}).status == MetricStatus::undefined);
  CHECK(at_speed(given, Metric::apparent_power_at, 5) > 0);
}

TEST_CASE("the mass of a stator is that of its bodies (P4.9)", "[core][stator]") {
  const auto ring = [](double inner, double outer, double height, double density) {
    return kPi * (outer * outer - inner * inner) * height * density;
  };
  const MotorDesign design = plate_motor();
  const stator::StatorGeometry& g = *design.stator.geometry;
  const double metal = g.substrate.density;
  const double slots = g.teeth->count * g.teeth->slot_width *
                       (g.teeth->outer_radius - g.teeth->inner_radius) * g.teeth->height;
  const double bodies =
      ring(g.web->inner_radius, g.web->outer_radius, g.web->thickness, metal) +
      ring(g.web->outer_radius, g.substrate.outer_radius, g.substrate.thickness, metal) +
      ring(g.teeth->inner_radius, g.teeth->outer_radius, g.teeth->height, metal) - slots * metal +
      ring(g.ceramic.inner_radius, g.ceramic.outer_radius, g.ceramic.thickness, g.ceramic.density) +
      ring(g.ceramic.inner_radius, g.ceramic.outer_radius, g.glue.thickness, g.glue.density);
  CHECK_THAT(known_value(design, {Metric::stator_mass}), WithinRel(bodies, 1e-13));
}
