// SPDX-License-Identifier: Apache-2.0
// Values and derivatives of what follows from the wear of a motor (V2.7).
#include "metrics/wear_metrics.hpp"

#include "design/wear_design.hpp"
#include "metrics/found_value.hpp"
#include "metrics/wear_quadrature.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

std::optional<LoadPoint> load_of_life(const MetricRequest& request) {
  const LoadPoint load =
      request.worn_at.value_or(LoadPoint{request.argument, request.at, request.torque});
  return load.argument == Argument::none ? std::nullopt : std::optional(load);
}

MetricRequest of_worn_motor(const MetricRequest& request) {
  MetricRequest plain = request;
  plain.worn_at.reset();
  return plain;
}

bool counts_turns(Metric metric) {
  return metric == M::life_revolutions || metric == M::life_revolutions_at;
}

}  // namespace

WearCourse& WearMetrics::course(const std::optional<LoadPoint>& load) {
  for (WearCourse& one : courses_)
    if (one.load() == load) return one;
  return courses_.emplace_back(design_, load);
}

WearCourse& WearMetrics::lived(const std::optional<LoadPoint>& load) {
  WearCourse& found = course(load);
  if (found.life().status != MetricStatus::ok) throw SearchFailure{found.life().status};
  return found;
}

double WearMetrics::value(const MetricRequest& request) {
  const std::optional<LoadPoint> load = load_of_life(request);
  if (request.worn_at) {
    if (is_endless(course(load).life().status)) throw SearchFailure{MetricStatus::undefined};
    const MetricValue there = twum::evaluate(lived(load).worn_motor(), of_worn_motor(request));
    if (there.status != MetricStatus::ok) throw SearchFailure{there.status};
    return there.value;
  }
  if (request.metric == M::wear_rate_at) return WearRates(design_, load).at(0).depth;
  const Life& life = lived(load).life();
  return counts_turns(request.metric) ? life.revolutions : life.seconds;
}

MetricValue WearMetrics::evaluate(const MetricRequest& request) {
  if (!design_.wear) return {kNoValue, MetricStatus::undefined};
  try {
    return found_value([&] { return value(request); });
  } catch (const InputError&) {  // a worn motor that is none
    return {kNoValue, MetricStatus::unresolved};
  }
}

// du_L / dq: of a limit -g_q / g_u.
Gradient WearMetrics::end_slope(WearCourse& course, bool fixed) const {
  const Life& end = course.life();
  Gradient g{};
  const double u = end.depth;
  switch (end.end) {
    case EndOfLife::depth_limit: g[index_of(P::wear_depth_limit)] = 1; return g;
    case EndOfLife::preload_gone:
      g[index_of(P::preload)] = u / design_.preload;
      g[index_of(P::preload_spring)] = -u / design_.wear->preload_spring;
      return g;
    case EndOfLife::worn_through: {  // h = s chi u
      Gradient thickness{};
      thickness[index_of(P::thickness)] = 1;
      g = by_new_motor(design_, u, thickness);
      for (double& d : g) d /= thickness_share(design_);
      return g;
    }
    case EndOfLife::limit: break;
    case EndOfLife::none:
    case EndOfLife::load_lost: throw SearchFailure{MetricStatus::undefined};
  }
  if (!(u > 0)) return g;  // the new motor violates it, and its neighbours do
  const WearLimit& limit = design_.wear->until[end.limit];
  const MetricDerivative found = twum::differentiate(course.worn_motor(), limit.request, fixed);
  if (found.value.status != MetricStatus::ok || found.smoothness == Smoothness::undefined)
    throw SearchFailure{MetricStatus::undefined};
  const double by_u = by_depth(design_, u, found.gradient);
  g = by_new_motor(design_, u, found.gradient);
  for (double& d : g) d /= -by_u;
  return g;
}

// dt_L/dq = - integral of nu_q / nu^2 du + (du_L/dq) / nu(u_L), and likewise of the turns.
MetricDerivative WearMetrics::of_life(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  WearCourse& course = lived(load_of_life(request));
  if (course.life().depth == 0) return {value, {}, Smoothness::flat};
  const bool turns = counts_turns(request.metric);
  const auto per_depth = [&](double at_depth) {
    const WearRate& at = course.rate_with_slopes(at_depth, fixed);
    std::vector<double> slopes{1 / at.depth};
    for (std::size_t q = 0; q < kParameterCount; ++q) {
      const double by_rate = -at.depth_slope[q] / (at.depth * at.depth);
      slopes.push_back(turns ? at.turn_slope[q] / at.depth + at.turns * by_rate : by_rate);
    }
    return slopes;
  };
  const double depth = course.life().depth;
  const std::vector<double> along = course.is_smooth()
                                        ? ten_points_over_depth(per_depth, 0, depth)
                                        : integral_over_depth(per_depth, 0, depth).sums;
  const WearRate last = course.rates().at(depth);
  const double at_end = (turns ? last.turns : 1) / last.depth;
  MetricDerivative result{value, end_slope(course, fixed), Smoothness::smooth};
  for (std::size_t q = 0; q < kParameterCount; ++q)
    result.gradient[q] = result.gradient[q] * at_end + along[1 + q];
  return result;
}

MetricDerivative WearMetrics::of_worn(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  WearCourse& course = lived(load_of_life(request));
  const double depth = course.life().depth;
  MetricDerivative result = twum::differentiate(course.worn_motor(), of_worn_motor(request), fixed);
  if (result.smoothness == Smoothness::undefined) return no_derivative(value);
  const double by_u = by_depth(design_, depth, result.gradient);
  const Gradient end_moves = end_slope(course, fixed);
  result.gradient = by_new_motor(design_, depth, result.gradient);
  for (std::size_t q = 0; q < kParameterCount; ++q) result.gradient[q] += by_u * end_moves[q];
  if (result.smoothness == Smoothness::flat) result.smoothness = Smoothness::smooth;
  result.value = value;
  return result;
}

MetricDerivative WearMetrics::differentiate(const MetricRequest& request, bool fixed) {
  const MetricValue found = evaluate(request);
  if (found.status != MetricStatus::ok) return no_derivative(found);
  try {
    if (request.worn_at) return of_worn(request, found, fixed);
    if (request.metric != M::wear_rate_at) return of_life(request, found, fixed);
    return {found, WearRates(design_, load_of_life(request)).with_slopes(0, fixed).depth_slope,
            Smoothness::smooth};
  } catch (const SearchFailure&) {
    return no_derivative(found);
  } catch (const EvaluationError&) {
    return no_derivative(found);
  } catch (const InputError&) {
    return no_derivative(found);
  }
}

}  // namespace twum::inline v0_1::core
