// SPDX-License-Identifier: Apache-2.0
#include "model.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motion/motion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

using P = Parameter;

// The motor whose wave has the amplitude that it is told, with the nodes that `auto` chooses for the design.
MotorDesign with_given_amplitude(MotorDesign design) {
  if (design.stator.radial_slices == kAutoSlices)
    design.stator.radial_slices = Motor(design).radial_slices();
  if (!design.stator.voltage) return design;
  design.stator.voltage.reset();
  design.stator.amplitude = std::clamp(10 * opening_amplitude(design), 1e-12, 1e-3);
  return design;
}

void require_equal_phases(const MotorDesign& design) {
  if (design.stator.imbalance && *design.stator.imbalance != Imbalance{})
    throw InputError(
        "phases or modes are unequal (stator.imbalance), but a motion has one wave; leave out "
        "voltage_ratio, phase_error and mode_splitting");
}

void require_capacitance(const MotionModel& model) {
  if (model.driven && model.has_series() && model.capacitance == 0)
    throw InputError(
        "blocked_capacitance is 0 F; a motion with driver_inductance or driver_resistance needs "
        "it: "
        "give stator.blocked_capacitance, such as 8.5 nF");
}

double required_inertia(const MotorDesign& design) {
  if (!design.rotor.inertia)
    throw InputError(
        "rotor_inertia is missing, which a motion needs; give rotor.inertia, such as 7e-6 kg.m^2");
  return *design.rotor.inertia + design.load.value_or(ShaftLoad{}).inertia;
}

}  // namespace

// A_1 = F_N / (2 K_c), K_c = pi r b E / h (D1.4, D1.5).
double opening_amplitude(const MotorDesign& design) {
  const double stiffness = std::numbers::pi * design.stator.contact_radius *
                           design.stator.contact_width * design.layer.youngs_modulus /
                           design.layer.thickness;
  return design.preload / (2 * stiffness);
}

MotionModel::MotionModel(const MotorDesign& design)
    : motor((require_equal_phases(design), with_given_amplitude(design))),
      driven(design.stator.voltage.has_value()),
      inertia(required_inertia(design)) {
  const MotorDesign& d = motor.design();
  const ShaftLoad load = d.load.value_or(ShaftLoad{});
  load_damping = load.damping, load_friction = load.friction;
  stiffness = load.stiffness, neutral = load.neutral;
  const Driver driver = d.driver.value_or(Driver{});
  off_resistance = driver.off_resistance;
  series_inductance = driver.inductance, series_resistance = driver.resistance;
  rotor_mass = d.rotor.mass.value_or(0), axial_damping = d.rotor.axial_damping;
  bed_stiffness = 2 * d.stator.contact_radius * d.stator.contact_width * d.layer.youngs_modulus /
                  d.layer.thickness;
  full_contact_amplitude = opening_amplitude(d);
  holding_torque = motor.holding_torque();
  mirrors_at_rest = d.stator.radial_slices == 1 && shear_viscosity(d) == 0 &&
                    d.friction.threshold == d.friction.kinetic;
  const double r = d.stator.contact_radius;
  crest_per_amplitude = get(d, P::neutral_plane_distance) * d.stator.wavelengths / (r * r);
  if (!has_modal_data(d)) return;
  const double rate = 2 * std::numbers::pi * get(d, P::resonance_frequency);
  mass = get(d, P::modal_mass), damping = modal_damping(d);
  stiffness_of_wave = rate * rate * mass;  // (D2.2)
  force_factor = get(d, P::force_factor);
  capacitance = get(d, P::blocked_capacitance), loss_tangent = get(d, P::loss_tangent);
  require_capacitance(*this);
}

namespace {

// theta_L with cos theta_L = z / A; pi in full contact, 0 without any.
double contact_angle(double amplitude, double height) {
  if (height <= -amplitude) return std::numbers::pi;
  return height >= amplitude ? 0 : std::acos(height / amplitude);
}

}  // namespace

// 2 r b (E / h) (A sin theta_L - z theta_L)
double MotionModel::normal_force(double amplitude, double height) const {
  const double angle = contact_angle(amplitude, height);
  return bed_stiffness * (amplitude * std::sin(angle) - height * angle);
}

MotionModel::NormalSlopes MotionModel::normal_slopes(double amplitude, double height) const {
  const double angle = contact_angle(amplitude, height);
  return {bed_stiffness * std::sin(angle), -bed_stiffness * angle};
}

// Newton's method from full contact, where the force is the largest: it falls and is convex in z, so that no step passes the root.
double MotionModel::balanced_height(double amplitude) const {
  const double preload = motor.design().preload;
  constexpr int kSteps = 100;
  double height = -std::max(amplitude, preload / (bed_stiffness * std::numbers::pi));
  for (int i = 0; i < kSteps; ++i) {
    const double step =
        (preload - normal_force(amplitude, height)) / normal_slopes(amplitude, height).per_height;
    height += step;
    if (!(std::abs(step) > 1e-15 * std::abs(height))) break;
  }
  return height;
}

double MotionModel::drive_force(double voltage) const {
  return force_factor * std::numbers::sqrt2 * voltage;
}

Complex MotionModel::off_voltage(double omega) const {
  return -off_resistance * kI * omega * force_factor /
         (1.0 + off_resistance * capacitive_admittance(omega));
}

}  // namespace twum::inline v0_1::motion
