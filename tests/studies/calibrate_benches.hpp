// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "calibrate_support.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

/// Motors with known parameters before the instruments of a bench.
namespace twum::test {

// Normal numbers by Box and Muller; 1 - u is never 0.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed, 0, 0) {}
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(1 - random_.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random_.uniform());
  }

 private:
  optim::Random random_;
};

inline double metric(const MotorDesign& design, Metric which, Argument argument = Argument::none,
                     double at = 0) {
  return evaluate(Motor(design), MetricRequest{which, argument, at}).value;
}

// A table of numbers with their standard deviations, of which noise is a multiple.
struct Bench {
  std::string motor;
  std::string variables;
  std::vector<ParameterValue> truth;
  std::function<std::string(const MotorDesign&, Noise&, double)> csv;  // of the true motor
  bool long_columns{false};  // enough for a scatter of each
};

// Torques at speeds under two preloads that the bench sets.
inline std::string preloads(const MotorDesign& design, Noise& noise, double size) {
  std::string csv = "speed [rpm],torque [N.m],torque_sd [N.m],preload [N]\n";
  for (const double preload : {120.0, 180.0}) {
    const Motor motor(with(design, Parameter::preload, preload));
    for (const int rpm : {20, 60, 90, 110, 120, 130}) {
      const double torque = motor.operating_point(rpm * kRpm).torque;
      csv += number(rpm) + "," + number(torque + size * 4e-3 * noise()) + ",4e-3," +
             number(preload) + "\n";
    }
  }
  return csv;
}

// What a load bench reads at a torque: speed, current and power.
inline std::string loads(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "torque [N.m],speed_at [rpm],speed_at_sd [rpm],phase_current_at [A],phase_current_at_sd [A],"
      "electrical_power_at [W],electrical_power_at_sd [W]\n";
  for (const double torque : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const auto at = [&](Metric which) { return metric(design, which, Argument::torque, torque); };
    csv += number(torque) + "," + number(at(Metric::speed_at) / kRpm + size * 0.5 * noise()) +
           ",0.5," + number(at(Metric::phase_current_at) + size * 1e-3 * noise()) + ",1e-3," +
           number(at(Metric::electrical_power_at) + size * 0.1 * noise()) + ",0.1\n";
  }
  return csv;
}

// Numbers of the whole motor, each read a few times.
inline std::string plain(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque [N.m],holding_torque_sd [N.m]\n";
  for (int i = 0; i < 4; ++i)
    csv += number(metric(design, Metric::no_load_speed) / kRpm + size * 0.5 * noise()) + ",0.5," +
           number(metric(design, Metric::holding_torque) + size * 5e-3 * noise()) + ",5e-3\n";
  return csv;
}

// Torques at speeds, and numbers of the whole motor; as few as columns with a scatter of their own may be.
inline std::string mixture(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "speed [rpm],torque,torque_sd,no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque,"
      "holding_torque_sd\n";
  const Motor motor(design);
  for (const int rpm : {20, 40, 60, 70, 80, 90, 95, 100, 105, 110, 115, 120, 130})
    csv += number(rpm) + "," +
           number(motor.operating_point(rpm * kRpm).torque + size * 4e-3 * noise()) + ",4e-3," +
           number(metric(design, Metric::no_load_speed) / kRpm + size * 0.5 * noise()) + ",0.5," +
           number(metric(design, Metric::holding_torque) + size * 5e-3 * noise()) + ",5e-3\n";
  return csv;
}

// The fewest rows that columns with a scatter of their own may have: three more than parameters.
inline std::string short_mixture(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "speed [rpm],torque,torque_sd,no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque,"
      "holding_torque_sd\n";
  const Motor motor(design);
  for (const int rpm : {20, 60, 90, 110, 120, 130})
    csv += number(rpm) + "," +
           number(motor.operating_point(rpm * kRpm).torque + size * 4e-3 * noise()) + ",4e-3," +
           number(metric(design, Metric::no_load_speed) / kRpm + size * 0.5 * noise()) + ",0.5," +
           number(metric(design, Metric::holding_torque) + size * 5e-3 * noise()) + ",5e-3\n";
  return csv;
}

