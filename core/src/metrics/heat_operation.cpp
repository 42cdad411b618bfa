// SPDX-License-Identifier: Apache-2.0
// Temperatures over a cycle of loads, and for how long a motor may run.
#include "metrics/heat_metrics.hpp"

#include "curve/curve.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kLongestWarmUp =
    300;  // slow time constants; a passage past a fold takes some twenty

double period_of(const std::vector<LoadPhase>& phases) {
  return std::accumulate(phases.begin(), phases.end(), 0.0,
                         [](double sum, const LoadPhase& phase) { return sum + phase.time; });
}

void require_limit(const PartValues<double>& limits) {
  const auto given = [](double limit) { return std::isfinite(limit); };
  if (std::none_of(limits.begin(), limits.end(), given))
    throw SearchFailure{MetricStatus::undefined};
}

MetricDerivative derivative(const MetricValue& value, Gradient gradient, double factor) {
  for (double& d : gradient) d *= factor;
  return {value, gradient, Smoothness::smooth};
}

}  // namespace

const HeatMetrics::Operation& HeatMetrics::operation() {
  if (design_.operation.empty()) throw SearchFailure{MetricStatus::undefined};
  if (!operation_) {
    HeatCourse course(design_, design_.operation);
    HeatCourse::Lap lap = course.periodic();
    operation_.emplace(Operation{std::move(course), std::move(lap)});
  }
  return *operation_;
}

CourseSensitivity& HeatMetrics::sensitivity(bool fixed) {
  if (!sensitivity_ || sensitivity_->is_with_fixed_static_friction() != fixed)
    sensitivity_ =
        std::make_unique<CourseSensitivity>(design_, operation().course, operation().lap, fixed);
  return *sensitivity_;
}

NodeTemperatures HeatMetrics::mean_nodes() {
  const PartValues<double> mean = operation().course.mean(operation().lap);
  return {mean[kNodeParts[0]], mean[kNodeParts[1]], mean[kNodeParts[2]]};
}

std::array<Gradient, 3> HeatMetrics::mean_moves(bool fixed) {
  const auto moved = sensitivity(fixed).of_mean();
  return {moved[kNodeParts[0]], moved[kNodeParts[1]], moved[kNodeParts[2]]};
}

double HeatMetrics::peak(std::size_t part) {
  const Operation& now = operation();
  return now.course.temperature(now.course.peak(now.lap, part), part);
}

// At a peak within a phase the temperature does not move with the time, and phases end at given times (envelope theorem).
MetricDerivative HeatMetrics::of_peak(std::size_t part, const MetricValue& value, bool fixed) {
  const Operation& now = operation();
  const auto moved = sensitivity(fixed).in_cycle(now.course.peak(now.lap, part));
  return derivative(value, moved[part], 1);
}

HeatMetrics::WarmUp& HeatMetrics::known_warm_up(const LoadPoint& load, bool searches) {
  for (WarmUp& one : warm_ups_)
    if (one.load == load && one.searches == searches) return one;
  HeatCourse course(design_, std::vector{LoadPhase{load, 1}});
  if (searches) course = course.searching();
  const HeatSolver& solver = course.phases().front().solver;
  const HeatState cold = solver.cold();
  if (cold.status != MetricStatus::ok) throw SearchFailure{cold.status};
  HeatSolver::Way way(solver, cold, kCourseError);
  return warm_ups_.emplace_back(WarmUp{load, searches, std::move(course), std::move(way)});
}

HeatMetrics::WarmUp& HeatMetrics::warm_up(const LoadPoint& load, double time) {
  const auto followed = [&](bool searches) -> WarmUp& {
    WarmUp& warm = known_warm_up(load, searches);
    warm.way.go_on(warm.course.phases().front().solver, time);
    warm.lap = {warm.way.states()};
    return warm;
  };
  WarmUp& quick = followed(false);
  const std::vector<HeatState>& states = quick.way.states();
  const auto later = std::upper_bound(states.begin() + 1, states.end(), time,
                                      [](double t, const HeatState& s) { return t < s.time; });
  return quick.course.phases().front().solver.is_confirmed(*(later - 1)) ? quick : followed(true);
}

double HeatMetrics::after(const MetricRequest& request) {
  const WarmUp& warm = warm_up(load_of(request), *request.after);
  return warm.course.temperature(warm.course.at(warm.lap, *request.after),
                                 *part_of(request.metric));
}

MetricDerivative HeatMetrics::of_after(const MetricRequest& request, const MetricValue& value,
                                       bool fixed) {
  WarmUp& warm = warm_up(load_of(request), *request.after);
  if (!warm.sensitivity || warm.sensitivity->is_with_fixed_static_friction() != fixed)
    warm.sensitivity = std::make_unique<CourseSensitivity>(design_, warm.course, warm.lap, fixed);
  const HeatCourse::Moment moment = warm.course.at(warm.lap, *request.after);
  return derivative(value, warm.sensitivity->from_cold(moment)[*part_of(request.metric)], 1);
}

