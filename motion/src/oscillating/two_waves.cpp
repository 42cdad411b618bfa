// SPDX-License-Identifier: Apache-2.0
#include "oscillating/two_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::motion {

TwoWaves::TwoWaves(const MotorDesign& design, const MotionModel& model, int points)
    : model_(&model),
      law_(design),
      points_(law_, points),
      wavelengths_(design.stator.wavelengths),
      radius_(design.stator.contact_radius),
      surface_(model.crest_per_amplitude * radius_),
      area_(2 * std::numbers::pi * radius_ * design.stator.contact_width),
      rotor_mass_(design.rotor.mass.value_or(0)),
      axial_damping_(design.rotor.axial_damping),
      conductance_(2 * std::numbers::pi * drive_frequency(design) * model.capacitance *
                   model.loss_tangent),
      pressure_(law_.pressure) {
  const double splitting = design.stator.imbalance.value_or(Imbalance{}).mode_splitting;
  stiffness_ = {model.stiffness_of_wave * (1 + splitting),
                model.stiffness_of_wave * (1 - splitting)};
  state_.height = -law_.pressure / law_.stiffness;
}

void TwoWaves::lead(const Two& displacement, double speed, double duration) {
  const Two way{displacement[0] - state_.displacement[0], displacement[1] - state_.displacement[1]};
  state_.displacement = displacement, state_.speed = speed;
  state_.angle += duration * speed;
  const double rotor_mass = std::exchange(rotor_mass_, 0);  // it has found its height
  move_contact(way, duration);
  rotor_mass_ = rotor_mass;
}

void TwoWaves::set_step(double duration) {
  if (duration == duration_) return;
  duration_ = duration;
  for (std::size_t i = 0; i < 2; ++i) drifts_[i] = drift_of(stiffness_[i]);
  if (model_->has_series()) circuit_ = circuit_of();
}

// L_s I' = V - u - R_s I,  C_0 u' = I - G u - Theta w'  (M3.1) in the frame of the stator. With the mean rate c and its square's rest
// s^2 = c^2 - det of the matrix M: e^(M t) = e^(c t) [cosh(s t) + (M - c) sinh(s t) / s], and the source acts by M^-1 (e^(M t) - 1).
TwoWaves::Circuit TwoWaves::circuit_of() const {
  const double L = model_->series_inductance, R = model_->series_resistance,
               C = model_->capacitance, t = duration_;
  if (L == 0) {  // C_0 u' = (V - u) / R_s - G u - Theta w'
    const double rate = (1 / R + conductance_) / C, left = std::exp(-rate * t);
    const double gained = (1 - left) / (rate * C);
    return {{{0, 0}, {0, left}}, {{0, 0}, {gained / R, gained}}};
  }
  const double a = -R / L, b = -1 / L, c = 1 / C, d = -conductance_ / C;
  const double mean = 0.5 * (a + d), determinant = a * d - b * c;
  const Complex rate = std::sqrt(Complex{mean * mean - determinant, 0});
  const double cosine = std::cosh(rate * t).real();
  const double sine = std::abs(rate) * t > 1e-9 ? (std::sinh(rate * t) / rate).real() : t;
  const double left = std::exp(mean * t);
  const double e[2][2] = {{left * (cosine + (a - mean) * sine), left * b * sine},
                          {left * c * sine, left * (cosine + (d - mean) * sine)}};
  Circuit circuit{{{e[0][0], e[0][1]}, {e[1][0], e[1][1]}}, {}};
  for (int j = 0; j < 2; ++j) {
    const double top = e[0][j] - (j == 0 ? 1 : 0), bottom = e[1][j] - (j == 1 ? 1 : 0);
    const double per = j == 0 ? 1 / L : 1 / C;
    circuit.source[0][j] = (d * top - b * bottom) / determinant * per;
    circuit.source[1][j] = (a * bottom - c * top) / determinant * per;
  }
  return circuit;
}

// With decay c = d_s / 2 m_s and rate s, s^2 = c^2 - k / m_s: x(t) = e^(-c t) [x cosh(s t) + (v + c x) sinh(s t) / s].
TwoWaves::Drift TwoWaves::drift_of(double stiffness) const {
  const double decay = model_->damping / (2 * model_->mass), square = stiffness / model_->mass;
  const Complex rate = std::sqrt(Complex{decay * decay - square, 0});
  const double cosine = std::cosh(rate * duration_).real();
  const double sine =
      std::abs(rate) * duration_ > 1e-9 ? (std::sinh(rate * duration_) / rate).real() : duration_;
  const double left = std::exp(-decay * duration_);
  return {left * (cosine + decay * sine), left * sine, -left * square * sine,
          left * (cosine - decay * sine)};
}

void TwoWaves::step(const ActingNow& before, const ActingNow& after) {
  kick(before);
  drift(before, after);
  kick(after);
}

