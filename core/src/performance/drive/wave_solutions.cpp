// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/wave_solutions.hpp"

#include "performance/drive/branch_node.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace twum::performance {
namespace {

constexpr double kRatio = 1.25;  // of neighbouring samples; H bends over amplitudes of its own size
constexpr double kScanAccuracy = 1e-5;  // crude enough for a track without splits
constexpr double kNoise = 1e-4;         // of H: a fall that may be the samples' inaccuracy
constexpr double kNextTo = 1e-2;  // of the amplitude: samples nearer than that tell nothing new
constexpr double kFlat = 0.15;    // of what H would change by were it proportional to the amplitude
constexpr int kParts = 4;
// Limit of zones that one search may follow in a slice, some ten milliseconds. Usual motors need a thousand, contacts
// unlike any motor millions.
constexpr long kMostZonesToSolve = 50'000;
constexpr int kMostDecades = 20;
constexpr double kLargest = 1, kSmallest = 1e-30;  // [m], far beyond amplitudes of any motor
constexpr double kShortStep = 3e-5;     // of the amplitude; its cube is below the rounding of H
constexpr double kSettledPlace = 1e-7;  // of the amplitude; the error is its square
// of the states with which slopes are found; an extremum is off by as much, its force by the square
constexpr double kSlopeAccuracy = 1e-10;
constexpr double kSettledKink = 1e-9;  // of the amplitude; the force is a line on both sides
constexpr double kSecants = 10;        // largest factor in the error of secants
constexpr int kMostSlopes = 60;

// Thrown for an amplitude whose contact has no periodic state.
struct NoState {};

struct Range {
  double low, high;
};

struct ExtremumSearch {
  std::optional<ForceExtremum> found;
  long zones;  // followed
};

// H near an amplitude, to first order.
struct ForceLine {
  double amplitude, force, slope;
};

// Where the lines on both sides of a kink meet.
ForceExtremum kink_between(const ForceLine& below, const ForceLine& above, bool maximum) {
  const double apart = above.amplitude - below.amplitude, turn = below.slope - above.slope;
  const double from = (above.force - below.force - above.slope * apart) / turn;
  return {below.amplitude, below.force + below.slope * from, maximum, -turn / apart,
          above.amplitude};
}

// Where H_A vanishes between two amplitudes: secants from a vertex nearby, halving where they leave the interval. The last step
// is not solved again; the parabola gives the force.
ExtremumSearch extremum_between(const DrivenWaves& waves, double speed, const ForceExtremum& near,
                                double low, double high) {
  double a = std::clamp(near.amplitude, low, high), bend = near.bend, before = 0, slope_before = 0;
  double last_before = a;
  long zones = 0;
  WarmStart from;
  DrivenWaves::LevelSlopes s;
  std::optional<ForceLine> below, above;
  for (int i = 0; i < kMostSlopes && zones <= kMostZonesToSolve; ++i) {
    s = i > 0 ? waves.slopes(a, speed, &from, kSlopeAccuracy, &s.solved)
              : waves.slopes(a, speed, nullptr, kSlopeAccuracy);
    const SlopedWave& w = s.in_amplitude;
    zones += w.wave.zones;
    if (w.wave.status != PointStatus::ok) break;
    const double slope = w.force_slope();
    if (i > 0 && slope != slope_before) bend = (slope - slope_before) / (a - before);
    const bool left = (slope > 0) == near.maximum;
    (left ? below : above) = ForceLine{a, w.wave.force(), slope};
    (left ? low : high) = a;
    if (below && above && high - low <= kSettledKink * a)
      return {kink_between(*below, *above, near.maximum), zones};
    const double secant = a - slope / bend;
    const bool inside = (bend < 0) == near.maximum && secant >= low && secant <= high;
    const double step = (inside ? secant : 0.5 * (low + high)) - a, last = i > 0 ? a - before : a;
    // The error of secants is the product of the last two over the amplitude; at a kink it stays a share of the last one.
    const bool smooth = std::fabs(step) * a <= kSecants * std::fabs(last * last_before);
    if (inside && smooth && std::fabs(step) <= kShortStep * a &&
        std::fabs(step * last) <= kSettledPlace * a * a)
      return {ForceExtremum{a + step, w.wave.force() + 0.5 * slope * step, near.maximum, bend},
              zones};
    last_before = last, before = a, slope_before = slope;
    from = moved(w.wave.start, s.states, step);
    a += step;
  }
  return {{}, zones};
}

// H over the amplitude at one speed.
class ForceCurve {
 public:
  ForceCurve(const DrivenWaves& waves, double speed) : waves_(waves), speed_(speed) {}

