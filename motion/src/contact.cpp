// SPDX-License-Identifier: Apache-2.0
#include "contact.hpp"

#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <numbers>

namespace twum::motion {

ContactForces Contact::at(double amplitude, double speed, double frequency, double preload) {
  // The integrator asks for rates and Jacobian at one state.
  if (amplitude == last_amplitude_ && speed == last_speed_ && frequency == last_frequency_ &&
      preload == last_preload_)
    return last_;
  last_ = solved(amplitude, speed, frequency, preload);
  last_amplitude_ = amplitude, last_speed_ = speed, last_frequency_ = frequency;
  last_preload_ = preload;
  return last_;
}

OperatingPoint Contact::point(const OperatingConditions& at, double preload) const {
  if (preload == kOfDesign) return model_->motor.operating_point(at);
  MotorDesign design = model_->motor.design();
  design.preload = preload;
  return Motor(design).operating_point(at);
}

ContactForces Contact::solved(double amplitude, double speed, double frequency, double preload) {
  // no preload, no contact
  if (model_->full_contact_amplitude == 0 || preload == 0) return {};
  const double a = std::max(amplitude, floor_);
  const double omega = 2 * std::numbers::pi * frequency;
  const MotorDesign& d = model_->motor.design();
  const bool met = speed > -omega / d.stator.wavelengths;  // the wave is faster than the rotor
  if (!met || !complaint(Parameter::amplitude, a).empty()) {
    failure_ = "out-of-range";
    return {.known = false};
  }
  ++count_;
  const OperatingPoint p = point({speed, a, frequency}, preload);
  if (p.status != PointStatus::ok) {
    failure_ = to_string(p.status);
    return {.known = false};
  }
  const double share = amplitude / a;  // of powers, which vanish with the square of the wave
  return {{p.reactive_force / a, p.stator_power / (omega * a * a)},  // (D1.2)
          p.torque,
          p.stator_power * share * share,
          p.friction_power,
          true};
}

}  // namespace twum::motion
