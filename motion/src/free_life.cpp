// SPDX-License-Identifier: Apache-2.0
// The history of a track of which each radius wears by itself (V3.1 to V3.3).
#include <twum/motion/free_life.hpp>

#include "integrator.hpp"
#include "wear_ends.hpp"

#include <twum/base/error.hpp>
#include <twum/motion/integrator_version.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kNever = 1e13;  // [s] of running: what is not worn by then does not wear
// Share of a depth that a step may miss: at the end of a life a thousandth of the elastic depth's tolerance.
constexpr double kRelative = 1e-10;

// Of the time that has passed, of a step: what is left of a life then counts for nothing.
constexpr double kShortest = 1e-7;
constexpr long kMostSteps = 20000;  // a life takes some hundreds

// Depths of the nodes, and revolutions behind them.
class WearSystem final : public OdeSystem {
 public:
  explicit WearSystem(TrackWear& track) : track_(track) {}

  const TrackRates& at(std::span<const double> y) {
    const auto depths = y.first(track_.nodes().size());
    if (!std::ranges::equal(depths, depths_)) {
      depths_.assign(depths.begin(), depths.end());
      rates_ = track_.at(depths);
      if (rates_.status != MetricStatus::ok) lost_ = true;
    }
    return rates_;
  }
  /// True if some depths had no point since this was asked last.
  bool lost_a_load() { return std::exchange(lost_, false); }

  bool rates(double, std::span<const double> y, std::span<double> dy) override {
    const TrackRates& found = at(y);
    if (found.status != MetricStatus::ok) return false;
    std::ranges::copy(found.rates, dy.begin());
    dy.back() = found.turns;
    return true;
  }
  bool jacobian(double, std::span<const double> y, std::span<double> jacobian) override {
    const TrackRates& found = at(y);
    if (found.status != MetricStatus::ok) return false;
    const std::size_t n = track_.nodes().size(), row = n + 1;
    std::ranges::fill(jacobian, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j) jacobian[k * row + j] = found.jacobian[k * n + j];
      jacobian[k * row + n] = found.turn_slopes[k];
    }
    return true;
  }
  bool events(double, std::span<const double>, std::span<double>) override { return true; }

 private:
  TrackWear& track_;
  std::vector<double> depths_;
  TrackRates rates_;
  bool lost_{false};
};

// How deep the wave of the first load presses into the new layer [m].
double elastic_depth(const MotorDesign& design, const TrackRates& rates) {
  double highest = 0;
  for (const TrackLoad& load : rates.loads)
    highest = std::fmax(highest, *std::ranges::max_element(load.pressures));
  return highest * design.layer.thickness / design.layer.youngs_modulus;
}

class FreeLifeRun {
 public:
  FreeLifeRun(const MotorDesign& design, const std::optional<LoadPoint>& load,
              const FreeLifeOptions& options)
      : design_(design), asked_(options), track_(design, load), system_(track_) {}

  FreeLife found() {
    const std::size_t n = track_.nodes().size();
    life_.nodes = track_.nodes();
    const std::vector<double> start(n + 1);
    const TrackRates first = system_.at(start);
    life_.last = point_of(0, start);
    life_.status = first.status;
    if (first.status != MetricStatus::ok) return life_;
    life_.stability = wear_stability(first);
    ends_.emplace(design_, track_, first);
    if (!(*std::ranges::max_element(first.rates) > 0)) {
      life_.status = MetricStatus::does_not_wear;
    } else if (const auto broken = ends_->first_broken(depths_in(start))) {
      end_with(*broken, 0, start);
    } else {
      follow(first, start);
    }
    return std::move(life_);
  }

 private:
  std::span<const double> depths_in(std::span<const double> y) const {
    return y.first(track_.nodes().size());
  }

  WornTrackPoint point_of(double seconds, std::span<const double> y) {
    const auto depths = depths_in(y);
    WornTrackPoint point{.seconds = seconds, .revolutions = y.back()};
    point.depth = track_.mean(depths);
    point.preload = design_.preload - design_.wear->preload_spring * point.depth;
    point.depths.assign(depths.begin(), depths.end());
    TrackRates rates = track_.at(depths);
    point.rates = std::move(rates.rates), point.loads = std::move(rates.loads);
    return point;
  }