// The warm-up up to the first limit, or to where the point is lost.
HeatMetrics::OnTime HeatMetrics::on_time(const LoadPoint& load) const {
  const PartValues<double> limits = temperature_limits(design_);
  require_limit(limits);
  const HeatNetwork network = network_of(design_);
  HeatCourse course(design_,
                    std::vector{LoadPhase{load, kLongestWarmUp * time_constants(network).back()}});
  const CoursePhase& phase = course.phases().front();
  HeatCourse::Lap lap{phase.solver.followed(phase.solver.cold(), phase.time, kCourseError)};
  const MetricStatus end = lap.front().back().status;
  if (end != MetricStatus::ok) lap.front().pop_back();
  if (lap.front().empty()) throw SearchFailure{end};
  const auto found = course.first_limit(lap, limits);
  if (!found) throw SearchFailure{end == MetricStatus::ok ? MetricStatus::never_too_hot : end};
  return {std::move(course), std::move(lap), found->first, found->second};
}

// T(t, q) = T_lim(q) (H6.5)
MetricDerivative HeatMetrics::of_on_time(const LoadPoint& load, const MetricValue& value,
                                         bool fixed) const {
  const OnTime at = on_time(load);
  const double rate = at.course.phases().front().solver.part_rates(at.moment.state)[at.part];
  if (!(at.moment.time > 0) || !(rate > 0)) return no_derivative(value);
  Gradient g = CourseSensitivity(design_, at.course, at.lap, fixed).from_cold(at.moment)[at.part];
  g[index_of(kTemperatureLimits[at.part])] -= 1;
  return derivative(value, g, -1 / rate);
}

HeatMetrics::Shared HeatMetrics::shared(const LoadPoint& load, double share) const {
  const PartValues<double> limits = temperature_limits(design_);
  const double period = period_of(design_.operation);
  HeatCourse course(
      design_, std::vector{LoadPhase{load, share * period}, LoadPhase{{}, (1 - share) * period}});
  HeatCourse::Lap lap = course.periodic();
  std::optional<std::pair<HeatCourse::Moment, std::size_t>> least;
  double margin = kNoLimit;
  for (std::size_t part = 0; part < kParts; ++part) {
    if (!std::isfinite(limits[part])) continue;
    const HeatCourse::Moment top = course.peak(lap, part);
    const double left = limits[part] - course.temperature(top, part);
    if (!least || left < margin) least.emplace(top, part), margin = left;
  }
  return {std::move(course), std::move(lap), least->first, least->second, margin};
}

// The peaks rise with the share: one share just keeps the limits (H5.3), or is the last whose cycle returns.
HeatMetrics::DutyLimit HeatMetrics::duty_limit(const LoadPoint& load) {
  constexpr double kLeast = 1e-6;  // of the share
  require_limit(temperature_limits(design_));
  if (design_.operation.empty()) throw SearchFailure{MetricStatus::undefined};
  const double T = design_.thermal->ambient;
  const MetricStatus cold = LoadLosses(design_, load).at({T, T, T}).status;
  if (cold != MetricStatus::ok) throw SearchFailure{cold};
  if (known(load).steady.ok() && !(margin(known(load)) < 0)) return {1, {}, Limiting::load};
  const auto margin_at = [&](double share) {
    try {
      return shared(load, share).margin;
    } catch (const SearchFailure&) {
      return kNoValue;
    }
  };
  double from = 0, to = 1, good = HUGE_VAL, bad = kNoValue;
  while ((std::isnan(bad) || from == 0) && to - from > kLeast) {
    const double middle = 0.5 * (from + to), there = margin_at(middle);
    if (there >= 0)
      from = middle, good = there;
    else
      to = middle, bad = there;
  }
  if (from == 0) return {0, {}, Limiting::load};
  if (std::isnan(bad)) return {from, {}, Limiting::lost};
  const double share =
      closed_in("the duty limit", margin_at, Bracket{from, to, good, bad}, 40).nearest();
  return {share, shared(load, share), Limiting::temperature};
}

// T_lim(q) - peak(share, q) = 0 (H6.5), with the derivative by the share from differences to the fourth order.
MetricDerivative HeatMetrics::of_duty_limit(const LoadPoint& load, const MetricValue& value,
                                            bool fixed) {
  const DutyLimit found = duty_limit(load);
  if (found.limiting == Limiting::lost) return no_derivative(value);
  if (!found.at) return {value, {}, Smoothness::flat};
  const double s = found.share, h = 1e-2 * std::min(s, 1 - s);
  const auto f = [&](double by) { return shared(load, s + by).margin; };
  const double slope = (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
  Gradient g = CourseSensitivity(design_, found.at->course, found.at->lap, fixed)
                   .in_cycle(found.at->moment)[found.at->part];
  g[index_of(kTemperatureLimits[found.at->part])] -= 1;
  return derivative(value, g, 1 / slope);
}

}  // namespace twum::inline v0_1::core