void TwoWaves::kick(const ActingNow& acting) {
  const double half = duration_ / 2, theta = model_->force_factor;
  const bool fed = model_->has_series() && !acting.off;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!acting.off && !fed) state_.voltage[i] = acting.voltage[i];
    const double drive = theta * state_.voltage[i];
    const double before = state_.velocity[i];
    state_.velocity[i] += half * (drive + force_[i]) / model_->mass;
    const double way = half * (before + state_.velocity[i]) / 2;
    if (fed && model_->series_inductance != 0)
      work_.drive += half * acting.voltage[i] * state_.current[i];
    if (!fed)
      work_.drive += way * drive + half * conductance_ * state_.voltage[i] * state_.voltage[i];
    work_.contact -= way * force_[i];
  }
  work_.impulse += half * torque_;
  const double per_torque = half / model_->inertia;
  const double load = acting.load_torque + model_->spring(state_.angle);
  const double free =
      (state_.speed + per_torque * (torque_ - load)) / (1 + per_torque * model_->load_damping);
  const double friction = per_torque * model_->load_friction;  // it stops the rotor at most
  state_.speed = free - std::clamp(free, -friction, friction);
  if (is_light()) return;
  // m_r z'' = 2 pi r b <p> - F_N - d_z z'  (M9.2)
  const double per_force = half / rotor_mass_;
  state_.rise = (state_.rise + per_force * area_ * (pressure_ - law_.pressure)) /
                (1 + per_force * axial_damping_);
}

// C_0 u' = -u / R - Theta w' with w' constant over the step: exact, and u = -R Theta w' without a capacitance.
void TwoWaves::lie_on_resistance(const Two& way) {
  const double resistance = 1 / (1 / model_->off_resistance + conductance_);
  for (std::size_t i = 0; i < 2; ++i) {
    const double source = -resistance * model_->force_factor * way[i] / duration_;
    const double left = model_->off_resistance == 0 || model_->capacitance == 0
                            ? 0
                            : std::exp(-duration_ / (resistance * model_->capacitance));
    state_.voltage[i] = source + left * (state_.voltage[i] - source);
  }
  state_.current = {};  // the coil is switched off
}

void TwoWaves::feed(const Two& voltage, const Two& way) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double in[2] = {voltage[i], -model_->force_factor * way[i] / duration_};
    const double I = state_.current[i], u = state_.voltage[i];
    const auto next = [&](int row) {
      return circuit_.left[row][0] * I + circuit_.left[row][1] * u +
             circuit_.source[row][0] * in[0] + circuit_.source[row][1] * in[1];
    };
    state_.current[i] = next(0), state_.voltage[i] = next(1);
    if (model_->series_inductance == 0) work_.drive += work_through_resistance(i, u, way[i]);
  }
}

// By the charge of the step, I = C_0 u' + G u + Theta w': (V - u) / R_s at its ends would see the steps of V.
double TwoWaves::work_through_resistance(std::size_t phase, double before, double way) const {
  const double after = state_.voltage[phase], mean = 0.5 * (before + after);
  const double charge = model_->capacitance * (after - before) + model_->force_factor * way +
                        duration_ * conductance_ * mean;
  return charge * (mean + model_->series_resistance * charge / duration_);
}

void TwoWaves::drift(const ActingNow& before, const ActingNow& acting) {
  Two way{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double x = state_.displacement[i], v = state_.velocity[i];
    const Drift& d = drifts_[i];
    state_.displacement[i] = d.xx * x + d.xv * v;
    state_.velocity[i] = d.vx * x + d.vv * v;
    way[i] = state_.displacement[i] - x;
  }
  if (acting.off)
    lie_on_resistance(way);
  else if (model_->has_series())
    feed({0.5 * (before.voltage[0] + acting.voltage[0]),
          0.5 * (before.voltage[1] + acting.voltage[1])},
         way);
  state_.angle += duration_ * state_.speed;
  state_.height += duration_ * state_.rise;
  move_contact(way, duration_);
}

// Face and sliding of the stator (M9.1), seen from the rotor: xi = kappa x + n theta_r.
void TwoWaves::move_contact(const Two& way, double duration) {
  const double turn = wavelengths_ * state_.angle, c = std::cos(turn), s = std::sin(turn);
  const auto& [wc, ws] = state_.displacement;
  const double per_way = surface_ / duration;
  const PointsMove move{wc * c - ws * s,
                        wc * s + ws * c,
                        per_way * (way[0] * s + way[1] * c),
                        per_way * (way[1] * s - way[0] * c),
                        radius_ * state_.speed,
                        duration};
  if (is_light()) state_.height = points_.balanced_height(move, state_.height);
  const PointsMeans at = points_.step(move, state_.height);
  // Q_c + i Q_s = -2 pi r b <(p + i a kappa tau) e^(i kappa x)>,  T = 2 pi r^2 b <tau>  (M9.3)
  const Complex mean{at.pressure_cos - surface_ * at.traction_sin,
                     at.pressure_sin + surface_ * at.traction_cos};
  const Complex force = -area_ * mean * Complex{c, -s};
  force_ = {force.real(), force.imag()};
  torque_ = area_ * radius_ * at.traction;
  pressure_ = at.pressure;
  work_.friction += area_ * at.slip_work;
  work_.stick_margin = std::min(work_.stick_margin, at.stick_margin);
}

WavesWork TwoWaves::take_work() { return std::exchange(work_, WavesWork{}); }

// A kicked oscillator of the rate w is stable for w dt < 2; at half of that its rate is right to 4 %.
double TwoWaves::longest_step() const {
  const double along = area_ * law_.stiffness;  // 2 pi r b E / h
  const double around =
      area_ * radius_ * radius_ * law_.shear / law_.thickness;  // 2 pi r^3 b G / h
  double square = std::max(along / (2 * model_->mass), around / model_->inertia);
  if (!is_light()) square = std::max(square, along / rotor_mass_);
  return 1 / std::sqrt(square);
}

}  // namespace twum::inline v0_1::motion
