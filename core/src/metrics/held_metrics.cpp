// SPDX-License-Identifier: Apache-2.0
#include "metrics/held_metrics.hpp"

#include "point/slice_count.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

MetricStatus status_of(HeldStatus status) {
  switch (status) {
    case HeldStatus::ok: return MetricStatus::ok;
    case HeldStatus::torque_out_of_reach: return MetricStatus::torque_out_of_reach;
    case HeldStatus::voltage_too_low: return MetricStatus::voltage_too_low;
    case HeldStatus::amplitude_too_low: return MetricStatus::amplitude_too_low;
    case HeldStatus::outside_frequency_range: return MetricStatus::outside_frequency_range;
    case HeldStatus::unstable_amplitude: return MetricStatus::unstable_amplitude;
    case HeldStatus::no_periodic_state: return MetricStatus::no_periodic_state;
    case HeldStatus::not_converged: return MetricStatus::not_converged;
  }
  return MetricStatus::unresolved;
}

// A metric without argument has no held value, nor has what is given: the torque or the speed.
bool has_held_value(const MetricRequest& request) {
  if (request.argument != Argument::both) return true;
  const Argument argument = info(request.metric).argument;
  return argument == Argument::both || argument == Argument::speed_or_torque;
}

bool by_frequency(const MotorDesign& design) {
  return design.stator.voltage && design.stator.control == DriveControl::frequency;
}

MetricDerivative without_derivative(const MetricValue& value) {
  MetricDerivative result{value, {}, Smoothness::undefined};
  result.gradient.fill(kNoValue);
  return result;
}

Row keeps_file_voltage(Row voltage) {
  voltage[Parameter::voltage] = -1;
  return voltage;
}

Row less(Row row, const std::array<double, kParameterCount>& target, double share) {
  for (std::size_t p = 0; p < kParameterCount; ++p) row.in[p] -= share * target[p];
  return row;
}

// How the wave moves where the drive is at an end, whatever the torque.
WaveSlopes slopes_at_end(const MotorDesign& design, DriveEnd end, const WaveRows& rows) {
  switch (end) {
    case DriveEnd::voltage:
      return by_frequency(design) ? keeping(rows.lag, keeps_file_voltage(rows.voltage))
                                  : keeping(keeps_file_voltage(rows.voltage));
    case DriveEnd::upper_flank: return keeping(rows.lag);
    case DriveEnd::frequency: {
      WaveSlopes slopes = keeping(keeps_file_voltage(rows.voltage));
      slopes.amplitude[Parameter::frequency] = slopes.frequency[Parameter::frequency] = 0;
      return slopes;
    }
    case DriveEnd::friction:
    case DriveEnd::amplitude: break;
  }
  WaveSlopes file;  // its amplitude and frequency
  file.amplitude[Parameter::amplitude] = file.frequency[Parameter::frequency] = 1;
  return file;
}

// The frequency is that of the file, where it may follow from others: f = ratio f_r, and f_r from the geometry.
MetricDerivative in_file_parameters(const MotorDesign& design, MetricDerivative result,
                                    bool fixed) {
  auto& g = result.gradient;
  const double share = std::exchange(g[index_of(Parameter::frequency)], 0.0);
  if (share == 0) return result;
  const auto moves = std::make_unique<ParameterJacobian>(parameter_jacobian(design, fixed));
  for (std::size_t p = 0; p < kParameterCount; ++p)
    g[p] += share * (*moves)[index_of(Parameter::frequency)][p];
  return result;
}

Smoothness smoothness_of(const WaveRows& rows) {
  return rows.smoothness == Smoothness::flat ? Smoothness::smooth : rows.smoothness;
}

}  // namespace

const Envelope& HeldMetrics::envelope() {
  if (!envelope_) envelope_.emplace(design_);
  return *envelope_;
}

const HeldMetrics::Known& HeldMetrics::known(double torque, double speed) {
  for (const Known& one : known_)
    if (one.torque == torque && one.speed == speed) return one;
  Known found{torque, speed, {}, {}};
  found.held = held_point(design_, beyond_drive_ ? envelope().with_wave(torque) : torque, speed);
  if (found.held.status == HeldStatus::ok || (beyond_drive_ && found.held.amplitude > 0))
    found.motor.emplace(with_held_wave(design_, found.held));
  return known_.emplace_back(std::move(found));
}

