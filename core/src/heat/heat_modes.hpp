// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "heat/network.hpp"

namespace twum::inline v0_1::core {

/// The modes of the masses: K v = mu C v with V^T C V = 1 (H4.1). In their amplitudes z = V^T C theta the network is
/// z' = -mu z + V^T B p.
class HeatModes {
 public:
  explicit HeatModes(const HeatNetwork& network);

  /// mu [1/s], the slowest first. Of one node the first alone counts.
  const Masses<double>& rates() const { return rates_; }
  /// Amplitudes of a state of the masses.
  Masses<double> amplitudes(const Masses<double>& theta) const;
  /// Those of the steady state: V^T B p / mu.
  Masses<double> steady(const Sources<double>& p) const;
  /// The state of the masses with these amplitudes.
  Masses<double> masses(const Masses<double>& z) const;
  /// What remains of the distance to the steady state after a time.
  Masses<double> after(const Masses<double>& z, const Sources<double>& p, double time) const;
  /// Derivative of a rate if entry (i, j) of K, or C_i, moves: v_i v_j and -mu v_i^2.
  double shape(std::size_t mass, std::size_t mode) const { return shapes_[mass][mode]; }
  const NetworkMatrices<double>& matrices() const { return matrices_; }

 private:
  NetworkMatrices<double> matrices_;
  Masses<double> capacities_, rates_;
  Rows3<double, kMasses> shapes_;  // column k is v_k
};

/// A rise over time: base + sum of weights exp(-rates t).
struct Decay {
  double base;
  Masses<double> weights, rates;

  double at(double time) const;
  /// Lowest and highest value from 0 to a time.
  std::pair<double, double> range(double time) const;
};

/// The rise of a part from the amplitudes z on, under constant losses.
Decay decay_of(const HeatModes& modes, std::size_t part, const Masses<double>& z,
               const Sources<double>& p);

}  // namespace twum::inline v0_1::core
