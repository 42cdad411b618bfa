// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plate_solver.hpp"
#include "stator_plate.hpp"

#include <twum/stator/stator_model.hpp>

#include <vector>

namespace twum::inline v0_1::stator {

/// The lowest modes of one number of nodal diameters.
struct Order {
  Mesh mesh;
  Spectrum spectrum;
  std::vector<double> frequencies;  ///< 0 of rigid-body modes [Hz]
};

inline constexpr int kLowest = 8;  ///< modes of an order that are looked at
/// Modes of an order that in most plates reach beyond the wave by more than the nearest mode; found in half of the time.
inline constexpr int kFew = 4;

Order solve_order(const StatorPlate<double>& plate, PlateTheory theory, InnerEdge support,
                  int nodal_diameters, int count);

/// What a mode of an order is.
StatorMode described(const Order& order, const StatorPlate<double>& plate, double contact_radius,
                     std::size_t mode);

/// Position of a mode among all modes.
struct ModePlace {
  std::size_t order;
  std::size_t mode;
};

/// Which mode carries the travelling wave.
struct Choice {
  std::size_t mode;
  ModeIdentity identity;
};

/// The mode of an order that keeps its sign on the ring and has the smallest modal mass.
/// @throws EvaluationError "no-ring-mode"
Choice choose_mode(const Order& order, const StatorPlate<double>& plate, double ring_inner,
                   double contact_radius);

/// Eigenvectors whose eigenvalues are nearer than this are known to rounding over the gap, 1e-12 / 1e-6,
/// at best, and their derivatives to the square of that.
inline constexpr double kCrossing = 1e-6;

/// Whether another mode of the order has the same eigenvalue to kCrossing.
bool crosses(const Spectrum& spectrum, std::size_t mode);

/// All other modes, nearest frequency first.
std::vector<ModePlace> by_distance(const std::vector<Order>& orders, const ModePlace& chosen);

}  // namespace twum::inline v0_1::stator
