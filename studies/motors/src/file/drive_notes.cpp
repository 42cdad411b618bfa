// SPDX-License-Identifier: Apache-2.0
#include "file/drive_notes.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>

#include <numbers>

namespace twum::inline v0_1::motors {
namespace {

std::string drive_of(const MotorDesign& design) {
  return "at " + engineering(*design.stator.voltage, "V") + " and " +
         engineering(drive_frequency(design), "Hz");
}

// "more than 117.7 V (start_voltage) at this frequency", or the frequency at this voltage; thresholds without a value
// are left out.
std::string threshold(const Motor& motor, Metric voltage, Metric frequency, const char* side) {
  const auto said = [&](Metric metric, const char* unit, const char* held) {
    const MetricValue found = evaluate(motor, {metric});
    if (found.status != MetricStatus::ok || !(found.value > 0)) return std::string();
    return std::string(side) + engineering(found.value, unit) + " (" +
           std::string(info(metric).name) + ") at this " + held;
  };
  const std::string volts = said(voltage, "V", "frequency");
  const std::string hertz = said(frequency, "Hz", "voltage");
  return volts + (volts.empty() || hertz.empty() ? "" : ", or ") + hertz;
}

ModelNote note(const Motor& motor, const std::string& what, const std::string& remedy) {
  return {"drive", 0, drive_of(motor.design()) + " " + what + "; " + remedy};
}

}  // namespace

std::optional<ModelNote> drive_note(const Motor& motor) {
  const Stator& stator = motor.design().stator;
  if (!stator.voltage) return {};
  const double resonance = get(motor.design(), Parameter::resonance_frequency);
  // Behind an inductance the stator resonates elsewhere, and its lag is another one (D8.3).
  const Driver driver = motor.design().driver.value_or(Driver{});
  const bool ideal = driver.inductance == 0 && driver.resistance == 0;
  const auto clamped = [&](const char* where) {
    return note(motor, "there is one small wave, which the rotor clamps",
                std::string("drive it ") + where + " the resonance of its stator, " +
                    engineering(resonance, "Hz"));
  };
  if (ideal && drive_frequency(motor.design()) <= resonance) return clamped("above");
  const OperatingPoint at_rest = motor.operating_point(0);
  const PointStatus rest = at_rest.status;
  const auto start = [&](const char* side) {
    return threshold(motor, Metric::start_voltage, Metric::start_frequency, side);
  };
  if (rest == PointStatus::no_dead_branch)
    return note(motor, "the motor starts by itself and has no dead wave",
                "a dead wave takes " + start("less than "));
  if (stator.branch == Branch::dead) return {};
  if (rest == PointStatus::pulled_out || rest == PointStatus::no_running_branch) {
    return note(motor, "only the dead wave exists at rest, which the rotor clamps",
                "a running wave takes " + threshold(motor, Metric::hold_voltage,
                                                    Metric::pull_out_frequency, "at least "));
  }
  const MetricValue starts = evaluate(motor, {Metric::start_voltage});
  // An optimum with the limit `start_voltage <= voltage` may violate it by 1e-6 relative.
  constexpr double kMet = 1e-6;
  if (starts.status != MetricStatus::ok) return {};
  // The only wave, which lags by less than a quarter of a turn: driven below the resonance that the rotor gives it (D2.4).
  if (ideal && starts.value == 0 && rest == PointStatus::ok &&
      at_rest.phase_lag < 0.5 * std::numbers::pi)
    return clamped("farther above");
  if (*stator.voltage >= starts.value * (1 - kMet)) return {};
  const MetricValue holds = evaluate(motor, {Metric::hold_voltage});
  if (holds.status == MetricStatus::ok && *stator.voltage < holds.value * (1 - kMet))
    return note(motor, "the wave at rest is a small one, which the rotor clamps",
                "a running wave takes " + threshold(motor, Metric::hold_voltage,
                                                    Metric::pull_out_frequency, "at least "));
  constexpr double kNear = 1e-3;
  if (*stator.voltage >= starts.value * (1 - kNear))
    return note(motor, "the motor is less than 0.1 % below its start voltage",
                "raise the voltage or the frequency a little if it has to start by itself");
  return note(motor, "the motor runs but does not start by itself if the voltage rises slowly",
              "to start it takes " + start("more than "));
}

}  // namespace twum::inline v0_1::motors
