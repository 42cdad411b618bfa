// SPDX-License-Identifier: Apache-2.0
// Derivatives of what follows from the motor's temperatures (H6.1).
#include "metrics/heat_metrics.hpp"

#include "curve/curve.hpp"
#include "heat/heat_modes.hpp"

#include <twum/base/dual.hpp>
#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>

namespace twum::core {
namespace {

using M = Metric;
using P = Parameter;

// Conductances, in the order of Paths.
constexpr std::array kPathParameters{P::conductance_stator_contact,  P::conductance_lining,
                                     P::conductance_stator_housing,  P::conductance_rotor_housing,
                                     P::conductance_housing_ambient, P::conductance_stator_ambient,
                                     P::conductance_rotor_ambient};
using PathDual = Dual<double, static_cast<int>(kPathParameters.size())>;

constexpr double kTied = 1e-9;  // [K] parts so close in their margins have a kink between them

void add(Gradient& to, double factor, const Gradient& more) {
  for (std::size_t q = 0; q < kParameterCount; ++q) to[q] += factor * more[q];
}

NetworkMatrices<PathDual> moving_matrices(const HeatNetwork& network) {
  Paths<PathDual> g;
  const Paths<double> still = paths_of(network);
  for (std::size_t i = 0; i < g.size(); ++i)
    g[i] = PathDual::variable(still[i], static_cast<int>(i));
  return three_mass_matrices(g);
}

}  // namespace

// Central differences to the fourth order; one-sided ones to the second order at no-load. The functions are smooth and exact to 1e-12:
// with a step of 1e-3 of the scale both errors are of order 1e-9.
double HeatMetrics::by_load(const std::function<double(double)>& f, double torque) const {
  const double h = 1e-3 * std::max(torque, 1e-3 * holding_torque());
  if (torque < 2 * h) return (-3 * f(torque) + 4 * f(torque + h) - f(torque + 2 * h)) / (2 * h);
  return (8 * (f(torque + h) - f(torque - h)) - (f(torque + 2 * h) - f(torque - 2 * h))) / (12 * h);
}

double HeatMetrics::holding_torque() const {
  return design_.friction.threshold * design_.preload * design_.stator.contact_radius;
}

// G_l itself, or what it follows from (H1.6).
Gradient HeatMetrics::of_lining(double by_conductance) const {
  Gradient g{};
  if (design_.thermal->conductances.lining) {
    g[index_of(P::conductance_lining)] = by_conductance;
    return g;
  }
  const double G = get(design_, P::conductance_lining);
  for (const P p : {P::conductivity, P::contact_radius, P::contact_width})
    g[index_of(p)] = by_conductance * G / get(design_, p);
  g[index_of(P::thickness)] = -by_conductance * G / get(design_, P::thickness);
  return g;
}

// G = P / rise (H1.10); the losses at the reference temperature depend on the torque, too.
Gradient HeatMetrics::conductance_of_node(bool fixed) {
  const OneNode& node = *design_.thermal->one_node;
  MotorDesign reference = design_;
  reference.thermal->drift = {};
  const auto sum_at = [&](double torque) {
    const double T = reference_temperature(design_);
    const WarmLosses found = LoadLosses(reference, {Argument::torque, torque}).at({T, T, T});
    if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
    return found.p[0] + found.p[1] + found.p[2] + found.p[3];
  };
  const double T = reference_temperature(design_);
  const auto losses =
      LoadLosses(reference, {Argument::torque, node.torque}).gradients({T, T, T}, fixed);
  if (!losses) throw SearchFailure{MetricStatus::undefined};
  Gradient g{};
  for (const Gradient& one : *losses) add(g, 1 / node.rise, one);
  g[index_of(P::one_node_rise)] -= sum_at(node.torque) / (node.rise * node.rise);
  g[index_of(P::one_node_torque)] +=
      by_load([&](double torque) { return sum_at(torque); }, node.torque) / node.rise;
  return g;
}

// Derivatives of the parts' temperatures by the network at losses that stay.
std::array<Gradient, kParts> HeatMetrics::by_network(const Known& at, bool fixed) {
  std::array<Gradient, kParts> moved{};
  const Sources<double>& p = at.steady.state.p;
  if (network().one_node) {
    const Gradient G = conductance_of_node(fixed);
    const double by_G = -(p[0] + p[1] + p[2] + p[3]) / std::pow(network().stator_ambient, 2);
    for (Gradient& part : moved) add(part, by_G, G);
    return moved;
  }
  Sources<PathDual> sources;
  for (std::size_t k = 0; k < kSources; ++k) sources[k] = PathDual(p[k]);
  const PartValues<PathDual> parts = steady_parts(moving_matrices(network()), sources);
  for (std::size_t i = 0; i < kParts; ++i)
    for (std::size_t j = 0; j < kPathParameters.size(); ++j) {
      if (j == kL)
        add(moved[i], 1, of_lining(parts[i].d[j]));
      else
        moved[i][index_of(kPathParameters[j])] += parts[i].d[j];
    }
  return moved;
}

std::optional<HeatMetrics::Rows> HeatMetrics::at_fixed_nodes(const Known& at, bool fixed) {
  const HeatSolver solver(problem(at.load));
  const NodeTemperatures& x = at.steady.state.x;
  const auto of_warm = LoadLosses(design_, at.load).gradients(x, fixed);
  if (!of_warm) return {};
  const DriftRule rule(design_, fixed);
  Rows rows{by_network(at, fixed), {}};
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
  const Limits limit = limits();
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

// dX/dq = X_q + X_x dx/dq
MetricDerivative HeatMetrics::of_warm(const MetricRequest& request, const MetricValue& value,
                                      bool fixed) {
  const Known& at = steady(*request.warm_at);
  const NodeTemperatures& x = at.steady.state.x;
  MetricRequest plain = request;
  plain.warm_at.reset();
  MetricDerivative result = twum::differentiate(Motor(*at_temperatures(design_, x)), plain, fixed);
  const auto moved = moves(at, fixed);
  if (result.smoothness == Smoothness::undefined || !moved) return no_derivative(value);
  const DriftRule rule(design_, fixed);
  const Vector3 by_nodes = rule.by_temperatures(result.gradient);
  result.gradient = rule.at_fixed_temperatures(result.gradient, x);
  for (std::size_t i = 0; i < 3; ++i) add(result.gradient, by_nodes[i], moved->nodes[i]);
  if (result.smoothness == Smoothness::flat) result.smoothness = Smoothness::smooth;
  result.value = value;
  return result;
}

// tau = 1 / mu, and mu = v^T K v with v^T C v = 1, so that v's own moves do not count (H4.1).
MetricDerivative HeatMetrics::of_time_constant(const MetricValue& value) const {
  MetricDerivative result{value, {}, Smoothness::smooth};
  if (network_->one_node) {
    result.gradient[index_of(P::one_node_time_constant)] = 1;
    return result;
  }
  const HeatModes modes(*network_);
  const NetworkMatrices<PathDual> m = moving_matrices(*network_);
  const double tau = value.value;
  PathDual mu(0.0);
  for (std::size_t i = 0; i < kMasses; ++i)
    for (std::size_t j = 0; j < kMasses; ++j)
      mu += m.K[i][j] * (modes.shape(i, 0) * modes.shape(j, 0));
  for (std::size_t j = 0; j < kPathParameters.size(); ++j) {
    const double slope = -tau * tau * mu.d[j];
    if (j == kL)
      add(result.gradient, 1, of_lining(slope));
    else
      result.gradient[index_of(kPathParameters[j])] = slope;
  }
  constexpr std::array kCapacities{P::stator_heat_capacity, P::rotor_heat_capacity,
                                   P::housing_heat_capacity};
  for (std::size_t i = 0; i < kMasses; ++i)
    result.gradient[index_of(kCapacities[i])] = tau * std::pow(modes.shape(i, 0), 2);
  return result;
}

MetricDerivative HeatMetrics::differentiate(const MetricRequest& request, bool fixed) {
  const MetricValue found = evaluate(request);
  if (found.status != MetricStatus::ok) return no_derivative(found);
  try {
    if (request.warm_at) return of_warm(request, found, fixed);
    switch (request.metric) {
      case M::thermal_gain_at: return no_derivative(found);
      case M::thermal_time_constant: return of_time_constant(found);
      case M::continuous_torque:
      case M::continuous_torque_at: return of_continuous(request, found, fixed);
      case M::start_temperature: return of_start(found, fixed);
      default: return of_parts(request, found, fixed);
    }
  } catch (const SearchFailure&) {
    return no_derivative(found);
  } catch (const EvaluationError&) {
    return no_derivative(found);
  }
}

}  // namespace twum::core
