// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metric_value.hpp>

namespace twum::inline v0_1 {

const char* to_string(MetricStatus status) noexcept {
  switch (status) {
    case MetricStatus::ok: return "ok";
    case MetricStatus::undefined: return "undefined";
    case MetricStatus::unreachable: return "unreachable";
    case MetricStatus::no_periodic_state: return "no-periodic-state";
    case MetricStatus::not_converged: return "not-converged";
    case MetricStatus::resonance: return "resonance";
    case MetricStatus::unresolved: return "unresolved";
    case MetricStatus::inaccurate: return "inaccurate";
    case MetricStatus::out_of_range: return "out-of-range";
    case MetricStatus::pulled_out: return "pulled-out";
    case MetricStatus::no_running_branch: return "no-running-branch";
    case MetricStatus::no_dead_branch: return "no-dead-branch";
    case MetricStatus::unstable_amplitude: return "unstable-amplitude";
    case MetricStatus::backward_wave_unknown: return "backward-wave-unknown";
    case MetricStatus::does_not_pull_out: return "does-not-pull-out";
    case MetricStatus::torque_out_of_reach: return "torque-out-of-reach";
    case MetricStatus::voltage_too_low: return "voltage-too-low";
    case MetricStatus::amplitude_too_low: return "amplitude-too-low";
    case MetricStatus::outside_frequency_range: return "outside-frequency-range";
    case MetricStatus::no_steady_temperature: return "no-steady-temperature";
    case MetricStatus::thermally_unstable: return "thermally-unstable";
    case MetricStatus::temperature_out_of_range: return "temperature-out-of-range";
    case MetricStatus::too_hot_at_no_load: return "too-hot-at-no-load";
    case MetricStatus::never_too_hot: return "never-too-hot";
    case MetricStatus::does_not_wear: return "does-not-wear";
    case MetricStatus::does_not_start: return "does-not-start";
    case MetricStatus::does_not_stop: return "does-not-stop";
    case MetricStatus::wear_localizes: return "wear-localizes";
  }
  return "unresolved";
}

const char* to_string(Smoothness smoothness) noexcept {
  switch (smoothness) {
    case Smoothness::smooth: return "smooth";
    case Smoothness::flat: return "flat";
    case Smoothness::one_sided: return "one-sided";
    case Smoothness::undefined: return "undefined";
  }
  return "undefined";
}

const char* to_string(Argument value) noexcept {
  switch (value) {
    case Argument::none: return "none";
    case Argument::speed: return "speed";
    case Argument::torque: return "torque";
    case Argument::both: return "both";
    case Argument::angle: return "angle";
    case Argument::periods: return "periods";
    case Argument::speed_or_torque: return "speed or torque";
    case Argument::either: return "speed or torque";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1
