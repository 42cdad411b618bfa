// SPDX-License-Identifier: Apache-2.0
#include "held/torque_law.hpp"

#include "contact/load_shape.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::core {
namespace {

constexpr double kMostRinging = 0.5;  // root of M up to which the amplitude falls with it

}  // namespace

TorqueLaw::TorqueLaw(const DrivenWaves& waves, double speed) {
  const MotorModel<double>& m = waves.model();
  const double per_wave = m.preload * m.kappa / (2 * m.n * m.b);
  soft_ = per_wave * m.thickness / m.youngs;
  const double W = waves.omega() + m.kappa * m.r * speed;
  const double stick_rate = m.shear * m.tilt * waves.omega() / (m.youngs * W);
  steep_ = m.kinetic / stick_rate;
  slow_ = speed / (waves.crest_speed_per_amplitude() * soft_);
  rings_ = std::fmin(W * std::sqrt(m.inertia * m.compliance), kMostRinging);
}

// theta_L falls as A grows, and what it carries by the law grows. In terms of theta_L nothing else has to be solved for.
double TorqueLaw::amplitude(double share) const {
  constexpr int kHalvings = 6;  // and a chord; the law itself is right to some per cent
  // The cube law holds near the plateau. The factors are fits to 6,000 motors; most amplitudes are right to 5 %.
  const double way = (2 + std::fabs(share)) / 3 * (1 - std::cbrt(1 - share));
  const auto load = [](double angle) { return std::sin(angle) - angle * std::cos(angle); };
  // By how much V is beyond what the load takes. A load that drives a slow rotor may leave some even at pi.
  const auto beyond = [&](double angle) {
    const double sine = std::sin(angle);
    return sine / angle - slow_ * load(angle) - way * (load(angle) / angle + steep_ * sine);
  };
  double low = 0, high = std::numbers::pi, at_low = 1, at_high = beyond(high);
  for (int i = 0; i < kHalvings; ++i) {
    const double angle = 0.5 * (low + high), here = beyond(angle);
    (here > 0 ? low : high) = angle, (here > 0 ? at_low : at_high) = here;
  }
  const double angle = at_high < 0 ? low + (high - low) * at_low / (at_low - at_high) : high;
  return soft_ / load(angle) * std::exp(-0.25 * rings_ * (1 + 2 * share));
}

double likely_traction(const DrivenMotor<double>& m, double speed, double share) {
  const contact::ContactNumbers<double> n = contact_numbers(m, speed);
  const double stuck = n.stick_rate / (2 * std::numbers::pi) *
                       (n.half_angle - n.edge.sin * n.edge.cos -
                        2 * n.speed_ratio * contact::load_shape(n.half_angle, n.edge));
  return (1 - share) * stuck * m.mean.force_scale;
}

}  // namespace twum::inline v0_1::core