HeldMetrics::Slopes& HeldMetrics::slopes(const Known& of, bool fixed) {
  for (Slopes& one : slopes_)
    if (one.of == &of && one.fixed == fixed) return one;
  Slopes made{&of, fixed, std::make_unique<Differentiator>(*of.motor, fixed), {}};
  made.rows = wave_rows(*made.numbers, *of.motor, of.speed, by_frequency(design_), fixed);
  return slopes_.emplace_back(std::move(made));
}

Envelope::Corner HeldMetrics::corner(const MetricRequest& request) {
  const bool at_torque = request.metric == Metric::held_speed_limit_at;
  const Envelope::Corner found =
      at_torque ? envelope().at_torque(request.at) : envelope().at_speed(request.at);
  if (found.status != HeldStatus::ok) throw SearchFailure{status_of(found.status)};
  return found;
}

double HeldMetrics::value(const MetricRequest& request) {
  switch (request.metric) {
    case Metric::held_speed_limit_at: return corner(request).speed;
    case Metric::held_torque_limit_at: return corner(request).torque;
    case Metric::pull_out_margin_at: return corner(request).torque - request.torque;
    case Metric::torque_reserve_at:
      if (!(envelope().largest_torque() > 0))
        throw SearchFailure{MetricStatus::torque_out_of_reach};
      return 1 - std::fabs(request.torque) / envelope().largest_torque();  // (Y5.1)
    case Metric::drive_reserve_at: {
      const DriveReserve found =
          envelope().reserve(envelope().with_wave(request.torque), request.at);  // (Y5.2)
      if (!std::isfinite(found.share)) throw SearchFailure{status_of(found.wave.status)};
      return found.share;
    }
    case Metric::voltage_reserve_at: {
      if (!design_.stator.voltage) throw SearchFailure{MetricStatus::undefined};
      if (request.argument == Argument::torque && request.at < 0)  // as for speed_at
        throw SearchFailure{MetricStatus::unreachable};
      const HeldPoint& least = least_voltage(request).wave;
      if (!(least.voltage > 0))  // or there is no least one
        throw SearchFailure{least.status == HeldStatus::ok ? MetricStatus::undefined
                                                           : status_of(least.status)};
      return *design_.stator.voltage / least.voltage - 1;  // (Y5.5)
    }
    default: break;
  }
  const Known& one = known(request.torque, request.at);
  if (!one.motor) throw SearchFailure{status_of(one.held.status)};
  const MetricValue found =
      twum::evaluate(*one.motor, {request.metric, Argument::speed, request.at});
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return found.value;
}

MetricValue HeldMetrics::evaluate(const MetricRequest& request) {
  const bool needs_speed =
      request.metric != Metric::held_speed_limit_at && request.metric != Metric::voltage_reserve_at;
  const bool at_rest = needs_speed && !(request.at > 0);
  // at rest friction holds
  if (!has_held_value(request) || at_rest) return {kNoValue, MetricStatus::undefined};
  try {
    return {value(request), MetricStatus::ok};
  } catch (const SearchFailure& failure) {
    return {kNoValue, failure.status};
  } catch (const EvaluationError&) {  // a search without a bracket
    return {kNoValue, MetricStatus::unresolved};
  } catch (const InputError&) {  // no modal data, or a wave beyond those of any motor
    return {kNoValue, MetricStatus::undefined};
  }
}

MetricDerivative HeldMetrics::differentiate(const MetricRequest& request,
                                            bool fixed_static_friction) {
  const MetricValue found = evaluate(request);
  if (found.status != MetricStatus::ok) return without_derivative(found);
  MetricDerivative result;
  switch (request.metric) {
    case Metric::held_speed_limit_at:
    case Metric::held_torque_limit_at:
    case Metric::pull_out_margin_at:
      result = of_envelope(request, found, fixed_static_friction);
      break;
    case Metric::torque_reserve_at: {
      result = of_largest_torque(fixed_static_friction);
      const double share = std::fabs(request.torque) / result.value.value / result.value.value;
      for (double& d : result.gradient) d *= share;
      break;
    }
    case Metric::drive_reserve_at:
      result = of_drive_reserve(request, found, fixed_static_friction);
      break;
    case Metric::voltage_reserve_at:
      result = of_voltage_reserve(request, found, fixed_static_friction);
      break;
    default: result = of_wave(request, found, fixed_static_friction);
  }
  if (result.smoothness == Smoothness::undefined) return without_derivative(found);
  result.value = found;
  return in_file_parameters(design_, result, fixed_static_friction);
}

