// SPDX-License-Identifier: Apache-2.0
#include "hopping.hpp"

#include <twum/core/contact_gradients.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::motion {
namespace {

// A number of the contact near a wave: contact and torque are those of the instantaneous normal force N(A, z).
struct Slopes {
  double amplitude, speed, height;
};
Slopes with_normal_force(const ContactGradients::Number& n, const ContactGradients& contact) {
  const double per_force = n.gradient[index_of(Parameter::preload)];
  return {n.per_amplitude + per_force * contact.normal_per_amplitude, n.per_speed,
          per_force * contact.normal_per_height};
}

// Amplitude, phase, speed, height z of the rotor over its steady one, and z', in units of their size (M7.1, M4.5).
Eigen::Matrix<double, 5, 5> hopping(const MotionModel& m, const MotorDesign& design, double speed,
                                    const ContactGradients& contact) {
  const Slopes re = with_normal_force(contact.reactive_force, contact),
               im = with_normal_force(contact.active_force, contact),
               torque = with_normal_force(contact.torque, contact);
  const double A = design.stator.amplitude, J = m.inertia, mass = *design.rotor.mass;
  const double w = 2 * std::numbers::pi * drive_frequency(design);
  const double detuning = m.stiffness_of_wave - w * w * m.mass;
  const double R = detuning * A + contact.reactive_force.value,
               I = w * m.damping * A + contact.active_force.value;
  const double free = std::sqrt((m.stiffness_of_wave + contact.reactive_force.value / A) / m.mass);
  const double D = (w + free) * m.mass;
  Eigen::Matrix<double, 5, 5> a;
  a << -(w * m.damping + im.amplitude) / D, R / D, -im.speed / D, -im.height / D, 0,  //
      -(detuning + re.amplitude) / (D * A), -I / (D * A), -re.speed / (D * A), -re.height / (D * A),
      0,                                                                                   //
      torque.amplitude / J, 0, (torque.speed - m.load_damping) / J, torque.height / J, 0,  //
      0, 0, 0, 0, 1,                                                                       //
      contact.normal_per_amplitude / mass, 0, 0, contact.normal_per_height / mass,
      -design.rotor.axial_damping / mass;
  const double rate = std::sqrt(-contact.normal_per_height / mass);
  const Eigen::Vector<double, 5> unit{A, 1, std::max(std::abs(speed), 1e-3), A, A * rate};
  return unit.cwiseInverse().asDiagonal() * a * unit.asDiagonal();
}

}  // namespace

// The pole nearest to that of the rotor on the layer alone.
double hopping_rate(const MotionModel& model, const MotorDesign& design, double speed) {
  const ContactGradients contact = ContactDifferentiator(design).at(design.stator.amplitude, speed);
  if (contact.status != PointStatus::ok) return std::numeric_limits<double>::quiet_NaN();
  const Complex alone = kI * std::sqrt(-contact.normal_per_height / *design.rotor.mass);
  const Eigen::Vector<Complex, 5> poles =
      Eigen::EigenSolver<Eigen::Matrix<double, 5, 5>>(hopping(model, design, speed, contact), false)
          .eigenvalues();
  return std::ranges::min_element(poles.begin(), poles.end(), {},
                                  [&](const Complex& p) { return std::abs(p - alone); })
      ->real();
}

}  // namespace twum::motion
