// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/driven_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

// Motors under a voltage: another program's solutions, identities, limits, and what is said where there is no wave.
namespace {

using namespace twum;
using namespace twum::test;

struct ReferenceWave {
  std::string name;
  bool upper{};
  std::map<std::string, double> at;
};

std::vector<ReferenceWave> reference_waves() {
  std::ifstream file(TWUM_TEST_DATA "/reference/stator.csv");
  std::string line, cell;
  std::vector<std::string> head;
  std::getline(file, line);
  for (std::stringstream s(line); std::getline(s, cell, ',');) head.push_back(cell);
  std::vector<ReferenceWave> rows;
  while (std::getline(file, line)) {
    ReferenceWave row;
    std::size_t i = 0;
    for (std::stringstream s(line); std::getline(s, cell, ','); ++i) {
      if (i == 0) row.name = cell;
      if (i == 1) row.upper = cell == "upper";
      if (i > 1) row.at[head[i]] = std::stod(cell);
    }
    rows.push_back(row);
  }
  return rows;
}

MotorDesign design_of(const ReferenceWave& row) {
  const auto& r = row.at;
  MotorDesign d = driven_motor(r.at("U_peak") / std::numbers::sqrt2, r.at("f"));
  Stator& s = d.stator;
  s.wavelengths = r.at("n"), s.contact_radius = r.at("r"), s.contact_width = r.at("b");
  s.neutral_plane_distance = r.at("a");
  s.modal_mass = r.at("m"), s.modal_damping = r.at("d"), s.force_factor = r.at("Theta");
  s.resonance_frequency = std::sqrt(r.at("k") / r.at("m")) / (2 * kPi);
  s.blocked_capacitance = r.at("C0"), s.loss_tangent = r.at("tan_delta");
  s.branch = row.upper ? Branch::running : Branch::dead;
  d.layer.thickness = r.at("h"), d.layer.youngs_modulus = r.at("E");
  d.layer.given_shear_modulus = r.at("G"), d.layer.given_shear_viscosity = r.at("gamma");
  d.layer.given_inertia = r.at("inertia");
  d.friction = {r.at("mu"), r.at("mu")};
  d.preload = r.at("F_N");
  return d;
}

double value(const Motor& motor, const MetricRequest& request) {
  const MetricValue found = evaluate(motor, request);
  REQUIRE(found.status == MetricStatus::ok);
  return found.value;
}

MetricStatus status(const Motor& motor, const MetricRequest& request) {
  return evaluate(motor, request).status;
}

}  // namespace

TEST_CASE("waves of another program under a voltage (D2.3, D2.4, D2.6, D2.7, D4.1, D4.2)",
          "[core][driven][differential]") {
  Deviation wave("amplitude and phase lag of the reference waves", 1e-8);
  Deviation power("torque and electrical power of the reference waves", 1e-8);
  Deviation slow("Jacobian of the slow flow at the reference waves", 1e-6);
  for (const ReferenceWave& row : reference_waves()) {
    CAPTURE(row.name, row.upper);
    const auto& r = row.at;
    const MotorDesign design = design_of(row);
    const Motor motor(design);
    const OperatingPoint p = motor.operating_point(r.at("Omega"));
    REQUIRE(p.status == PointStatus::ok);
    // The digits printed are good to 1e-9.
    wave.add(p.amplitude, r.at("A"), r.at("A"));
    wave.add(p.phase_lag, r.at("phi"), 1);
    power.add(p.torque, r.at("torque"), r.at("mu") * r.at("F_N") * r.at("r"));
    power.add(p.electrical_power, r.at("P_el"), r.at("P_el"));
    power.add(p.phase_current, r.at("I_rms_per_phase"), r.at("I_rms_per_phase"));
    power.add(p.voltage, *design.stator.voltage, *design.stator.voltage);
    const std::vector<WaveState> states = motor.wave_states(r.at("Omega"));
    CHECK(states.size() == static_cast<std::size_t>(r.at("solutions")));
    const WaveState& state = row.upper ? states.back() : states.front();
    CHECK(state.running == row.upper);
    // Derivatives magnify the amplitude's error by the bend of F near the ends of zones, some hundred times.
    slow.add(state.determinant, r.at("det_J"), r.at("det_J"));
    slow.add(state.trace, r.at("trace_J"), r.at("trace_J"));
  }
  CHECK(wave.holds());
  CHECK(power.holds());
  CHECK(slow.holds());
}

