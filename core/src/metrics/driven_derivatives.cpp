// SPDX-License-Identifier: Apache-2.0
// Derivatives of what a motor under a voltage has besides its points: where it pulls out, starts and holds.
#include "metrics/differentiator.hpp"
#include "metrics/motor_curve.hpp"

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

// of d ln H / d ln A at an extremum, which is found to 1e-7 of the amplitude: a steeper one is a kink, on one side of which the
// derivative is taken
constexpr double kSteep = 1e-4;

}  // namespace

// At the fold H = Theta u_0 and H_A = 0: the first moves the speed, the second the amplitude.
Derived Differentiator::at_pull_out(Metric metric) {
  const double speed = values_.pull_out().parameter;
  const MotorPoint at = values_.pull_out_point();
  contact::SpeedDual amplitude(at.motor.mean.amplitude);
  amplitude.d[0] = 1;
  const DrivenMotor<ModelDual2> motor = differentiated_motor(design_, amplitude, m_.track);
  ModelDual2 variable = speed_variable<ModelDual2>(speed);
  variable.v.d[0] = 0;  // the inner derivative is along the amplitude
  const PointNumbers<ModelDual2> n = at.solved.differentiated(motor, variable);
  const auto p = wave_point(motor, n, variable);
  const auto modes = moving_modes(values_.modes(), motor.stator_damping);
  const DesignDual2 excess =
      drive_balance(modes, p).force() - moving_drive(modes, *design_.stator.voltage);
  const DesignDual2 f = widened(point_metric(metric, n, variable, motor));
  constexpr int kAmplitude = static_cast<int>(model_index(Parameter::amplitude));
  DesignDual result(f.v.v);
  for (int j = 0; j < kDesignDirections; ++j) {
    if (j == kSpeedDirection || j == kAmplitude) continue;
    const double in_speed = -excess.d[j].v / excess.d[kSpeedDirection].v;
    const double in_amplitude =
        -(excess.d[j].d[0] + excess.d[kSpeedDirection].d[0] * in_speed) / excess.d[kAmplitude].d[0];
    result.d[j] = f.d[j].v + f.d[kSpeedDirection].v * in_speed + f.d[kAmplitude].v * in_amplitude;
  }
  return {result, smoothness_of(at.motor, at.solved, speed)};
}

Differentiator::RestForce Differentiator::force_at_rest(const Threshold& t, double amplitude,
                                                        const MotorDesign& design) {
  const DrivenMotor<ModelDual> motor = differentiated_motor(design, amplitude, m_.track);
  const ModelDual rest = speed_variable<ModelDual>(0);
  const DrivenWaves waves = values_.thresholds().waves_at(t.frequency);
  const SolvedPoint point = solve_point(waves.motor(amplitude), 0);
  if (point.status != PointStatus::ok) throw SearchFailure{metric_status(point.status)};
  const auto modes = moving_modes(values_.modes(), motor.stator_damping);
  DesignDual force =
      drive_balance(modes, wave_point(motor, point.differentiated(motor, rest), rest)).force();
  force.d[kSpeedDirection] = force.d[model_index(Parameter::amplitude)] = 0;
  return {force, waves.in_amplitude(amplitude, 0).force_slope(),
          point.special ? Smoothness::smooth : smoothness_of(waves.motor(amplitude), point, 0)};
}

// H is at an extremum over the amplitude, which therefore drops out (D3.3), or at a kink (D3.5).
Derived Differentiator::threshold(Metric metric) {
  const Threshold& t = values_.thresholds().at(metric);
  if (t.amplitude == 0) return {DesignDual(t.value), Smoothness::flat};
  const bool is_voltage = metric == Metric::start_voltage || metric == Metric::hold_voltage;
  const MotorDesign design = is_voltage ? design_ : with(design_, Parameter::frequency, t.value);
  auto [force, slope, smoothness] = force_at_rest(t, t.amplitude, design);
  if (t.beyond_kink > 0) {
    const RestForce beyond = force_at_rest(t, t.beyond_kink, design);
    const double share = slope / (slope - beyond.slope);
    force = with_value(DesignDual(force + share * (beyond.force - force)), force.v);
    smoothness = Smoothness::smooth;
  } else if (std::fabs(slope) * t.amplitude > kSteep * force.v) {
    smoothness = Smoothness::one_sided;
  }
  const auto modes = moving_modes(values_.modes(), model_.stator_damping);
  if (is_voltage)
    return {
        with_value(force / (modes.force_factor * modes.unequal.share()) * std::sqrt(0.5), t.value),
        smoothness};
  return {frequency_of(force - moving_drive(modes, *design_.stator.voltage), design, t.value),
          smoothness};
}

// The frequency at which `excess` is zero. Where the layer's viscosity is that of a loss factor it goes with the
// frequency, there and in the slopes of the design's parameters, which are those at the design's own frequency.
DesignDual Differentiator::frequency_of(DesignDual excess, const MotorDesign& there,
                                        double frequency) const {
  constexpr auto kFrequency = model_index(Parameter::frequency),
                 kViscosity = model_index(Parameter::shear_viscosity);
  const double own = drive_frequency(design_);
  const bool follows = in_use(design_, Parameter::loss_factor);
  const double slope = excess.d[kFrequency] -
                       (follows ? excess.d[kViscosity] * shear_viscosity(there) / frequency : 0);
  DesignDual f(frequency);
  for (int j = 0; j < kDesignDirections; ++j) f.d[j] = -excess.d[j] / slope;
  f.d[kFrequency] = 0;
  if (follows) {
    f.d[kViscosity] *= own / frequency;
    f.d[kFrequency] = f.d[kViscosity] * shear_viscosity(design_) / own;
  }
  return f;
}

}  // namespace twum::inline v0_1::core