// One kind of number, read once at each place.
struct OneKind {
  Metric which;
  const char* unit;  // as in the heading
  double in_si;      // 1 of this unit
  double deviation;  // in this unit
};

inline std::string heading(const OneKind& kind) {
  const std::string name(info(kind.which).name);
  return name + " [" + kind.unit + "]," + name + "_sd [" + kind.unit + "]\n";
}

inline std::string cells(const OneKind& kind, double value, Noise& noise, double size) {
  return number(value / kind.in_si + size * kind.deviation * noise()) + "," +
         number(kind.deviation) + "\n";
}

// At these torques.
inline std::string at_torques(const MotorDesign& design, const OneKind& kind,
                              const std::vector<double>& torques, Noise& noise, double size) {
  std::string csv = "torque [N.m]," + heading(kind);
  for (const double torque : torques)
    csv += number(torque) + "," +
           cells(kind, metric(design, kind.which, Argument::torque, torque), noise, size);
  return csv;
}

// Of the whole motor, under preloads that the bench sets.
inline std::string at_preloads(const MotorDesign& design, const OneKind& kind, Noise& noise,
                               double size) {
  std::string csv = "preload [N]," + heading(kind);
  for (const double preload : {120.0, 135.0, 150.0, 165.0, 180.0, 195.0})
    csv += number(preload) + "," +
           cells(kind, metric(with(design, Parameter::preload, preload), kind.which), noise, size);
  return csv;
}

