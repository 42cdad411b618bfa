// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/curve_node.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// The plane in which the waves of a motor under a voltage are curves: the amplitude, and what is continued beside it. The curve is
/// where ln H - ln(Theta u_0) vanishes; its derivatives along x and y are exact.
class ForcePlane {
 public:
  /// Speed at the drive's frequency and voltage.
  /// @param waves  has to outlive the plane
  /// @param unit   speed of y = 1, such as a crest speed [rad/s]
  static ForcePlane of_speed(const DrivenWaves& waves, double unit) {
    return {waves, Continued::speed, 0, unit};
  }
  /// Frequency above the free stator's resonance, whose logarithm is y, at a speed.
  static ForcePlane of_frequency(const DrivenWaves& waves, double speed) {
    return {waves, Continued::frequency, speed, 1};
  }
  /// Voltage as the force that it exerts, whose logarithm is y, at a speed. An amplitude has one voltage.
  static ForcePlane of_voltage(const DrivenWaves& waves, double speed) {
    return {waves, Continued::voltage, speed, 1};
  }

  /// What a wave lacks, and how that changes.
  struct Value {
    DrivenWaves::LevelSlopes wave;
    double excess, in_x, in_y;  ///< of ln H - ln(Theta u_0)
    bool ok() const { return wave.in_amplitude.wave.status == PointStatus::ok; }
    const WarmStart& start() const { return wave.in_amplitude.wave.start; }
    long zones() const { return wave.in_amplitude.wave.zones; }
  };
  Value at(PlanePoint p, const WarmStart* guess, double accuracy,
           const SolvedPoint* near = nullptr) const;
  /// A node where Newton's method leads from a value, by steps so small that its square is lost.
  CurveNode node(Value value, PlanePoint p, PlanePoint step) const;

  Continued continued() const { return continued_; }
  double parameter(double y) const;
  double coordinate(double parameter) const;
  double speed(double y) const { return continued_ == Continued::speed ? parameter(y) : speed_; }
  /// How the parameter moves with y.
  double rate(double y) const;
  const DrivenWaves& waves() const { return waves_; }

 private:
  ForcePlane(const DrivenWaves& waves, Continued continued, double speed, double unit)
      : waves_(waves), continued_(continued), speed_(speed), unit_(unit) {}

  const DrivenWaves& waves_;
  Continued continued_;
  double speed_, unit_;
};

}  // namespace twum::inline v0_1::core
