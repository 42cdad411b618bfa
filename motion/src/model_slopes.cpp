// SPDX-License-Identifier: Apache-2.0
#include "model_slopes.hpp"

#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

using P = Parameter;

MotorDesign with_given_slices(MotorDesign design) {
  if (design.stator.radial_slices == kAutoSlices)
    design.stator.radial_slices = Motor(design).radial_slices();
  return design;
}

ModelSlope slope(const MotorDesign& design, const ParameterJacobian& jacobian, P parameter) {
  const auto of = [&](P value) { return jacobian[index_of(value)][index_of(parameter)]; };
  const double size = std::fabs(get(design, parameter));
  ModelSlope s{};
  s.parameter = parameter;
  s.scale = size > 0 ? size : 1;
  s.omega = 2 * std::numbers::pi * of(P::frequency);
  s.inertia = of(P::rotor_inertia) + of(P::load_inertia);
  s.load_damping = of(P::load_damping), s.load_friction = of(P::load_friction);
  s.stiffness = of(P::load_stiffness), s.neutral = of(P::load_neutral);
  s.off_resistance = of(P::off_resistance);
  s.series_inductance = of(P::driver_inductance), s.series_resistance = of(P::driver_resistance);
  if (!has_modal_data(design)) return s;
  const double rate = 2 * std::numbers::pi * get(design, P::resonance_frequency);
  s.mass = of(P::modal_mass), s.damping = of(P::modal_damping);
  s.stiffness_of_wave = rate * rate * s.mass + 2 * rate * get(design, P::modal_mass) * 2 *
                                                   std::numbers::pi * of(P::resonance_frequency);
  s.force_factor = of(P::force_factor), s.capacitance = of(P::blocked_capacitance);
  s.loss_tangent = of(P::loss_tangent), s.voltage = of(P::voltage);
  return s;
}

}  // namespace

bool counts_in_motion(P parameter) {
  return parameter < P::conductivity || parameter > P::lining_youngs_modulus;
}

ModelSlopes::ModelSlopes(const MotorDesign& design, bool fixed_static_friction,
                         std::span<const Parameter> wanted)
    : contact_(with_given_slices(design), fixed_static_friction) {
  const ParameterJacobian jacobian = parameter_jacobian(design, fixed_static_friction);
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    const auto parameter = static_cast<P>(i);
    const bool asked = wanted.empty() || std::ranges::find(wanted, parameter) != wanted.end();
    if (asked && in_use(design, parameter) && counts_in_motion(parameter))
      columns_.push_back(slope(design, jacobian, parameter));
  }
}

}  // namespace twum::inline v0_1::motion