  std::vector<double> tolerances(const TrackRates& first) const {
    const double depth = elastic_depth(design_, first);
    const double fastest = *std::ranges::max_element(first.rates);
    std::vector<double> absolute(track_.nodes().size(), asked_.tolerance * depth);
    // revolutions while that depth is worn
    absolute.push_back(asked_.tolerance * std::fmax(first.turns, 1e-6) * depth / fastest);
    return absolute;
  }

  void follow(const TrackRates& first, std::span<const double> start) {
    Integrator integrator(system_, 0, kRelative, tolerances(first));
    integrator.restart(0, start, std::fmin(asked_.longest, kNever));
    take(0, start);
    std::vector<double> last(start.begin(), start.end());
    for (double begin = 0;; begin = integrator.time()) {
      const StepEnd step = integrator.step();
      life_.steps = integrator.steps();
      if (step == StepEnd::failed) return stop_short(begin, last);
      if (ended(integrator, begin)) return;
      last.assign(integrator.y().begin(), integrator.y().end());
      // Next to where a wave under a voltage pulls out its slopes grow without bound, and steps shrink for ever.
      if (integrator.time() - begin < kShortest * begin) return stop_short(integrator.time(), last);
      system_.lost_a_load();
      if (life_.steps >= kMostSteps) return stop_short(integrator.time(), last);
      take_outputs(integrator, integrator.time());
      if (step != StepEnd::stop_time) continue;
      if (integrator.time() >= kNever) life_.status = MetricStatus::does_not_wear;
      life_.last = point_of(integrator.time(), integrator.y());
      return;
    }
  }

  // No shorter step leads on: a load is lost, or the integrator fails.
  void stop_short(double time, const std::vector<double>& y) {
    if (system_.lost_a_load())
      life_.end = EndOfLife::load_lost;
    else
      life_.status = MetricStatus::not_converged;
    life_.last = point_of(time, y);
  }

  bool ended(const Integrator& integrator, double begin) {
    const auto depths_at = [&](double time) {
      std::vector<double> y = integrator.at(time);
      y.pop_back();
      return y;
    };
    const auto end = ends_->within(depths_at, begin, integrator.time(), asked_.beyond_localization);
    if (!end) return false;
    take_outputs(integrator, end->time);
    end_with(end->which, end->time, integrator.at(end->time));
    return true;
  }

  void end_with(const WearEnd& which, double time, std::span<const double> y) {
    life_.end = which.end, life_.limit = which.limit;
    life_.last = point_of(time, y);
    life_.largest_share = ends_->largest_share(life_.last.loads);
    if (which.localizes) life_.status = MetricStatus::wear_localizes;
    if (asked_.output_times.empty()) life_.points.push_back(life_.last);
  }

  void take(double time, std::span<const double> y) {
    if (!asked_.output_times.empty() && (asked_.output_times.front() > 0 || time > 0)) return;
    life_.points.push_back(point_of(time, y));
    if (!asked_.output_times.empty()) ++next_output_;
  }
  void take_outputs(const Integrator& integrator, double until) {
    if (asked_.output_times.empty()) {
      if (until == integrator.time()) life_.points.push_back(point_of(until, integrator.y()));
      return;
    }
    for (; next_output_ < asked_.output_times.size() && asked_.output_times[next_output_] <= until;
         ++next_output_) {
      const double time = asked_.output_times[next_output_];
      life_.points.push_back(point_of(time, integrator.at(time)));
    }
  }

  const MotorDesign& design_;
  const FreeLifeOptions& asked_;
  TrackWear track_;
  WearSystem system_;
  std::optional<WearEnds> ends_;
  std::size_t next_output_{0};
  FreeLife life_;
};

}  // namespace

void require_free_life(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  if (!has_integrator())
    throw InputError(
        "this twum was built without SUNDIALS, which wear.profile: free needs; install "
        "libsundials-dev and build it again, or take wear.profile: even");
  TrackWear(design, load);
}

FreeLife free_life(const MotorDesign& design, const std::optional<LoadPoint>& load,
                   const FreeLifeOptions& options) {
  require_free_life(design, load);
  return FreeLifeRun(design, load, options).found();
}

}  // namespace twum::inline v0_1::motion