TEST_CASE(
    "electrical power is output and every loss, and half of the real part of u I* (D4.1, D4.2, "
    "D4.3)",
    "[core][driven][identity]") {
  for (const MotorDesign& design : {driven_motor(), driven_motor_with_layer(95, 41.5e3)}) {
    const Motor motor(design);
    const Stator& s = design.stator;
    for (const double speed : {-2.0, 0.0, 3.0, 9.0, 12.0, 14.5}) {
      const OperatingPoint p = motor.operating_point(speed);
      REQUIRE(p.status == PointStatus::ok);
      const double parts =
          p.output_power + p.friction_power + p.layer_loss + p.stator_loss + p.dielectric_loss;
      // The contact's powers balance to 1e-12 of their scale, (T7.10).
      CHECK(p.electrical_power == Approx(parts).epsilon(1e-10));
      const std::complex<double> i(0, 1), u = p.voltage * std::numbers::sqrt2,
                                          tan_delta = i * s.loss_tangent;
      const double omega = 2 * kPi * s.frequency;
      const std::complex<double> current =
          i * omega * s.blocked_capacitance * (1.0 - tan_delta) * u +
          i * omega * *s.force_factor * p.amplitude * std::polar(1.0, -p.phase_lag);
      CHECK(std::real(u * std::conj(current)) == Approx(p.electrical_power).epsilon(1e-10));
      CHECK(std::abs(current) == Approx(std::numbers::sqrt2 * p.phase_current).epsilon(1e-12));
      CHECK(p.power_factor == Approx(0.5 * p.electrical_power / (p.voltage * p.phase_current)));
      CAPTURE(speed, p.electrical_power, p.output_power);
      if (p.output_power > 0)
        CHECK(p.overall_efficiency() == Approx(p.output_power / p.electrical_power));
      else if (p.electrical_power > 0)
        CHECK(p.overall_efficiency() == 0);
      else
        CHECK(std::isnan(p.overall_efficiency()));
    }
  }
}

TEST_CASE("the voltage that an amplitude takes gives that amplitude (D2.4)",
          "[core][driven][identity]") {
  MotorDesign given = driven_motor_with_layer();
  given.stator.voltage.reset();
  given.stator.amplitude = 1.7e-6;
  for (const double speed : {0.0, 6.0, 12.0}) {
    const OperatingPoint p = Motor(given).operating_point(speed);
    const OperatingPoint back =
        Motor(with(given, Parameter::voltage, p.voltage)).operating_point(speed);
    REQUIRE(back.status == PointStatus::ok);
    // The last secant step of the search leaves 1e-15 of the amplitude; H loses some digits where its parts cancel.
    CHECK(back.amplitude == Approx(1.7e-6).epsilon(1e-12));
    CHECK(back.torque == Approx(p.torque).epsilon(1e-10));
  }
  CHECK(Motor(given).wave_states(0).empty());
}

TEST_CASE("the default motor starts, holds and resonates where its source says (D3.1, D3.2, D3.4)",
          "[core][driven][differential]") {
  const Motor motor(driven_motor());
  // Three digits are printed.
  CHECK(value(motor, {Metric::start_voltage}) == Approx(119.6).epsilon(5e-4));
  CHECK(value(Motor(driven_motor_with_layer()), {Metric::start_voltage}) ==
        Approx(117.7).epsilon(5e-4));
  CHECK(value(Motor(driven_motor_with_layer(120, 42e3)), {Metric::start_voltage}) ==
        Approx(92.0).epsilon(5e-4));
  // Found by following the branches over frequency, at 65 V and 0.3 rad/s in place of rest.
  const Motor weak(driven_motor(65));
  CHECK(value(weak, {Metric::pull_out_frequency}) == Approx(40338).epsilon(1e-3));
  CHECK(value(weak, {Metric::start_frequency}) == Approx(43671).epsilon(2e-5));
  // (D3.1) where R vanishes: there the voltage needed has the phase of 90 degrees.
  const double loaded = value(motor, {Metric::loaded_resonance});
  MotorDesign there = driven_motor();
  const double no_load = value(motor, {Metric::no_load_speed});
  there.stator.amplitude = motor.operating_point(no_load).amplitude;
  there.stator.voltage.reset();
  there.stator.frequency = loaded;
  const OperatingPoint at = Motor(there).operating_point(no_load * loaded / 40.8e3);
  // An elastic layer feels the ratio of speed and frequency alone (C8.10).
  CHECK(at.phase_lag == Approx(kPi / 2).margin(1e-9));
}

