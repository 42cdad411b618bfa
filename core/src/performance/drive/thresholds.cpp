// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/thresholds.hpp"

#include "performance/curve/curve.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::performance {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStride = 1.25;             // of the distance to the free resonance
constexpr double kFrequencySettled = 1e-13;  // of the frequency
constexpr double kSettledPlace = 1e-7;       // of the amplitude, whose square counts
constexpr int kMostSteps = 60;

// dH / df at fixed amplitude, but for what the contact makes of the frequency.
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

// The extremum falls with the frequency, from the free resonance on until it vanishes. Secants from the design's own frequency
// follow it to where it takes the drive's force, in steps up to a share of the distance to the free resonance.
Threshold Thresholds::frequency(bool start) {
  if (!given_voltage_) throw SearchFailure{MetricStatus::undefined};
  const double free = waves_.modes().resonance / kTurn;
  double f = frequency_, before = 0, excess_before = 0;
  std::optional<ForceExtremum> e = own_extremum(start);
  for (int i = 0; e && i < kMostSteps; ++i) {
    const DrivenWaves waves = waves_at(f);
    const double excess = e->force - waves.drive();
    const double slope = i > 0 ? (excess - excess_before) / (f - before)
                               : force_slope_in_frequency(waves, e->amplitude);
    const double wanted = f - excess / slope;
    const double next =
        std::clamp(wanted, free + (f - free) / kStride, free + (f - free) * kStride);
    if (std::fabs(next - f) <= kFrequencySettled * f) return {next, e->amplitude, next};
    before = f, excess_before = excess, f = next;
    e = followed(waves_at(f), *e);
    if (!e) e = chosen(force_extrema(waves_at(f), 0), start);
  }
  throw SearchFailure{MetricStatus::undefined};  // it vanishes before, or never falls so far
}

// Secants for H_A = 0 beside an extremum at another frequency.
std::optional<ForceExtremum> Thresholds::followed(const DrivenWaves& waves,
                                                  const ForceExtremum& near) const {
  double a = near.amplitude, b = 1.01 * a;
  SlopedWave at_a = waves.in_amplitude(a, 0), at_b = waves.in_amplitude(b, 0);
  for (int i = 0; i < kMostSteps; ++i) {
    const double bend = (at_b.fold() - at_a.fold()) / (b - a);
    if ((bend < 0) != near.maximum) return {};
    const double next = b - at_b.fold() / bend;
    if (!(next > 0.5 * near.amplitude && next < 2 * near.amplitude)) return {};
    if (std::fabs(next - b) <= kSettledPlace * b)
      return ForceExtremum{next, waves.at(next, 0).force(), near.maximum};
    a = b, at_a = at_b;
    b = next, at_b = waves.in_amplitude(b, 0, &at_a.wave.start);
  }
  return {};
}

}  // namespace twum::performance
