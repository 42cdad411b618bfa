// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/normal_contact.hpp>
#include <twum/core/operating_point.hpp>
#include <twum/core/workspace.hpp>

#include <memory>
#include <vector>

namespace twum::inline v0_1 {

namespace core {
template <typename S>
struct DrivenMotor;
template <typename S>
struct StatorModes;
class Drive;
class LazyDrive;
struct MotorPoint;
struct MotorParts;
}  // namespace core

/// A motor: its design and everything that follows from the design alone. Immutable, so any number of threads may use
/// one Motor.
///
/// Under a voltage the amplitude depends on the load. contact() and crest_speed(), which do not depend on speed for a
/// given amplitude, then belong to the wave at first_speed().
class Motor {
 public:
  /// Solves the normal contact (T3.1 to T3.4; W2.1 to W2.4). About a microsecond, 20 for 8 slices, and a
  /// millisecond for `auto`, which tries how many nodes are needed. Under a voltage the running wave is followed
  /// over speed when it is first needed, which takes some hundred operating points.
  /// @throws InputError with every complaint about the design.
  explicit Motor(const MotorDesign& design);
  /// Copies share what was computed. A move copies, so that a motor that was moved from stays a motor.
  /// @{
  Motor(const Motor&) = default;
  Motor& operator=(const Motor&) = default;
  ~Motor() = default;
  /// @}

  /// The design as it was given.
  const MotorDesign& design() const noexcept { return design_; }
  /// True if the designs are equal, and with them all that follows.
  bool operator==(const Motor& other) const { return design_ == other.design_; }
  /// Pressure between wave and rotor at the contact radius, the same at every speed (T3.1 to T3.4, W2.2).
  const NormalContact<double>& contact() const;

  /// The design's radial_slices; where it is kAutoSlices, -N with the number N of nodes a panel that `auto` chooses for it.
  /// `with(design, Parameter::radial_slices, motor.radial_slices())` fixes them while the design moves.
  int radial_slices() const;
  /// False if `auto` has given up the search for the number of slices that 1e-6 takes, and has taken as many as it may.
  bool slices_settled() const;
  /// Radii of the slices that touch, in rising order [m]; the contact radius alone if there is one slice. With `auto`, those where
  /// no zone appears along the track.
  std::vector<double> slice_radii() const;

  /// Smallest rotor speed of the curve: 0, or where the running wave of a motor under a voltage begins [rad/s].
  double first_speed() const;

  /// V0 / r, rotor speed that matches the crest velocity of the stator surface [rad/s].
  double crest_speed() const;
  /// v_w / r; rotor speeds must exceed its negative [rad/s].
  double wave_speed() const;
  /// mu_0 F_N r (T7.8), over an annulus (W3.6): torque at rest without drive; for one slice the bound of every torque [N m].
  double holding_torque() const;
  /// True if the whole contact sticks at rest, the motor being locked like a brake; theory section 10.
  bool locks_at_rest() const;

  /// Periodic state at a rotor speed [rad/s], by the closed forms of T4.1 to T4.5. With one slice and a given amplitude about
  /// a microsecond and no heap allocation. Some four times as long for 8 slices or under a voltage, 40 times for `auto`, 200
  /// times for both, with up to a hundred allocations (docs/benchmarks.md).
  /// Smooth in speed where zones neither appear nor vanish, C1 there if mu_0 = mu. Where the whole contact sticks at rest, the
  /// torque there is the limit of forward speeds, and at a speed of -0.0 that of backward ones.
  /// @throws InputError unless speed > -wave_speed() (and finite).
  OperatingPoint operating_point(double speed) const;
  /// The same in the memory of a workspace: without heap allocation once the workspace is large enough, but for the first call
  /// of a motor under a voltage, which follows its running wave; first_speed() does that, too.
  OperatingPoint operating_point(double speed, Workspace& workspace) const;

  /// The same for a wave with another amplitude and frequency than the design's. The layer's viscosity stays that of
  /// the design, even if it follows from a loss factor at the design's frequency.
  /// @throws InputError as above, and for an amplitude or a frequency outside its range.
  OperatingPoint operating_point(const OperatingConditions& at) const;
  /// The same in the memory of a workspace, as above.
  OperatingPoint operating_point(const OperatingConditions& at, Workspace& workspace) const;

  /// Stick and slip zones at the contact radius at a rotor speed [rad/s] from contact entry to exit; empty if the point has
  /// no answer. About a microsecond a slice.
  /// @throws InputError as operating_point().
  std::vector<Zone> zones(double speed) const;
  /// The same at another radius of the contact track, not necessarily that of a slice. With one slice the zones are
  /// the same at all radii.
  /// @param radius  [m]
  /// @throws InputError as operating_point(), and for a radius outside the track.
  std::vector<Zone> zones(double speed, double radius) const;

  /// Fields at the contact radius at a rotor speed [rad/s] at `samples` equally spaced phases over one wave (no
  /// samples are added at the borders of zones). Pressure is continuous; traction may jump at the borders.
  /// @param samples  at least 2
  /// @throws InputError as operating_point(), and for fewer samples.
  ContactFields fields(double speed, int samples) const;
  /// The same at another radius of the contact track, as zones().
  /// @param radius  [m]
  /// @throws InputError as above, and for a radius outside the track.
  ContactFields fields(double speed, int samples, double radius) const;

  /// The backward wave at a rotor speed [rad/s], all NaN where operating_point() has no answer. Some ten microseconds a slice.
  /// @throws InputError as operating_point().
  BackwardWave backward_wave(double speed) const;

  /// Every steady wave under the voltage at a rotor speed [rad/s], stable or not, smallest amplitude first (D2.4).
  /// Empty for a motor with a given amplitude.
  /// @throws InputError as operating_point().
  std::vector<WaveState> wave_states(double speed) const;

 private:
  friend struct core::MotorParts;
  const core::Drive* drive() const;
  const core::DrivenMotor<double>& model() const;
  core::MotorPoint solved(double speed) const;

  MotorDesign design_;
  // Immutable, shared by copies.
  std::shared_ptr<const core::StatorModes<double>> modes_;
  std::shared_ptr<const core::LazyDrive> drive_;            // of a motor under a voltage
  std::shared_ptr<const core::DrivenMotor<double>> model_;  // of any other
};

/// Operating points at the given speeds [rad/s], in their order. Each costs as much as Motor::operating_point().
/// @throws InputError as Motor::operating_point(), for the first speed that is out of range.
std::vector<OperatingPoint> torque_speed_curve(const Motor& motor,
                                               const std::vector<double>& speeds);

}  // namespace twum::inline v0_1
