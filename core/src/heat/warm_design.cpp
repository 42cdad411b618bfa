// SPDX-License-Identifier: Apache-2.0
#include "heat/warm_design.hpp"

#include <twum/base/error.hpp>

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

constexpr double kLeastFactor =
    0.1;  // a linear law means nothing where a value has lost nine tenths

// The factor of a number of the plate; null for other parameters and without a geometry.
double* plate_factor(MotorDesign& design, P parameter) {
  if (!design.stator.geometry) return nullptr;
  PlateDrift& drift = design.stator.plate_drift;
  if (parameter == P::resonance_frequency) return &drift.resonance_frequency;
  if (parameter == P::force_factor) return &drift.force_factor;
  return parameter == P::blocked_capacitance ? &drift.blocked_capacitance : nullptr;
}

}  // namespace

std::vector<Drifting> drifting_parameters(const MotorDesign& design) {
  std::vector<Drifting> list;
  for (const DriftRow& row : kDrifts) {
    const double slope = get(design, row.coefficient);
    if (!in_use(design, row.coefficient) || slope == 0) continue;
    const Drifting one{row.parameter, row.coefficient, row.node, get(design, row.parameter), slope};
    list.push_back(one);
    const auto with_it = [&](P other) {
      list.push_back({other, row.coefficient, row.node, get(design, other), slope, true});
    };
    if (row.parameter == P::kinetic_friction) with_it(P::static_friction);
    if (row.parameter == P::youngs_modulus && design.layer.given_shear_modulus)
      with_it(P::shear_modulus);
  }
  return list;
}

double drift_factor(const Drifting& one, const NodeTemperatures& x, double reference) {
  return 1 + one.slope * (x[static_cast<std::size_t>(one.node)] - reference);
}

std::optional<MotorDesign> at_temperatures(const MotorDesign& design, const NodeTemperatures& x) {
  MotorDesign warm = design;
  const double reference = reference_temperature(design);
  warm.stator.plate_drift.moves = design.stator.geometry.has_value();
  std::vector<ParameterValue> values;
  for (const Drifting& one : drifting_parameters(design)) {
    const double factor = drift_factor(one, x, reference);
    if (!(factor >= kLeastFactor)) return {};
    if (double* of_plate = plate_factor(warm, one.parameter))
      *of_plate = factor;
    else
      values.emplace_back(one.parameter, one.value * factor);
  }
  try {
    return with(warm, values);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace twum::inline v0_1::core
