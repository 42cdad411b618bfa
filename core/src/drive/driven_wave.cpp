// SPDX-License-Identifier: Apache-2.0
#include "drive/driven_wave.hpp"

#include "design/layer_properties.hpp"
#include "model/mapped_motor.hpp"
#include "model/track.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

using contact::kInAmplitude;
using contact::kInSpeed;
using contact::MotionDual;

// The model needs an amplitude, but does not depend on its value.
ModelArray<double> wave_values(const MotorDesign& design) {
  ModelArray<double> values = model_values(design);
  values[model_index(Parameter::amplitude)] = 1e-6;
  return values;
}

// Theta u_f (D6.1) [N]; zero without a voltage.
double drive_force(const MotorDesign& design, const StatorModes<double>& modes) {
  return std::numbers::sqrt2 * design.stator.voltage.value_or(0) * modes.force_factor *
         modes.unequal.share();
}

// omega^2 with k_s - omega^2 m_s + Re beta = 0 by Newton's method from the free stator's; that again where it leads nowhere.
double resonance_of(const StatorModes<double>& m) {
  if (!m.has_series()) return m.resonance;
  constexpr int kSteps = 30;
  constexpr double kSettled = 1e-14;
  double square = m.resonance * m.resonance;
  for (int i = 0; i < kSteps; ++i) {
    const double omega = std::sqrt(square);
    const double left =
        core::dynamic_stiffness(m, omega) + series_action(m, omega).stiffness().real;
    const double step = left / (m.mass - series_mass(m, omega));
    square += step;
    if (!(square > 0)) break;
    if (std::fabs(step) <= kSettled * square) return std::sqrt(square);
  }
  return m.resonance;
}

// k of (D2.10). A table's spline may be slightly larger between the sampled radii.
double reach_of(const MotorModel<double>& m) {
  if (m.track.nodes == 1) return 1;
  constexpr int kLooks = 64;
  constexpr double kAboveLooks = 1.1;
  const double inner = m.r - 0.5 * m.b;
  double most = 0;
  for (int i = 0; i <= kLooks; ++i)
    most = std::max(most, std::fabs(1 + shape_excess(m, inner + m.b * i / kLooks)));
  return kAboveLooks * most * m.r / inner;
}

}  // namespace

DrivenWaves::DrivenWaves(const MotorDesign& design, const TrackRule& track)
    : model_(motor_model(wave_values(design), track)),
      dual_model_(mapped<MotionDual>(model_, [](double x) { return MotionDual(x); })),
      modes_(stator_modes(design).value_or(StatorModes<double>{})),
      drive_(drive_force(design, modes_)),
      omega_(2 * std::numbers::pi * drive_frequency(design)),
      resonance_(resonance_of(modes_)),
      reach_(reach_of(model_)) {
  if (in_use(design, Parameter::loss_factor)) loss_factor_ = design.layer.loss_factor;
}

DrivenWaves DrivenWaves::at_frequency(double omega) const {
  DrivenWaves other = *this;
  other.omega_ = omega;
  if (!loss_factor_) return other;
  other.model_.viscosity = shear_viscosity_of(*loss_factor_, model_.shear, omega);
  other.dual_model_.viscosity = MotionDual(other.model_.viscosity);
  return other;
}

DrivenWave DrivenWaves::wave_of(const SolvedPoint& point, double amplitude, double speed) const {
  const WarmStart start = point.start();
  const long slices = static_cast<long>(start.size());
  return {amplitude,           speed, balance(point.numbers, amplitude),
          point.status,        start, point.zones_followed() / slices,
          point.numbers.torque};
}

DrivenWave DrivenWaves::at(double amplitude, double speed, const WarmStart* guess,
                           double accuracy) const {
  return wave_of(solve_point(motor(amplitude), speed, guess, accuracy), amplitude, speed);
}

// The viscosity of a loss factor goes with 1 / omega.
DrivenMotor<MotionDual> DrivenWaves::moving_motor(const MotionDual& amplitude,
                                                  const MotionDual& omega,
                                                  std::optional<double> half_angle) const {
  if (!loss_factor_ || omega.d[kInSpeed] == 0)
    return driven(dual_model_, {amplitude, omega}, half_angle);
  MotorModel<MotionDual> model = dual_model_;
  model.viscosity.d[kInSpeed] = -model.viscosity.v / omega.v;
  return driven(model, {amplitude, omega}, half_angle);
}

DrivenWaves::MovingWave DrivenWaves::moving(const SolvedPoint& point, double amplitude,
                                            double speed, Continued along) const {
  const bool in_frequency = along == Continued::frequency;
  const MotionDual a = MotionDual::variable(amplitude, kInAmplitude),
                   omega =
                       in_frequency ? MotionDual::variable(omega_, kInSpeed) : MotionDual(omega_);
  MovingPoint moving =
      point.moving(moving_motor(a, omega, point.half_angle),
                   in_frequency ? MotionDual(speed) : MotionDual::variable(speed, kInSpeed));
  const PointNumbers<MotionDual>& n = moving.numbers;
  const auto modes = constant_modes<MotionDual>(modes_);
  return {n, std::move(moving.states), a,
          drive_balance(modes, wave_balance(modes, a, omega, n.reactive_force, n.stator_power), a,
                        omega)};
}