  void sample(const Range& range) {
    const double full = waves_.full_contact_amplitude();
    const auto close = [](double a, double b) { return std::fabs(a - b) < kNextTo * b; };
    for (double a = range.low; a < range.high; a *= kRatio)
      if (!close(a, full) && !close(a, range.high)) sample(a);
    sample(range.high);
    if (full > range.low && full < range.high && !close(full, range.high)) sample(full);
    std::sort(samples_.begin(), samples_.end(), below);
    look_closer();
  }

  // The ends of a range, and extrema inside it.
  void sample(const Range& range, const std::vector<ForceExtremum>& extrema) {
    sample(range.low);
    for (const ForceExtremum& e : extrema)
      if (e.amplitude > range.low && e.amplitude < range.high)
        samples_.push_back({e.amplitude, e.force, std::nullopt});
    sample(range.high);
  }

  // Extends the samples to smaller amplitudes until H is below a force; H(0) = 0.
  void begin_below(double force) {
    for (int i = 0; i < kMostDecades && !samples_.empty() && samples_.front().force >= force; ++i) {
      sample(0.1 * samples_.front().amplitude);
      std::sort(samples_.begin(), samples_.end(), below);
    }
  }

  // Adds the extrema that `wanted` takes to the samples, and returns them.
  template <typename Wanted>
  std::vector<ForceExtremum> refine(Wanted wanted) {
    std::vector<ForceExtremum> found;
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
      const Sample &a = samples_[i - 1], &b = samples_[i], &c = samples_[i + 1];
      const bool maximum = b.force >= a.force && b.force > c.force,
                 minimum = b.force <= a.force && b.force < c.force;
      if (!(maximum || minimum) || !wanted(b.force, maximum)) continue;
      found.push_back(extremum(a, b, c, maximum));
    }
    for (const ForceExtremum& e : found) samples_.push_back({e.amplitude, e.force, std::nullopt});
    std::sort(samples_.begin(), samples_.end(), below);
    return found;
  }

  // Amplitudes where H passes through a force.
  std::vector<double> crossings(double drive) {
    std::vector<double> roots;
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
      const Sample &a = samples_[i], &b = samples_[i + 1];
      if ((a.force < drive) == (b.force < drive)) continue;
      try {
        roots.push_back(crossing(drive, a, b));
      } catch (const NoState&) {
        continue;
      }
    }
    return roots;
  }

  bool rises_below(double amplitude) const {
    for (std::size_t i = 1; i < samples_.size() && samples_[i].amplitude < amplitude; ++i)
      if (samples_[i].force < (1 - kNoise) * samples_[i - 1].force) return false;
    return true;
  }

  long zones() const { return zones_; }

 private:
  struct Sample {
    double amplitude, force;
    std::optional<WarmStart> start;

    const WarmStart* guess() const { return start ? &*start : nullptr; }
  };
  static bool below(const Sample& a, const Sample& b) { return a.amplitude < b.amplitude; }

  void sample(double amplitude) {
    const WarmStart* guess = samples_.empty() ? nullptr : samples_.back().guess();
    if (zones_ > kMostZonesToSolve) return;
    const DrivenWave wave = waves_.at(amplitude, speed_, guess, kScanAccuracy);
    zones_ += wave.zones;
    if (wave.status == PointStatus::ok) samples_.push_back({amplitude, wave.force(), wave.start});
  }

  // H may rise, fall and rise again between two samples with nearly the same force.
  void look_closer() {
    std::vector<double> places;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      const Sample &a = samples_[i - 1], &b = samples_[i];
      const double apart = 1 - a.amplitude / b.amplitude;
      if (std::fabs(b.force - a.force) > kFlat * apart * b.force) continue;
      for (int k = 1; k < kParts; ++k)
        places.push_back(a.amplitude + (b.amplitude - a.amplitude) * k / kParts);
    }
    for (const double place : places) sample(place);
    std::sort(samples_.begin(), samples_.end(), below);
  }

  // The extremum about a sample, from the vertex of the parabola through it and its neighbours; the sample itself where the
  // contact has no answer.
  ForceExtremum extremum(const Sample& a, const Sample& b, const Sample& c, bool maximum) {
    const double before = (b.force - a.force) / (b.amplitude - a.amplitude),
                 after = (c.force - b.force) / (c.amplitude - b.amplitude),
                 bend = 2 * (after - before) / (c.amplitude - a.amplitude);
    const double vertex = 0.5 * (a.amplitude + b.amplitude) - before / bend;
    const ForceExtremum near{std::isfinite(vertex) ? vertex : b.amplitude, b.force, maximum, bend};
    if (zones_ > kMostZonesToSolve) return near;
    const ExtremumSearch search = extremum_between(waves_, speed_, near, a.amplitude, c.amplitude);
    zones_ += search.zones;
    return search.found.value_or(ForceExtremum{b.amplitude, b.force, maximum, bend});
  }

  double force(double amplitude, const WarmStart* guess) {
    if (zones_ > kMostZonesToSolve) throw NoState{};
    const DrivenWave wave = waves_.at(amplitude, speed_, guess);
    zones_ += wave.zones;
    if (wave.status != PointStatus::ok) throw NoState{};
    return wave.force();
  }

  double crossing(double drive, const Sample& a, const Sample& b) {
    const auto excess = [&](double x) { return force(x, a.guess()) - drive; };
    const double low = excess(a.amplitude), high = excess(b.amplitude);
    if (low == 0 || high == 0 || (low < 0) == (high < 0))
      return std::fabs(low) <= std::fabs(high) ? a.amplitude : b.amplitude;
    return closed_in("an amplitude of the driven wave", excess, {a.amplitude, b.amplitude, low, high}).nearest();
  }

  const DrivenWaves& waves_;
  double speed_;
  std::vector<Sample> samples_;
  long zones_{0};  // followed in all
};

