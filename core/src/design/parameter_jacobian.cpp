// SPDX-License-Identifier: Apache-2.0
#include <twum/core/design/parameters.hpp>

#include "design/layer_properties.hpp"
#include "design/plate_numbers.hpp"

#include <twum/base/dual.hpp>

namespace twum {

ParameterJacobian parameter_jacobian(const MotorDesign& design, bool fixed_static_friction) {
  using Moving = Dual<double, 1>;
  ParameterArray<Moving> still;
  for (std::size_t i = 0; i < kParameterCount; ++i)
    still[i] = Moving(get(design, static_cast<Parameter>(i)));
  using PlateSlopes = std::array<std::array<double, kParameterCount>, kPlateNumbers>;
  const PlateSlopes plate = design.stator.geometry ? plate_jacobian(design) : PlateSlopes{};
  ParameterJacobian jacobian{};
  for (std::size_t moved = 0; moved < kParameterCount; ++moved) {
    if (!in_use(design, static_cast<Parameter>(moved))) continue;
    ParameterArray<Moving> values = still;
    values[moved].d[0] = 1;
    for (std::size_t i = 0; design.stator.geometry && i < kParameterCount; ++i)
      if (const auto number = plate_number_of(static_cast<Parameter>(i)))
        values[i].d[0] = plate[index_of(*number)][moved];
    if (moved == index_of(Parameter::kinetic_friction) && !fixed_static_friction)
      values[index_of(Parameter::static_friction)].d[0] = friction_ratio(design.friction);
    values = with_alternatives(design, values);
    for (std::size_t i = 0; i < kParameterCount; ++i) jacobian[i][moved] = values[i].d[0];
  }
  return jacobian;
}

}  // namespace twum
