// SPDX-License-Identifier: Apache-2.0
#include "metrics/wear_metrics.hpp"

#include "curve/curve.hpp"
#include "metrics/wear_quadrature.hpp"

#include <twum/base/error.hpp>
#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace twum::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSamples = 16;      // of the margins along a life
constexpr double kWithin = 1e-6;  // of the depth at which lining or preload is gone

double known(const MetricValue& found) {
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return found.value;
}

MetricDerivative known(const MetricDerivative& found) {
  if (found.value.status != MetricStatus::ok) throw SearchFailure{found.value.status};
  if (found.smoothness == Smoothness::undefined) throw SearchFailure{MetricStatus::undefined};
  return found;
}

void add(Gradient& to, double factor, const Gradient& more) {
  for (std::size_t q = 0; q < kParameterCount; ++q) to[q] += factor * more[q];
}

double drift_of(const std::optional<double>& coefficient) { return coefficient.value_or(0); }

}  // namespace

bool WearMetrics::is_warm() const {
  return design_.thermal &&
         (drifts(design_) || drift_of(design_.thermal->drift.specific_wear) != 0);
}

WearMetrics::Loads WearMetrics::loads(const std::optional<LoadPoint>& load) const {
  if (load) return {{*load, 1, {}}};
  if (design_.operation.empty()) throw SearchFailure{MetricStatus::undefined};
  Loads shares = design_.operation;
  const double period =
      std::accumulate(shares.begin(), shares.end(), 0.0,
                      [](double sum, const LoadPhase& phase) { return sum + phase.time; });
  for (LoadPhase& phase : shares) phase.time /= period;
  return shares;
}

// k / mu at the temperature of the contact.
double WearMetrics::ratio(double contact) const {
  const double cold = specific_wear_of_both(design_) / design_.friction.kinetic;
  if (std::isnan(contact)) return cold;
  const ThermalDrift& drift = design_.thermal->drift;
  const double way = contact - reference_temperature(design_);
  return cold * (1 + drift_of(drift.specific_wear) * way) /
         (1 + drift_of(drift.kinetic_friction) * way);
}

// (k / mu) I of a load (V1.1), at the steady temperatures under it where the motor has some (V2.1).
WearMetrics::Rate WearMetrics::rate_of(const MotorDesign& worn, const LoadPhase& phase,
                                       bool gradient, bool fixed) const {
  const LoadPoint& load = *phase.load;
  MotorDesign now = worn;
  if (phase.voltage && now.stator.voltage) now.stator.voltage = phase.voltage;
  std::vector<MetricRequest> asked{
      {M::wear_intensity_at, load.argument, load.at, load.torque, {}, {}},
      {M::speed_at, load.argument, load.at, load.torque, {}, {}}};
  const bool runs_at_speed = load.argument != Argument::torque;
  if (runs_at_speed) asked.pop_back();
  if (is_warm()) {
    for (MetricRequest& one : asked) one.warm_at = load;
    asked.push_back({M::contact_temperature_at, load.argument, load.at, load.torque, {}, {}});
  }
  Rate rate;
  const auto sum_up = [&](double intensity, double speed, double contact) {
    rate.contact_temperature = contact;
    rate.depth_rate = ratio(contact) * intensity;
    rate.turn_rate = std::fabs(speed) / kTurn;
  };
  if (!gradient) {
    const auto found = twum::evaluate(Motor(now), asked);
    sum_up(known(found[0]), runs_at_speed ? load.at : known(found[1]),
           is_warm() ? known(found.back()) : kNoValue);
    return rate;
  }
  const auto found = twum::differentiate(Motor(now), asked, fixed);
  const MetricDerivative intensity = known(found[0]);
  const std::optional<MetricDerivative> speed =
      runs_at_speed ? std::nullopt : std::optional(known(found[1]));
  const std::optional<MetricDerivative> contact =
      is_warm() ? std::optional(known(found.back())) : std::nullopt;
  sum_up(intensity.value.value, speed ? speed->value.value : load.at,
         contact ? contact->value.value : kNoValue);
  add(rate.slope, ratio(rate.contact_temperature), intensity.gradient);
  add(rate.slope, rate.depth_rate, by_ratio(contact));
  if (speed) add(rate.turn_slope, 1 / kTurn, speed->gradient);
  if (phase.voltage) rate.slope[index_of(P::voltage)] = rate.turn_slope[index_of(P::voltage)] = 0;
  return rate;
}