// The largest solution there can be (D2.7).
double largest_amplitude(const DrivenWaves& w) {
  const StatorModes<double>& m = w.modes();
  const double damped = (w.drive() + w.traction_bound()) / (w.omega() * m.damping);
  const double stiff = (w.drive() + w.pressure_bound() + w.traction_bound()) /
                       std::fabs(dynamic_stiffness(m, w.omega()));
  return std::fmin(std::fmin(damped, stiff) * (1 + 1e-9), kLargest);
}

// Upper bound of H per amplitude, if the contact is not stiffer than one that is closed all round.
double steepest(const DrivenWaves& w) {
  const StatorModes<double>& m = w.modes();
  return std::fabs(dynamic_stiffness(m, w.omega())) + w.omega() * m.damping +
         2 * w.contact_stiffness();
}

// Amplitudes between which all solutions lie.
Range range_of_solutions(const DrivenWaves& waves) {
  const double high = largest_amplitude(waves);
  return {std::fmax(std::fmin(0.1 * waves.drive() / steepest(waves), 0.1 * high), kSmallest), high};
}

std::vector<WaveSolution> solutions_on(ForceCurve& curve, const DrivenWaves& waves, double speed) {
  std::vector<WaveSolution> solutions;
  for (const double amplitude : curve.crossings(waves.drive())) {
    const SlopedWave wave = waves.in_amplitude(amplitude, speed);
    solutions.push_back({wave, waves.stability(wave), !curve.rises_below(amplitude), false});
  }
  return solutions;
}

}  // namespace

WaveSolutions wave_solutions(const DrivenWaves& waves, double speed) {
  const double drive = waves.drive();
  if (!(drive > 0)) return {{}, 0};
  ForceCurve curve(waves, speed);
  curve.sample(range_of_solutions(waves));
  curve.begin_below(drive);
  curve.refine([&](double force, bool maximum) { return (force < drive) == maximum; });
  std::vector<WaveSolution> solutions = solutions_on(curve, waves, speed);
  if (solutions.size() == 1 && !solutions[0].beyond_start())
    solutions[0].only_one = force_extrema(waves, speed).empty();
  return {solutions, curve.zones()};
}

WaveSolutions wave_solutions(const DrivenWaves& waves, double speed,
                             const std::vector<ForceExtremum>& extrema) {
  if (!(waves.drive() > 0)) return {{}, 0};
  ForceCurve curve(waves, speed);
  curve.sample(range_of_solutions(waves), extrema);
  return {solutions_on(curve, waves, speed), curve.zones()};
}

// Beyond the backbone, where R stays negative, both |R| and I grow.
std::vector<ForceExtremum> force_extrema(const DrivenWaves& waves, double speed) {
  const double softness = -dynamic_stiffness(waves.modes(), waves.omega());
  if (!(softness > 0)) return {};
  const double high = std::fmin(2 * (waves.pressure_bound() + waves.traction_bound()) / softness,
                                kLargest),
               low = std::fmin(0.01 * waves.full_contact_amplitude(), 1e-3 * high);
  if (!(low > kSmallest)) return {};  // no preload: nothing bends
  ForceCurve curve(waves, speed);
  curve.sample({low, high});
  return curve.refine([](double, bool) { return true; });
}

LeastForce least_force(const DrivenWaves& waves, double speed, double low, double high) {
  long zones = 0;
  // In units of the interval's end, because the tolerance of Brent's method is absolute.
  const auto force = [&](double share) {
    if (zones > kMostZonesToSolve) return std::numeric_limits<double>::infinity();
    const DrivenWave wave = waves.at(share * high, speed);
    zones += wave.zones;
    return wave.force();
  };
  const LeastValue least = least_between("the least force of a wave", force, low / high, 1.0);
  return {least.place * high, least.value};
}

}  // namespace twum::performance