double DrivenWaves::MovingWave::amplitude_per_speed() const {
  const MotionDual square = balance.real * balance.real + balance.imaginary * balance.imaginary;
  return -square.d[kInSpeed] / square.d[kInAmplitude];
}

DrivenWaves::LevelSlopes DrivenWaves::slopes(double amplitude, double speed, const WarmStart* guess,
                                             double accuracy, const SolvedPoint* near,
                                             Continued along) const {
  return slopes_of(near && near->jumps() ? solve_point_near(motor(amplitude), speed, *near,
                                                            guess ? *guess : near->start())
                                         : solve_point(motor(amplitude), speed, guess, accuracy),
                   amplitude, speed, along);
}

DrivenWaves::LevelSlopes DrivenWaves::slopes_of(SolvedPoint solved, double amplitude, double speed,
                                                Continued along) const {
  LevelSlopes s;
  s.solved = std::move(solved);
  SlopedWave& a = s.in_amplitude;
  a.wave = wave_of(s.solved, amplitude, speed);
  if (a.wave.status != PointStatus::ok) return s;
  MovingWave w = moving(s.solved, amplitude, speed, along);
  const MotionDual& torque = w.numbers.torque;
  a.slope = {w.balance.real.d[kInAmplitude], w.balance.imaginary.d[kInAmplitude]};
  a.torque_slope = torque.d[kInAmplitude];
  s.force_per_speed =
      (w.balance.real * w.balance.real + w.balance.imaginary * w.balance.imaginary).d[kInSpeed] /
      (2 * a.wave.force());
  s.balance_per_speed = {w.balance.real.d[kInSpeed], w.balance.imaginary.d[kInSpeed]};
  s.amplitude_per_speed = w.amplitude_per_speed();
  s.torque_per_speed = torque.d[kInSpeed] + a.torque_slope * s.amplitude_per_speed;
  s.numbers = w.numbers, s.states = std::move(w.states);
  return s;
}

double DrivenWaves::phase_lag(const DrivenWave& w) const {
  return core::phase_lag(modes_, w.balance, omega_);
}

double DrivenWaves::dynamic_stiffness() const {
  const double own = core::dynamic_stiffness(modes_, omega_);
  return modes_.has_series() ? own + series_action(modes_, omega_).stiffness().real : own;
}

double DrivenWaves::damping() const {
  if (!modes_.has_series()) return modes_.damping;
  return modes_.damping + series_action(modes_, omega_).stiffness().imaginary / omega_;
}

double DrivenWaves::divider() const {
  return modes_.has_series() ? series_action(modes_, omega_).size : 1;
}

// A free stator has two resonances, omega_1 and omega_2. Up to the root of the mean of their squares, or from there on, the force that
// an amplitude needs grows with the distance from its own resonance, as (D5.1) takes it. The stiffer the contact, the higher that is:
// the free stator's bounds it from above, that of a stuck contact from below.
std::pair<double, double> DrivenWaves::own_side() const {
  const StatorModes<double>& m = modes_;
  if (!m.has_series() || m.series->inductance == 0 || m.capacitance == 0) return {0, HUGE_VAL};
  const double electrical = 1 / (m.series->inductance * m.capacitance);
  const double coupling = m.force_factor * m.force_factor / (m.mass * m.capacitance);
  const double mean = 0.5 * (electrical + m.resonance * m.resonance + coupling);
  if (resonance_ * resonance_ < mean) return {0, std::sqrt(mean)};
  return {std::sqrt(mean + 0.5 * contact_stiffness() / m.mass), HUGE_VAL};
}

Stability DrivenWaves::stability(const SlopedWave& w) const {
  const double rate = 2 * omega_ * modes_.mass * divider(), a = w.wave.amplitude;
  return {w.fold() / (a * rate * rate),
          -(w.wave.balance.imaginary + a * w.slope.imaginary) / (rate * a)};
}

double DrivenWaves::full_contact_amplitude() const {
  return model_.preload * model_.thickness /
         (2 * std::numbers::pi * model_.r * model_.b * model_.youngs);
}

double DrivenWaves::contact_stiffness() const {
  // Of an annulus pi R^2 rho / h over its width: the mean of rho is r.
  const WornTrack* worn = worn_track(model_);
  const double thinnest = model_.thickness - (worn ? worn->thickness_share * worn->spread() : 0);
  const double track = reach_ * reach_ * std::numbers::pi * model_.r * model_.b / thinnest;
  const double inertia = model_.inertia * omega_ * omega_, damping = model_.viscosity * omega_;
  return track *
         (model_.youngs + model_.tilt * model_.tilt * std::hypot(model_.shear - inertia, damping));
}

}  // namespace twum::inline v0_1::core
