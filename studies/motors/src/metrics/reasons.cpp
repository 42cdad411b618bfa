// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/metrics/reasons.hpp>

namespace twum::studies {

std::span<const Reason> reasons() {
  static constexpr Reason kReasons[] = {
      {MetricStatus::undefined,
       "no meaning for this motor: peaks need a stall torque, efficiencies an input, "
       "max_efficiency modal_damping; of an expression: a quotient by zero, or sqrt or log of a "
       "negative number"},
      {MetricStatus::unreachable, "the motor cannot carry this load"},
      {MetricStatus::no_periodic_state,
       "the contact never repeats itself from wave to wave, usual with static friction above the "
       "kinetic one"},
      {MetricStatus::not_converged, "no steady state was found, usual for a layer without damping"},
      {MetricStatus::resonance, "the layer has no damping and is driven at its own resonance"},
      {MetricStatus::unresolved, "more zones of stick and slip than can be followed"},
      {MetricStatus::inaccurate,
       "rounding spoils the answer, far from any motor; bring the parameters nearer to one"},
      {MetricStatus::out_of_range, "a speed at or below the negative one of the wave"},
      {MetricStatus::pulled_out,
       "the voltage keeps no running wave at the speed that is needed; raise the voltage or the "
       "frequency"},
      {MetricStatus::no_running_branch,
       "the voltage keeps no running wave at any speed; raise the voltage or the frequency"},
      {MetricStatus::no_dead_branch,
       "the motor starts by itself and has no dead wave; lower the voltage or the frequency"},
      {MetricStatus::unstable_amplitude,
       "the wave that is asked for is unstable: a small disturbance of it grows"},
      {MetricStatus::backward_wave_unknown,
       "the backward wave is known for contacts that slip all one way, and for layers without "
       "damping and inertia (loss_factor 0, density 0) with equal frictions"},
      {MetricStatus::does_not_pull_out, "the running wave exists down to rest"}};
  return kReasons;
}

}  // namespace twum::studies
