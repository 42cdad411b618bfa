// SPDX-License-Identifier: Apache-2.0
#include "metrics/heat_numbers.hpp"

#include "curve/curve.hpp"
#include "design/stator_heat.hpp"

#include <twum/base/dual.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

// Conductances, in the order of Paths.
constexpr std::array kPathParameters{P::conductance_stator_contact,  P::conductance_lining,
                                     P::conductance_stator_housing,  P::conductance_rotor_housing,
                                     P::conductance_housing_ambient, P::conductance_stator_ambient,
                                     P::conductance_rotor_ambient};
using PathDual = Dual<double, static_cast<int>(kPathParameters.size())>;

constexpr std::array kCapacities{P::stator_heat_capacity, P::rotor_heat_capacity,
                                 P::housing_heat_capacity};

template <std::size_t rows, std::size_t columns>
void take_slope(std::array<std::array<double, columns>, rows>& into,
                const std::array<std::array<PathDual, columns>, rows>& moving, std::size_t path) {
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) into[i][j] = moving[i][j].d[path];
}

// The number itself, or what it follows from (H1.7, H1.8, H1.9): the parameters of the geometry, one after the other.
Gradient of_stator(const MotorDesign& design, P number) {
  using Moving = Dual<double, 1>;
  Gradient g{};
  if (in_use(design, number)) {
    g[index_of(number)] = 1;
    return g;
  }
  ParameterArray<Moving> still;
  for (std::size_t i = 0; i < kParameterCount; ++i)
    still[i] = Moving(get(design, static_cast<Parameter>(i)));
  for (std::size_t moved = 0; moved < kParameterCount; ++moved) {
    if (!in_use(design, static_cast<Parameter>(moved))) continue;
    ParameterArray<Moving> values = still;
    values[moved].d[0] = 1;
    add_stator_heat(design, values);
    if (moved != index_of(number)) g[moved] = values[index_of(number)].d[0];
  }
  return g;
}

// G_l itself, or what it follows from (H1.6).
Gradient of_lining(const MotorDesign& design) {
  Gradient g{};
  if (design.thermal->conductances.lining) {
    g[index_of(P::conductance_lining)] = 1;
    return g;
  }
  const double G = get(design, P::conductance_lining);
  for (const P p : {P::conductivity, P::contact_radius, P::contact_width})
    g[index_of(p)] = G / get(design, p);
  g[index_of(P::thickness)] = -G / get(design, P::thickness);
  return g;
}

std::vector<NetworkNumber> of_masses(const MotorDesign& design, const HeatNetwork& network) {
  const Paths<double> still = paths_of(network);
  Paths<PathDual> paths;
  for (std::size_t j = 0; j < paths.size(); ++j)
    paths[j] = PathDual::variable(still[j], static_cast<int>(j));
  const NetworkMatrices<PathDual> moving = three_mass_matrices(paths);
  std::vector<NetworkNumber> numbers;
  for (std::size_t j = 0; j < paths.size(); ++j) {
    NetworkNumber& one = numbers.emplace_back();
    take_slope(one.slope.K, moving.K, j), take_slope(one.slope.B, moving.B, j);
    take_slope(one.slope.M, moving.M, j), take_slope(one.slope.D, moving.D, j);
    one.by = j == kL ? of_lining(design) : of_stator(design, kPathParameters[j]);
  }
  for (std::size_t i = 0; i < kMasses; ++i) {
    NetworkNumber& one = numbers.emplace_back();
    one.slope = zero_matrices<double>();
    one.capacities[i] = 1;
    one.by = of_stator(design, kCapacities[i]);
  }
  return numbers;
}

// G = P / rise (H1.10); the losses at the reference temperature depend on the torque, too.
Gradient conductance_of_node(const MotorDesign& design, bool fixed) {
  const OneNode& node = *design.thermal->one_node;
  MotorDesign reference = design;
  reference.thermal->drift = {};
  const double T = reference_temperature(design);
  const auto sum_at = [&](double torque) {
    const WarmLosses found = LoadLosses(reference, {Argument::torque, torque}).at({T, T, T});
    if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
    return found.p[0] + found.p[1] + found.p[2] + found.p[3];
  };
  const auto losses =
      LoadLosses(reference, {Argument::torque, node.torque}).gradients({T, T, T}, fixed);
  if (!losses) throw SearchFailure{MetricStatus::undefined};
  Gradient g{};
  for (const Gradient& one : *losses)
    for (std::size_t q = 0; q < kParameterCount; ++q) g[q] += one[q] / node.rise;
  g[index_of(P::one_node_rise)] -= sum_at(node.torque) / (node.rise * node.rise);
  g[index_of(P::one_node_torque)] += by_load(design, sum_at, node.torque) / node.rise;
  return g;
}

// K = G and C = G tau.
std::vector<NetworkNumber> of_node(const MotorDesign& design, const HeatNetwork& network,
                                   bool fixed) {
  std::vector<NetworkNumber> numbers(2);
  for (NetworkNumber& one : numbers) one.slope = zero_matrices<double>();
  numbers[0].slope.K[0][0] = 1;
  numbers[0].capacities[0] = design.thermal->one_node->time_constant;
  numbers[0].by = conductance_of_node(design, fixed);
  numbers[1].capacities[0] = network.stator_ambient;
  numbers[1].by[index_of(P::one_node_time_constant)] = 1;
  return numbers;
}

}  // namespace

std::vector<NetworkNumber> network_numbers(const MotorDesign& design, const HeatNetwork& network,
                                           bool fixed) {
  return network.one_node ? of_node(design, network, fixed) : of_masses(design, network);
}

std::array<Gradient, kParts> steady_moves(const std::vector<NetworkNumber>& numbers,
                                          const NetworkMatrices<double>& matrices,
                                          const Masses<double>& theta, const Sources<double>& p) {
  std::array<Gradient, kParts> moved{};
  for (const NetworkNumber& number : numbers) {
    Masses<double> heat;  // K dtheta = dB p - dK theta
    for (std::size_t i = 0; i < kMasses; ++i)
      heat[i] = dot(number.slope.B[i], p) - dot(number.slope.K[i], theta);
    const Masses<double> masses = solved(matrices.K, heat);
    const PartValues<double> direct = parts_at(number.slope, theta, p);
    for (std::size_t i = 0; i < kParts; ++i)
      for (std::size_t q = 0; q < kParameterCount; ++q)
        moved[i][q] += (direct[i] + dot(matrices.M[i], masses)) * number.by[q];
  }
  return moved;
}

// The functions are smooth and exact to 1e-12: with a step of 1e-3 of the scale both errors are of order 1e-9.
double by_load(const MotorDesign& design, const std::function<double(double)>& f, double torque) {
  const double holding = design.friction.threshold * design.preload * design.stator.contact_radius;
  const double h = 1e-3 * std::max(torque, 1e-3 * holding);
  if (torque < 2 * h) return (-3 * f(torque) + 4 * f(torque + h) - f(torque + 2 * h)) / (2 * h);
  return (8 * (f(torque + h) - f(torque - h)) - (f(torque + 2 * h) - f(torque - 2 * h))) / (12 * h);
}

}  // namespace twum::inline v0_1::core
