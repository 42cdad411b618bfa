// SPDX-License-Identifier: Apache-2.0
#include "hopping.hpp"

#include "normal_force.hpp"
#include "poles.hpp"
#include "slow_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kLeastSpeed = 1e-3;  // unit of the speed of a rotor that hardly turns [rad/s]

// A number of the contact, which takes the instantaneous normal force N(A, z), and its derivative in z.
struct HoppingSlopes {
  ForceSlopes force;
  double per_height;
};
HoppingSlopes with_normal_force(const ContactGradients::Number& n,
                                const ContactGradients& contact) {
  const NormalForceSlopes by_force = by_normal_force(n, contact);
  return {{n.value, n.per_amplitude + by_force.per_amplitude, n.per_speed}, by_force.per_height};
}

// Poles of amplitude, phase, speed, height z of the rotor over its steady one, and z' (M7.1, M4.5).
std::vector<Complex> hopping_poles(const MotionModel& m, const MotorDesign& design, double speed,
                                   const ContactGradients& contact) {
  const HoppingSlopes re = with_normal_force(contact.reactive_force, contact),
                      im = with_normal_force(contact.active_force, contact),
                      torque = with_normal_force(contact.torque, contact);
  const double A = design.stator.amplitude, mass = *design.rotor.mass;
  const SlowFlow flow = slow_flow(m, A, 2 * std::numbers::pi * drive_frequency(design), re.force,
                                  im.force, torque.force);
  enum : Eigen::Index { kHeight = 3, kRise };
  Eigen::Matrix<double, 5, 5> a = Eigen::Matrix<double, 5, 5>::Zero();
  a.topLeftCorner<3, 3>() = flow.jacobian;
  a.col(kHeight).head<3>() << -im.per_height / flow.divisor, -re.per_height / (flow.divisor * A),
      torque.per_height / m.inertia;
  a(kHeight, kRise) = 1;
  a(kRise, 0) = contact.normal_per_amplitude / mass;
  a(kRise, kHeight) = contact.normal_per_height / mass;
  a(kRise, kRise) = -design.rotor.axial_damping / mass;
  const double rate = std::sqrt(-contact.normal_per_height / mass);
  const Eigen::Vector<double, 5> unit{A, 1, std::max(std::abs(speed), kLeastSpeed), A, A * rate};
  return poles_of(a, unit);
}

}  // namespace

double hopping_rate(const MotionModel& model, const MotorDesign& design, double speed) {
  const ContactGradients contact = ContactDifferentiator(design).at(design.stator.amplitude, speed);
  if (contact.status != PointStatus::ok) return std::numeric_limits<double>::quiet_NaN();
  const Complex alone = kI * std::sqrt(-contact.normal_per_height / *design.rotor.mass);
  return nearest_pole(hopping_poles(model, design, speed, contact), alone).real();
}

}  // namespace twum::inline v0_1::motion
