// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/thermal_design.hpp"
#include "heat/small_matrix.hpp"

#include <optional>
#include <vector>

namespace twum::inline v0_1::core {

/// T_s, T_c, T_l that parameters follow, in the order of ThermalNode [K].
using NodeTemperatures = Vector3;

/// A parameter that follows a temperature: q (1 + a (T - T_ref)) (H3.1).
struct Drifting {
  Parameter parameter, coefficient;
  ThermalNode node;
  double value;            ///< q, at the reference temperature
  double slope;            ///< a [1/K]
  bool with_other{false};  ///< moves by another one: mu_0 by mu, a given G by E
};

/// Those of a design: with a coefficient other than 0, mu_0 with mu, and a shear modulus that is given with Young's modulus.
std::vector<Drifting> drifting_parameters(const MotorDesign& design);

/// 1 + a (T - T_ref).
double drift_factor(const Drifting& one, const NodeTemperatures& x, double reference);

/// The motor whose parameters are those at the temperatures. Nothing where a factor is below a tenth, or a value leaves its range.
std::optional<MotorDesign> at_temperatures(const MotorDesign& design, const NodeTemperatures& x);

}  // namespace twum::inline v0_1::core