// Derivatives of ln(k / mu), with the temperature of the contact that follows.
Gradient WearMetrics::by_ratio(const std::optional<MetricDerivative>& contact) const {
  Gradient g{};
  const double k = specific_wear_of_both(design_);
  g[index_of(P::specific_wear)] += 1 / k;
  g[index_of(P::stator_specific_wear)] += 1 / k;
  g[index_of(P::kinetic_friction)] -= 1 / design_.friction.kinetic;
  if (!contact) return g;
  const ThermalDrift& drift = design_.thermal->drift;
  const double a = drift_of(drift.specific_wear), b = drift_of(drift.kinetic_friction);
  const double way = contact->value.value - reference_temperature(design_);
  const double by_way = a / (1 + a * way) - b / (1 + b * way);
  add(g, by_way, contact->gradient);
  g[index_of(design_.thermal->reference ? P::reference_temperature : P::ambient_temperature)] -=
      by_way;
  g[index_of(P::drift_specific_wear)] += way / (1 + a * way);
  g[index_of(P::drift_kinetic_friction)] -= way / (1 + b * way);
  return g;
}

// Of an operation with temperatures: the masses at their means (H5.2), contact and lining at those of each load.
std::vector<NodeTemperatures> WearMetrics::mission_temperatures(const MotorDesign& worn) const {
  const HeatCourse course(worn, worn.operation);
  const PartValues<double> mean = course.mean(course.periodic());
  const double ambient = worn.thermal->ambient;
  std::vector<NodeTemperatures> nodes;
  for (const CoursePhase& phase : course.phases()) {
    const HeatState state = phase.solver.at_masses(
        {mean[0] - ambient, mean[1] - ambient, mean[2] - ambient}, phase.solver.cold_nodes());
    if (state.status != MetricStatus::ok) throw SearchFailure{state.status};
    nodes.push_back(state.x);
  }
  return nodes;
}

WearMetrics::Rate WearMetrics::mission_rate(const Loads& loads, const MotorDesign& worn) const {
  const std::vector<NodeTemperatures> nodes = mission_temperatures(worn);
  Rate sum;
  sum.contact_temperature = -kNoLimit;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (!loads[i].load) continue;
    const LoadPoint& load = *loads[i].load;
    MotorDesign now = worn;
    if (loads[i].voltage && now.stator.voltage) now.stator.voltage = loads[i].voltage;
    const auto warm = at_temperatures(now, nodes[i]);
    if (!warm) throw SearchFailure{MetricStatus::temperature_out_of_range};
    const auto ask = [&](Metric metric) {
      return known(twum::evaluate(Motor(*warm), at_load(metric, load)));
    };
    const double speed = load.argument == Argument::torque ? ask(M::speed_at) : load.at;
    sum.depth_rate += loads[i].time * ratio(nodes[i][1]) * ask(M::wear_intensity_at);
    sum.turn_rate += loads[i].time * std::fabs(speed) / kTurn;
    sum.contact_temperature = std::fmax(sum.contact_temperature, nodes[i][1]);
  }
  return sum;
}

WearMetrics::Rate WearMetrics::rate(const Loads& loads, double depth, bool gradient,
                                    bool fixed) const {
  const MotorDesign worn = worn_design(design_, depth);
  const bool mission = loads.size() > 1 || !loads.front().load;
  if (mission && is_warm()) {
    if (gradient) throw SearchFailure{MetricStatus::undefined};
    return mission_rate(loads, worn);
  }
  Rate sum;
  for (const LoadPhase& phase : loads) {
    if (!phase.load) continue;
    const Rate one = rate_of(worn, phase, gradient, fixed);
    sum.depth_rate += phase.time * one.depth_rate;
    sum.turn_rate += phase.time * one.turn_rate;
    sum.contact_temperature = std::fmax(sum.contact_temperature, one.contact_temperature);
    add(sum.slope, phase.time, one.slope);
    add(sum.turn_slope, phase.time, one.turn_slope);
  }
  if (gradient) {
    sum.slope = by_new_motor(design_, depth, sum.slope);
    sum.turn_slope = by_new_motor(design_, depth, sum.turn_slope);
  }
  return sum;
}

