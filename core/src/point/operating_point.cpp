// SPDX-License-Identifier: Apache-2.0
#include "point/operating_point.hpp"

#include "point/backward_wave.hpp"

#include <twum/base/no_value.hpp>

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

// Made once: points are many.
constexpr OperatingPoint kNoAnswer = [] {
  OperatingPoint point{};
  for (double* number :
       {&point.torque, &point.output_power, &point.stator_power, &point.friction_power,
        &point.layer_loss, &point.stator_loss, &point.wear_intensity, &point.stick_fraction,
        &point.reactive_force, &point.amplitude, &point.phase_lag, &point.voltage,
        &point.phase_current, &point.dielectric_loss, &point.electrical_power, &point.power_factor,
        &point.driver_loss, &point.terminal_voltage})
    *number = kNoValue;
  return point;
}();

void add_terminals(OperatingPoint& point, const DrivenMotor<double>& m,
                   const StatorModes<double>& modes) {
  const WaveBalance<double> wave =
      wave_balance(modes, m.mean.amplitude, m.omega, point.reactive_force, point.stator_power);
  const WaveBalance<double> inverter = inverter_balance(modes, wave, m.mean.amplitude, m.omega);
  Phasor<double> backward{0, 0};
  if (!modes.unequal.none()) {
    backward = {kNoValue, kNoValue};
    if (const auto contact = disturbed_contact(m, point.speed))
      backward = forced_backward_wave(*contact, modes, inverter, m.mean.amplitude);
  }
  const Terminals<double> t = terminals(modes, wave, m.mean.amplitude, m.omega, backward);
  point.phase_lag =
      phase_lag(modes, drive_balance(modes, wave, m.mean.amplitude, m.omega), m.omega);
  point.voltage = t.voltage;
  point.phase_current = t.current;
  point.dielectric_loss = t.dielectric_loss;
  point.electrical_power = t.power;
  point.power_factor = t.power_factor;
  point.driver_loss = t.driver_loss;
  point.terminal_voltage = t.terminal_voltage;
}

}  // namespace

OperatingPoint operating_point_of(const DrivenMotor<double>& m, const SolvedPoint& solved,
                                  double speed, const StatorModes<double>* modes) {
  OperatingPoint point = kNoAnswer;
  point.speed = speed, point.status = solved.status;
  if (solved.status != PointStatus::ok) return point;
  const PointNumbers<double>& n = solved.numbers;
  point.torque = n.torque;
  point.output_power = n.torque * speed;
  point.stator_power = n.stator_power;
  point.friction_power = n.friction_power;
  point.layer_loss = n.layer_loss;
  point.stator_loss = stator_loss(m);
  point.wear_intensity = n.friction_power / track_area(m);
  point.stick_fraction = n.stick_fraction;
  point.reactive_force = n.reactive_force;
  point.amplitude = m.mean.amplitude;
  if (modes) add_terminals(point, m, *modes);
  return point;
}

BackwardWave backward_wave_of(const DrivenMotor<double>& m, const SolvedPoint& solved, double speed,
                              const StatorModes<double>* modes,
                              const std::optional<double>& rotor_mass) {
  BackwardWave wave{kNoValue, kNoValue, kNoValue, kNoValue, kNoValue, kNoValue};
  if (solved.status != PointStatus::ok) return wave;
  const auto contact = disturbed_contact(m, speed);
  if (!modes) {
    if (contact)
      wave.fed_damping = backward_stiffness(*contact, m.omega, rotor_mass).imaginary / m.omega;
    return wave;
  }
  if (contact) {
    const FreeBackwardWave<double> free = free_backward_wave(*contact, *modes, rotor_mass);
    wave.squeal_rate = free.rate;
    wave.fed_damping = 2 * free.mass * free.rate + free.damping;  // (D6.7, D6.8)
  }
  const WaveBalance<double> forward =
      inverter_balance(*modes,
                       wave_balance(*modes, m.mean.amplitude, m.omega,
                                    solved.numbers.reactive_force, solved.numbers.stator_power),
                       m.mean.amplitude, m.omega);
  Phasor<double> backward{0, 0};
  if (!modes->unequal.none()) {
    if (!contact) return wave;
    backward = forced_backward_wave(*contact, *modes, forward, m.mean.amplitude);
  }
  const double voltage = forward.force() / modes->force_factor / modes->unequal.share(),
               rms = std::sqrt(0.5);
  const PhaseCurrents<double> i =
      phase_currents(*modes, forward, m.mean.amplitude, m.omega, voltage, backward);
  wave.ratio = std::sqrt(backward.squared()) / m.mean.amplitude;
  wave.standing_wave_ratio = (1 + wave.ratio) / (1 - wave.ratio);
  wave.first_current = rms * i.first, wave.second_current = rms * i.second;
  return wave;
}

}  // namespace twum::inline v0_1::core

namespace twum::inline v0_1 {

const char* to_string(PointStatus status) noexcept {
  switch (status) {
    case PointStatus::ok: return "ok";
    case PointStatus::no_periodic_state: return "no-periodic-state";
    case PointStatus::not_converged: return "not-converged";
    case PointStatus::resonance: return "resonance";
    case PointStatus::unresolved: return "unresolved";
    case PointStatus::inaccurate: return "inaccurate";
    case PointStatus::pulled_out: return "pulled-out";
    case PointStatus::no_running_branch: return "no-running-branch";
    case PointStatus::no_dead_branch: return "no-dead-branch";
    case PointStatus::unstable_amplitude: return "unstable-amplitude";
  }
  return "unresolved";
}

double OperatingPoint::contact_efficiency() const noexcept {
  const double excess = stator_power - output_power - friction_power - layer_loss;
  return core::is_known(stator_power, excess) ? output_power / stator_power : kNoValue;
}

double OperatingPoint::overall_efficiency() const noexcept {
  const double excess = stator_power - output_power - friction_power - layer_loss;
  if (!core::is_known(electrical_power, excess)) return kNoValue;
  return output_power > 0 ? output_power / electrical_power : 0;
}

double OperatingPoint::efficiency() const noexcept {
  const double input = stator_power + stator_loss;
  const double excess = stator_power - output_power - friction_power - layer_loss;
  return core::is_known(input, excess) ? output_power / input : kNoValue;
}

}  // namespace twum::inline v0_1
