// SPDX-License-Identifier: Apache-2.0
// Values and derivatives of what follows from the wear of a motor (V2.7).
#include "metrics/wear_metrics.hpp"

#include "curve/curve.hpp"
#include "metrics/wear_quadrature.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>

namespace twum::core {
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

double WearMetrics::value(const MetricRequest& request) {
  const std::optional<LoadPoint> load = load_of_life(request);
  if (request.metric == M::wear_rate_at && !request.worn_at)
    return rate(loads(load), 0, false, false).depth_rate;
  const Life found = life(load);
  if (request.worn_at) {
    if (found.status != MetricStatus::ok) throw SearchFailure{MetricStatus::undefined};
    const MetricValue there =
        twum::evaluate(Motor(worn_design(design_, found.depth)), of_worn_motor(request));
    if (there.status != MetricStatus::ok) throw SearchFailure{there.status};
    return there.value;
  }
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return counts_turns(request.metric) ? found.revolutions : found.seconds;
}

MetricValue WearMetrics::evaluate(const MetricRequest& request) {
  if (!design_.wear) return {kNoValue, MetricStatus::undefined};
  try {
    const double found = value(request);
    return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                : MetricValue{kNoValue, MetricStatus::inaccurate};
  } catch (const SearchFailure& failure) {
    return {kNoValue, failure.status};
  } catch (const EvaluationError&) {  // a search without a bracket
    return {kNoValue, MetricStatus::unresolved};
  } catch (const InputError&) {  // a worn motor that is none
    return {kNoValue, MetricStatus::unresolved};
  }
}

// du_L / dq: of a limit -g_q / g_u.
Gradient WearMetrics::end_slope(const Life& end, bool fixed) const {
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
  if (!(u > 0)) throw SearchFailure{MetricStatus::undefined};
  const WearLimit& limit = design_.wear->until[end.limit];
  const MetricDerivative found =
      twum::differentiate(Motor(worn_design(design_, u)), limit.request, fixed);
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
  const std::optional<LoadPoint> load = load_of_life(request);
  const Loads now = loads(load);
  const Life end = life(load);
  const bool turns = counts_turns(request.metric);
  const auto per_depth = [&](double depth) {
    const Rate at = rate(now, depth, true, fixed);
    std::vector<double> slopes{1 / at.depth_rate};
    for (std::size_t q = 0; q < kParameterCount; ++q) {
      const double by_rate = -at.slope[q] / (at.depth_rate * at.depth_rate);
      slopes.push_back(turns ? at.turn_slope[q] / at.depth_rate + at.turn_rate * by_rate : by_rate);
    }
    return slopes;
  };
  const std::vector<double> along = integral_over_depth(per_depth, 0, end.depth);
  const Rate last = rate(now, end.depth, false, fixed);
  const double at_end = (turns ? last.turn_rate : 1) / last.depth_rate;
  MetricDerivative result{value, end_slope(end, fixed), Smoothness::smooth};
  for (std::size_t q = 0; q < kParameterCount; ++q)
    result.gradient[q] = result.gradient[q] * at_end + along[1 + q];
  return result;
}

MetricDerivative WearMetrics::of_worn(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  const Life end = life(load_of_life(request));
  MetricDerivative result =
      twum::differentiate(Motor(worn_design(design_, end.depth)), of_worn_motor(request), fixed);
  if (result.smoothness == Smoothness::undefined) return no_derivative(value);
  const double by_u = by_depth(design_, end.depth, result.gradient);
  const Gradient end_moves = end_slope(end, fixed);
  result.gradient = by_new_motor(design_, end.depth, result.gradient);
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
    return {found, rate(loads(load_of_life(request)), 0, true, fixed).slope, Smoothness::smooth};
  } catch (const SearchFailure&) {
    return no_derivative(found);
  } catch (const EvaluationError&) {
    return no_derivative(found);
  } catch (const InputError&) {
    return no_derivative(found);
  }
}

}  // namespace twum::core
