// SPDX-License-Identifier: Apache-2.0
// Derivatives of what follows from the motor's temperatures (H6.1).
#include "metrics/heat_metrics.hpp"

#include "curve/curve.hpp"
#include "heat/heat_modes.hpp"
#include "metrics/heat_course.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;
using P = Parameter;

constexpr double kTied = 1e-9;  // [K] parts so close in their margins have a kink between them

void add(Gradient& to, double factor, const Gradient& more) {
  for (std::size_t q = 0; q < kParameterCount; ++q) to[q] += factor * more[q];
}

}  // namespace

std::optional<HeatMetrics::Rows> HeatMetrics::at_fixed_nodes(const Known& at, bool fixed) {
  const HeatSolver solver(problem(at.load));
  const NodeTemperatures& x = at.steady.state.x;
  const auto of_warm = LoadLosses(design_, at.load, motors()).gradients(x, fixed);
  if (!of_warm) return {};
  const DriftRule rule(design_, fixed);
  const HeatState& state = at.steady.state;
  Rows rows{steady_moves(network_numbers(design_, network(), fixed), solver.matrices(), state.theta,
                         state.p),
            {}};
  for (std::size_t k = 0; k < kSources; ++k) {
    rows.slope[k] = rule.by_temperatures((*of_warm)[k]);
    const Gradient direct = rule.at_fixed_temperatures((*of_warm)[k], x);
    for (std::size_t i = 0; i < kParts; ++i) add(rows.parts[i], solver.response()[i][k], direct);
  }
  for (Gradient& part : rows.parts) part[index_of(P::ambient_temperature)] += 1;
  return rows;
}

// dx/dq = (I - Phi_x)^-1 Phi_q, and the parts with the losses that follow.
std::optional<HeatMetrics::Moves> HeatMetrics::moves(const Known& at, bool fixed) {
  const auto rows = at_fixed_nodes(at, fixed);
  if (!rows) return {};
  const HeatSolver solver(problem(at.load));
  const Matrix3 settle = inverse(plus(kIdentity3, -1, solver.loop(rows->slope)));
  Moves moves{rows->parts, {}};
  for (std::size_t q = 0; q < kParameterCount; ++q) {
    Vector3 phi;
    for (std::size_t i = 0; i < 3; ++i) phi[i] = rows->parts[kNodeParts[i]][q];
    const Vector3 node = settle * phi;
    for (std::size_t i = 0; i < 3; ++i) moves.nodes[i][q] = node[i];
    for (std::size_t i = 0; i < kParts; ++i)
      for (std::size_t k = 0; k < kSources; ++k)
        moves.parts[i][q] += solver.response()[i][k] * dot(rows->slope[k], node);
  }
  return moves;
}

MetricDerivative HeatMetrics::of_margin(const Known& at, const MetricValue& value, bool fixed) {
  const auto moved = moves(at, fixed);
  if (!moved) return no_derivative(value);
  const std::size_t part = hottest(at);
  MetricDerivative result{value, {}, Smoothness::smooth};
  add(result.gradient, -1, moved->parts[part]);
  result.gradient[index_of(kTemperatureLimits[part])] += 1;
  const PartValues<double> limit = temperature_limits(design_);
  for (std::size_t i = 0; i < kParts; ++i)
    if (i != part && limit[i] - at.parts[i] - margin(at) < kTied)
      result.smoothness = Smoothness::one_sided;
  return result;
}

MetricDerivative HeatMetrics::of_parts(const MetricRequest& request, const MetricValue& value,
                                       bool fixed) {
  const Known& at = steady({request.argument, request.at, request.torque});
  if (request.metric == M::temperature_margin_at) return of_margin(at, value, fixed);
  const auto moved = moves(at, fixed);
  if (!moved) return no_derivative(value);
  return {value, moved->parts[*part_of(request.metric)], Smoothness::smooth};
}

std::optional<std::array<Gradient, 3>> HeatMetrics::node_moves(const LoadPoint& load, bool fixed) {
  if (load.argument == Argument::none) return mean_moves(fixed);
  const auto moved = moves(steady(load), fixed);
  return moved ? std::optional(moved->nodes) : std::nullopt;
}

// dX/dq = X_q + X_x dx/dq
MetricDerivative HeatMetrics::of_warm(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  const NodeTemperatures x = nodes(*request.warm_at);
  MetricRequest plain = request;
  plain.warm_at.reset();
  MetricDerivative result = twum::differentiate(*motors()->at(x), plain, fixed);
  const auto moved = node_moves(*request.warm_at, fixed);
  if (result.smoothness == Smoothness::undefined || !moved) return no_derivative(value);
  const DriftRule rule(design_, fixed);
  const Vector3 by_nodes = rule.by_temperatures(result.gradient);
  result.gradient = rule.at_fixed_temperatures(result.gradient, x);
  for (std::size_t i = 0; i < 3; ++i) add(result.gradient, by_nodes[i], (*moved)[i]);
  if (result.smoothness == Smoothness::flat) result.smoothness = Smoothness::smooth;
  result.value = value;
  return result;
}

// tau = 1 / mu, and of mu = v^T K v / v^T C v with v^T C v = 1 the moves of v do not count (H4.1).
MetricDerivative HeatMetrics::of_time_constant(const MetricValue& value, bool fixed) {
  MetricDerivative result{value, {}, Smoothness::smooth};
  const HeatModes modes(network());
  const double tau = value.value;
  for (const NetworkNumber& number : network_numbers(design_, network(), fixed)) {
    double mu = 0;
    for (std::size_t i = 0; i < kMasses; ++i) {
      for (std::size_t j = 0; j < kMasses; ++j)
        mu += number.slope.K[i][j] * modes.shape(i, 0) * modes.shape(j, 0);
      mu -= number.capacities[i] * std::pow(modes.shape(i, 0), 2) / tau;
    }
    add(result.gradient, -tau * tau * mu, number.by);
  }
  return result;
}

MetricDerivative HeatMetrics::differentiate(const MetricRequest& request, bool fixed) {
  const MetricValue found = evaluate(request);
  if (found.status != MetricStatus::ok) return no_derivative(found);
  try {
    if (request.warm_at) return of_warm(request, found, fixed);
    switch (request.metric) {
      case M::thermal_gain_at: return no_derivative(found);
      case M::thermal_time_constant: return of_time_constant(found, fixed);
      case M::continuous_torque:
      case M::continuous_torque_at: return of_continuous(request, found, fixed);
      case M::start_temperature: return of_start(found, fixed);
      case M::on_time_at: return of_on_time(load_of(request), found, fixed);
      case M::duty_limit_at: return of_duty_limit(load_of(request), found, fixed);
      case M::stator_peak_temperature:
      case M::rotor_peak_temperature:
      case M::housing_peak_temperature:
      case M::contact_peak_temperature: return of_peak(*part_of(request.metric), found, fixed);
      default:
        return is_timed(request) ? of_after(request, found, fixed)
                                 : of_parts(request, found, fixed);
    }
  } catch (const SearchFailure&) {
    return no_derivative(found);
  } catch (const EvaluationError&) {
    return no_derivative(found);
  }
}

}  // namespace twum::inline v0_1::core
