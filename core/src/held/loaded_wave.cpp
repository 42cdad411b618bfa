// SPDX-License-Identifier: Apache-2.0
#include "held/loaded_wave.hpp"

#include "drive/curve_node.hpp"
#include "held/torque_law.hpp"

#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {
void LoadedWave::take_slopes(LoadedWave&& near) {
  torque_in_amplitude = near.torque_in_amplitude, torque_in_omega = near.torque_in_omega;
  in_amplitude = near.in_amplitude, in_omega = near.in_omega;
  states = std::move(near.states);
}

LoadedWaves::LoadedWaves(const DrivenWaves& waves, double speed) : waves_(waves), speed_(speed) {
  const MotorModel<double>& m = waves_.model();
  const double lever =
      m.track.nodes == 1 ? m.r : waves_.motor(waves_.full_contact_amplitude()).lever;
  plateau_ = m.kinetic * m.preload * lever;
  carry(0);
}

void LoadedWaves::carry(double torque) { torque_ = torque, root_ = std::cbrt(plateau_ - torque); }

// To first order the layer enters as the derivatives of the wave nearby say.
LoadedWave LoadedWaves::found(double amplitude, double omega, const LoadedWave* near,
                              double accuracy) const {
  const DrivenWaves there = waves_.at_frequency(omega);
  std::optional<WarmStart> start;
  if (near)
    start =
        moved(near->solved.start(), near->states, amplitude - near->amplitude, omega - near->omega);
  LoadedWave w;
  w.amplitude = amplitude, w.omega = omega, w.accuracy = accuracy;
  w.solved = solve_point(there.motor(amplitude), speed_, start ? &*start : nullptr, accuracy);
  w.torque = w.solved.numbers.torque, w.root = std::cbrt(plateau_ - w.torque);
  w.force = there.balance(w.solved.numbers, amplitude);
  return w;
}

void LoadedWaves::differentiate(LoadedWave& w) const {
  DrivenWaves::MovingWave moving =
      waves_.at_frequency(w.omega).moving(w.solved, w.amplitude, speed_, Continued::frequency);
  const auto slope = [&moving](std::size_t k) {
    return WaveBalance<double>{moving.balance.real.d[k], moving.balance.imaginary.d[k]};
  };
  w.torque_in_amplitude = moving.numbers.torque.d[contact::kInAmplitude];
  w.torque_in_omega = moving.numbers.torque.d[contact::kInSpeed];
  w.in_amplitude = slope(contact::kInAmplitude), w.in_omega = slope(contact::kInSpeed);
  w.states = std::move(moving.states);
}

LoadedWave LoadedWaves::at(double amplitude, double omega, const LoadedWave* near,
                           double accuracy) const {
  LoadedWave w = found(amplitude, omega, near, accuracy);
  if (w.ok()) differentiate(w);
  return w;
}

void LoadedWaves::move(LoadedWave& w, double step) const {
  w.omega += step;
  w.torque += step * w.torque_in_omega, w.root = std::cbrt(plateau_ - w.torque);
  w.force.real += step * w.in_omega.real, w.force.imaginary += step * w.in_omega.imaginary;
}

// T_p - T goes nearly with the cube of A_p - A, so that its cube root c is nearly straight: c - c_L times dT / dc.
double LoadedWaves::missing(const LoadedWave& w) const {
  return 3 * w.root * w.root * (w.root - root_);
}

double LoadedWaves::likely_amplitude(double omega) const {
  return TorqueLaw(waves_.at_frequency(omega), speed_).amplitude(torque_ / plateau_);
}

std::optional<LoadedWave> LoadedWaves::likely(double amplitude, double omega) const {
  if (waves_.has_static_excess()) return {};
  LoadedWave w = at(amplitude, omega, nullptr, kHeldRules.crude);
  for (int i = 0; i < kHeldRules.most_back && on_plateau(w); ++i)
    w = at(amplitude *= 1 - kHeldRules.back, omega, nullptr, kHeldRules.crude);
  return w.ok() ? std::optional(std::move(w)) : std::nullopt;
}

bool LoadedWaves::rings(double omega) const {
  const MotorModel<double>& m = waves_.model();
  const double viscosity = waves_.at_frequency(omega).model().viscosity;
  return viscosity < kHeldRules.dies_away * m.inertia * (omega + m.kappa * m.r * speed_);
}

// T(A) rises up to its plateau without inertia (980 curves), and where a layer does not ring in a contact that is partial from the
// crest's speed on (260,000 motors with C from 1.3 M to 2.6 M; 80 ripple, all in full contact).
bool LoadedWaves::surely_rises(double omega) const {
  if (waves_.model().inertia == 0) return true;
  const double at_crest = speed_ / waves_.at_frequency(omega).crest_speed_per_amplitude();
  return !rings(omega) && waves_.model().track.nodes == 1 &&
         at_crest > waves_.full_contact_amplitude();
}

double LoadedWaves::omega_beside(double omega, double gap, double amplitude) const {
  const double square = omega * omega + gap / (waves_.modes().mass * amplitude);
  return square > 0 ? std::sqrt(square) : omega;
}

}  // namespace twum::inline v0_1::core
