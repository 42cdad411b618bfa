// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/load_losses.hpp"

#include <functional>
#include <vector>

namespace twum::inline v0_1::core {

/// A number of a network, and how it moves with the parameters of the design.
struct NetworkNumber {
  NetworkMatrices<double> slope;  ///< derivatives of the matrices by the number
  Masses<double> capacities{};    ///< and of the capacities
  Gradient by{};                  ///< derivatives of the number
};

/// The conductances and capacities of a design's network: those of three masses, or conductance and time constant of one node.
/// @throws SearchFailure where the losses that determine the node have no derivative
std::vector<NetworkNumber> network_numbers(const MotorDesign& design, const HeatNetwork& network,
                                           bool fixed_static_friction);

/// How steady temperatures of the parts move with the network, at losses that stay.
std::array<Gradient, kParts> steady_moves(const std::vector<NetworkNumber>& numbers,
                                          const NetworkMatrices<double>& matrices,
                                          const Masses<double>& theta, const Sources<double>& p);

/// Derivative of a function of the load torque: central differences to the fourth order, one-sided ones to the second order at
/// no-load.
double by_load(const MotorDesign& design, const std::function<double(double)>& f, double torque);

}  // namespace twum::inline v0_1::core
