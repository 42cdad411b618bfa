// SPDX-License-Identifier: Apache-2.0
#include <twum/core/design/motor_design.hpp>

#include <numbers>

namespace twum {

// (T1.2)
double shear_modulus(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_shear_modulus.value_or(layer.youngs_modulus / (2 * (1 + layer.poisson_ratio)));
}

// (T1.3)
double shear_viscosity(const MotorDesign& design) {
  const double omega = 2 * std::numbers::pi * design.stator.frequency;
  return design.layer.given_shear_viscosity.value_or(design.layer.loss_factor *
                                                     shear_modulus(design) / omega);
}

// (T1.4)
double inertia(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_inertia.value_or(layer.density * layer.thickness * layer.thickness / 3);
}

}  // namespace twum
