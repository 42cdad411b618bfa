// SPDX-License-Identifier: Apache-2.0
#include "support/test_motors.hpp"

#include "support/constants.hpp"

#include <algorithm>
#include <cmath>

namespace twum::test {
namespace {

double between(double unit, double low, double high) { return low + (high - low) * unit; }
double log_between(double unit, double low, double high) {
  return low * std::exp(unit * std::log(high / low));
}

}  // namespace

double Uniform::logarithmic(double low, double high) { return log_between((*this)(), low, high); }

MotorDesign ring_motor() { return {}; }

MotorDesign elastic(MotorDesign design) {
  design.layer.given_shear_viscosity = 0;
  design.layer.given_inertia = 0;
  return design;
}

MotorDesign damped(MotorDesign design) {
  design.layer.given_inertia = 0;
  return design;
}

double full_contact_load(const MotorDesign& design) {
  const auto& s = design.stator;
  const double wave_number = s.wavelengths / s.contact_radius;
  return 2 * kPi * s.wavelengths * s.contact_width * design.layer.youngs_modulus * s.amplitude /
         (design.layer.thickness * wave_number);
}

MotorDesign at_load(MotorDesign design, double load) {
  design.preload = load * full_contact_load(design);
  return design;
}

double crest_speed_of(const MotorDesign& design) {
  const auto& s = design.stator;
  const double wave_number = s.wavelengths / s.contact_radius;
  return wave_number * s.neutral_plane_distance * s.amplitude * 2 * kPi * s.frequency /
         s.contact_radius;
}

MotorDesign realistic_design(Uniform& random) {
  MotorDesign design;
  auto& s = design.stator;
  s.wavelengths = std::floor(random(5, 14));
  s.contact_radius = random(12e-3, 42e-3);
  s.contact_width = s.contact_radius * random(0.05, 0.25);
  s.neutral_plane_distance = random(1.5e-3, 4e-3);
  s.frequency = random(25e3, 65e3);
  s.amplitude = random(0.5e-6, 2.5e-6);
  auto& layer = design.layer;
  layer.thickness = random.logarithmic(0.1e-3, 0.6e-3);
  layer.youngs_modulus = random.logarithmic(1.5e9, 1e10);
  layer.poisson_ratio = random(0.28, 0.42);
  layer.density = random(1200, 2200);
  layer.loss_factor = random.logarithmic(0.02, 0.2);
  const double kinetic = random(0.1, 0.4);
  design.friction = {kinetic, kinetic * (random.chance(0.5) ? 1.0 : random(1.0, 1.3))};
  design.preload = full_contact_load(design) * random.logarithmic(1e-3, 0.5);
  return design;
}

BoxPoint box_point(std::span<const double, kBoxDimension> u) {
  BoxPoint point;
  auto& s = point.design.stator;
  s.wavelengths = std::floor(between(u[0], 1, 30.999));
  s.contact_radius = log_between(u[1], 2e-3, 100e-3);
  s.contact_width = s.contact_radius * between(u[2], 0.02, 0.4);
  s.neutral_plane_distance = log_between(u[3], 0.2e-3, 10e-3);
  s.frequency = log_between(u[4], 20e3, 150e3);
  s.amplitude = log_between(u[5], 0.05e-6, 5e-6);
  auto& layer = point.design.layer;
  layer.thickness = log_between(u[6], 10e-6, 5e-3);
  layer.youngs_modulus = log_between(u[7], 1e6, 500e9);
  layer.poisson_ratio = between(u[8], 0.0, 0.49);
  layer.density = u[9] < 0.25 ? 0.0 : log_between(u[10], 500, 8000);
  layer.loss_factor = u[11] < 0.15  ? 0.0
                      : u[11] < 0.5 ? between(u[12], 0, 2)
                                    : log_between(u[12], 1e-3, 2);
  const double kinetic = u[13] < 0.02 ? 0.0 : u[13];
  const double ratio = u[14] < 0.4 ? 1.0 : between(u[15], 1, 2);
  point.design.friction = {kinetic, kinetic * ratio};
  const double load = u[16] < 0.3 ? log_between(u[17], 0.1, 10) : log_between(u[17], 1e-6, 1);
  point.design.preload = load * full_contact_load(point.design);
  point.speed =
      crest_speed_of(point.design) * (u[18] < 0.1 ? 1e-3 * u[19] : between(u[19], -0.3, 1.5));
  // short waves far from the neutral plane: -0.3 V0 may lie beyond the backward wave speed
  const double wave_speed = 2 * kPi * s.frequency / s.wavelengths;
  point.speed = std::max(point.speed, -0.9 * wave_speed);
  return point;
}

BoxPoint random_box_point(Uniform& random) {
  std::array<double, kBoxDimension> unit;
  for (double& value : unit) value = random();
  return box_point(unit);
}

}  // namespace twum::test
