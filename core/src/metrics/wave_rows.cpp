// SPDX-License-Identifier: Apache-2.0
#include "metrics/wave_rows.hpp"
#include "metrics/differentiator.hpp"
#include "metrics/motor_parts.hpp"

#include "drive/driven_wave.hpp"

#include <twum/core/parameters.hpp>

#include <algorithm>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

Row row_of(const MetricDerivative& derivative) { return {derivative.gradient, 0}; }

Row combined(const Row& a, double x, const Row& b, double y) {
  Row row;
  for (std::size_t p = 0; p < kParameterCount; ++p) row.in[p] = x * a.in[p] + y * b.in[p];
  row.in_speed = x * a.in_speed + y * b.in_speed;
  return row;
}

// Of a wave at another speed of the rotor: U = sqrt(R^2 + I^2) / Theta, and the lag is the angle of R and I (D2.4).
void add_speed(WaveRows& rows, const Motor& motor, double speed, double voltage) {
  const MotorDesign& design = motor.design();
  const DrivenWaves waves(design, MotorParts::model(motor).track);
  const DrivenWaves::LevelSlopes s = waves.slopes(design.stator.amplitude, speed);
  const WaveBalance<double> w = s.in_amplitude.wave.balance, slope = s.balance_per_speed;
  const double square = w.real * w.real + w.imaginary * w.imaginary;
  rows.torque.in_speed = s.numbers.torque.d[contact::kInSpeed];
  rows.voltage.in_speed = voltage * (w.real * slope.real + w.imaginary * slope.imaginary) / square;
  rows.lag.in_speed = (w.real * slope.imaginary - w.imaginary * slope.real) / square;
}

// Of the angle of 1 + Z_s Y, by which the frame of R and I lags behind the voltage (D8.2): that of x is Im((1 + Z_s Y)_x / (1 + Z_s Y)).
Row divider_row(const MotorDesign& design, bool fixed_static_friction) {
  Row row;
  const auto modes = stator_modes(design);
  if (!modes || !modes->series) return row;
  using Complex = std::complex<double>;
  const double omega = 2 * std::numbers::pi * drive_frequency(design);
  const Complex i{0, 1}, loss{modes->loss_tangent, 1};
  const Complex impedance{modes->series->resistance, omega * modes->series->inductance};
  const Complex admittance = omega * modes->capacitance * loss;
  const Complex blocked = 1.0 + impedance * admittance;
  const std::pair<Parameter, Complex> slopes[] = {
      {Parameter::frequency,
       2 * std::numbers::pi *
           (i * modes->series->inductance * admittance + impedance * modes->capacitance * loss)},
      {Parameter::driver_inductance, i * omega * admittance},
      {Parameter::driver_resistance, admittance},
      {Parameter::blocked_capacitance, impedance * omega * loss},
      {Parameter::loss_tangent, impedance * omega * modes->capacitance}};
  const auto moves =
      std::make_unique<ParameterJacobian>(parameter_jacobian(design, fixed_static_friction));
  for (const auto& [parameter, slope] : slopes)
    for (std::size_t p = 0; p < kParameterCount; ++p)
      row.in[p] += (slope / blocked).imag() * (*moves)[index_of(parameter)][p];
  return row;
}

}  // namespace

WaveRows wave_rows(const Motor& motor, double speed, bool modes, bool fixed_static_friction) {
  Differentiator numbers(motor, fixed_static_friction);
  return wave_rows(numbers, motor, speed, modes, fixed_static_friction);
}

WaveRows wave_rows(Differentiator& numbers, const Motor& motor, double speed, bool modes,
                   bool fixed_static_friction) {
  std::vector<MetricRequest> asked{{Metric::torque_at, Argument::speed, speed}};
  if (modes)
    asked.insert(asked.end(), {{Metric::drive_voltage_at, Argument::speed, speed},
                               {Metric::phase_lag_at, Argument::speed, speed}});
  std::vector<MetricDerivative> found;
  for (const MetricRequest& request : asked) found.push_back(numbers.differentiate(request));
  WaveRows rows;
  for (const MetricDerivative& d : found) rows.smoothness = std::max(rows.smoothness, d.smoothness);
  if (rows.smoothness == Smoothness::undefined) return rows;
  rows.torque = row_of(found[0]);
  if (!modes) {
    rows.torque.in_speed = differentiate_in_speed(motor, speed).torque;
    return rows;
  }
  rows.voltage = row_of(found[1]);
  rows.lag = combined(row_of(found[2]), 1, divider_row(motor.design(), fixed_static_friction), -1);
  add_speed(rows, motor, speed, found[1].value.value);
  return rows;
}

Row WaveSlopes::along_wave(Row row) const {
  const double in_amplitude = row[Parameter::amplitude], in_frequency = row[Parameter::frequency];
  row[Parameter::amplitude] = row[Parameter::frequency] = 0;
  const Row moved = combined(amplitude, in_amplitude, frequency, in_frequency);
  return combined(row, 1, moved, 1);
}

WaveSlopes keeping(const Row& one, const Row& other) {
  constexpr Parameter kA = Parameter::amplitude, kF = Parameter::frequency;
  const double determinant = one[kA] * other[kF] - one[kF] * other[kA];
  WaveSlopes slopes{combined(other, one[kF] / determinant, one, -other[kF] / determinant),
                    combined(one, other[kA] / determinant, other, -one[kA] / determinant)};
  for (Row* row : {&slopes.amplitude, &slopes.frequency}) (*row)[kA] = (*row)[kF] = 0;
  return slopes;
}

WaveSlopes keeping(const Row& one) {
  constexpr Parameter kA = Parameter::amplitude, kF = Parameter::frequency;
  WaveSlopes slopes{combined(one, -1 / one[kA], one, 0), {}};
  slopes.amplitude[kA] = 0;  // of the frequency's own derivative see frequency
  slopes.frequency[kF] = 1;
  return slopes;
}

}  // namespace twum::inline v0_1::core
