// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <array>
#include <cstdint>
#include <random>
#include <span>

namespace twum::test {

/// Uniform numbers that are the same on every platform (std's distributions are not).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}

  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< in [0, 1)
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }
  double logarithmic(double low, double high);
  bool chance(double probability) { return (*this)() < probability; }

 private:
  std::mt19937_64 engine_;
};

/// The 60 mm ring motor of examples/motors/ring-60.yaml (the defaults of MotorDesign).
MotorDesign ring_motor();

/// The three kinds of layer of the same motor: no inertia and no damping, damping alone, both.
MotorDesign elastic(MotorDesign design);
MotorDesign damped(MotorDesign design);

/// Preload as a share of the load at which contact becomes full, q = F_N / (2 pi n b E A / (h kappa)).
double full_contact_load(const MotorDesign& design);
/// The motor with a preload in units of that at which contact becomes full.
MotorDesign at_load(MotorDesign design, double load);

/// A realistic motor: ring motors of 25 to 90 mm, partial contact.
MotorDesign realistic_design(Uniform& random);

/// Point of the unit cube -> design and speed in the box of theory section 10 (last bullet).
inline constexpr std::size_t kBoxDimension = 20;
struct BoxPoint {
  MotorDesign design;
  double speed;  ///< [rad/s]
};
BoxPoint box_point(std::span<const double, kBoxDimension> unit);
BoxPoint random_box_point(Uniform& random);

/// V0 / r [rad/s].
double crest_speed_of(const MotorDesign& design);

}  // namespace twum::test
