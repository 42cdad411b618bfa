// SPDX-License-Identifier: Apache-2.0
#include "support/two_modes.hpp"

#include "support/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::test {

TwoModes::TwoModes(const MotorDesign& design, double speed)
    : speed_(speed),
      omega_(2 * kPi * drive_frequency(design)),
      step_(2 * kPi / omega_ / kSteps),
      mass_(*design.stator.modal_mass),
      decay_(0.5 * modal_damping(design) / mass_),
      drive_per_volt_(std::numbers::sqrt2 * *design.stator.force_factor),
      foundation_(design.layer.youngs_modulus / design.layer.thickness),
      shear_(shear_modulus(design) / design.layer.thickness),
      friction_(design.friction.kinetic),
      preload_(design.preload),
      area_(2 * kPi * design.stator.contact_radius * design.stator.contact_width),
      radius_(design.stator.contact_radius),
      wave_number_(design.stator.wavelengths / design.stator.contact_radius),
      turn_(kPlaces),
      pressure_(kPlaces),
      traction_(kPlaces) {
  const double free = 2 * kPi * *design.stator.resonance_frequency;
  const Imbalance unequal = design.stator.imbalance.value_or(Imbalance{});
  voltage_ratio_ = unequal.voltage_ratio, phase_error_ = unequal.phase_error;
  own_[0] = std::sqrt(free * free * (1 + unequal.mode_splitting) - decay_ * decay_);
  own_[1] = std::sqrt(free * free * (1 - unequal.mode_splitting) - decay_ * decay_);
  rotor_mass_ = design.rotor.mass.value_or(0);
  tilt_ = design.stator.neutral_plane_distance * wave_number_;
  set_voltage(*design.stator.voltage);
  place_rotor();
}

void TwoModes::set_frequency(double frequency) {
  omega_ = 2 * kPi * frequency;
  step_ = 2 * kPi / omega_ / kSteps;
}

// w = Re(conj(Z) exp(i kappa x)) with Z = w_c + i w_s; a forward wave is Z = A exp(i (omega t - phi)).
void TwoModes::set_wave(double amplitude, double phase_lag) {
  place_ = std::polar(amplitude, phase_ - phase_lag);
  velocity_ = Complex(0, omega_) * place_;
  std::fill(traction_.begin(), traction_.end(), 0.0);
  height_ = height_that_carries();
  lift_ = 0;
  press();
}

void TwoModes::add_backward_wave(double amplitude) {
  const Complex z = std::polar(amplitude, -phase_);
  place_ += z;
  velocity_ -= Complex(0, omega_) * z;
}

void TwoModes::run(int periods) {
  wave_ = 0, torque_ = 0, stator_power_ = 0, backward_ = 0, any_backward_ = 0;
  rate_[0] = rate_[1] = 0;
  const double share = 1.0 / (kSteps * periods);
  for (int i = 0; i < kSteps * periods; ++i) {
    step();
    wave_ += place_ * std::polar(share, -phase_);
    backward_ += place_ * std::polar(share, phase_);
    any_backward_ += std::norm(backward_velocity() / omega_) * share;
    rate_[0] += velocity_.real() * velocity_.real() * share;
    rate_[1] += velocity_.imag() * velocity_.imag() * share;
    torque_ += torque_now_ * share;
    stator_power_ += power_now_ * share;
  }
  any_backward_ = std::sqrt(any_backward_);
  for (double& rate : rate_) rate = std::sqrt(rate);
}