bool WearMetrics::carries(const Loads& loads, double depth) const {
  try {
    return rate(loads, depth, false, false).depth_rate >= 0;
  } catch (const SearchFailure&) {
    return false;
  }
}

// How far a limit of the life is kept, in its unit; NaN where the worn motor has no value for it.
double WearMetrics::margin(std::size_t limit, double depth) const {
  const WearLimit& one = design_.wear->until[limit];
  const MetricValue found = twum::evaluate(Motor(worn_design(design_, depth)), one.request);
  if (is_endless(found.status)) return std::isinf(one.upper) ? kNoLimit : -kNoLimit;
  if (found.status != MetricStatus::ok) return kNoValue;
  return std::fmin(found.value - one.lower, one.upper - found.value);
}

namespace {

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

}  // namespace

// Where a margin reaches zero between two depths, or the last depth at which the limit has a value.
double WearMetrics::root_of(std::size_t limit, double good, double bad) const {
  const auto f = [&](double depth) { return margin(limit, depth); };
  double at_bad = f(bad);
  while (std::isnan(at_bad) && bad - good > 1e-12 * bad) {
    const double middle = 0.5 * (good + bad), there = f(middle);
    if (there >= 0)
      good = middle;
    else
      bad = middle, at_bad = there;
  }
  if (std::isnan(at_bad)) return good;
  return closed_in("the end of a life", f, Bracket{good, bad, f(good), at_bad}, 48).nearest();
}

// The first limit that fails on the way to a depth.
std::optional<Life> WearMetrics::first_limit(double depth) const {
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

Life WearMetrics::end_of() const {
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
double WearMetrics::last_carried(const Loads& loads, double depth) const {
  double good = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double here = depth * i / kSamples;
    if (!carries(loads, here))
      return last_depth([&](double at) { return carries(loads, at); }, good, here);
    good = here;
  }
  return good;
}

// t and N of (V2.3).
void WearMetrics::spend(const Loads& loads, Life& life) const {
  const auto per_depth = [&](double depth) {
    const Rate now = rate(loads, depth, false, false);
    return std::vector{1 / now.depth_rate, now.turn_rate / now.depth_rate};
  };
  const std::vector<double> spent = integral_over_depth(per_depth, 0, life.depth);
  life.seconds = spent[0], life.revolutions = spent[1];
}

Life WearMetrics::found_life(const Loads& now) const {
  const Life endless{MetricStatus::does_not_wear, EndOfLife::none, 0, 0, kNoLimit, kNoLimit};
  if (!(rate(now, 0, false, false).depth_rate > 0)) return endless;
  Life found = end_of();
  try {
    if (!carries(now, found.depth)) throw SearchFailure{MetricStatus::unreachable};
    spend(now, found);
  } catch (const SearchFailure&) {
    found.end = EndOfLife::load_lost;
    found.depth = last_carried(now, found.depth);
    spend(now, found);
  }
  return std::isinf(found.seconds) ? endless : found;
}

const Life& WearMetrics::life(const std::optional<LoadPoint>& load) {
  for (const auto& [of, life] : known_)
    if (of == load) return life;
  return known_.emplace_back(load, found_life(loads(load))).second;
}

std::vector<WearPoint> WearMetrics::course(const std::optional<LoadPoint>& load,
                                           const std::vector<double>& depths) {
  const Loads now = loads(load);
  std::vector<WearPoint> points;
  Life way;
  for (const double depth : depths) {
    WearPoint point;
    point.depth = depth;
    try {
      const MotorDesign worn = worn_design(design_, depth);
      point.thickness = worn.layer.thickness, point.preload = worn.preload;
      const Rate at = rate(now, depth, false, false);
      point.rate = at.depth_rate, point.contact_temperature = at.contact_temperature;
      const double before = points.empty() ? 0 : points.back().depth;
      const auto per_depth = [&](double u) {
        const Rate r = rate(now, u, false, false);
        return std::vector{1 / r.depth_rate, r.turn_rate / r.depth_rate};
      };
      const std::vector<double> spent = three_points_over_depth(per_depth, before, depth);
      way.seconds += spent[0], way.revolutions += spent[1];
      point.seconds = way.seconds, point.revolutions = way.revolutions;
    } catch (const SearchFailure& failure) {
      point.status = failure.status;
    }
    points.push_back(point);
    if (point.status != MetricStatus::ok) break;
  }
  return points;
}

}  // namespace twum::core
