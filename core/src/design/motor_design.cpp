// SPDX-License-Identifier: Apache-2.0
#include <twum/core/design/motor_design.hpp>

#include "design/layer_properties.hpp"

#include <numbers>

namespace twum {

double shear_modulus(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_shear_modulus.value_or(
      shear_modulus_of(layer.youngs_modulus, layer.poisson_ratio));
}

double shear_viscosity(const MotorDesign& design) {
  const double omega = 2 * std::numbers::pi * design.stator.frequency;
  return design.layer.given_shear_viscosity.value_or(
      shear_viscosity_of(design.layer.loss_factor, shear_modulus(design), omega));
}

double inertia(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_inertia.value_or(inertia_of(layer.density, layer.thickness));
}

}  // namespace twum
