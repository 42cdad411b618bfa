// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>

#include <numbers>

namespace twum::inline v0_1 {

/// The layer's properties from its material, and the inverse; S is double or carries derivatives. All code uses these
/// formulas.
/// @{
template <typename S>
S shear_modulus_of(const S& youngs_modulus, const S& poisson_ratio) {  // (T1.2)
  return youngs_modulus / (2.0 * (1.0 + poisson_ratio));
}
template <typename S>
S poisson_ratio_of(const S& youngs_modulus, const S& shear_modulus) {
  return youngs_modulus / (2.0 * shear_modulus) - 1.0;
}
template <typename S>
S shear_viscosity_of(const S& loss_factor, const S& shear_modulus, const S& omega) {  // (T1.3)
  return loss_factor * shear_modulus / omega;
}
template <typename S>
S loss_factor_of(const S& shear_viscosity, const S& shear_modulus, const S& omega) {
  return shear_viscosity * omega / shear_modulus;
}
template <typename S>
S inertia_of(const S& density, const S& thickness) {  // (T1.4)
  return density * thickness * thickness / 3.0;
}
template <typename S>
S density_of(const S& inertia, const S& thickness) {
  return 3.0 * inertia / (thickness * thickness);
}
/// Conductance of the whole lining for heat.
template <typename S>
S lining_conductance_of(const S& conductivity, const S& radius, const S& width,
                        const S& thickness) {  // (H1.6)
  return 2 * std::numbers::pi * conductivity * radius * width / thickness;
}
/// Damping of a mode from its quality factor, and the inverse, which has the same form.
template <typename S>
S modal_damping_of(const S& quality_factor, const S& resonance, const S& modal_mass) {  // (D2.2)
  return 2 * std::numbers::pi * resonance * modal_mass / quality_factor;
}
/// @}

/// mu_0 / mu, which stays constant when mu changes; 1 without friction.
inline double friction_ratio(const Friction& friction) {
  return friction.kinetic > 0 ? friction.threshold / friction.kinetic : 1;
}

/// Values in the order of the parameter table.
template <typename S>
using ParameterArray = std::array<S, kParameterCount>;

/// True if the design says where the free stator resonates.
inline bool has_resonance(const MotorDesign& design) {
  return design.stator.geometry || design.stator.resonance_frequency;
}

/// Sets the alternatives that follow from the parameters in use.
/// @param given  says which are in use
template <typename S>
void set_alternatives(const MotorDesign& given, ParameterArray<S>& p) {
  using P = Parameter;
  const auto at = [&p](P parameter) -> S& { return p[index_of(parameter)]; };
  if (in_use(given, P::frequency_ratio)) {
    at(P::frequency) = at(P::frequency_ratio) * at(P::resonance_frequency);
  } else if (has_resonance(given)) {
    at(P::frequency_ratio) = at(P::frequency) / at(P::resonance_frequency);
  }
  const P damping = in_use(given, P::quality_factor) ? P::quality_factor : P::modal_damping;
  if (has_resonance(given) && (given.stator.geometry || given.stator.modal_mass)) {
    const P alternative = damping == P::modal_damping ? P::quality_factor : P::modal_damping;
    at(alternative) = modal_damping_of(at(damping), at(P::resonance_frequency), at(P::modal_mass));
  }
  const S omega = 2 * std::numbers::pi * at(P::frequency);
  const S &E = at(P::youngs_modulus), &h = at(P::thickness);
  if (in_use(given, P::shear_modulus)) {
    at(P::poisson_ratio) = poisson_ratio_of(E, at(P::shear_modulus));
  } else {
    at(P::shear_modulus) = shear_modulus_of(E, at(P::poisson_ratio));
  }
  const S& G = at(P::shear_modulus);
  if (in_use(given, P::shear_viscosity)) {
    at(P::loss_factor) = loss_factor_of(at(P::shear_viscosity), G, omega);
  } else {
    at(P::shear_viscosity) = shear_viscosity_of(at(P::loss_factor), G, omega);
  }
  if (in_use(given, P::inertia)) {
    at(P::density) = density_of(at(P::inertia), h);
  } else {
    at(P::inertia) = inertia_of(at(P::density), h);
  }
  if (!given.thermal) return;
  if (!given.thermal->reference) at(P::reference_temperature) = at(P::ambient_temperature);
  if (!given.thermal->conductances.lining && given.layer.conductivity && !given.thermal->one_node)
    at(P::conductance_lining) =
        lining_conductance_of(at(P::conductivity), at(P::contact_radius), at(P::contact_width), h);
}

/// True if set_alternatives() reads it.
constexpr bool leads_alternatives(Parameter parameter) {
  using P = Parameter;
  switch (parameter) {
    case P::frequency:
    case P::frequency_ratio:
    case P::resonance_frequency:
    case P::modal_damping:
    case P::quality_factor:
    case P::modal_mass:
    case P::thickness:
    case P::youngs_modulus:
    case P::poisson_ratio:
    case P::density:
    case P::loss_factor:
    case P::shear_modulus:
    case P::shear_viscosity:
    case P::inertia:
    case P::contact_radius:
    case P::contact_width:
    case P::conductivity:
    case P::ambient_temperature: return true;
    default: return false;
  }
}

}  // namespace twum::inline v0_1
