// SPDX-License-Identifier: Apache-2.0
#include "metrics/wear_course.hpp"

#include "curve/curve.hpp"
#include "metrics/wear_quadrature.hpp"

#include <twum/base/scalar_search.hpp>

#include <cmath>
#include <functional>

namespace twum::inline v0_1::core {
namespace {

constexpr int kSamples = 16;      // of the margins along a life
constexpr double kWithin = 1e-6;  // of the depth at which lining or preload is gone

// The last depth at which something holds, between one where it does and one where it does not.
double last_depth(const std::function<bool(double)>& holds, double good, double bad) {
  constexpr double kClose = 1e-12;
  while (bad - good > kClose * bad) {
    const double middle = 0.5 * (good + bad);
    if (middle <= good || middle >= bad) break;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

// Time and turns for a depth.
std::vector<double> per_depth(const WearRate& rate) {
  return {1 / rate.depth, rate.turns / rate.depth};
}

// The number of slices that `auto` takes would change on the way, and rates with it by a millionth: too much for an integral to 1e-8,
// which would then halve all of its panels.
MotorDesign with_kept_slices(MotorDesign design) {
  if (design.stator.radial_slices == kAutoSlices)
    design.stator.radial_slices = Motor(design).radial_slices();
  return design;
}

}  // namespace

WearCourse::WearCourse(const MotorDesign& design, const std::optional<LoadPoint>& load)
    : design_(with_kept_slices(design)), load_(load), rates_(design_, load) {}

double WearCourse::margin(std::size_t limit, double depth) {
  const WearLimit& one = design_.wear->until[limit];
  return margin_of(one, rates_.motors().evaluate(depth, std::span(&one.request, 1)).front());
}

double WearCourse::root_of(std::size_t limit, double good, double bad) {
  const auto f = [&](double depth) { return margin(limit, depth); };
  return zero_or_last_value("the end of a life", f, good, bad, 48);
}

// The first limit that fails on the way to a depth.
std::optional<Life> WearCourse::first_limit(double depth) {
  const std::size_t limits = design_.wear->until.size();
  std::optional<Life> first;
  for (int i = 0; i <= kSamples && !first; ++i) {
    const double here = depth * i / kSamples, before = depth * (i - 1) / kSamples;
    for (std::size_t j = 0; j < limits; ++j) {
      if (margin(j, here) >= 0) continue;
      const double at = i == 0 ? 0 : root_of(j, before, here);
      if (!first || at < first->depth) first = {MetricStatus::ok, EndOfLife::limit, j, at, 0, 0};
    }
  }
  return first;
}

Life WearCourse::end() {
  const HardEnd hard = hard_end(design_);
  const double allowed = design_.wear->depth_limit.value_or(kNoLimit),
               left = (1 - kWithin) * hard.depth;
  Life end{MetricStatus::ok, EndOfLife::depth_limit, 0, allowed, 0, 0};
  if (left < allowed)
    end = {MetricStatus::ok,
           hard.spring_relaxed ? EndOfLife::preload_gone : EndOfLife::worn_through,
           0,
           left,
           0,
           0};
  if (std::isinf(end.depth)) throw SearchFailure{MetricStatus::undefined};
  return first_limit(end.depth).value_or(end);
}

// The last depth at which the worn motor carries the loads.
double WearCourse::last_carried(double depth) {
  double good = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double here = depth * i / kSamples;
    if (!rates_.carries(here))
      return last_depth([&](double at) { return rates_.carries(at); }, good, here);
    good = here;
  }
  return good;
}

// t and N of (V2.3).
void WearCourse::spend(Life& life) {
  const DepthIntegral spent =
      integral_over_depth([&](double depth) { return per_depth(rates_.at(depth)); }, 0, life.depth);
  life.seconds = spent.sums[0], life.revolutions = spent.sums[1];
  smooth_ = spent.smooth;
}

Life WearCourse::found() {
  const Life endless{MetricStatus::does_not_wear, EndOfLife::none, 0, 0, kNoLimit, kNoLimit};
  if (!(rates_.at(0).depth > 0)) return endless;
  Life found = end();
  try {
    if (!rates_.carries(found.depth)) throw SearchFailure{MetricStatus::unreachable};
    spend(found);
  } catch (const SearchFailure&) {
    found.end = EndOfLife::load_lost;
    found.depth = last_carried(found.depth);
    spend(found);
  }
  return std::isinf(found.seconds) ? endless : found;
}

// Once more without following waves where those that were followed are not those of the motor.
const Life& WearCourse::life() {
  if (life_) return *life_;
  life_ = found();
  if (life_->status == MetricStatus::ok && !rates_.confirm_or_stop_following(life_->depth))
    life_ = found();
  return *life_;
}

const WearRate& WearCourse::rate_with_slopes(double depth, bool fixed) {
  const std::pair place{depth, fixed};
  if (const auto known = slopes_.find(place); known != slopes_.end()) return known->second;
  return slopes_.emplace(place, rates_.with_slopes(depth, fixed)).first->second;
}

// @param spent  seconds and turns until then
WearPoint WearCourse::point_at(double depth, const std::function<std::vector<double>()>& spent) {
  const MotorDesign worn = worn_design(design_, depth);
  WearPoint here{.depth = depth,
                 .thickness = worn.layer.thickness,
                 .preload = worn.preload,
                 .contact_temperature = kNoValue};
  try {
    const WearRate rate = rates_.at(depth);
    const std::vector<double> until = spent();
    here.seconds = until[0], here.revolutions = until[1];
    here.rate = rate.depth, here.contact_temperature = rate.contact_temperature;
  } catch (const SearchFailure& failure) {
    here.status = failure.status;
  }
  return here;
}

namespace {

// Fewer depths are reached with fewer rates by three between each two.
constexpr std::size_t kManyDepths = 8;

std::optional<SmoothDepthIntegral> smooth_way(const NumbersAt& numbers,
                                              const std::vector<double>& depths) {
  if (depths.size() < kManyDepths || depths.front() < 0) return {};
  try {
    return SmoothDepthIntegral::of(numbers, depths.back());
  } catch (const SearchFailure&) {  // a load is lost on the way
    return {};
  }
}

}  // namespace

std::vector<WearPoint> WearCourse::points(const std::vector<double>& depths) {
  const NumbersAt numbers = [&](double u) { return per_depth(rates_.at(u)); };
  const auto smooth = smooth_way(numbers, depths);
  std::vector<WearPoint> points;
  for (const double depth : depths) {
    const WearPoint before = points.empty() ? WearPoint{} : points.back();
    points.push_back(point_at(depth, [&] {
      if (smooth) return smooth->up_to(depth);
      std::vector<double> spent = three_points_over_depth(numbers, before.depth, depth);
      spent[0] += before.seconds, spent[1] += before.revolutions;
      return spent;
    }));
    if (points.back().status != MetricStatus::ok) break;
  }
  return points;
}

}  // namespace twum::inline v0_1::core
