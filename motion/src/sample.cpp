// SPDX-License-Identifier: Apache-2.0
#include "sample.hpp"

#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

// What the contact carries of a load at rest: what friction of the load does not, if it can.
double held_torque(Equations& equations, double time, std::span<const double> y) {
  const HoldingLimits limits = equations.holding_limits(time, y);
  if (!limits.known) return kNoValue;
  const double load = equations.load(time, y[kAngle]);
  return std::clamp(load, std::min(limits.forward, limits.backward),
                    std::max(limits.forward, limits.backward));
}

void add_terminals(MotionSample& sample, const Equations& equations, double time,
                   std::span<const double> y) {
  const double rms = std::numbers::sqrt2 / 2;
  const Equations::Electrical at = equations.electrical(time, y);
  sample.voltage = rms * std::abs(at.voltage);
  sample.phase_lag =
      std::remainder(-std::atan2(y[kImaginary], y[kReal]) - y[kTurn], 2 * std::numbers::pi);
  sample.electrical_power = at.power();
  sample.phase_current = rms * std::abs(at.current);
}

}  // namespace

MotionSample sample_at(const Equations& of, double time, std::span<const double> y) {
  Equations equations = of;  // the contacts of samples do not count
  const Stretch& s = equations.stretch();
  MotionSample sample{.time = time,
                      .voltage = kNoValue,
                      .frequency = s.frequency.at(time),
                      .load_torque = s.load_torque.at(time),
                      .amplitude = equations.amplitude(time, y),
                      .phase_lag = kNoValue,
                      .speed = y[kSpeed],
                      .angle = y[kAngle],
                      .electrical_power = kNoValue,
                      .phase_current = kNoValue,
                      .energy = equations.model().driven ? y[kEnergy] : kNoValue,
                      .held = equations.mode().held,
                      .off = s.off};
  const ContactForces f = equations.forces(time, y);
  sample.torque = sample.held ? held_torque(equations, time, y) : f.known ? f.torque : kNoValue;
  sample.stator_power = f.known ? f.stator_power : kNoValue;
  sample.friction_power = f.known ? f.friction_power : kNoValue;
  if (equations.model().driven) add_terminals(sample, equations, time, y);
  return sample;
}

}  // namespace twum::inline v0_1::motion