// T_p does not depend on the wave, so it is that of a motor with any.
MetricDerivative HeldMetrics::of_largest_torque(bool fixed) {
  const Motor motor(without_drive(design_));
  MetricDerivative result = Differentiator(motor, fixed).torque_of_full_slip();
  result.value.value = envelope().largest_torque();
  return result;
}

// The wave keeps its torque, and where the frequency follows the file's voltage; beyond the drive it keeps R = 0.
MetricDerivative HeldMetrics::of_wave(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  const Known& one = known(request.torque, request.at);
  Slopes& known_slopes = slopes(one, fixed);
  WaveRows rows = known_slopes.rows;
  if (rows.smoothness == Smoothness::undefined) return without_derivative(value);
  const double nearest = beyond_drive_ ? envelope().with_wave(request.torque) : request.torque;
  if (nearest != request.torque)
    rows.torque =
        less(rows.torque, of_largest_torque(fixed).gradient, nearest / envelope().largest_torque());
  const bool weak = one.held.status == HeldStatus::voltage_too_low;
  const WaveSlopes wave =
      by_frequency(design_)
          ? keeping(rows.torque, weak ? rows.lag : keeps_file_voltage(rows.voltage))
          : keeping(rows.torque);
  const MetricRequest asked{request.metric, Argument::speed, request.at};
  MetricDerivative result = info(request.metric).needs_motion
                                ? twum::differentiate(*one.motor, asked, fixed)
                                : known_slopes.numbers->differentiate(asked);
  result.gradient = wave.along_wave({result.gradient, 0}).in;
  result.smoothness = std::max(result.smoothness, smoothness_of(rows));
  if (result.smoothness == Smoothness::flat) result.smoothness = Smoothness::smooth;
  return result;
}

MetricDerivative HeldMetrics::of_envelope(const MetricRequest& request, const MetricValue& value,
                                          bool fixed) {
  const Envelope::Corner at = corner(request);
  if (at.end == DriveEnd::friction) return of_largest_torque(fixed);
  const Motor motor(with_held_wave(design_, at.wave));
  const WaveRows rows = wave_rows(motor, at.speed, at.end != DriveEnd::amplitude, fixed);
  if (rows.smoothness == Smoothness::undefined) return without_derivative(value);
  const Row torque = slopes_at_end(design_, at.end, rows).along_wave(rows.torque);
  MetricDerivative result{value, torque.in, smoothness_of(rows)};
  if (request.metric ==
      Metric::held_speed_limit_at)  // the torque at the end of the drive stays (Y4.3)
    for (double& d : result.gradient) d /= -torque.in_speed;
  return result;
}

const LeastVoltage& HeldMetrics::least_voltage(const MetricRequest& request) {
  const bool at_torque = request.argument == Argument::torque;
  for (const auto& [of_torque, at, known] : least_)
    if (of_torque == at_torque && at == request.at) return known;
  least_.push_back({at_torque, request.at,
                    at_torque ? least_voltage_at_torque(design_, envelope().with_wave(request.at))
                              : least_voltage_at_speed(design_, request.at)});
  return least_.back().found;
}

// The wave of a drive of the file's frequency that carries a torque at a speed, and the derivatives of its voltage.
HeldMetrics::VoltageAt HeldMetrics::voltage_at(double torque, double speed, bool fixed) {
  const double nearest = envelope().with_wave(torque);
  const HeldPoint wave = held_point(design_, nearest, speed, DriveControl::voltage);
  WaveRows rows = wave_rows(Motor(with_held_wave(design_, wave)), speed, true, fixed);
  if (nearest != torque)
    rows.torque =
        less(rows.torque, of_largest_torque(fixed).gradient, nearest / envelope().largest_torque());
  return {wave.voltage, keeping(rows.torque).along_wave(rows.voltage), smoothness_of(rows)};
}

// Secants for du / dOmega = 0 from a place that comparing values knows to the root of their rounding.
HeldMetrics::VoltageAt HeldMetrics::least_voltage_at(double torque, double near, bool fixed) {
  constexpr double kFirstStep = 1e-5, kFarthest = 1e-3, kSettled = 1e-9;
  constexpr int kMostSteps = 6;
  double speed = near, step = kFirstStep * near;
  VoltageAt here = voltage_at(torque, speed, fixed);
  for (int i = 0; i < kMostSteps && std::fabs(step) > kSettled * near; ++i) {
    const VoltageAt next = voltage_at(torque, speed + step, fixed);
    const double bend = (next.slopes.in_speed - here.slopes.in_speed) / step;
    speed += step, here = next;
    step = -here.slopes.in_speed / bend;
    if (!(std::fabs(speed + step - near) <= kFarthest * near))  // at an end, or at a kink
      return voltage_at(torque, near, fixed);
  }
  return here;
}

