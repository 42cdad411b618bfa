// SPDX-License-Identifier: Apache-2.0
#include <twum/core/parameters.hpp>

#include "design/layer_properties.hpp"
#include "design/parameter_slopes.hpp"
#include "design/plate_numbers.hpp"
#include "design/stator_heat.hpp"

#include <twum/base/dual.hpp>

#include <memory>

namespace twum::inline v0_1 {
namespace {

bool drifts_with_plate(Parameter parameter) {
  return parameter == Parameter::resonance_frequency || parameter == Parameter::force_factor ||
         parameter == Parameter::blocked_capacitance;
}

}  // namespace

std::vector<ParameterSlope> parameter_slopes(const MotorDesign& design,
                                             bool fixed_static_friction) {
  using Moving = Dual<double, 1>;
  ParameterArray<Moving> still;
  for (std::size_t i = 0; i < kParameterCount; ++i)
    still[i] = Moving(get(design, static_cast<Parameter>(i)));
  using PlateSlopes = std::array<std::array<double, kParameterCount>, kPlateNumbers>;
  const auto plate = design.stator.geometry
                         ? std::make_unique<const PlateSlopes>(plate_jacobian(design))
                         : nullptr;
  std::vector<ParameterSlope> slopes;
  slopes.reserve(2 * kParameterCount);  // enough without a geometry
  for (std::size_t moved = 0; moved < kParameterCount; ++moved) {
    const auto parameter = static_cast<Parameter>(moved);
    const bool of_warm_plate = design.stator.plate_drift.moves && drifts_with_plate(parameter);
    if (!in_use(design, parameter) && !of_warm_plate) continue;
    if (!plate && !leads_alternatives(parameter)) {
      slopes.push_back({moved, moved, 1});
      continue;
    }
    ParameterArray<Moving> values = still;
    values[moved].d[0] = 1;
    for (std::size_t i = 0; plate && i < kParameterCount; ++i)
      if (const auto number = plate_number_of(static_cast<Parameter>(i)))
        values[i].d[0] = (*plate)[index_of(*number)][moved];
    if (of_warm_plate) values[moved].d[0] = 1;
    set_alternatives(design, values);
    if (plate) add_stator_heat(design, values);
    for (std::size_t i = 0; i < kParameterCount; ++i)
      if (values[i].d[0] != 0) slopes.push_back({i, moved, values[i].d[0]});
  }
  constexpr std::size_t kKinetic = index_of(Parameter::kinetic_friction);
  if (const double ratio = friction_ratio(design.friction); !fixed_static_friction && ratio != 0)
    slopes.push_back({index_of(Parameter::static_friction), kKinetic, ratio});
  return slopes;
}

ParameterJacobian parameter_jacobian(const MotorDesign& design, bool fixed_static_friction) {
  ParameterJacobian jacobian{};
  for (const ParameterSlope& s : parameter_slopes(design, fixed_static_friction))
    jacobian[s.value][s.moved] = s.slope;
  return jacobian;
}

}  // namespace twum::inline v0_1
