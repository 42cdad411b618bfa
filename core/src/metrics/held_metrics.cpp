// SPDX-License-Identifier: Apache-2.0
#include "metrics/held_metrics.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <cmath>

namespace twum::core {
namespace {

using Gradient = std::array<double, kParameterCount>;

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

// torque_at and speed_at are what is given; a metric without argument has none.
bool has_held_value(Metric metric) {
  const Argument argument = info(metric).argument;
  return argument == Argument::both || argument == Argument::speed_or_torque;
}

double& of(Gradient& g, Parameter p) { return g[index_of(p)]; }

MetricDerivative without_derivative(MetricValue value) {
  MetricDerivative result{value, {}, Smoothness::undefined};
  result.gradient.fill(kNoValue);
  return result;
}

// How amplitude and frequency of the wave move with each parameter so that its torque, and of a drive that follows by frequency its
// voltage, stay what they are (Y2.6).
struct WaveSlopes {
  Gradient amplitude{}, frequency{};
};

WaveSlopes slopes_in_amplitude(Gradient torque) {
  WaveSlopes slopes;
  const double in_amplitude = of(torque, Parameter::amplitude);
  for (std::size_t p = 0; p < kParameterCount; ++p) slopes.amplitude[p] = -torque[p] / in_amplitude;
  return slopes;
}

WaveSlopes slopes_in_frequency(Gradient torque, Gradient voltage) {
  const double ta = of(torque, Parameter::amplitude), tf = of(torque, Parameter::frequency),
               va = of(voltage, Parameter::amplitude), vf = of(voltage, Parameter::frequency);
  const double determinant = ta * vf - tf * va;
  of(voltage, Parameter::voltage) = -1;  // the file's is what it stays
  WaveSlopes slopes;
  for (std::size_t p = 0; p < kParameterCount; ++p) {
    slopes.amplitude[p] = (tf * voltage[p] - vf * torque[p]) / determinant;
    slopes.frequency[p] = (va * torque[p] - ta * voltage[p]) / determinant;
  }
  return slopes;
}

}  // namespace

const HeldMetrics::Known& HeldMetrics::known(const MetricRequest& request) {
  for (const Known& one : known_)
    if (one.torque == request.torque && one.speed == request.at) return one;
  Known found{request.torque, request.at, held_point(design_, request.torque, request.at), {}};
  if (found.held.status == HeldStatus::ok) found.motor.emplace(with_held_wave(design_, found.held));
  return known_.emplace_back(std::move(found));
}

MetricValue HeldMetrics::evaluate(const MetricRequest& request) {
  if (!has_held_value(request.metric)) return {kNoValue, MetricStatus::undefined};
  if (!(request.at > 0)) return {kNoValue, MetricStatus::undefined};  // at rest friction holds
  try {
    const Known& one = known(request);
    if (!one.motor) return {kNoValue, status_of(one.held.status)};
    return twum::evaluate(*one.motor, {request.metric, Argument::speed, request.at});
  } catch (const InputError&) {  // no modal data, or a wave beyond those of any motor
    return {kNoValue, MetricStatus::undefined};
  }
}

MetricDerivative HeldMetrics::differentiate(const MetricRequest& request,
                                            bool fixed_static_friction) {
  const MetricValue value = evaluate(request);
  if (value.status != MetricStatus::ok) return without_derivative(value);
  const Known& one = known(request);
  const bool by_frequency =
      design_.stator.voltage && design_.stator.control == DriveControl::frequency;
  std::vector<MetricRequest> asked{{request.metric, Argument::speed, request.at},
                                   {Metric::torque_at, Argument::speed, request.at}};
  if (by_frequency) asked.push_back({Metric::drive_voltage_at, Argument::speed, request.at});
  const std::vector<MetricDerivative> found =
      twum::differentiate(*one.motor, asked, fixed_static_friction);
  MetricDerivative result{value, found[0].gradient, found[0].smoothness};
  for (const MetricDerivative& d : found) {
    if (d.smoothness == Smoothness::undefined) return without_derivative(value);
    if (d.smoothness == Smoothness::one_sided) result.smoothness = Smoothness::one_sided;
  }
  if (result.smoothness == Smoothness::flat) result.smoothness = Smoothness::smooth;
  Gradient& g = result.gradient;
  const double in_amplitude = of(g, Parameter::amplitude),
               in_frequency = of(g, Parameter::frequency);
  const WaveSlopes wave = by_frequency ? slopes_in_frequency(found[1].gradient, found[2].gradient)
                                       : slopes_in_amplitude(found[1].gradient);
  for (std::size_t p = 0; p < kParameterCount; ++p)
    g[p] += in_amplitude * wave.amplitude[p] + in_frequency * wave.frequency[p];
  of(g, Parameter::amplitude) = 0;
  if (by_frequency) {
    of(g, Parameter::frequency) = 0;
  } else if (design_.stator.frequency_ratio) {  // f = ratio f_r
    const double share = of(g, Parameter::frequency);
    of(g, Parameter::frequency_ratio) += share * get(design_, Parameter::resonance_frequency);
    of(g, Parameter::resonance_frequency) += share * *design_.stator.frequency_ratio;
    of(g, Parameter::frequency) = 0;
  }
  return result;
}

}  // namespace twum::core
