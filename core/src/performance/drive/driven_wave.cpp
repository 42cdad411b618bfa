// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/driven_wave.hpp"

#include "design/layer_properties.hpp"
#include "performance/track.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::performance {
namespace {

using contact::SpeedDual;

ModelArray<SpeedDual> constants(const ModelArray<double>& values) {
  ModelArray<SpeedDual> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = SpeedDual(values[i]);
  return p;
}

// The model needs an amplitude, but does not depend on its value.
ModelArray<double> wave_values(const MotorDesign& design) {
  ModelArray<double> values = model_values(design);
  values[model_index(Parameter::amplitude)] = 1e-6;
  return values;
}

StatorModes<double> modes_of(const MotorDesign& design) {
  const auto modes = stator_modes(design);
  TWUM_ASSERT(modes.has_value());
  return *modes;
}

// Theta u_f (D6.1) [N]; zero without a voltage.
double drive_force(const MotorDesign& design) {
  const StatorModes<double> modes = modes_of(design);
  return std::numbers::sqrt2 * design.stator.voltage.value_or(0) * modes.force_factor *
         modes.unequal.share();
}

SpeedDual moving(double value, double seed) {
  SpeedDual x(value);
  x.d[0] = seed;
  return x;
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
      dual_model_(motor_model(constants(wave_values(design)), track)),
      modes_(modes_of(design)),
      drive_(drive_force(design)),
      omega_(2 * std::numbers::pi * drive_frequency(design)),
      reach_(reach_of(model_)) {
  if (in_use(design, Parameter::loss_factor)) loss_factor_ = design.layer.loss_factor;
}

DrivenWaves DrivenWaves::at_frequency(double omega) const {
  DrivenWaves other = *this;
  other.omega_ = omega;
  if (!loss_factor_) return other;
  other.model_.viscosity = shear_viscosity_of(*loss_factor_, model_.shear, omega);
  other.dual_model_.viscosity = SpeedDual(other.model_.viscosity);
  return other;
}

DrivenWave DrivenWaves::at(double amplitude, double speed, const WarmStart* guess,
                           double accuracy) const {
  const SolvedPoint point = solve_point(motor(amplitude), speed, guess, accuracy);
  const WarmStart start = point.start();
  const long slices = static_cast<long>(start.size());
  return {amplitude,           speed, balance(point.numbers, amplitude),
          point.status,        start, point.zones_followed() / slices,
          point.numbers.torque};
}

PointNumbers<SpeedDual> DrivenWaves::along(const SolvedPoint& point, double amplitude, double speed,
                                           double amplitude_seed, double speed_seed) const {
  const SpeedDual a = moving(amplitude, amplitude_seed);
  return point.differentiated(driven(dual_model_, {a, SpeedDual(omega_)}),
                              moving(speed, speed_seed));
}

SlopedWave DrivenWaves::sloped(const SolvedPoint& point, double amplitude, double speed,
                               double amplitude_seed, double speed_seed) const {
  SlopedWave result;
  const WarmStart start = point.start();
  const long slices = static_cast<long>(start.size());
  result.wave = {amplitude,           speed, {0, 0},
                 point.status,        start, point.zones_followed() / slices,
                 point.numbers.torque};
  if (point.status != PointStatus::ok) return result;
  const PointNumbers<SpeedDual> n = along(point, amplitude, speed, amplitude_seed, speed_seed);
  const WaveBalance<SpeedDual> b =
      wave_balance(constant_modes<SpeedDual>(modes_), moving(amplitude, amplitude_seed),
                   SpeedDual(omega_), n.reactive_force, n.stator_power);
  result.wave.balance = {b.real.v, b.imaginary.v};
  result.slope = {b.real.d[0], b.imaginary.d[0]};
  result.torque_slope = n.torque.d[0];
  return result;
}

SlopedWave DrivenWaves::in_amplitude(double amplitude, double speed, const WarmStart* guess) const {
  return sloped(solve_point(motor(amplitude), speed, guess), amplitude, speed, 1, 0);
}

DrivenWaves::LevelSlopes DrivenWaves::slopes(double amplitude, double speed,
                                             const WarmStart* guess) const {
  const SolvedPoint point = solve_point(motor(amplitude), speed, guess);
  return {point, sloped(point, amplitude, speed, 1, 0), sloped(point, amplitude, speed, 0, 1)};
}

Stability DrivenWaves::stability(const SlopedWave& w) const {
  const double rate = 2 * omega_ * modes_.mass, a = w.wave.amplitude;
  return {w.fold() / (a * rate * rate),
          -(w.wave.balance.imaginary + a * w.slope.imaginary) / (rate * a)};
}

double DrivenWaves::full_contact_amplitude() const {
  return model_.preload * model_.thickness /
         (2 * std::numbers::pi * model_.r * model_.b * model_.youngs);
}

double DrivenWaves::contact_stiffness() const {
  // Of an annulus pi R^2 rho / h over its width: the mean of rho is r.
  const double track = reach_ * reach_ * std::numbers::pi * model_.r * model_.b / model_.thickness;
  const double inertia = model_.inertia * omega_ * omega_, damping = model_.viscosity * omega_;
  return track *
         (model_.youngs + model_.tilt * model_.tilt * std::hypot(model_.shear - inertia, damping));
}

}  // namespace twum::performance
