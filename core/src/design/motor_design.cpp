// SPDX-License-Identifier: Apache-2.0
#include <twum/core/motor_design.hpp>

#include "design/layer_properties.hpp"

#include <numbers>

namespace twum::inline v0_1 {
double drive_frequency(const MotorDesign& design) {
  const Stator& stator = design.stator;
  if (!stator.frequency_ratio) return stator.frequency;
  return *stator.frequency_ratio * get(design, Parameter::resonance_frequency);
}

double modal_damping(const MotorDesign& design) {
  const Stator& stator = design.stator;
  if (!stator.quality_factor) return stator.modal_damping;
  return modal_damping_of(*stator.quality_factor, get(design, Parameter::resonance_frequency),
                          get(design, Parameter::modal_mass));
}

bool has_radial_shape(const MotorDesign& design) {
  const RadialShape& shape = design.stator.radial_shape;
  return design.stator.geometry || !shape.table.empty() || shape.exponent != 0;
}

bool has_modal_data(const MotorDesign& design) {
  const Stator& stator = design.stator;
  if (stator.geometry) return stator.quality_factor || stator.modal_damping > 0;
  return stator.resonance_frequency && stator.modal_mass && stator.force_factor &&
         modal_damping(design) > 0;
}

double shear_modulus(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_shear_modulus.value_or(
      shear_modulus_of(layer.youngs_modulus, layer.poisson_ratio));
}

double shear_viscosity(const MotorDesign& design) {
  const double omega = 2 * std::numbers::pi * drive_frequency(design);
  return design.layer.given_shear_viscosity.value_or(
      shear_viscosity_of(design.layer.loss_factor, shear_modulus(design), omega));
}

double inertia(const MotorDesign& design) {
  const ContactLayer& layer = design.layer;
  return layer.given_inertia.value_or(inertia_of(layer.density, layer.thickness));
}

const char* to_string(Branch value) noexcept {
  switch (value) {
    case Branch::running: return "running";
    case Branch::dead: return "dead";
  }
  return "unknown";
}

const char* to_string(DriveControl value) noexcept {
  switch (value) {
    case DriveControl::frequency: return "frequency";
    case DriveControl::voltage: return "voltage";
    case DriveControl::amplitude: return "amplitude";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1