void TwoModes::step() {
  kick(0.5 * step_);
  // w'' + 2 decay w' + (own^2 + decay^2) w = 0, for each mode
  const double envelope = std::exp(-decay_ * step_);
  const auto glided = [&](int mode, double w, double rate) {
    const double own = own_[mode], c = std::cos(own * step_), s = std::sin(own * step_);
    const double glide = (rate + decay_ * w) / own, next = envelope * (c * w + s * glide);
    return Complex(next, own * envelope * (c * glide - s * w) - decay_ * next);
  };
  const Complex cosine = glided(0, place_.real(), velocity_.real()),
                sine = glided(1, place_.imag(), velocity_.imag());
  const Complex next(cosine.real(), sine.real());
  velocity_ = {cosine.imag(), sine.imag()};
  height_ += lift_ * step_;
  const double turn = radius_ * speed_ * step_ * wave_number_;
  rotor_ = std::fmod(rotor_ + 0.5 * turn, 2 * kPi);
  place_rotor();
  shear(next - place_);
  rotor_ += 0.5 * turn;
  place_rotor();
  place_ = next;
  phase_ = std::fmod(phase_ + omega_ * step_, 2 * kPi);
  press();
  kick(0.5 * step_);
}

// Z' - i omega Z vanishes on a steady forward wave and is twice the velocity of a backward one.
TwoModes::Complex TwoModes::backward_velocity() const {
  return 0.5 * (velocity_ - Complex(0, omega_) * place_);
}

void TwoModes::kick(double duration) {
  const Complex drive(drive_ * std::cos(phase_),
                      voltage_ratio_ * drive_ * std::sin(phase_ + phase_error_));
  velocity_ += duration / mass_ * (drive + force_ - backward_damping_ * backward_velocity());
  if (rotor_mass_ > 0) lift_ += duration / rotor_mass_ * (pressed_ - preload_);
}

// The rotor moves in the drive direction, against the wave.
void TwoModes::place_rotor() {
  for (int j = 0; j < kPlaces; ++j)
    turn_[static_cast<std::size_t>(j)] = std::polar(1.0, 2 * kPi * j / kPlaces - rotor_);
}

// A layer that sticks is sheared by the stator's surface, which moves by a dw/dx, and by the rotor.
void TwoModes::shear(Complex moved) {
  for (std::size_t j = 0; j < turn_.size(); ++j) {
    const double surface =
        tilt_ * (moved.imag() * turn_[j].real() - moved.real() * turn_[j].imag());
    traction_[j] += shear_ * (surface - radius_ * speed_ * step_);
  }
}

// Newton's method for the height at which the mean pressure carries the preload; the layer is a foundation of springs.
double TwoModes::height_that_carries() const {
  double z = height_;
  for (int i = 0; i < 50; ++i) {
    double sum = 0;
    int touching = 0;
    for (const Complex& e : turn_) {
      const double depth = place_.real() * e.real() + place_.imag() * e.imag() - z;
      if (depth > 0) sum += depth, ++touching;
    }
    const double missing = preload_ / (area_ * foundation_) * kPlaces - sum;
    const double next = touching > 0 ? z - missing / touching : z - std::abs(place_) * 0.5 - 1e-9;
    if (std::fabs(next - z) <= 1e-14 * std::abs(place_) + 1e-22) return next;
    z = next;
  }
  return z;
}

void TwoModes::press() {
  if (rotor_mass_ == 0) height_ = height_that_carries();
  Complex q = 0;
  double torque = 0, power = 0, pressed = 0;
  for (int j = 0; j < kPlaces; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const Complex e = turn_[k];
    const double depth = place_.real() * e.real() + place_.imag() * e.imag() - height_;
    const double p = foundation_ * std::max(depth, 0.0);
    const double t = std::clamp(traction_[k], -friction_ * p, friction_ * p);
    traction_[k] = t;
    q -= (p + Complex(0, tilt_ * t)) * e;
    torque += t;
    pressed += p;
    power += t * tilt_ * (velocity_.imag() * e.real() - velocity_.real() * e.imag());
  }
  pressed_ = pressed * area_ / kPlaces;
  force_ = q * (area_ / kPlaces);
  torque_now_ = torque * area_ * radius_ / kPlaces;
  power_now_ = power * area_ / kPlaces;
}

}  // namespace twum::test
