// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/thresholds.hpp"

#include "performance/curve/curve.hpp"
#include "performance/drive/branch_node.hpp"
#include "performance/drive/learned_slopes.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace twum::performance {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStride = 0.5;  // of the logarithms: longest step
// of the same: last steps, towards the place of the extremum and of the frequency; they leave a hundredth
constexpr double kPlaceSettled = 1e-7, kFrequencySettled = 1e-8;
constexpr double kProbe = 1e-3;           // of the amplitude
constexpr double kStateAccuracy = 1e-12;  // of the states with which slopes are found
constexpr double kRoughAccuracy = 1e-7;   // of those that tell a direction
constexpr double kNearStep = 1e-3;        // length of a step that leads so near that it tells more
constexpr int kMostTries = 30, kMostSearches = 12;

// dH / df at fixed amplitude, without the dependence of the contact on the frequency.
double force_slope_in_frequency(const DrivenWaves& waves, double amplitude) {
  const WaveBalance<double> b = waves.at(amplitude, 0, nullptr, kRoughAccuracy).balance;
  const StatorModes<double>& m = waves.modes();
  return kTurn * amplitude * (m.damping * b.imaginary - 2 * m.mass * waves.omega() * b.real) /
         b.force();
}

// The layer's states at another amplitude.
WarmStart moved_to(double amplitude, const DrivenWaves::LevelSlopes& from) {
  const DrivenWave& wave = from.in_amplitude.wave;
  return moved(wave.start, from.states, amplitude - wave.amplitude);
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

Thresholds::Thresholds(const MotorDesign& design, const TrackRule& track,
                       std::optional<std::vector<ForceExtremum>> extrema)
    : waves_(design, track),
      given_voltage_(design.stator.voltage.has_value()),
      frequency_(drive_frequency(design)),
      extrema_(std::move(extrema)) {}

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
  return {e->force / force_per_volt, e->amplitude, frequency_, e->beyond_kink};
}

// The extremum of H falls with the frequency, from the free resonance on, until it vanishes. It is followed from the design's
// frequency to where it equals the drive's force; where that fails, it is searched anew at the frequency reached.
Threshold Thresholds::frequency(bool start) {
  if (!given_voltage_) throw SearchFailure{MetricStatus::undefined};
  double f = frequency_;
  std::optional<ForceExtremum> e = own_extremum(start);
  for (int i = 0; e && i < kMostSearches; ++i) {
    const Followed end = followed(*e, f);
    if (end.settled) return {end.frequency, end.amplitude, end.frequency};
    f = end.frequency;
    e = chosen(force_extrema(waves_at(f), 0), start);
  }
  // it vanishes before it reaches the force, or never falls so far
  throw SearchFailure{MetricStatus::undefined};
}

// Broyden's method for H_A = 0 and H = Theta u_0 (D3.4) in p = ln (A x) and v = ln x, where x is the distance to the free
// resonance. A x changes little, because the amplitude of an extremum goes like 1 / x. The first step is Newton's, with the
// second derivative of H at the beginning.
Thresholds::Followed Thresholds::followed(const ForceExtremum& from, double frequency) const {
  const double free = waves_.modes().resonance / kTurn, from_place = std::log(frequency - free);
  const double bend = from.bend * from.amplitude * from.amplitude / from.force,
               fall = force_slope_in_frequency(waves_at(frequency), from.amplitude) *
                      (frequency - free) / from.force;
  std::optional<DrivenWaves::LevelSlopes> last;
  const auto residuals = [&](const Followed& at, double accuracy) -> std::optional<Pair> {
    const DrivenWaves waves = waves_at(at.frequency);
    std::optional<WarmStart> layer;
    if (last) layer = moved_to(at.amplitude, *last);
    last = waves.slopes(at.amplitude, 0, layer ? &*layer : nullptr, accuracy);
    const SlopedWave& w = last->in_amplitude;
    if (w.wave.status != PointStatus::ok) return {};
    const double slope = w.force_slope() * at.amplitude / w.wave.force();
    const double excess = std::log(w.wave.force() / waves.drive()) - 0.5 * slope * slope / bend;
    return Pair{-slope / bend, -excess / fall};
  };
  Pair x{std::log(from.amplitude) + from_place, from_place};
  Followed at{from.amplitude, frequency, false};
  LearnedSlopes slopes;
  auto f = residuals(at, kRoughAccuracy);
  for (int i = 0; f && i < kMostTries; ++i) {
    Pair step = slopes.step(*f);
    step[1] = std::clamp(step[1], -kStride, kStride);
    if (!(std::fabs(step[0]) < kStride)) break;
    x = {x[0] + step[0], x[1] + step[1]};
    at = {std::exp(x[0] - x[1]), free + std::exp(x[1]), false};
    if (std::fabs(step[0]) <= kPlaceSettled && std::fabs(step[1]) <= kFrequencySettled)
      return {at.amplitude, at.frequency, is_extremum(at, from.maximum, *last)};
    const bool near = std::fmax(std::fabs(step[0]), std::fabs(step[1])) < kNearStep;
    const auto next = residuals(at, near ? kStateAccuracy : kRoughAccuracy);
    if (next) slopes.learn(step, {(*f)[0] - (*next)[0], (*f)[1] - (*next)[1]});
    f = next;
  }
  return at;
}

// H falls beyond a maximum and rises beyond a minimum.
bool Thresholds::is_extremum(const Followed& at, bool maximum,
                             const DrivenWaves::LevelSlopes& near) const {
  const double amplitude = (1 + kProbe) * at.amplitude;
  const WarmStart start = moved_to(amplitude, near);
  const SlopedWave beyond =
      waves_at(at.frequency).slopes(amplitude, 0, &start, kRoughAccuracy).in_amplitude;
  return beyond.wave.status == PointStatus::ok && (beyond.fold() < 0) == maximum;
}

}  // namespace twum::performance
