// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/held_point.hpp>

namespace twum::inline v0_1::core {

/// T_p is held to this share where a search needs a wave beyond it.
inline constexpr double kNearlyAll = 1 - 1e-4;

/// What a drive is short of where it just holds a torque at a speed (Y4.1, Y4.2).
enum class DriveEnd : unsigned char {
  friction,  ///< the contact transmits no more
  voltage,  ///< the voltage, at the frequency that needs least of it or that of a drive that follows by voltage
  upper_flank,  ///< a drive that follows by voltage leaves the upper flank of the resonance: R = 0
  amplitude,    ///< the amplitude of a motor without a voltage
  frequency     ///< the range of the frequency
};

/// How much more than the least that would do a drive has (Y5.2), and which of its limits is the nearest.
struct DriveReserve {
  double share;  ///< 0 at the limit, negative beyond it; NaN where the layer's motion has no answer
  DriveEnd end;
  HeldPoint wave;  ///< at R = 0 for `voltage` by frequency, else that of held_point()
};

/// Lag of a held wave in the frame of R and I, a quarter of a turn at R = 0: that behind the voltage, less what a series branch turns
/// (D8.3) [rad].
double flank_lag(const MotorDesign& design, const HeldPoint& held);

class HeldLine;

/// The torques and speeds that a motor's drive holds.
class Envelope {
 public:
  explicit Envelope(const MotorDesign& design);

  double largest_torque() const { return largest_; }
  /// The torque, or the nearest one that a search may ask for: kNearlyAll of the largest.
  double with_wave(double torque) const;
  /// @param torque  below the largest
  DriveReserve reserve(double torque, double speed) const;

  struct Corner {
    HeldStatus status{HeldStatus::ok};
    double torque{0}, speed{0};
    DriveEnd end{DriveEnd::friction};
    HeldPoint wave{};  ///< as DriveReserve::wave; none for `friction`
  };
  /// The largest torque held at a speed.
  Corner at_speed(double speed) const;
  /// The largest speed at which a torque is held.
  Corner at_torque(double torque) const;

 private:
  HeldLine line(double speed) const;
  DriveReserve reserve(HeldLine& line, double torque) const;
  DriveReserve by_frequency(HeldLine& line, double torque) const;
  Corner corner(double torque, double speed) const;
  Corner out_of_reach(double torque, double speed) const;
  double highest_speed(double torque) const;

  const MotorDesign& design_;
  DriveControl control_;
  double largest_;
};

}  // namespace twum::inline v0_1::core
