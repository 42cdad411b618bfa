// SPDX-License-Identifier: Apache-2.0
#include "metrics/heat_metrics.hpp"

#include "curve/curve.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

LoadPoint load_of(const MetricRequest& request) {
  return {request.argument, request.at, request.torque};
}

}  // namespace

std::optional<std::size_t> part_of(M metric) {
  switch (metric) {
    case M::stator_temperature_at: return 0;
    case M::rotor_temperature_at: return 1;
    case M::housing_temperature_at: return 2;
    case M::contact_temperature_at: return 3;
    default: return {};
  }
}

const HeatNetwork& HeatMetrics::network() {
  if (!network_) network_ = network_of(design_);
  return *network_;
}

HeatProblem HeatMetrics::problem(const LoadPoint& load) {
  const LoadLosses losses(design_, load);
  return {network(), design_.thermal->ambient,
          [losses](const NodeTemperatures& x) { return losses.at(x); }};
}

const HeatMetrics::Known& HeatMetrics::known(const LoadPoint& load) {
  for (const Known& one : known_)
    if (one.load == load) return one;
  const HeatSolver solver(problem(load));
  Known found{load, solver.from_cold(), {}};
  found.parts = solver.parts(found.steady.state);
  return known_.emplace_back(found);
}

const HeatMetrics::Known& HeatMetrics::steady(const LoadPoint& load) {
  const Known& found = known(load);
  if (!found.steady.ok()) throw SearchFailure{found.steady.state.status};
  return found;
}

HeatMetrics::Limits HeatMetrics::limits() const {
  Limits limits;
  limits.fill(kNoLimit);
  for (std::size_t i = 0; i < kTemperatureLimits.size(); ++i)
    if (const double given = get(design_, kTemperatureLimits[i]); !std::isnan(given))
      limits[i] = given;
  return limits;
}

std::size_t HeatMetrics::hottest(const Known& known) const {
  const Limits limit = limits();
  std::size_t least = 0;
  for (std::size_t i = 1; i < kParts; ++i)
    if (limit[i] - known.parts[i] < limit[least] - known.parts[least]) least = i;
  return least;
}

double HeatMetrics::margin(const Known& known) const {
  const std::size_t part = hottest(known);
  return limits()[part] - known.parts[part];
}

double HeatMetrics::value(const MetricRequest& request) {
  if (request.warm_at) {
    const Known& at = steady(*request.warm_at);
    MetricRequest plain = request;
    plain.warm_at.reset();
    const MetricValue found =
        twum::evaluate(Motor(*at_temperatures(design_, at.steady.state.x)), plain);
    if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
    return found.value;
  }
  switch (request.metric) {
    case M::thermal_time_constant: return time_constants(network()).back();
    case M::continuous_torque:
    case M::continuous_torque_at: return continuous(request).torque;
    case M::start_temperature: return start_temperature();
    case M::thermal_gain_at: return steady(load_of(request)).steady.gain;
    case M::temperature_margin_at: {
      const double least = margin(steady(load_of(request)));
      if (std::isinf(least)) throw SearchFailure{MetricStatus::undefined};
      return least;
    }
    default: return steady(load_of(request)).parts[*part_of(request.metric)];
  }
}

MetricValue HeatMetrics::evaluate(const MetricRequest& request) {
  if (!design_.thermal) return {kNoValue, MetricStatus::undefined};
  const LoadPoint load = request.warm_at ? *request.warm_at : load_of(request);
  if (load.argument == Argument::both && !(load.at > 0)) return {kNoValue, MetricStatus::undefined};
  try {
    const double found = value(request);
    return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                : MetricValue{kNoValue, MetricStatus::inaccurate};
  } catch (const SearchFailure& failure) {
    return {kNoValue, failure.status};
  } catch (const EvaluationError&) {  // a search without a bracket
    return {kNoValue, MetricStatus::unresolved};
  }
}

}  // namespace twum::core