// At its minimum the voltage does not change with the speed, or with the amplitude: what is left are the derivatives of the wave
// that keeps torque and speed, or amplitude and speed, at the frequency of the drive.
MetricDerivative HeldMetrics::of_voltage_reserve(const MetricRequest& request,
                                                 const MetricValue& value, bool fixed) {
  const LeastVoltage& least = least_voltage(request);
  VoltageAt at;
  if (request.argument == Argument::torque) {
    at = least_voltage_at(request.at, least.speed, fixed);
  } else {
    const Motor motor(with_held_wave(design_, least.wave));
    const WaveRows rows = wave_rows(motor, least.speed, true, fixed);
    at = {least.wave.voltage, rows.voltage, smoothness_of(rows)};
  }
  if (at.smoothness == Smoothness::undefined) return without_derivative(value);
  at.slopes[Parameter::amplitude] = 0;
  MetricDerivative result{value, {}, at.smoothness};
  for (std::size_t p = 0; p < kParameterCount; ++p)
    result.gradient[p] = -(value.value + 1) / at.voltage * at.slopes.in[p];
  result.gradient[index_of(Parameter::voltage)] += 1 / at.voltage;
  return result;
}

// The least that would do moves with the wave that keeps its torque: (Y2.6) with R = 0 where the frequency follows.
MetricDerivative HeldMetrics::of_drive_reserve(const MetricRequest& request,
                                               const MetricValue& value, bool fixed) {
  const DriveReserve there = envelope().reserve(envelope().with_wave(request.torque), request.at);
  const Motor motor(with_held_wave(design_, there.wave));
  const bool modes = there.end != DriveEnd::amplitude;
  WaveRows rows = wave_rows(motor, request.at, modes, fixed);
  if (rows.smoothness == Smoothness::undefined) return without_derivative(value);
  const double nearest = envelope().with_wave(request.torque);
  if (nearest != request.torque)
    rows.torque =
        less(rows.torque, of_largest_torque(fixed).gradient, nearest / envelope().largest_torque());
  const bool follows = by_frequency(design_);
  MetricDerivative result{value, {}, smoothness_of(rows)};
  const auto set = [&](const Row& needs, double per_need, Parameter has, double per_has) {
    for (std::size_t p = 0; p < kParameterCount; ++p) result.gradient[p] = per_need * needs.in[p];
    if (per_has != 0) result.gradient[index_of(has)] += per_has;
  };
  const double amplitude = there.wave.amplitude, voltage = there.wave.voltage;
  switch (there.end) {
    case DriveEnd::amplitude: {
      Row needs;
      needs[Parameter::amplitude] = 1;
      set(keeping(rows.torque).along_wave(needs), -(value.value + 1) / amplitude,
          Parameter::amplitude, 1 / amplitude);
      break;
    }
    case DriveEnd::voltage:
      set((follows ? keeping(rows.torque, rows.lag) : keeping(rows.torque))
              .along_wave(rows.voltage),
          -(value.value + 1) / voltage, Parameter::voltage, 1 / voltage);
      break;
    case DriveEnd::upper_flank:  // -cos of the lag
      set(keeping(rows.torque).along_wave(rows.lag), std::sin(flank_lag(design_, there.wave)),
          Parameter::voltage, 0);
      break;
    case DriveEnd::frequency: {
      const bool weak = there.wave.voltage > *design_.stator.voltage;
      const auto& range = *design_.stator.frequency_range;
      Row needs;
      needs[Parameter::frequency] = 1;
      const bool low =
          there.wave.frequency / range.first - 1 <= 1 - there.wave.frequency / range.second;
      set(keeping(rows.torque, weak ? rows.lag : keeps_file_voltage(rows.voltage))
              .along_wave(needs),
          low ? 1 / range.first : -1 / range.second, Parameter::voltage, 0);
      break;
    }
    case DriveEnd::friction: return without_derivative(value);
  }
  return result;
}

}  // namespace twum::inline v0_1::core
