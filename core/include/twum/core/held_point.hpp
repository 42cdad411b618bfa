// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/operating_point.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace twum::inline v0_1 {

/// Whether a drive can hold a torque at a speed.
enum class HeldStatus : unsigned char {
  ok,
  torque_out_of_reach,  ///< no amplitude carries the torque: it is beyond the plateau of full slip
  voltage_too_low,      ///< no frequency is enough, or more voltage is needed than there is
  amplitude_too_low,    ///< more amplitude is needed than there is
  outside_frequency_range,  ///< the drive does not reach the frequency
  unstable_amplitude,       ///< a disturbed wave does not return
  no_periodic_state,        ///< the layer's motion does not become periodic (typical: mu_0 > mu)
  not_converged
};

/// Short machine-readable word, such as "voltage-too-low"; "ok" for ok. Static lifetime.
const char* to_string(HeldStatus status) noexcept;

/// SI unit of HeldPoint::needed for a status; empty where no single number would do. Static lifetime.
std::string_view needed_unit(HeldStatus status) noexcept;

/// A torque held at a speed. Numbers are NaN where there is no such wave; where only the drive is too weak they are those of the
/// wave that would hold the torque.
struct HeldPoint {
  HeldStatus status{HeldStatus::ok};  ///< ok, or why the drive cannot hold it
  double amplitude{0};                ///< A of the wave [m]
  double frequency{0};                ///< of the drive [Hz]
  double voltage{0};                  ///< of a phase, rms [V]; NaN without modal data
  /// What would do: the largest torque [N m] for `torque_out_of_reach` (with mu_0 > mu that of full slip, which jumps may exceed by
  /// some per cent), the least voltage [V] for `voltage_too_low`, the amplitude [m]
  /// for `amplitude_too_low`, the frequency [Hz] for `outside_frequency_range`. Else NaN.
  double needed{0};
  /// True if the rotor would leave the speed under this torque at a fixed drive: only a controller of the speed holds it.
  bool by_control_only{false};
  int radial_slices{1};  ///< of the design, or -N with the number N that `auto` takes for this wave
  OperatingPoint point{};  ///< of the motor under this wave, where there is one
};

/// The wave of the smallest amplitude that carries a torque at a speed (Y2.1), and the drive that holds it (Y2.2, Y2.3).
///
/// The result is smooth in all values as long as the status is ok and no zone begins or ends.
/// @param torque  load torque [N m]
/// @param speed   of the rotor [rad/s], more than 0
/// @throws InputError if speed is not more than 0, if torque is not finite, or if modal data or, for `frequency`, a voltage are
///         missing
HeldPoint held_point(const MotorDesign& design, double torque, double speed, DriveControl control);
/// The same as the design's drive holds it: with its control, within its voltage or amplitude and its range of frequencies.
HeldPoint held_point(const MotorDesign& design, double torque, double speed);

/// The same for each of some torques at one speed, in their order and up to rounding. In rising order they take half the time, because
/// the search for each begins at the wave of the one before; not with `auto` slices or mu_0 > mu.
/// @param torques  load torques [N m]
/// @param speed    of the rotor [rad/s], more than 0
/// @throws InputError as held_point(), also for no torques
std::vector<HeldPoint> held_points(const MotorDesign& design, std::span<const double> torques,
                                   double speed);

/// The wave at the lowest voltage with which any frequency holds the torque at the speed: R = 0 (Y4.1). Its `voltage` is that
/// voltage, whatever the design's.
/// @throws InputError as held_point() for a drive that follows by frequency
HeldPoint least_voltage_point(const MotorDesign& design, double torque, double speed);

/// T_p, the torque of a contact that slips and drives all through: no drive holds more where mu_0 = mu [N m].
/// @throws InputError for an impossible motor
double largest_held_torque(const MotorDesign& design);

/// The motor with the wave of a held point in place of its drive: its amplitude, frequency and slices are given.
/// @throws InputError if they lie outside the ranges of a motor
MotorDesign with_held_wave(const MotorDesign& design, const HeldPoint& held);

}  // namespace twum::inline v0_1
