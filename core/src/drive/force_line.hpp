// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/wave_curve.hpp"

namespace twum::inline v0_1::core {

/// A wave that the drive holds at a speed: a root of H(A) = Theta u_0 (D2.4).
struct WaveSolution {
  SlopedWave sloped;
  Stability stability;
  bool past_maximum;  ///< H has a maximum at a smaller amplitude
  bool only_one;      ///< H has no extremum: each voltage holds one wave, running and dead alike
  std::optional<bool> named_running{};  ///< it is on a curve that has a name

  const DrivenWave& wave() const { return sloped.wave; }
  /// Behind the drive by more than a quarter of a turn, or beyond the maximum that a start has to pass.
  bool beyond_start() const { return past_maximum || wave().balance.real <= 0; }
  bool running() const {
    return stability.stable() && (named_running ? *named_running : beyond_start() || only_one);
  }
};

/// An extremum of H over the amplitude: with rising voltage the motor starts at a maximum, with falling
/// voltage it stops at a minimum.
struct ForceExtremum {
  double amplitude, force;  ///< [m], [N]
  bool maximum;
  double bend;  ///< how A H_A / H changes with ln A, negative at a maximum
  /// Amplitude beyond a kink, where a zone begins or ends and H_A jumps past zero; then `amplitude` is the one below it. 0 where
  /// H_A is zero, and at a jump of H, whose one side this is.
  double beyond_kink{0};
};

/// H over the amplitude at one speed, which is the curve of waves continued in voltage. Where H jumps (mu_0 > mu), both sides of
/// the jump are nodes.
class ForceLine {
 public:
  /// Which jumps of H (mu_0 > mu), and ends of amplitudes without a periodic state, are found as exactly as rounding allows: those
  /// that the drive may meet, or also those that may be extrema. The others stay between two samples.
  enum class Jumps : unsigned char { all, at_drive };
  /// Between two amplitudes.
  ForceLine(const DrivenWaves& waves, double speed, double low, double high,
            Jumps jumps = Jumps::all);
  /// Over all amplitudes at which the motor may have an extremum or a wave.
  ForceLine(const DrivenWaves& waves, double speed);

  /// The smallest amplitude first.
  Vector<ForceExtremum> extrema() const;
  /// Waves under the drive's force, the smallest first.
  Vector<CurveNode> held() const;
  std::optional<CurveNode> largest_held() const;
  /// The same at a speed without the smaller amplitudes. Needs mu_0 = mu.
  static std::optional<CurveNode> largest_held(const DrivenWaves& waves, double speed);
  Vector<WaveSolution> solutions() const;
  /// The smallest amplitude needs less than the drive's force.
  bool begins_below() const;
  /// No amplitude has a periodic state.
  bool empty() const { return nodes_.empty(); }
  long zones() const { return curve_.zones(); }

 private:
  // A sample beside amplitudes without a periodic state, and one of these.
  struct Edge {
    const CurveNode* sample;
    double edge;  // ln A
    double apart() const { return std::fabs(edge - sample->at.x); }
    double reach() const;
    bool may_hold(double drive) const;
    bool may_be_extremum(const Edge& beyond) const;
  };

  std::optional<CurveNode> held_after(std::size_t i) const;
  ForceLine(const DrivenWaves& waves, double speed, const PlaneRange& range);
  void follow(double low, double high, Jumps jumps);
  void follow_continuous(double low, double high);
  void follow_down_to_drive(double high);
  void take(Vector<CurveNode> samples);
  bool is_past_extrema(const CurveNode& n) const;
  Vector<CurveNode> halved_where_in_doubt(Vector<CurveNode> samples) const;
  void append(CurveNode next, Jumps jumps);
  bool turns_to(const CurveNode& next);
  bool may_hold_between(const CurveNode& a, const CurveNode& b) const;
  void push_jump(CurveNode next);
  void pass_gap(CurveNode next, double inside, Jumps jumps);
  void extend_below(double force);

  const DrivenWaves& waves_;
  double speed_;
  WaveCurve curve_;
  Vector<CurveNode> nodes_;
};

/// Upper bound of the amplitude of a wave (D2.7).
double largest_amplitude(const DrivenWaves& waves);

}  // namespace twum::inline v0_1::core