TEST_CASE("at its thresholds the number of waves changes", "[core][driven][limit]") {
  const double start = value(Motor(driven_motor()), {Metric::start_voltage}),
               hold = value(Motor(driven_motor()), {Metric::hold_voltage});
  const auto waves = [](double volts) { return Motor(driven_motor(volts)).wave_states(0).size(); };
  // A fold is quadratic: its force is known to 1e-12.
  for (const double offset : {1e-3, 1e-6, 1e-9}) {
    CHECK(waves(start * (1 - offset)) == 3);
    CHECK(waves(start * (1 + offset)) == 1);
    CHECK(waves(hold * (1 + offset)) == 3);
    CHECK(waves(hold * (1 - offset)) == 1);
  }
  // Near the hold fold the running wave lags by less than a quarter of a turn.
  const std::vector<WaveState> held = Motor(driven_motor(hold * 1.0001)).wave_states(0);
  CHECK(held.back().running);
  CHECK(held.back().phase_lag < kPi / 2);
}

TEST_CASE("a motor whose running wave ends above rest has a curve without stall torque",
          "[core][driven][edge]") {
  const Motor motor(driven_motor_with_layer(50));
  CHECK(status(motor, {Metric::stall_torque}) == MetricStatus::pulled_out);
  CHECK(motor.operating_point(0).status == PointStatus::pulled_out);
  const double torque = value(motor, {Metric::pull_out_torque});
  CHECK(value(motor, {Metric::max_torque}) >= torque);
  CHECK(value(motor, {Metric::no_load_speed}) > 10);
  CHECK(value(motor, {Metric::peak_power}) > 0);
  // Loads between: both ways agree.
  const double speed = value(motor, {Metric::speed_at, Argument::torque, 0.5 * torque});
  CHECK(value(motor, {Metric::torque_at, Argument::speed, speed}) ==
        Approx(0.5 * torque).epsilon(1e-9));
  CHECK(status(motor, {Metric::speed_at, Argument::torque, 1.05 * torque}) != MetricStatus::ok);
}

