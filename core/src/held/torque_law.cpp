// SPDX-License-Identifier: Apache-2.0
#include "held/torque_law.hpp"

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
  constexpr int kHalvings = 12;  // the law itself is right to some per cent
  // The cube law holds near the plateau. The factors are fits to 6,000 motors; most amplitudes are right to 5 %.
  const double way = (2 + std::fabs(share)) / 3 * (1 - std::cbrt(1 - share));
  double low = 0, high = std::numbers::pi, load = 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double angle = 0.5 * (low + high), sine = std::sin(angle);
    load = sine - angle * std::cos(angle);
    const double beyond_nothing = sine / angle - slow_ * load,
                 to_plateau = load / angle + steep_ * sine;
    (beyond_nothing > way * to_plateau ? low : high) = angle;
  }
  return soft_ / load * std::exp(-0.25 * rings_ * (1 + 2 * share));
}

}  // namespace twum::inline v0_1::core
