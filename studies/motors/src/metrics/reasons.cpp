// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/reasons.hpp>

namespace twum::inline v0_1::motors {

std::span<const Reason> reasons() {
  static constexpr Reason kReasons[] = {
      {MetricStatus::undefined,
       "the metric has no meaning for this motor. Peaks need a stall torque, efficiencies an input "
       "power, and max_efficiency needs modal_damping. Voltages, currents and electrical powers "
       "need modal data. start_frequency and pull_out_frequency need a voltage and a drive above "
       "the resonance of the stator. In an expression: a division by zero, or sqrt or log of a "
       "negative number"},
      {MetricStatus::unreachable, "the motor cannot carry this load"},
      {MetricStatus::no_periodic_state,
       "the motion of the contact does not repeat from one wave to the next; common if static "
       "friction exceeds kinetic friction"},
      {MetricStatus::not_converged,
       "no steady state was found; common for a layer without damping"},
      {MetricStatus::resonance, "the layer has no damping and is driven at its own resonance"},
      {MetricStatus::unresolved,
       "the contact has more stick and slip zones than the solver can resolve"},
      {MetricStatus::inaccurate,
       "rounding errors are too large, because the parameters are far from those of any motor; "
       "change them"},
      {MetricStatus::out_of_range, "the rotor runs backward as fast as the wave or faster"},
      {MetricStatus::pulled_out,
       "the voltage cannot sustain a running wave at this speed; raise the voltage or the "
       "frequency"},
      {MetricStatus::no_running_branch,
       "the voltage cannot sustain a running wave at any speed; raise the voltage or the "
       "frequency"},
      {MetricStatus::no_dead_branch,
       "the motor starts by itself, so there is no wave that is too small to move the rotor; lower "
       "the voltage or the frequency"},
      {MetricStatus::unstable_amplitude,
       "the requested wave is unstable: a small disturbance of it grows"},
      {MetricStatus::backward_wave_unknown,
       "the backward wave is not computed for this contact. It is computed if the whole contact "
       "slips one way, and for layers with loss_factor 0, density 0 and equal friction "
       "coefficients"},
      {MetricStatus::does_not_pull_out,
       "the running wave exists at every speed down to rest, so there is no pull-out torque"},
      {MetricStatus::torque_out_of_reach,
       "no wave amplitude can carry this torque at this speed: it exceeds what friction can "
       "transmit"},
      {MetricStatus::voltage_too_low,
       "the drive cannot hold this torque at this speed with its voltage; raise the voltage"},
      {MetricStatus::amplitude_too_low,
       "this torque at this speed needs a larger amplitude than the motor's"},
      {MetricStatus::outside_frequency_range,
       "the frequency that holds this torque at this speed lies outside stator.frequency_range"},
      {MetricStatus::no_steady_temperature,
       "the motor warms until it no longer carries the load, so there is no steady temperature; "
       "lower the load, run it only part of the time, or let the drive track the resonance "
       "(frequency_ratio)"},
      {MetricStatus::thermally_unstable,
       "the temperatures do not become steady: with temperature the losses rise faster than the "
       "heat outflow; lower the voltage or the load, or let the drive track the resonance "
       "(frequency_ratio)"},
      {MetricStatus::temperature_out_of_range,
       "the temperature is so far from the reference that a parameter would lose 90 % of its value "
       "or leave its range; lower the voltage, or check the entries of thermal.drift"},
      {MetricStatus::too_hot_at_no_load,
       "a temperature limit is exceeded even without load; lower the voltage, or run the motor "
       "only part of the time; less torque does not help"},
      {MetricStatus::never_too_hot,
       "no temperature limit is reached, even if the motor runs continuously with this load"},
      {MetricStatus::does_not_wear,
       "nothing slips in the contact under this load, so nothing wears and the life is unlimited"},
      {MetricStatus::does_not_start,
       "from rest the rotor does not reach 90 % of its steady speed; raise the voltage, or start "
       "at "
       "a higher frequency"},
      {MetricStatus::does_not_stop,
       "with the drive off the load keeps the rotor turning and the rotor keeps the wave running, "
       "so friction never holds the rotor"},
      {MetricStatus::wear_localizes,
       "with wear.profile: free one radius takes over more than three times its share of the load; "
       "raise the load, or use wear.profile: even"}};
  return kReasons;
}

}  // namespace twum::inline v0_1::motors