TEST_CASE("a curve that begins with a torque against the motion drives further on",
          "[core][driven][edge]") {
  const Motor motor(driven_motor(40, 39'671.6));
  REQUIRE(value(motor, {Metric::pull_out_torque}) < 0);
  const double speed = value(motor, {Metric::no_load_speed});
  const double offset = 1e-3 * speed;
  CHECK(std::fabs(motor.operating_point(speed).torque) <= 1e-9 * motor.holding_torque());
  CHECK(motor.operating_point(speed - offset).torque > 0);  // it runs there by itself
  CHECK(motor.operating_point(speed + offset).torque < 0);
  const double most = value(motor, {Metric::max_torque}),
               power = value(motor, {Metric::peak_power});
  for (double s = motor.first_speed() + offset; s < speed; s += 0.02 * speed) {
    const OperatingPoint p = motor.operating_point(s);
    CHECK(p.torque <= most * (1 + 1e-9));
    CHECK(p.torque * s <= power * (1 + 1e-9));
  }
  CHECK(value(motor, {Metric::torque_at, Argument::speed,
                      value(motor, {Metric::speed_at, Argument::torque, 0.5 * most})}) ==
        Approx(0.5 * most).epsilon(1e-9));
}

TEST_CASE("what has no wave says why", "[core][driven][edge]") {
  const Motor running(driven_motor());
  CHECK(status(running, {Metric::pull_out_torque}) == MetricStatus::does_not_pull_out);
  MotorDesign lossy = driven_motor(30);
  lossy.stator.modal_damping = 300;
  const Motor weak(lossy);
  CHECK(status(weak, {Metric::stall_torque}) == MetricStatus::no_running_branch);
  CHECK(status(weak, {Metric::peak_power}) == MetricStatus::no_running_branch);
  CHECK(weak.operating_point(3).status == PointStatus::no_running_branch);
  MotorDesign dead = driven_motor(100);
  dead.stator.branch = Branch::dead;
  CHECK(Motor(dead).operating_point(0).status == PointStatus::ok);
  // A turning rotor feeds the dead wave.
  CHECK(Motor(dead).operating_point(5).status == PointStatus::unstable_amplitude);
  dead.stator.voltage = 125;
  CHECK(Motor(dead).operating_point(0).status == PointStatus::no_dead_branch);
  // Below the free resonance there is one wave: it starts and holds at any voltage.
  const Motor below(driven_motor(120, 38.5e3));
  CHECK(value(below, {Metric::start_voltage}) == 0);
  CHECK(value(below, {Metric::hold_voltage}) == 0);
  CHECK(status(below, {Metric::start_frequency}) == MetricStatus::undefined);
  CHECK(below.wave_states(0).size() == 1);
  CHECK(below.wave_states(0)[0].running);
  CHECK(value(below, {Metric::stall_torque}) > 0);
  // So much damping that H only rises: one wave as well.
  lossy.stator.modal_damping = 1000;
  CHECK(value(Motor(lossy), {Metric::hold_voltage}) == 0);
  CHECK(Motor(lossy).operating_point(0).status == PointStatus::ok);
  lossy.stator.branch = Branch::dead;
  CHECK(Motor(lossy).operating_point(0).status == PointStatus::ok);
  const Motor given(ring_motor());
  CHECK(status(given, {Metric::start_voltage}) == MetricStatus::undefined);
  CHECK(status(given, {Metric::phase_lag_at, Argument::speed, 3}) == MetricStatus::undefined);
}

TEST_CASE("answers do not depend on what was asked before", "[core][driven][property]") {
  const Motor a(driven_motor_with_layer(70)), b(driven_motor_with_layer(70));
  for (double speed = -3; speed < 18; speed += 0.7) a.operating_point(speed);
  for (double speed = 17.3; speed > -3; speed -= 1.3) {
    const OperatingPoint p = a.operating_point(speed), q = b.operating_point(speed);
    CHECK(p.amplitude == q.amplitude);
    CHECK(p.torque == q.torque);
  }
}

TEST_CASE("the impedance fixes the modes but for a factor, and the motor feels the factor (D4.4)",
          "[core][driven][limit]") {
  const MotorDesign design = driven_motor();
  MotorDesign scaled = design;
  *scaled.stator.modal_mass *= 2;
  scaled.stator.modal_damping *= 2;
  *scaled.stator.force_factor *= std::numbers::sqrt2;
  const Motor a(design), b(scaled);
  // Without a contact both take the same current at every frequency; C_m / C_0 and Q say so.
  CHECK(value(b, {Metric::capacitance_ratio}) ==
        Approx(value(a, {Metric::capacitance_ratio})).epsilon(1e-14));
  CHECK(get(scaled, Parameter::quality_factor) ==
        Approx(get(design, Parameter::quality_factor)).epsilon(1e-14));
  CHECK(a.operating_point(9).amplitude != Approx(b.operating_point(9).amplitude).epsilon(0.01));
  const double ratio = value(a, {Metric::capacitance_ratio});
  CHECK(value(a, {Metric::coupling_factor}) == Approx(std::sqrt(ratio / (1 + ratio))));
  // f_p^2 / f_s^2 - 1 of the free stator, 39.000 and 39.460 kHz.
  CHECK(ratio == Approx(std::pow(39.460 / 39, 2) - 1).epsilon(2e-3));
}

TEST_CASE("a very stiff stator with force to match holds its amplitude", "[core][driven][limit]") {
  MotorDesign stiff = driven_motor();
  *stiff.stator.modal_mass *= 1e4;
  stiff.stator.modal_damping *= 1e4;
  *stiff.stator.force_factor *= 1e4;
  const Motor motor(stiff);
  const double at_rest = motor.operating_point(0).amplitude;
  MotorDesign given = stiff;
  given.stator.voltage.reset();
  given.stator.amplitude = at_rest;
  const Motor same(given);
  for (const double speed : {5.0, 10.0, 14.0}) {
    const OperatingPoint p = motor.operating_point(speed), q = same.operating_point(speed);
    // |F| / (modal stiffness A) is 1e-4 of its old size of order one.
    CHECK(p.amplitude == Approx(at_rest).epsilon(1e-4));
    CHECK(p.torque == Approx(q.torque).epsilon(1e-3));
  }
}

TEST_CASE("alternatives of the drive replace each other, and what is missing is named (D2.2)",
          "[core][driven][edge]") {
  const MotorDesign design = driven_motor();
  const double q = get(design, Parameter::quality_factor);
  CHECK(q == Approx(2 * kPi * 39e3 * 0.025 / 40));
  const MotorDesign by_quality = with(design, Parameter::quality_factor, q);
  CHECK(!in_use(by_quality, Parameter::modal_damping));
  CHECK(get(by_quality, Parameter::modal_damping) == Approx(40).epsilon(1e-14));
  CHECK(get(with(by_quality, Parameter::modal_mass, 0.05), Parameter::modal_damping) ==
        Approx(80).epsilon(1e-14));
  const MotorDesign by_ratio = with(design, Parameter::frequency_ratio, 1.05);
  CHECK(get(by_ratio, Parameter::frequency) == Approx(1.05 * 39e3));
  CHECK(get(with(by_ratio, Parameter::resonance_frequency, 38e3), Parameter::frequency) ==
        Approx(1.05 * 38e3));
  CHECK(!in_use(design, Parameter::amplitude));
  CHECK(!in_use(with(design, Parameter::amplitude, 1e-6), Parameter::voltage));
  CHECK_THROWS_WITH(with(ring_motor(), Parameter::voltage, 100.0),
                    Catch::Contains("resonance_frequency") && Catch::Contains("modal_mass") &&
                        Catch::Contains("force_factor") && Catch::Contains("quality_factor"));
  CHECK_THROWS_AS(with(ring_motor(), Parameter::frequency_ratio, 1.02), InputError);
  CHECK_THROWS_AS(with(ring_motor(), Parameter::quality_factor, 100.0), InputError);
  const std::vector<ParameterValue> both{{Parameter::amplitude, 1e-6}, {Parameter::voltage, 100}};
  CHECK_THROWS_AS(with(design, both), InputError);
}

TEST_CASE("ends of ranges of a driven stator keep its power balance or have a status (D4.2)",
          "[core][driven][limit]") {
  for (const ParameterInfo& row : parameter_table()) {
    if (!of_driven_stator(row.parameter)) continue;
    for (const double value : {row.min, row.max}) {
      const Motor motor(with(unequal_motor(), row.parameter, value));
      for (const double speed : {0.0, 6.0, 13.0}) {
        CAPTURE(row.name, value, speed);
        const OperatingPoint p = motor.operating_point(speed);
        if (p.status != PointStatus::ok) continue;
        const double scale = std::fabs(p.electrical_power) + p.stator_loss + p.dielectric_loss +
                             motor.holding_torque() * motor.crest_speed();
        // (T7.10) is kept to 1e-6 of the contact's own scale.
        CHECK(std::fabs(p.electrical_power - p.output_power - p.friction_power - p.layer_loss -
                        p.stator_loss - p.dielectric_loss) <= 1e-6 * scale);
      }
      for (const MetricInfo& metric : metric_table()) {
        if (metric.argument != Argument::none) continue;
        const MetricValue found = evaluate(motor, {metric.metric});
        CHECK(std::isfinite(found.value) == (found.status == MetricStatus::ok));
      }
    }
  }
}
