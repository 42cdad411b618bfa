// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1 {

/// Every metric of a motor; definitions in theory section 7.
enum class Metric : unsigned char {
  stall_torque,
  max_torque,
  holding_torque,
  no_load_speed,
  plateau_speed,
  peak_power,
  speed_at_peak_power,
  torque_at_peak_power,
  contact_efficiency_at_peak_power,
  max_efficiency,
  speed_at_max_efficiency,
  contact_half_length,
  contact_ratio,
  max_pressure,
  layer_aspect,
  pressure_nonuniformity,
  radial_motion_ratio,
  max_overall_efficiency,
  speed_at_max_overall_efficiency,
  pull_out_torque,
  start_voltage,
  hold_voltage,
  start_frequency,
  pull_out_frequency,
  loaded_resonance,
  coupling_factor,
  capacitance_ratio,
  mode_separation,
  ceramic_stress,
  torque_at,
  speed_at,
  output_power_at,
  stator_power_at,
  friction_power_at,
  layer_loss_at,
  efficiency_at,
  contact_efficiency_at,
  wear_intensity_at,
  stick_fraction_at,
  amplitude_at,
  phase_lag_at,
  electrical_power_at,
  overall_efficiency_at,
  phase_current_at,
  power_factor_at,
  backward_ratio_at,
  squeal_rate_at,
  sensor_voltage_at,
  sensor_phase_at,
  drive_frequency_at,
  drive_voltage_at,
  max_pressure_at,
  layer_aspect_at,
  ceramic_stress_at,
  held_speed_limit_at,
  held_torque_limit_at,
  pull_out_margin_at,
  torque_reserve_at,
  drive_reserve_at,
  voltage_reserve_at,
  // of heat
  stator_loss_at,
  dielectric_loss_at,
  stator_temperature_at,
  rotor_temperature_at,
  housing_temperature_at,
  contact_temperature_at,
  temperature_margin_at,
  thermal_gain_at,
  thermal_time_constant,
  continuous_torque,
  continuous_torque_at,
  start_temperature,
  on_time_at,
  duty_limit_at,
  stator_peak_temperature,
  rotor_peak_temperature,
  housing_peak_temperature,
  contact_peak_temperature,
  // of wear
  wear_rate_at,
  life_at,
  life_revolutions_at,
  life,
  life_revolutions,
  // of motions
  settling_rate_at,
  bounce_rate_at,
  speed_per_frequency_at,
  speed_per_voltage_at,
  start_time_at,
  start_overshoot_at,
  stop_time_at,
  stop_angle_at,
  move_energy,
  burst_angle,
  dynamic_start_voltage,
  // of the stator and its driver
  stator_mass,
  free_amplitude,
  apparent_power_at,
  matching_inductance_at,
  driver_loss_at,
  terminal_voltage_at
};

/// Argument that a metric takes.
enum class Argument : unsigned char {
  none,             ///< nothing: a number of the motor, such as stall_torque
  speed,            ///< a rotor speed [rad/s]
  torque,           ///< a load torque [N m]
  both,             ///< a torque that the drive holds at a speed
  angle,            ///< an angle of the rotor [rad]
  periods,          ///< a number of periods of the drive
  speed_or_torque,  ///< a speed, a torque, or both; only in the table, never in a request
  either            ///< a speed or a torque, not both; likewise
};
/// As in the table of metrics; static lifetime.
const char* to_string(Argument value) noexcept;

/// Whether a metric has a value.
enum class MetricStatus : unsigned char {
  ok,
  /// not defined for this motor: it has no stall torque, no stator damping, or no input power
  undefined,
  unreachable,        ///< the motor cannot carry the torque asked for
  no_periodic_state,  ///< needs a point without a periodic state
  not_converged,      ///< needs a point that did not converge
  resonance,          ///< needs a point at an undamped resonance
  unresolved,         ///< needs a point with too many zones
  /// needs a point where rounding errors violate a law of the model, or a value is not finite
  inaccurate,
  out_of_range,        ///< asked at a speed at or below the negative wave speed
  pulled_out,          ///< under the voltage there is no running wave at the speed that is needed
  no_running_branch,   ///< under the voltage there is no running wave at any speed
  no_dead_branch,      ///< the motor starts by itself
  unstable_amplitude,  ///< needs a wave that is not stable
  /// the model of the backward wave does not cover stick in a layer with damping or inertia, or with mu_0 > mu
  backward_wave_unknown,
  does_not_pull_out,        ///< the running wave exists down to rest
  torque_out_of_reach,      ///< no amplitude carries the held torque
  voltage_too_low,          ///< the drive holds the torque at no voltage up to its own
  amplitude_too_low,        ///< the held torque needs more than the motor's amplitude
  outside_frequency_range,  ///< the drive does not reach the frequency that holds the torque
  no_steady_temperature,  ///< as the motor warms it loses the point, and finds no steady temperature
  thermally_unstable,     ///< the temperatures of the motor do not settle
  temperature_out_of_range,  ///< so far from the reference that the drift of a parameter means nothing
  too_hot_at_no_load,        ///< a limit of temperature is broken without a load already
  never_too_hot,             ///< no limit of temperature is reached, however long the motor runs
  does_not_wear,             ///< nothing slips in the contact, so that the life has no end
  does_not_start,            ///< the drive does not bring the rotor from rest to its running speed
  does_not_stop,             ///< the load drives the rotor on when the drive is off
  wear_localizes  ///< of a free profile: one radius takes over the load, so that there is no life
};

/// Short machine-readable word, such as "unreachable"; "ok" for ok. Static lifetime.
const char* to_string(MetricStatus status) noexcept;

/// True where the metric is a time that does not end: it keeps every lower limit.
constexpr bool is_endless(MetricStatus status) {
  return status == MetricStatus::never_too_hot || status == MetricStatus::does_not_wear;
}

/// A metric's value in SI units; NaN unless status is ok.
struct MetricValue {
  double value{0};                        ///< in the unit of its row
  MetricStatus status{MetricStatus::ok};  ///< ok, or why there is no value
};

/// What a gradient can be used for.
enum class Smoothness : unsigned char {
  smooth,  ///< an ordinary derivative
  /// the derivative is exactly zero in amplitude, thickness and so on: the value lies on a plateau
  flat,
  one_sided,  ///< at a kink or jump: the derivative of the branch on which the value lies
  undefined   ///< no derivative; entries are NaN
};

/// "smooth", "flat", "one-sided" or "undefined"; static lifetime.
const char* to_string(Smoothness smoothness) noexcept;

}  // namespace twum::inline v0_1
