// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <twum/core/frequency_response.hpp>

#include <functional>
#include <numbers>
#include <optional>

namespace twum::inline v0_1::core {

/// A wave that the drive holds at its own frequency.
struct ResponseWave {
  double place{0};       ///< along the path (D5.2)
  double omega{0};       ///< of the drive [rad/s]
  double amplitude{0};   ///< [m]
  double speed{0};       ///< of the rotor [rad/s]
  bool standing{false};  ///< friction holds the load, the rotor does not turn
  bool stable{false};
  double resistive_force{0};  ///< I (D2.3) [N]
  double torque_slope{0};     ///< of the torque over the speed ratio, 0 if not known [N m]
  WarmStart start;
  double margin{0};  ///< of its stability: positive where it is stable

  double frequency() const { return omega / (2 * std::numbers::pi); }
};

/// Thrown inside searches where the contact has no answer.
struct NoWave {};

/// Finds frequency and speed of a wave with a given amplitude, or amplitude and speed of a wave with a given
/// frequency, under the load of the rotor.
class HeldWaves {
 public:
  /// Where a search begins.
  struct Guess {
    double omega, speed_ratio;        ///< rotor speed over crest speed
    double torque_slope{0};           ///< as in ResponseWave
    bool standing{false};             ///< a wave nearby is
    const WarmStart* start{nullptr};  ///< of a wave nearby
  };

  /// @param waves  at any frequency; has to outlive this
  HeldWaves(const DrivenWaves& waves, const RotorLoad& load);

  /// The wave of an amplitude (D5.1).
  /// @param side  -1 for the lower flank, 1 for the upper, 0 for the resonance between them, for any drive force
  std::optional<ResponseWave> held(double amplitude, double side, const Guess& guess) const;
  /// The wave of a frequency, from one nearby.
  std::optional<ResponseWave> solve_to_rounding(ResponseWave near) const;
  /// Positive if the wave and the rotor return after a disturbance; continuous along a path.
  double margin(const ResponseWave& wave) const;
  Guess guess_of(const ResponseWave& wave) const;
  const DrivenWaves& waves() const { return waves_; }

 private:
  struct Carried {
    DrivenWave wave;
    bool standing;
  };

  std::optional<ResponseWave> solve_by_newton(double amplitude, double side,
                                              const Guess& guess) const;
  std::optional<ResponseWave> solve_by_secants(double amplitude, double side,
                                               const Guess& guess) const;
  double torque_slope(const DrivenWaves& waves, const DrivenWave& wave) const;
  bool stands(double amplitude, double torque_beyond_rest) const;

  std::optional<Carried> carried(const DrivenWaves& waves, double amplitude, double speed_ratio,
                                 double window) const;
  std::optional<Carried> at_torque(const DrivenWaves& waves, double amplitude, double speed_ratio,
                                   double window) const;

  const DrivenWaves& waves_;
  RotorLoad load_;
};

}  // namespace twum::inline v0_1::core
