// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "random_contact.hpp"

#include <twum/core/motor_design.hpp>

#include <cmath>

namespace twum::test {

// Of the sizes of motors one can buy: elastic, with inertia and viscosity, and with mu_0 > mu.
inline MotorDesign random_ring(Dice& dice, int index) {
  MotorDesign d;
  Stator& s = d.stator;
  s.wavelengths = std::round(dice.uniform(5, 11));
  s.contact_radius = dice.uniform(0.015, 0.04);
  s.contact_width = s.contact_radius * dice.uniform(0.1, 0.2);
  s.neutral_plane_distance = s.contact_radius * dice.uniform(0.08, 0.13);
  s.resonance_frequency = dice.uniform(25e3, 60e3);
  s.frequency = *s.resonance_frequency * dice.uniform(1.015, 1.1);
  s.modal_mass = dice.log_uniform(5e-3, 0.1);
  s.quality_factor = dice.log_uniform(80, 400);
  s.force_factor = dice.uniform(0.2, 1);
  s.voltage = dice.log_uniform(8, 150);
  d.layer = {};
  d.layer.thickness = dice.log_uniform(1.5e-4, 1e-3);
  d.layer.youngs_modulus = dice.log_uniform(3e8, 1.5e9);
  d.layer.poisson_ratio = 0.38;
  d.layer.density = 1500;
  if (index % 3 == 0) d.layer.given_inertia = d.layer.given_shear_viscosity = 0;
  d.friction.kinetic = dice.uniform(0.15, 0.3);
  d.friction.threshold = d.friction.kinetic * (index % 3 == 2 ? dice.uniform(1.1, 1.5) : 1);
  d.preload = dice.log_uniform(50, 500);
  return d;
}

}  // namespace twum::test
