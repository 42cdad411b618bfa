// SPDX-License-Identifier: Apache-2.0
#include "contact.hpp"

#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {

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

namespace {

ContactForces mixed(const ContactForces& a, const ContactForces& b, double share) {
  const auto mix = [share](auto x, auto y) { return (1 - share) * x + share * y; };
  return {mix(a.stiffness, b.stiffness), mix(a.torque, b.torque),
          mix(a.stator_power, b.stator_power), mix(a.friction_power, b.friction_power),
          a.known && b.known};
}

}  // namespace

ContactForces Contact::solved(double amplitude, double speed, double frequency, double preload) {
  // no preload, no contact
  if (model_->full_contact_amplitude == 0 || preload == 0) return {};
  if (!model_->motor.design().stator.radial_motion)
    return solved_at(amplitude, speed, frequency, preload, floor_);
  const double least = kLeastRadial * model_->full_contact_amplitude;
  const double creep = kCreep * model_->crest_per_amplitude * 2 * std::numbers::pi * frequency *
                       std::max(amplitude, least);
  const auto at = [&](double size, double smallest) {
    return solved_at(amplitude, std::copysign(size, speed), frequency, preload, smallest);
  };
  const double share = std::abs(speed) / creep;
  if (share >= 1) return at(std::abs(speed), least);
  return share < kNoShare ? at(0, floor_) : mixed(at(0, floor_), at(creep, least), share);
}

ContactForces Contact::solved_at(double amplitude, double speed, double frequency, double preload,
                                 double least) {
  const double a = std::max(amplitude, least);
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

}  // namespace twum::inline v0_1::motion