inline std::string speeds(const MotorDesign& design, Noise& noise, double size) {
  return at_torques(design, {Metric::speed_at, "rpm", kRpm, 0.5},
                    {0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.8}, noise, size);
}
inline std::string currents(const MotorDesign& design, Noise& noise, double size) {
  return at_torques(design, {Metric::phase_current_at, "A", 1, 1e-3},
                    {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, noise, size);
}
inline std::string powers(const MotorDesign& design, Noise& noise, double size) {
  return at_torques(design, {Metric::electrical_power_at, "W", 1, 0.1},
                    {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, noise, size);
}
inline std::string no_load_speeds(const MotorDesign& design, Noise& noise, double size) {
  return at_preloads(design, {Metric::no_load_speed, "rpm", kRpm, 0.5}, noise, size);
}
inline std::string holding_torques(const MotorDesign& design, Noise& noise, double size) {
  return at_preloads(design, {Metric::holding_torque, "N.m", 1, 5e-3}, noise, size);
}
inline std::string stall_torques(const MotorDesign& design, Noise& noise, double size) {
  return at_preloads(design, {Metric::stall_torque, "N.m", 1, 5e-3}, noise, size);
}
inline std::string start_voltages(const MotorDesign& design, Noise& noise, double size) {
  return at_preloads(design, {Metric::start_voltage, "V", 1, 0.5}, noise, size);
}

// A vibrometer on the stator of the running motor, at two voltages.
inline std::string amplitudes(const MotorDesign& design, Noise& noise, double size) {
  std::string csv = "speed [rpm],amplitude_at [um],amplitude_at_sd [um],voltage [V]\n";
  for (const double voltage : {110.0, 130.0}) {
    const MotorDesign under = with(design, Parameter::voltage, voltage);
    for (const int rpm : {20, 60, 90, 110, 130})
      csv += number(rpm) + "," +
             number(1e6 * metric(under, Metric::amplitude_at, Argument::speed, rpm * kRpm) +
                    size * 5e-3 * noise()) +
             ",5e-3," + number(voltage) + "\n";
  }
  return csv;
}

// What a motor needs to start, and what it starts against.
inline std::string starts(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "stall_torque [N.m],stall_torque_sd [N.m],start_voltage [V],start_voltage_sd [V]\n";
  for (int i = 0; i < 4; ++i)
    csv += number(metric(design, Metric::stall_torque) + size * 5e-3 * noise()) + ",5e-3," +
           number(metric(design, Metric::start_voltage) + size * 0.5 * noise()) + ",0.5\n";
  return csv;
}

// Admittance of a phase of the free stator, from textbook algebra of complex numbers: C_0 with its loss beside a branch of R,
// L and C in series.
inline std::complex<double> admittance(const MotorDesign& design, double frequency) {
  const auto value = [&](Parameter p) { return get(design, p); };
  const double theta = value(Parameter::force_factor);
  const double turn = 2 * std::numbers::pi * value(Parameter::resonance_frequency);
  const double l = value(Parameter::modal_mass) / (theta * theta);
  const double c = 1 / (turn * turn * l);
  const double r = turn * l / value(Parameter::quality_factor);
  const double w = 2 * std::numbers::pi * frequency;
  const std::complex<double> branch(r, w * l - 1 / (w * c));
  const std::complex<double> leak = std::complex<double>(value(Parameter::loss_tangent), 1) * w *
                                    value(Parameter::blocked_capacitance);
  return 1.0 / branch + leak;
}

// The free stator before an impedance analyser.
inline std::string circle(const MotorDesign& design, int each_way, double step, Noise& noise,
                          double size) {
  std::string csv =
      "frequency [Hz],conductance [S],conductance_sd [S],susceptance [S],susceptance_sd [S]\n";
  for (int i = -each_way; i <= each_way; ++i) {
    const double f = get(design, Parameter::resonance_frequency) + step * i;
    const auto y = admittance(design, f);
    csv += number(f) + "," + number(y.real() + size * 2e-5 * noise()) + ",2e-5," +
           number(y.imag() + size * 2e-5 * noise()) + ",2e-5\n";
  }
  return csv;
}

// An analyser that shows size and phase, the size to a part of itself.
inline std::string impedances(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "frequency [Hz],impedance [ohm],impedance_sd [ohm],impedance_phase [rad],"
      "impedance_phase_sd [rad]\n";
  for (int i = -7; i <= 7; ++i) {
    const double f = get(design, Parameter::resonance_frequency) + 45 * i;
    const auto z = 1.0 / admittance(design, f);
    csv += number(f) + "," + number(std::abs(z) * (1 + size * 5e-3 * noise())) + "," +
           number(5e-3 * std::abs(z)) + "," + number(std::arg(z) + size * 5e-3 * noise()) +
           ",5e-3\n";
  }
  return csv;
}

inline std::string long_circle(const MotorDesign& design, Noise& noise, double size) {
  return circle(design, 8, 40, noise, size);
}
inline std::string short_circle(const MotorDesign& design, Noise& noise, double size) {
  return circle(design, 7, 45, noise, size);
}

inline const Bench kPreloads{"ring-60", kThree, kTruth, preloads};
inline const Bench kMixture{"ring-60", kThree, kTruth, mixture, true};
inline const Bench kLoads{
    "drive-60",
    "force_factor: {min: 0.3 N/V, max: 0.9 N/V}, quality_factor: {min: 50, max: 400}, "
    "youngs_modulus: {min: 0.2 GPa, max: 4 GPa, scale: log}",
    {{Parameter::force_factor, 0.53},
     {Parameter::quality_factor, 140},
     {Parameter::youngs_modulus, 1e9}},
    loads};
inline const Bench kPlain{
    "ring-60",
    "kinetic_friction: {min: 0.05, max: 0.5}, amplitude: {min: 1 um, max: 2.2 um}",
    {{Parameter::kinetic_friction, 0.23}, {Parameter::amplitude, 1.52e-6}},
    plain};
inline const Bench kCircle{
    "drive-60",
    "resonance_frequency: {min: 38 kHz, max: 40 kHz}, quality_factor: {min: 50, max: 400}, "
    "modal_mass: {min: 10 g, max: 60 g}, blocked_capacitance: {min: 1 nF, max: 20 nF}",
    {{Parameter::resonance_frequency, 39020},
     {Parameter::quality_factor, 160},
     {Parameter::modal_mass, 0.027},
     {Parameter::blocked_capacitance, 8e-9}},
    long_circle,
    true};
inline const Bench kShortCircle{kCircle.motor, kCircle.variables, kCircle.truth, short_circle,
                                true};
inline std::string shortest_circle(const MotorDesign& design, Noise& noise, double size) {
  return circle(design, 3, 100, noise, size);
}
inline const Bench kShortestCircle{kCircle.motor, kCircle.variables, kCircle.truth, shortest_circle,
                                   true};
inline const Bench kShortMixture{kMixture.motor, kMixture.variables, kMixture.truth, short_mixture,
                                 true};
inline const char* const kFriction = "kinetic_friction: {min: 0.05, max: 0.5}";
inline const Bench kSpeeds{kPreloads.motor, kPreloads.variables, kPreloads.truth, speeds};
inline const Bench kCurrents{
    "drive-60",
    "force_factor: {min: 0.3 N/V, max: 0.9 N/V}, quality_factor: {min: 50, max: 400}",
    {{Parameter::force_factor, 0.53}, {Parameter::quality_factor, 140}},
    currents};
inline const Bench kPowers{kCurrents.motor, kCurrents.variables, kCurrents.truth, powers};
inline const Bench kNoLoadSpeeds{"ring-60",
                                 "amplitude: {min: 1 um, max: 2.2 um}",
                                 {{Parameter::amplitude, 1.52e-6}},
                                 no_load_speeds};
inline const Bench kHoldingTorques{
    "ring-60", kFriction, {{Parameter::kinetic_friction, 0.23}}, holding_torques};
inline const Bench kStallTorques{
    "ring-60", kFriction, {{Parameter::kinetic_friction, 0.23}}, stall_torques};
inline const Bench kStartVoltages{"drive-60",
                                  "force_factor: {min: 0.3 N/V, max: 0.9 N/V}",
                                  {{Parameter::force_factor, 0.57}},
                                  start_voltages};
inline const Bench kImpedances{kCircle.motor, kCircle.variables, kCircle.truth, impedances};
inline const Bench kAmplitudes{
    "drive-60",
    "force_factor: {min: 0.3 N/V, max: 0.9 N/V}, quality_factor: {min: 50, max: 400}",
    {{Parameter::force_factor, 0.53}, {Parameter::quality_factor, 140}},
    amplitudes};
inline const Bench kStarts{
    "drive-60",
    "kinetic_friction: {min: 0.05, max: 0.5}, force_factor: {min: 0.3 N/V, max: 0.9 N/V}",
    {{Parameter::kinetic_friction, 0.22}, {Parameter::force_factor, 0.57}},
    starts};

struct Named {
  const char* name;
  const Bench& bench;
};
inline const Named kBenches[] = {{"preloads", kPreloads},
                                 {"loads", kLoads},
                                 {"plain", kPlain},
                                 {"circle", kCircle},
                                 {"short circle", kShortCircle},
                                 {"mixture", kMixture},
                                 {"amplitudes", kAmplitudes},
                                 {"starts", kStarts},
                                 {"impedances", kImpedances},
                                 {"shortest circle", kShortestCircle},
                                 {"short mixture", kShortMixture},
                                 {"speeds", kSpeeds},
                                 {"currents", kCurrents},
                                 {"powers", kPowers},
                                 {"no-load speeds", kNoLoadSpeeds},
                                 {"holding torques", kHoldingTorques},
                                 {"stall torques", kStallTorques},
                                 {"starting voltages", kStartVoltages}};
/// So many of them, the last, have short columns or a single kind of data.
inline constexpr std::size_t kFewNumbers = 9;

struct BenchCase : Case {
  explicit BenchCase(const Bench& bench) {
    motor = bench.motor;
    variables = bench.variables;
  }
};

inline MotorDesign truth_of(const Bench& bench) {
  return with(BenchCase(bench).design(), bench.truth);
}

}  // namespace twum::test
