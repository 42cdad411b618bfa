// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/search.hpp"
#include "model/track.hpp"

#include "model/stator_modes.hpp"
#include "point/backward_wave.hpp"

#include <twum/core/metrics.hpp>

namespace twum::inline v0_1::core {

/// h / 2 L at the mean radius (W5.3). @throws SearchFailure if the wave does not reach the rotor there
template <typename S>
S layer_aspect(const DrivenMotor<S>& m) {
  if (!(value_of(m.mean.contact.half_length) > 0)) throw SearchFailure{MetricStatus::undefined};
  return m.thickness / (2.0 * m.mean.contact.half_length);
}

/// A point metric from the numbers of a point (T7.1 to T7.9); S is double or carries derivatives. The one place for these
/// formulas; a metric without its line does not compile (-Werror=switch).
template <typename S>
S point_metric(Metric metric, const PointNumbers<S>& n, const S& speed, const DrivenMotor<S>& m) {
  using M = Metric;
  switch (metric) {
    case M::torque_at: return n.torque;
    case M::output_power_at: return n.torque * speed;  // (T7.1)
    case M::stator_power_at: return n.stator_power;
    case M::friction_power_at: return n.friction_power;
    case M::layer_loss_at: return n.layer_loss;
    case M::efficiency_at: return n.torque * speed / (n.stator_power + stator_loss(m));  // (T7.7)
    case M::contact_efficiency_at: return n.torque * speed / n.stator_power;             // (T7.6)
    case M::wear_intensity_at: return n.friction_power / track_area(m);                  // (T7.9)
    case M::stick_fraction_at: return n.stick_fraction;
    case M::speed_at: return speed;
    case M::amplitude_at: return m.mean.amplitude;
    case M::drive_frequency_at: return m.omega / (2 * std::numbers::pi);
    case M::max_pressure_at: return largest_pressure(m);
    case M::layer_aspect_at: return layer_aspect(m);
    case M::stator_loss_at: return stator_loss(m);
    // of the stator's modes, see wave_metric()
    case M::phase_lag_at:
    case M::electrical_power_at:
    case M::overall_efficiency_at:
    case M::phase_current_at:
    case M::power_factor_at:
    case M::backward_ratio_at:
    case M::squeal_rate_at:
    case M::sensor_voltage_at:
    case M::sensor_phase_at:
    case M::drive_voltage_at:
    case M::dielectric_loss_at:
    case M::loaded_resonance:
    // of a drive that follows, see HeldMetrics
    case M::held_speed_limit_at:
    case M::held_torque_limit_at:
    case M::pull_out_margin_at:
    case M::torque_reserve_at:
    case M::drive_reserve_at:
    case M::voltage_reserve_at:
    // of heat, see HeatMetrics
    case M::stator_temperature_at:
    case M::rotor_temperature_at:
    case M::housing_temperature_at:
    case M::contact_temperature_at:
    case M::temperature_margin_at:
    case M::thermal_gain_at:
    case M::thermal_time_constant:
    case M::continuous_torque:
    case M::continuous_torque_at:
    case M::start_temperature:
    case M::on_time_at:
    case M::duty_limit_at:
    case M::stator_peak_temperature:
    case M::rotor_peak_temperature:
    case M::housing_peak_temperature:
    case M::contact_peak_temperature:
    // of wear, see WearMetrics
    case M::wear_rate_at:
    case M::life_at:
    case M::life_revolutions_at:
    case M::life:
    case M::life_revolutions:
    // of motions, see MotionMetrics
    case M::settling_rate_at:
    case M::bounce_rate_at:
    case M::speed_per_frequency_at:
    case M::speed_per_voltage_at:
    case M::start_time_at:
    case M::start_overshoot_at:
    case M::stop_time_at:
    case M::stop_angle_at:
    case M::move_energy:
    case M::burst_angle:
    case M::dynamic_start_voltage:
    // numbers of the motor, see metric_row()
    case M::ceramic_stress_at:
    case M::max_overall_efficiency:
    case M::speed_at_max_overall_efficiency:
    case M::pull_out_torque:
    case M::start_voltage:
    case M::hold_voltage:
    case M::start_frequency:
    case M::pull_out_frequency:
    case M::coupling_factor:
    case M::capacitance_ratio:
    case M::mode_separation:
    case M::ceramic_stress:
    case M::stall_torque:
    case M::max_torque:
    case M::holding_torque:
    case M::no_load_speed:
    case M::plateau_speed:
    case M::peak_power:
    case M::speed_at_peak_power:
    case M::torque_at_peak_power:
    case M::contact_efficiency_at_peak_power:
    case M::max_efficiency:
    case M::speed_at_max_efficiency:
    case M::contact_half_length:
    case M::contact_ratio:
    case M::max_pressure:
    case M::layer_aspect:
    case M::pressure_nonuniformity:
    case M::radial_motion_ratio: break;
    case M::stator_mass:
    case M::free_amplitude:
    case M::apparent_power_at:
    case M::matching_inductance_at:
    case M::driver_loss_at:
    case M::terminal_voltage_at: break;
  }
  return S(0.0);
}

/// True for the signals of a sensor electrode.
constexpr bool needs_sensor(Metric metric) {
  return metric == Metric::sensor_voltage_at || metric == Metric::sensor_phase_at;
}

/// True for what a driver has to give besides power.
constexpr bool is_of_terminals(Metric metric) {
  return metric == Metric::apparent_power_at || metric == Metric::matching_inductance_at;
}

/// True for the point metrics that wave_metric() knows.
constexpr bool is_wave_metric(Metric metric) {
  using M = Metric;
  return is_of_terminals(metric) || metric == M::phase_lag_at || metric == M::electrical_power_at ||
         metric == M::overall_efficiency_at || metric == M::phase_current_at ||
         metric == M::power_factor_at || metric == M::loaded_resonance ||
         metric == M::driver_loss_at || metric == M::terminal_voltage_at ||
         metric == M::drive_voltage_at || metric == M::dielectric_loss_at ||
         metric == M::backward_ratio_at || metric == M::squeal_rate_at || needs_sensor(metric);
}

/// True if the metric is made of the backward wave (D6.5, D6.7). Equal phases and modes drive none.
template <typename S>
bool needs_backward_wave(Metric metric, const StatorModes<S>& modes) {
  using M = Metric;
  if (metric == M::squeal_rate_at) return true;
  return !modes.unequal.none() && (metric == M::backward_ratio_at ||
                                   metric == M::phase_current_at || metric == M::power_factor_at ||
                                   metric == M::terminal_voltage_at || is_of_terminals(metric));
}

/// What a metric of the stator's modes is made of at a point.
template <typename S>
struct WavePoint {
  S amplitude, omega, reactive_force, stator_power, output_power;
  Phasor<S> backward{S(0.0), S(0.0)};  ///< z of (D6.5)
  S squeal_rate = S(0.0);              ///< of (D6.7)
};

/// The force that the wave of a point takes of the voltage at the terminals (D2.3) [N].
template <typename S>
WaveBalance<S> wave_balance(const StatorModes<S>& modes, const WavePoint<S>& p) {
  return wave_balance(modes, p.amplitude, p.omega, p.reactive_force, p.stator_power);
}

/// The force that it takes of the inverter's voltage (D8.3), in the frame of alpha times the voltage or in that of the voltage [N].
/// @{
template <typename S>
WaveBalance<S> drive_balance(const StatorModes<S>& modes, const WavePoint<S>& p) {
  return drive_balance(modes, wave_balance(modes, p), p.amplitude, p.omega);
}
template <typename S>
WaveBalance<S> inverter_balance(const StatorModes<S>& modes, const WavePoint<S>& p) {
  return inverter_balance(modes, wave_balance(modes, p), p.amplitude, p.omega);
}
/// @}

/// The point with what a contact does to a backward wave.
template <typename S>
WavePoint<S> with_backward_wave(Metric metric, WavePoint<S> p, const StatorModes<S>& modes,
                                const DisturbedContact<S>& contact) {
  if (metric == Metric::squeal_rate_at) {
    p.squeal_rate = free_backward_wave(contact, modes, modes.rotor_mass).rate;
    return p;
  }
  const WaveBalance<S> w = inverter_balance(modes, p);
  p.backward = forced_backward_wave(contact, modes, w, p.amplitude);
  return p;
}

/// Apparent power of both phases (D4.6), or the inductance that takes the reactive current of the first one (D4.7).
/// @throws SearchFailure if that current is not capacitive
template <typename S>
S terminal_metric(Metric metric, const StatorModes<S>& modes, const WaveBalance<S>& w,
                  const WavePoint<S>& p) {
  const Terminals<S> t = terminals(modes, w, p.amplitude, p.omega, p.backward);
  if (metric == Metric::apparent_power_at)
    return modes.unequal.none() ? S(2.0 * t.voltage * t.current) : S(t.power / t.power_factor);
  const S voltage = std::numbers::sqrt2 * t.voltage;
  const S reactive = reactive_current(modes, inverter_balance(modes, p), p.amplitude, p.omega,
                                      voltage, p.backward);
  if (!(value_of(reactive) > 0)) throw SearchFailure{MetricStatus::undefined};
  return voltage / (p.omega * reactive);
}

/// Amplitude of the wave of a stator that no rotor touches (D3.6) [m].
/// @param force  of the voltage on the forward wave, Theta u_f [N]
template <typename S>
S free_amplitude(const StatorModes<S>& modes, const S& omega, const S& force) {
  return force /
         drive_balance(modes, wave_balance(modes, S(1.0), omega, S(0.0), S(0.0)), S(1.0), omega)
             .force();
}

/// A point metric of the stator's modes; S is double or carries derivatives.
template <typename S>
S wave_metric(Metric metric, const StatorModes<S>& modes, const WavePoint<S>& p) {
  using M = Metric;
  using std::sqrt;
  constexpr double kTurn = 2 * std::numbers::pi;
  const WaveBalance<S> w = wave_balance(modes, p);
  if (metric == M::phase_lag_at) return phase_lag(modes, drive_balance(modes, p), p.omega);
  if (metric == M::loaded_resonance)  // (D3.1)
    return sqrt(modes.resonance * modes.resonance + p.reactive_force / (p.amplitude * modes.mass)) /
           kTurn;
  if (metric == M::backward_ratio_at) return sqrt(p.backward.squared()) / p.amplitude;
  if (metric == M::squeal_rate_at) return p.squeal_rate;
  if (needs_sensor(metric)) {
    const SensorSignal<S> signal =
        sensor_signal(modes, inverter_balance(modes, p), p.amplitude, p.omega);
    return metric == M::sensor_voltage_at ? signal.voltage : signal.phase;
  }
  if (is_of_terminals(metric)) return terminal_metric(metric, modes, w, p);
  const Terminals<S> t = terminals(modes, w, p.amplitude, p.omega, p.backward);
  if (metric == M::drive_voltage_at) return t.voltage;
  if (metric == M::electrical_power_at) return t.power;
  if (metric == M::dielectric_loss_at) return t.dielectric_loss;
  if (metric == M::phase_current_at) return t.current;
  if (metric == M::power_factor_at) return t.power_factor;
  if (metric == M::driver_loss_at) return t.driver_loss;
  if (metric == M::terminal_voltage_at) return t.terminal_voltage;
  return value_of(p.output_power) > 0 ? S(p.output_power / t.power) : S(0.0);  // (D4.3)
}

/// C_m / C_0 of a phase (D4.4).
template <typename S>
S capacitance_ratio(const StatorModes<S>& m) {
  return m.force_factor * m.force_factor / (m.mass * m.resonance * m.resonance * m.capacitance);
}

/// sqrt(C_m / (C_0 + C_m)) of a phase.
template <typename S>
S coupling_factor(const StatorModes<S>& m) {
  using std::sqrt;
  const S motional = m.force_factor * m.force_factor / (m.mass * m.resonance * m.resonance);
  return sqrt(motional / (m.capacitance + motional));
}

/// One row for each metric: what it is, for its value and for its derivatives alike; a metric without its row does not
/// compile.
/// @param to  answers with numbers (Evaluator) or with numbers and their derivatives (Differentiator)
template <typename Answers>
typename Answers::Number metric_row(Answers& to, const MetricRequest& request) {
  using M = Metric;
  CurveSearch& search = to.search();
  switch (request.metric) {
    case M::stall_torque:
      return to.at_peak(M::torque_at, {0, search.stall_torque(), PeakKind::rest});
    case M::max_torque: return to.at_peak(M::torque_at, search.max_torque());
    case M::holding_torque: return to.of_motor([](const auto& m) { return holding_torque(m); });
    case M::no_load_speed: return to.crossing(search.no_load(), to.fixed(0));
    case M::plateau_speed: return to.plateau_of_track();
    case M::peak_power: return to.at_peak(M::output_power_at, search.peak_power());
    case M::speed_at_peak_power: return to.speed_of_peak(M::output_power_at, search.peak_power());
    case M::torque_at_peak_power: return to.along_peak(M::torque_at, search.working_peak());
    case M::contact_efficiency_at_peak_power:
      return to.along_peak(M::contact_efficiency_at, search.working_peak());
    case M::max_efficiency: return to.at_peak(M::efficiency_at, search.max_efficiency());
    case M::speed_at_max_efficiency:
      return to.speed_of_peak(M::efficiency_at, search.max_efficiency());
    case M::contact_half_length:
      return to.of_contact([](const auto& m) { return m.mean.contact.half_length; });
    case M::contact_ratio: return to.of_contact([](const auto& m) { return m.mean.contact.ratio; });
    case M::max_pressure: return to.of_contact([](const auto& m) { return largest_pressure(m); });
    case M::layer_aspect: return to.of_contact([](const auto& m) { return layer_aspect(m); });
    case M::pressure_nonuniformity:
      return to.of_contact([](const auto& m) { return pressure_nonuniformity(m); });
    case M::radial_motion_ratio:
      return to.of_contact([](const auto& m) { return ratio_at_contact(m); });
    case M::max_overall_efficiency:
      return to.at_peak(M::overall_efficiency_at, search.max_overall_efficiency());
    case M::speed_at_max_overall_efficiency:
      return to.speed_of_peak(M::overall_efficiency_at, search.max_overall_efficiency());
    case M::pull_out_torque: return to.at_pull_out(M::torque_at);
    case M::start_voltage:
    case M::hold_voltage:
    case M::start_frequency:
    case M::pull_out_frequency: return to.threshold(request.metric);
    case M::loaded_resonance:
      return to.at(M::loaded_resonance, to.crossing(search.no_load(), to.fixed(0)));
    case M::coupling_factor: return to.of_modes([](const auto& m) { return coupling_factor(m); });
    case M::capacitance_ratio:
      return to.of_modes([](const auto& m) { return capacitance_ratio(m); });
    case M::mode_separation: return to.of_plate(PlateNumber::mode_separation);
    case M::stator_mass: return to.of_plate(PlateNumber::stator_mass);
    case M::free_amplitude: return to.free_wave();
    case M::apparent_power_at:
    case M::matching_inductance_at:
    case M::driver_loss_at:
    case M::terminal_voltage_at: break;
    case M::ceramic_stress:
      return to.product(to.of_plate(PlateNumber::ceramic_stress),
                        to.at(M::amplitude_at, to.crossing(search.no_load(), to.fixed(0))));
    case M::speed_at: return to.crossing(search.speed_at(request.at), to.fixed(request.at));
    case M::torque_at:
    case M::output_power_at:
    case M::stator_power_at:
    case M::friction_power_at:
    case M::layer_loss_at:
    case M::efficiency_at:
    case M::contact_efficiency_at:
    case M::wear_intensity_at:
    case M::stick_fraction_at:
    case M::amplitude_at:
    case M::phase_lag_at:
    case M::electrical_power_at:
    case M::overall_efficiency_at:
    case M::phase_current_at:
    case M::power_factor_at:
    case M::backward_ratio_at:
    case M::squeal_rate_at:
    case M::sensor_voltage_at:
    case M::sensor_phase_at:
    case M::drive_frequency_at:
    case M::drive_voltage_at:
    case M::max_pressure_at:
    case M::layer_aspect_at:
    case M::ceramic_stress_at:
    case M::stator_loss_at:
    case M::dielectric_loss_at: break;
    case M::held_speed_limit_at:
    case M::held_torque_limit_at:
    case M::pull_out_margin_at:
    case M::torque_reserve_at:
    case M::drive_reserve_at:
    case M::voltage_reserve_at: throw SearchFailure{MetricStatus::undefined};  // see HeldMetrics
    case M::stator_temperature_at:
    case M::rotor_temperature_at:
    case M::housing_temperature_at:
    case M::contact_temperature_at:
    case M::temperature_margin_at:
    case M::thermal_gain_at:
    case M::thermal_time_constant:
    case M::continuous_torque:
    case M::continuous_torque_at:
    case M::start_temperature:
    case M::on_time_at:
    case M::duty_limit_at:
    case M::stator_peak_temperature:
    case M::rotor_peak_temperature:
    case M::housing_peak_temperature:
    case M::contact_peak_temperature:
    case M::wear_rate_at:
    case M::life_at:
    case M::life_revolutions_at:
    case M::life:
    case M::life_revolutions:
    case M::settling_rate_at:
    case M::bounce_rate_at:
    case M::speed_per_frequency_at:
    case M::speed_per_voltage_at:
    case M::start_time_at:
    case M::start_overshoot_at:
    case M::stop_time_at:
    case M::stop_angle_at:
    case M::move_energy:
    case M::burst_angle:
    case M::dynamic_start_voltage:
      throw SearchFailure{MetricStatus::undefined};  // see HeatMetrics, WearMetrics, MotionMetrics
  }
  const typename Answers::Number speed =
      request.argument == Argument::torque
          ? to.crossing(search.speed_at(request.at), to.fixed(request.at))
          : to.fixed(request.at);
  if (request.metric == M::ceramic_stress_at)
    return to.product(to.of_plate(PlateNumber::ceramic_stress), to.at(M::amplitude_at, speed));
  return to.at(request.metric, speed);
}

}  // namespace twum::inline v0_1::core
