// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/thresholds.hpp"

#include "performance/curve/curve.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::performance {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStride = 1.25;             // of the distance to the free resonance
constexpr double kFrequencySettled = 1e-13;  // of the frequency
constexpr double kProbe = 0.01;      // of the amplitude; first step, to measure the curvature of H
constexpr double kShortStep = 3e-5;  // of the amplitude; its cube is below the rounding of H
constexpr double kSettledPlace = 1e-7;  // of the amplitude; the error is its square
constexpr int kMostSteps = 60;

// dH / df at fixed amplitude, without the dependence of the contact on the frequency.
double force_slope_in_frequency(const DrivenWaves& waves, double amplitude) {
  const WaveBalance<double> b = waves.at(amplitude, 0).balance;
  const StatorModes<double>& m = waves.modes();
  return kTurn * amplitude * (m.damping * b.imaginary - 2 * m.mass * waves.omega() * b.real) /
         b.force();
}

std::size_t place_of(Metric metric) {
  switch (metric) {
    case Metric::start_voltage: return 0;
    case Metric::hold_voltage: return 1;
    case Metric::start_frequency: return 2;
    default: TWUM_ASSERT(metric == Metric::pull_out_frequency); return 3;
  }
}

// The highest maximum that a start has to pass, or the lowest minimum that holds the running wave.
std::optional<ForceExtremum> chosen(const std::vector<ForceExtremum>& extrema, bool start) {
  std::optional<ForceExtremum> best;
  for (const ForceExtremum& e : extrema) {
    if (e.maximum != start) continue;
    if (!best || (e.force > best->force) == start) best = e;
  }
  return best;
}

}  // namespace

Thresholds::Thresholds(const MotorDesign& design, const TrackRule& track)
    : waves_(design, track),
      given_voltage_(design.stator.voltage.has_value()),
      frequency_(drive_frequency(design)) {}

const Threshold& Thresholds::at(Metric metric) {
  std::optional<Threshold>& kept = found_[place_of(metric)];
  if (kept) return *kept;
  switch (metric) {
    case Metric::start_voltage: kept = voltage(true); break;
    case Metric::hold_voltage: kept = voltage(false); break;
    default: kept = frequency(metric == Metric::start_frequency);
  }
  return *kept;
}

DrivenWaves Thresholds::waves_at(double frequency) const {
  return waves_.at_frequency(kTurn * frequency);
}

std::optional<ForceExtremum> Thresholds::own_extremum(bool start) {
  if (!extrema_) extrema_ = force_extrema(waves_at(frequency_), 0);
  return chosen(*extrema_, start);
}

// Where H has no extremum there is one wave at every voltage.
Threshold Thresholds::voltage(bool start) {
  const std::optional<ForceExtremum> e = own_extremum(start);
  if (!e) return {0, 0, frequency_};
  const StatorModes<double>& m = waves_.modes();
  const double force_per_volt = std::numbers::sqrt2 * m.force_factor * m.unequal.share();
  return {e->force / force_per_volt, e->amplitude, frequency_};
}

// The extremum of H falls with the frequency, from the free resonance on, until it vanishes. Secants follow it from
// the design's frequency to where it equals the drive's force. A step is at most a share of the distance to the free
// resonance.
Threshold Thresholds::frequency(bool start) {
  if (!given_voltage_) throw SearchFailure{MetricStatus::undefined};
  const double free = waves_.modes().resonance / kTurn;
  double f = frequency_, before = 0, excess_before = 0, drift = 0;
  std::optional<Extremum> e = bent(own_extremum(start));
  for (int i = 0; e && i < kMostSteps; ++i) {
    const DrivenWaves waves = waves_at(f);
    const double excess = e->at.force - waves.drive();
    const double slope = i > 0 ? (excess - excess_before) / (f - before)
                               : force_slope_in_frequency(waves, e->at.amplitude);
    const double wanted = f - excess / slope;
    const double next =
        std::clamp(wanted, free + (f - free) / kStride, free + (f - free) * kStride);
    if (std::fabs(next - f) <= kFrequencySettled * f) return {next, e->at.amplitude, next};
    before = f, excess_before = excess, f = next;
    const double amplitude_before = e->at.amplitude;
    e = followed(waves_at(f), *e, drift * (f - before));
    if (!e) e = bent(chosen(force_extrema(waves_at(f), 0), start));
    if (e) drift = (e->at.amplitude - amplitude_before) / (f - before);
  }
  // it vanishes before it reaches the force, or never falls so far
  throw SearchFailure{MetricStatus::undefined};
}

std::optional<Thresholds::Extremum> Thresholds::bent(const std::optional<ForceExtremum>& e) {
  if (!e) return {};
  return Extremum{*e, std::numeric_limits<double>::quiet_NaN()};
}

// Secants for H_A = 0 near an extremum at another frequency, starting with its second derivative. The last step is
// not solved again; the parabola gives the force.
std::optional<Thresholds::Extremum> Thresholds::followed(const DrivenWaves& waves,
                                                         const Extremum& near, double drift) const {
  const double size = near.at.amplitude;
  double a = size + drift, before = 0, slope_before = 0, bend = near.bend;
  WarmStart from;
  for (int i = 0; i < kMostSteps; ++i) {
    const SlopedWave w = waves.in_amplitude(a, 0, i > 0 ? &from : nullptr);
    if (w.wave.status != PointStatus::ok) return {};
    const double slope = w.force_slope();
    if (i > 0) bend = (slope - slope_before) / (a - before);
    const double last_step = i > 0 ? a - before : size;
    const double step = std::isnan(bend) ? kProbe * size : -slope / bend;
    if (!std::isnan(bend) && (bend < 0) != near.at.maximum) return {};
    if (!(std::fabs(a + step - size) < 0.5 * size)) return {};
    if (std::fabs(step) <= kShortStep * size &&
        std::fabs(step * last_step) <= kSettledPlace * size * size)
      return Extremum{{a + step, w.wave.force() + 0.5 * slope * step, near.at.maximum}, bend};
    before = a, slope_before = slope, from = w.wave.start;
    a += step;
  }
  return {};
}

}  // namespace twum::performance
