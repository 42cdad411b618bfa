// SPDX-License-Identifier: Apache-2.0
#include <twum/core/held_point.hpp>

#include "held/holding.hpp"
#include "point/slice_count.hpp"

#include <twum/core/parameters.hpp>

#include <array>

namespace twum::inline v0_1 {

using namespace core;

const char* to_string(HeldStatus status) noexcept {
  switch (status) {
    case HeldStatus::ok: return "ok";
    case HeldStatus::torque_out_of_reach: return "torque-out-of-reach";
    case HeldStatus::voltage_too_low: return "voltage-too-low";
    case HeldStatus::amplitude_too_low: return "amplitude-too-low";
    case HeldStatus::outside_frequency_range: return "outside-frequency-range";
    case HeldStatus::unstable_amplitude: return "unstable-amplitude";
    case HeldStatus::no_periodic_state: return "no-periodic-state";
    case HeldStatus::not_converged: return "not-converged";
  }
  return "not-converged";
}

std::string_view needed_unit(HeldStatus status) noexcept {
  switch (status) {
    case HeldStatus::torque_out_of_reach: return "N.m";
    case HeldStatus::voltage_too_low: return "V";
    case HeldStatus::amplitude_too_low: return "m";
    case HeldStatus::outside_frequency_range: return "Hz";
    default: return "";
  }
}

namespace {

// What is held within the drive's voltage or amplitude and its range of frequencies.
HeldPoint within_drive(const Stator& stator, HeldPoint held) {
  if (held.status != HeldStatus::ok) return held;
  const auto refused = [&](HeldStatus status, double needed) {
    held.status = status, held.needed = needed;
  };
  switch (control_of(stator)) {
    case DriveControl::amplitude:
      if (held.amplitude > stator.amplitude) refused(HeldStatus::amplitude_too_low, held.amplitude);
      break;
    case DriveControl::voltage:
      if (held.voltage > *stator.voltage) refused(HeldStatus::voltage_too_low, held.voltage);
      break;
    case DriveControl::frequency:
      if (const auto& range = stator.frequency_range;
          range && !(held.frequency >= range->first && held.frequency <= range->second))
        refused(HeldStatus::outside_frequency_range, held.frequency);
      break;
  }
  return held;
}

}  // namespace

HeldPoint held_point(const MotorDesign& design, double torque, double speed, DriveControl control) {
  return HeldLine(design, speed, control).held(torque);
}

HeldPoint held_point(const MotorDesign& design, double torque, double speed) {
  return within_drive(design.stator, held_point(design, torque, speed, control_of(design.stator)));
}

std::vector<HeldPoint> held_points(const MotorDesign& design, std::span<const double> torques,
                                   double speed) {
  HeldLine line(design, speed, control_of(design.stator));
  std::vector<HeldPoint> points;
  points.reserve(torques.size());
  for (const double torque : torques)
    points.push_back(within_drive(design.stator, line.held(torque)));
  return points;
}

HeldPoint least_voltage_point(const MotorDesign& design, double torque, double speed) {
  return HeldLine(design, speed, DriveControl::frequency)
      .held(torque, Holding::Sought::least_voltage);
}

double largest_held_torque(const MotorDesign& design) {
  require_motor(design);
  return LoadedWaves({design, track_rule(without_drive(design))}, 0).plateau();
}

MotorDesign with_held_wave(const MotorDesign& design, const HeldPoint& held) {
  return with(design, std::array<ParameterValue, 3>{
                          {{Parameter::amplitude, held.amplitude},
                           {Parameter::frequency, held.frequency},
                           {Parameter::radial_slices, static_cast<double>(held.radial_slices)}}});
}

}  // namespace twum::inline v0_1
