// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metrics.hpp>

namespace twum {
namespace {

using M = Metric;
using A = Argument;

constexpr bool kModes = true, kGeometry = true, kThermal = true, kAbsolute = true,
               kOperation = true, kWear = true, kMotion = true;

constexpr std::array<MetricInfo, kMetricCount> kMetricRows{{
    {M::stall_torque, "stall_torque", "N.m", A::none, "torque as the rotor begins to turn"},
    {M::max_torque, "max_torque", "N.m", A::none, "largest torque between rest and no-load speed"},
    {M::holding_torque, "holding_torque", "N.m", A::none,
     "torque held at rest without drive, mu_0 F_N r"},
    {M::no_load_speed, "no_load_speed", "rad/s", A::none,
     "smallest speed at which the torque falls through zero"},
    {M::plateau_speed, "plateau_speed", "rad/s", A::none,
     "largest speed up to which the whole contact slips and drives"},
    {M::peak_power, "peak_power", "W", A::none,
     "largest output power between rest and no-load speed"},
    {M::speed_at_peak_power, "speed_at_peak_power", "rad/s", A::none,
     "speed of the largest output power"},
    {M::torque_at_peak_power, "torque_at_peak_power", "N.m", A::none,
     "torque at the largest output power"},
    {M::contact_efficiency_at_peak_power, "contact_efficiency_at_peak_power", "1", A::none,
     "output over stator power at the largest output power"},
    {M::max_efficiency, "max_efficiency", "1", A::none,
     "largest efficiency, stator loss included; needs modal_damping > 0"},
    {M::speed_at_max_efficiency, "speed_at_max_efficiency", "rad/s", A::none,
     "speed of the largest efficiency; needs modal_damping > 0"},
    {M::contact_half_length, "contact_half_length", "m", A::none,
     "half length of one contact zone"},
    {M::contact_ratio, "contact_ratio", "1", A::none,
     "half length of the contact over the wavelength"},
    {M::max_pressure, "max_pressure", "Pa", A::none,
     "pressure at the crest of the wave, the largest over the track"},
    {M::layer_aspect, "layer_aspect", "1", A::none,
     "thickness of the layer over the length of one contact zone"},
    {M::pressure_nonuniformity, "pressure_nonuniformity", "1", A::none,
     "largest over mean pressure across the track, each averaged over a wave"},
    {M::radial_motion_ratio, "radial_motion_ratio", "1", A::none,
     "radial over tangential motion of the surface at the contact radius; computed with "
     "stator.radial_motion"},
    {M::max_overall_efficiency, "max_overall_efficiency", "1", A::none,
     "largest overall efficiency between rest and no-load speed", kModes},
    {M::speed_at_max_overall_efficiency, "speed_at_max_overall_efficiency", "rad/s", A::none,
     "speed of the largest overall efficiency", kModes},
    {M::pull_out_torque, "pull_out_torque", "N.m", A::none,
     "torque at the fold at which the running branch ends under load", kModes},
    {M::start_voltage, "start_voltage", "V", A::none,
     "voltage above which the motor starts by itself from rest, rms; 0 where there is one wave at "
     "every "
     "voltage",
     kModes},
    {M::hold_voltage, "hold_voltage", "V", A::none,
     "voltage below which the running wave ends at rest, rms; 0 where there is one wave at every "
     "voltage",
     kModes},
    {M::start_frequency, "start_frequency", "Hz", A::none,
     "frequency above which the motor starts by itself from rest", kModes},
    {M::pull_out_frequency, "pull_out_frequency", "Hz", A::none,
     "frequency below which the running wave ends at rest", kModes},
    {M::loaded_resonance, "loaded_resonance", "Hz", A::none,
     "resonance of the stator with the rotor on it, at the amplitude at no-load", kModes},
    {M::coupling_factor, "coupling_factor", "1", A::none,
     "effective coupling factor of a phase, sqrt(C_m / (C_0 + C_m))", kModes},
    {M::capacitance_ratio, "capacitance_ratio", "1", A::none,
     "motional over blocked capacitance of a phase", kModes},
    {M::mode_separation, "mode_separation", "Hz", A::none,
     "distance to the nearest other mode of n - 2 to n + 2 wavelengths", !kModes, kGeometry},
    {M::ceramic_stress, "ceramic_stress", "Pa", A::none,
     "largest bending stress of the ceramic at the amplitude at no-load", !kModes, kGeometry},
    {M::torque_at, "torque_at", "N.m", A::speed, "torque at a speed"},
    {M::speed_at, "speed_at", "rad/s", A::torque,
     "largest speed up to no-load at which the motor carries a torque"},
    {M::output_power_at, "output_power_at", "W", A::speed_or_torque,
     "output power at a speed or torque"},
    {M::stator_power_at, "stator_power_at", "W", A::speed_or_torque,
     "power from the stator to the layer"},
    {M::friction_power_at, "friction_power_at", "W", A::speed_or_torque,
     "friction power at a speed or torque"},
    {M::layer_loss_at, "layer_loss_at", "W", A::speed_or_torque,
     "viscous loss in the layer at a speed or torque"},
    {M::efficiency_at, "efficiency_at", "1", A::speed_or_torque,
     "output over stator power and stator loss"},
    {M::contact_efficiency_at, "contact_efficiency_at", "1", A::speed_or_torque,
     "output over stator power"},
    {M::wear_intensity_at, "wear_intensity_at", "W/m^2", A::speed_or_torque,
     "friction power per area of the contact track"},
    {M::stick_fraction_at, "stick_fraction_at", "1", A::speed_or_torque,
     "share of the contact length that sticks"},
    {M::amplitude_at, "amplitude_at", "m", A::speed_or_torque, "amplitude of the travelling wave"},
    {M::phase_lag_at, "phase_lag_at", "rad", A::speed_or_torque,
     "lag of the wave behind the voltage", kModes},
    {M::electrical_power_at, "electrical_power_at", "W", A::speed_or_torque,
     "power out of the inverter, both phases together", kModes},
    {M::overall_efficiency_at, "overall_efficiency_at", "1", A::speed_or_torque,
     "output over electrical power; 0 where the output is negative", kModes},
    {M::phase_current_at, "phase_current_at", "A", A::speed_or_torque, "current of a phase, rms",
     kModes},
    {M::power_factor_at, "power_factor_at", "1", A::speed_or_torque,
     "electrical over apparent power of both phases", kModes},
    {M::backward_ratio_at, "backward_ratio_at", "1", A::speed_or_torque,
     "amplitude of the backward wave of unequal phases and modes over that of the forward one",
     kModes},
    {M::squeal_rate_at, "squeal_rate_at", "1/s", A::speed_or_torque,
     "rate at which a free backward wave grows; the motor squeals where it is positive", kModes},
    {M::sensor_voltage_at, "sensor_voltage_at", "V", A::speed_or_torque,
     "voltage of the sensor electrode, rms; needs a sensor", kModes},
    {M::sensor_phase_at, "sensor_phase_at", "rad", A::speed_or_torque,
     "lag of the sensor's voltage behind that of the first phase; needs a sensor", kModes},
    {M::drive_frequency_at, "drive_frequency_at", "Hz", A::both,
     "frequency with which the drive holds a torque at a speed"},
    {M::drive_voltage_at, "drive_voltage_at", "V", A::both,
     "voltage of a phase with which the drive holds a torque at a speed, rms", kModes},
    {M::max_pressure_at, "max_pressure_at", "Pa", A::speed_or_torque,
     "pressure at the crest of the wave at a speed or torque, the largest over the track"},
    {M::layer_aspect_at, "layer_aspect_at", "1", A::speed_or_torque,
     "thickness of the layer over the length of one contact zone at a speed or torque"},
    {M::ceramic_stress_at, "ceramic_stress_at", "Pa", A::speed_or_torque,
     "largest bending stress of the ceramic at a speed or torque", !kModes, kGeometry},
    {M::held_speed_limit_at, "held_speed_limit_at", "rad/s", A::torque,
     "largest speed at which the drive, which follows, holds a torque"},
    {M::held_torque_limit_at, "held_torque_limit_at", "N.m", A::speed,
     "largest torque that the drive, which follows, holds at a speed"},
    {M::pull_out_margin_at, "pull_out_margin_at", "N.m", A::both,
     "largest torque that the drive, which follows, holds at a speed, minus a torque"},
    {M::torque_reserve_at, "torque_reserve_at", "1", A::both,
     "1 - torque / mu F_N r: the share of the transmitted torque that is left"},
    {M::drive_reserve_at, "drive_reserve_at", "1", A::both,
     "voltage or amplitude of the drive, which follows, over the least that holds a torque at a "
     "speed, minus 1"},
    {M::voltage_reserve_at, "voltage_reserve_at", "1", A::either,
     "voltage over the least with which the motor, at its frequency, carries a torque or runs at a "
     "speed, minus 1; at a speed with mu_0 = mu only",
     kModes},
    {M::stator_loss_at, "stator_loss_at", "W", A::speed_or_torque, "loss in the stator"},
    {M::dielectric_loss_at, "dielectric_loss_at", "W", A::speed_or_torque,
     "loss in the blocked capacitances of both phases", kModes},
    {M::stator_temperature_at, "stator_temperature_at", "K", A::speed_or_torque,
     "steady temperature of the stator", !kModes, !kGeometry, kThermal, kAbsolute},
    {M::rotor_temperature_at, "rotor_temperature_at", "K", A::speed_or_torque,
     "steady temperature of the rotor", !kModes, !kGeometry, kThermal, kAbsolute},
    {M::housing_temperature_at, "housing_temperature_at", "K", A::speed_or_torque,
     "steady temperature of the housing", !kModes, !kGeometry, kThermal, kAbsolute},
    {M::contact_temperature_at, "contact_temperature_at", "K", A::speed_or_torque,
     "steady temperature where lining and stator slide", !kModes, !kGeometry, kThermal, kAbsolute},
    {M::temperature_margin_at, "temperature_margin_at", "K", A::speed_or_torque,
     "smallest distance of a steady temperature below its limit", !kModes, !kGeometry, kThermal},
    {M::thermal_gain_at, "thermal_gain_at", "1", A::speed_or_torque,
     "rise that a rise of 1 K causes by more losses; unstable from 1 on", !kModes, !kGeometry,
     kThermal},
    {M::thermal_time_constant, "thermal_time_constant", "s", A::none,
     "slowest time constant of the warm-up under constant losses", !kModes, !kGeometry, kThermal},
    {M::continuous_torque, "continuous_torque", "N.m", A::none,
     "largest torque up to which the motor runs for ever within its limits of temperature", !kModes,
     !kGeometry, kThermal},
    {M::continuous_torque_at, "continuous_torque_at", "N.m", A::speed,
     "largest torque held at a speed for ever within the limits of temperature", !kModes,
     !kGeometry, kThermal},
    {M::start_temperature, "start_temperature", "K", A::none,
     "lowest temperature of the whole motor at which it starts by itself", kModes, !kGeometry,
     kThermal, kAbsolute},
    {M::on_time_at, "on_time_at", "s", A::speed_or_torque,
     "time from cold until a limit of temperature is reached", !kModes, !kGeometry, kThermal},
    {M::duty_limit_at, "duty_limit_at", "1", A::speed_or_torque,
     "largest share of the operation's period for which the motor may run", !kModes, !kGeometry,
     kThermal, !kAbsolute, kOperation},
    {M::stator_peak_temperature, "stator_peak_temperature", "K", A::none,
     "highest temperature of the stator in the operation", !kModes, !kGeometry, kThermal, kAbsolute,
     kOperation},
    {M::rotor_peak_temperature, "rotor_peak_temperature", "K", A::none,
     "highest temperature of the rotor in the operation", !kModes, !kGeometry, kThermal, kAbsolute,
     kOperation},
    {M::housing_peak_temperature, "housing_peak_temperature", "K", A::none,
     "highest temperature of the housing in the operation", !kModes, !kGeometry, kThermal,
     kAbsolute, kOperation},
    {M::contact_peak_temperature, "contact_peak_temperature", "K", A::none,
     "highest temperature where lining and stator slide, in the operation", !kModes, !kGeometry,
     kThermal, kAbsolute, kOperation},
    {M::wear_rate_at, "wear_rate_at", "m/s", A::speed_or_torque, "how fast the new track wears",
     !kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, kWear},
    {M::life_at, "life_at", "s", A::speed_or_torque, "time until the worn motor breaks a limit",
     !kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, kWear},
    {M::life_revolutions_at, "life_revolutions_at", "1", A::speed_or_torque,
     "revolutions until the worn motor breaks a limit", !kModes, !kGeometry, !kThermal, !kAbsolute,
     !kOperation, kWear},
    {M::life, "life", "s", A::none, "time until the worn motor breaks a limit, in its operation",
     !kModes, !kGeometry, !kThermal, !kAbsolute, kOperation, kWear},
    {M::life_revolutions, "life_revolutions", "1", A::none,
     "revolutions until the worn motor breaks a limit, in its operation", !kModes, !kGeometry,
     !kThermal, !kAbsolute, kOperation, kWear},
    {M::settling_rate_at, "settling_rate_at", "1/s", A::torque,
     "rate at which the motor returns to its speed under a torque after a small disturbance",
     kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::bounce_rate_at, "bounce_rate_at", "1/s", A::torque,
     "growth rate of hops of the rotor under a torque; it hops where this is positive; needs "
     "rotor_mass",
     kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::speed_per_frequency_at, "speed_per_frequency_at", "rad/s/Hz", A::torque,
     "change of the steady speed with the drive frequency under a torque", kModes, !kGeometry,
     !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::speed_per_voltage_at, "speed_per_voltage_at", "rad/s/V", A::torque,
     "change of the steady speed with the drive voltage under a torque", kModes, !kGeometry,
     !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::start_time_at, "start_time_at", "s", A::torque,
     "time from rest to 90 % of the steady speed under a torque", !kModes, !kGeometry, !kThermal,
     !kAbsolute, !kOperation, !kWear, kMotion},
    {M::start_overshoot_at, "start_overshoot_at", "1", A::torque,
     "largest speed of a start under a torque over the steady one, minus 1", !kModes, !kGeometry,
     !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::stop_time_at, "stop_time_at", "s", A::torque,
     "time under a torque from the end of the drive until friction holds the rotor", kModes,
     !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::stop_angle_at, "stop_angle_at", "rad", A::torque,
     "angle under a torque from the end of the drive until friction holds the rotor", kModes,
     !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::move_energy, "move_energy", "J", A::angle,
     "electrical energy of a start, a run and a stop over an angle without load", kModes,
     !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::burst_angle, "burst_angle", "rad", A::periods,
     "angle by which the rotor turns, from rest until friction holds it, if the drive is on for a "
     "number of periods",
     kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::dynamic_start_voltage, "dynamic_start_voltage", "V", A::none,
     "smallest voltage that starts the motor from rest without load if it is switched on at once, "
     "rms",
     kModes, !kGeometry, !kThermal, !kAbsolute, !kOperation, !kWear, kMotion},
    {M::stator_mass, "stator_mass", "kg", A::none,
     "mass of the stator's metal, glue and ceramic, clamp excluded", !kModes, kGeometry},
    {M::free_amplitude, "free_amplitude", "m", A::none,
     "amplitude of the wave of the stator without rotor, at the motor's voltage and frequency",
     kModes},
    {M::apparent_power_at, "apparent_power_at", "V.A", A::speed_or_torque,
     "voltage times current, both phases together", kModes},
    {M::matching_inductance_at, "matching_inductance_at", "H", A::speed_or_torque,
     "inductance that, in parallel with a phase, takes its reactive current; undefined where this "
     "current is not capacitive",
     kModes},
    {M::driver_loss_at, "driver_loss_at", "W", A::speed_or_torque,
     "loss in driver_resistance, both phases together", kModes},
    {M::terminal_voltage_at, "terminal_voltage_at", "V", A::speed_or_torque,
     "voltage across a phase, behind driver_inductance and driver_resistance, rms", kModes},
}};

// A page has the texts besides (metrics_json()), and its core does without them.
constexpr auto kMetricTable = [] {
  std::array<MetricInfo, kMetricCount> table = kMetricRows;
#ifdef TWUM_WITHOUT_TEXTS
  for (MetricInfo& row : table) row.text = {};
#endif
  return table;
}();

constexpr bool every_metric_in_its_place() {
  for (std::size_t i = 0; i < kMetricCount; ++i)
    if (static_cast<std::size_t>(kMetricTable[i].metric) != i || kMetricTable[i].name.empty())
      return false;
  return true;
}
static_assert(every_metric_in_its_place(), "a metric has no row of its own, or not in its place");

}  // namespace

std::span<const MetricInfo> metric_table() { return kMetricTable; }

const MetricInfo& info(Metric metric) { return kMetricTable[static_cast<std::size_t>(metric)]; }

std::optional<Metric> find_metric(std::string_view name) {
  for (const MetricInfo& row : kMetricTable) {
    if (row.name == name) return row.metric;
  }
  return {};
}

}  // namespace twum
