// SPDX-License-Identifier: Apache-2.0
#include "support/contact_problem.hpp"

#include "support/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::test {
namespace {

// sin t - t cos t; the series' first dropped term is below 1e-19 of the sum for t < 0.2.
long double load_shape(long double t) {
  if (t > 0.2L) return std::sin(t) - t * std::cos(t);
  long double term = t * t * t / 2;
  long double sum = 0;
  for (int k = 1; k < 12; ++k) {
    sum += term * 2 / (2 * k + 1);  // t^(2k+1) (-1)^(k+1) 2k / (2k+1)!
    term *= -t * t / static_cast<long double>(2 * k * (2 * k + 1));
  }
  return sum;
}

// Bisection on the logarithm: sixty halvings of [1e-13, pi], then sixty more.
double half_angle_of(long double load) {
  long double low = 1e-13L;
  long double high = std::numbers::pi_v<long double>;
  for (int i = 0; i < 200; ++i) {
    const long double middle = std::sqrt(low * high);
    (load_shape(middle) < load ? low : high) = middle;
  }
  return static_cast<double>(low);
}

void set_normal_contact(ContactProblem& problem, const MotorDesign& design, double wave_number) {
  const auto& stator = design.stator;
  const double foundation = design.layer.youngs_modulus / design.layer.thickness;
  const double per_pressure = 2 * stator.wavelengths * stator.contact_width / wave_number;
  problem.pressure_amplitude = foundation * stator.amplitude;
  const double load = design.preload / per_pressure;  // P (sin t - t cos t) [Pa]
  problem.full = load >= kPi * problem.pressure_amplitude;
  if (problem.full) {
    problem.half_angle = kPi;
    problem.edge_cosine = -load / (kPi * problem.pressure_amplitude);
  } else {
    problem.half_angle = half_angle_of(static_cast<long double>(load) / problem.pressure_amplitude);
    problem.edge_cosine = std::cos(problem.half_angle);
  }
}

void set_layer(ContactProblem& problem, const MotorDesign& design, double omega, double rate) {
  const auto& layer = design.layer;
  const double g =
      layer.given_shear_modulus.value_or(layer.youngs_modulus / (2 + 2 * layer.poisson_ratio));
  const double viscosity = layer.given_shear_viscosity.value_or(layer.loss_factor * g / omega);
  const double mass =
      layer.given_inertia.value_or(layer.density * layer.thickness * layer.thickness / 3);
  problem.stiffness = g;
  problem.damping = viscosity * rate;
  problem.inertia = mass * rate * rate;
  problem.strain_velocity = layer.thickness * rate;
}

}  // namespace

double ContactProblem::pressure(double theta) const {
  if (full) return pressure_amplitude * (std::cos(theta) - edge_cosine);
  // cos a - cos b as a product: no cancellation near the edges.
  return 2 * pressure_amplitude * std::sin((half_angle + theta) / 2) *
         std::sin((half_angle - theta) / 2);
}

double ContactProblem::sticking_rate(double theta) const {
  return (crest_velocity * std::cos(theta) - rotor_velocity) / strain_velocity;
}

double ContactProblem::slip_velocity(double theta, double rate) const {
  return rotor_velocity + strain_velocity * rate - crest_velocity * std::cos(theta);
}

ContactProblem contact_problem(const MotorDesign& design, double speed) {
  const auto& stator = design.stator;
  ContactProblem problem{};
  const double omega = 2 * kPi * stator.frequency;
  const double wave_number = stator.wavelengths / stator.contact_radius;
  problem.speed = speed;
  problem.radius = stator.contact_radius;
  problem.rotor_velocity = speed * stator.contact_radius;
  problem.crest_velocity = wave_number * stator.neutral_plane_distance * stator.amplitude * omega;
  problem.track_area = 2 * kPi * stator.contact_radius * stator.contact_width;
  problem.kinetic = design.friction.kinetic;
  problem.threshold = design.friction.threshold;
  set_normal_contact(problem, design, wave_number);
  set_layer(problem, design, omega, omega + wave_number * problem.rotor_velocity);
  problem.torque_scale = problem.threshold * design.preload * problem.radius;
  problem.power_scale = problem.threshold * design.preload *
                        std::max(problem.crest_velocity, std::abs(problem.rotor_velocity));
  return problem;
}

}  // namespace twum::test
