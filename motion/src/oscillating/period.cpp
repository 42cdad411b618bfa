// SPDX-License-Identifier: Apache-2.0
#include "oscillating/period.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

constexpr double MotionSample::*kEven[] = {&MotionSample::voltage,
                                           &MotionSample::frequency,
                                           &MotionSample::load_torque,
                                           &MotionSample::amplitude,
                                           &MotionSample::speed,
                                           &MotionSample::backward_amplitude,
                                           &MotionSample::phase_difference,
                                           &MotionSample::angle,
                                           &MotionSample::torque,
                                           &MotionSample::stator_power,
                                           &MotionSample::friction_power,
                                           &MotionSample::electrical_power,
                                           &MotionSample::phase_current,
                                           &MotionSample::energy};

}  // namespace

void Period::add(const WavesState& state, double phase, double omega) {
  const Complex turn = std::polar(1.0, phase);
  const auto both = [](const Two& pair) { return Complex{pair[0], pair[1]}; };
  const Complex w = both(state.displacement), rate = both(state.velocity) / (kI * omega);
  displacement_.forward += 0.5 * (w + rate) * std::conj(turn);
  displacement_.backward += 0.5 * (w - rate) * turn;
  const Complex u = both(state.voltage);
  voltage_.forward += u * std::conj(turn), voltage_.backward += u * turn;
  ++steps_;
}

MotionSample Period::sample(double end, const WavesState& state, const WavesWork& work) const {
  const double duration = end - begin_;
  MotionSample s{.time = (begin_ + end) / 2,
                 .speed = (state.angle - angle_) / duration,
                 .angle = (angle_ + state.angle) / 2};
  s.torque = work.impulse / duration;
  s.stator_power = work.contact / duration;
  s.friction_power = work.friction / duration;
  s.electrical_power = work.drive / duration;
  s.energy = energy_ + work.drive / 2;
  s.held = work.stick_margin >= 0;
  return s;
}

MotionSample between(const MotionSample& earlier, const MotionSample& later, double time) {
  MotionSample sample = earlier;
  const double span = later.time - earlier.time;
  const double share = span > 0 ? (time - earlier.time) / span : 0;
  for (const auto member : kEven) sample.*member = std::lerp(earlier.*member, later.*member, share);
  // An angle takes the shorter way.
  const double turn = std::remainder(later.phase_lag - earlier.phase_lag, 2 * std::numbers::pi);
  sample.phase_lag = std::remainder(earlier.phase_lag + share * turn, 2 * std::numbers::pi);
  sample.time = time;
  return sample;
}

}  // namespace twum::inline v0_1::motion
