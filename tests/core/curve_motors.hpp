// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/test_motors.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <numbers>
#include <span>

namespace twum::test {

inline MetricValue ask(const Motor& motor, Metric which) {
  return evaluate(motor, MetricRequest{which});
}

inline MetricValue ask_at_torque(const Motor& motor, Metric which, double torque) {
  return evaluate(motor, MetricRequest{which, Argument::torque, torque});
}

inline MetricDerivative differentiated(const Motor& motor, const MetricRequest& request) {
  return differentiate(motor, std::span(&request, 1)).front();
}

/// G, gamma and m given outright, so that each can be scaled.
inline MotorDesign outright(MotorDesign design) {
  const MotorDesign derived = design;
  design.layer.given_shear_modulus = shear_modulus(derived);
  design.layer.given_shear_viscosity = shear_viscosity(derived);
  design.layer.given_inertia = inertia(derived);
  return design;
}

/// A ring motor with a light, heavy or lightly damped layer: its own motion lasts for several turns, so that
/// torque and powers have dips, kinks and several maxima over speed. mu_0 = mu.
inline MotorDesign ringing_motor(Uniform& random, int i) {
  MotorDesign design = ring_motor();
  design.layer.loss_factor = 0.002 * (1 + i % 7);
  design.layer.given_inertia = random.logarithmic(5e-5, 5e-3);
  design.preload *= random.logarithmic(0.05, 5);
  design.stator.modal_damping = 45;
  return design;
}

/// A realistic motor, mu_0 = mu for odd i and well above it for even ones.
inline MotorDesign holding_motor(Uniform& random, int i) {
  MotorDesign design = realistic_design(random);
  design.friction.threshold = design.friction.kinetic * (i % 2 == 1 ? 1 : random(1.02, 2.5));
  design.stator.modal_damping = 30;
  return design;
}

/// A motor of the box of theory section 10 with mu_0 = mu.
inline MotorDesign box_motor(Uniform& random) {
  MotorDesign design = random_box_point(random).design;
  design.friction.threshold = design.friction.kinetic;
  design.stator.modal_damping = 30;
  return design;
}

/// The ring motor with an elastic layer of given half contact angle phi and friction-compliance number S at rest
/// (C8.4).
inline MotorDesign elastic_ring(double phi, double compliance) {
  MotorDesign design = elastic(ring_motor());
  const Stator& s = design.stator;
  design.layer.given_shear_modulus = design.friction.kinetic * design.layer.youngs_modulus *
                                     s.contact_radius /
                                     (compliance * s.wavelengths * s.neutral_plane_distance);
  design.preload =
      full_contact_load(design) / std::numbers::pi * (std::sin(phi) - phi * std::cos(phi));
  return design;
}

/// A narrow contact at 145 kHz whose soft layer holds a fifth more than it slides.
inline MotorDesign sticky_motor() {
  MotorDesign design;
  design.stator.wavelengths = 8;
  design.stator.contact_radius = 0.039208379619791345;
  design.stator.contact_width = 0.006389914430234179;
  design.stator.neutral_plane_distance = 0.00034867570723548361;
  design.stator.frequency = 145287.36654851906;
  design.stator.amplitude = 2.7943915578906325e-07;
  design.stator.modal_damping = 30;
  design.layer.thickness = 0.00011252512572183046;
  design.layer.youngs_modulus = 3341564.0085601537;
  design.layer.poisson_ratio = 0.41228156082484574;
  design.layer.density = 3980.5149858990785;
  design.layer.loss_factor = 0.036935163871543809;
  design.friction = {0.8046646707483085, 0.97799561774438304};
  design.preload = 0.8274424898795929;
  return design;
}

}  // namespace twum::test
