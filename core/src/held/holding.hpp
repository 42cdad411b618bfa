// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "held/first_wave.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/held_point.hpp>

#include <optional>

namespace twum::inline v0_1::core {

/// How a motor's drive follows.
inline DriveControl control_of(const Stator& stator) {
  return stator.voltage ? stator.control : DriveControl::amplitude;
}

inline HeldPoint without_wave(HeldStatus status, double needed = kNoValue) {
  return {status, kNoValue, kNoValue, kNoValue, needed, false, 1, {}};
}

/// A motor at a speed whose drive follows, with a track that is the same under all torques. They are held one after the other: the
/// search for each begins at the wave of the one before.
class Holding {
 public:
  /// The wave of the drive's voltage (Y2.3), or that with R = 0.
  enum class Sought : bool { drive, least_voltage };

  Holding(const MotorDesign& design, const TrackRule& track, double speed, DriveControl control);
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;

  HeldPoint held(double torque, Sought sought = Sought::drive);

 private:
  struct LikelyWave {
    double amplitude, omega;
  };
  /// A step of Newton's method for (Y2.1) together with (Y2.3).
  struct Step {
    double amplitude, omega;
    double size;  ///< the larger of both, of themselves
  };

  struct Scan {
    std::optional<LoadedWave> wave;
    HeldStatus missed;  ///< why there is none
  };

  bool follows_by_frequency() const { return control_ == DriveControl::frequency; }
  FirstWave first(Sought sought) const;
  std::optional<LoadedWave> straight(const FirstWave& first) const;
  std::optional<LoadedWave> from_likely(const FirstWave& first) const;
  std::optional<LoadedWave> from(LoadedWave wave, const FirstWave& first) const;
  std::optional<LoadedWave> near_least_voltage(std::optional<LoadedWave> least,
                                               const FirstWave& wanted) const;
  bool is_first_of_frequency(const LoadedWave& wave, const LoadedWave* lower) const;
  Scan scanned(const FirstWave& first) const;
  LikelyWave likely_wave(const WavePath& path) const;
  double likely_omega(const LikelyWave& wave, const WavePath& path) const;
  Step newton_step(const LoadedWave& w, const WavePath& path) const;
  LoadedWave stepped(const LoadedWave& w, const Step& step, double share) const;
  std::optional<LoadedWave> by_newton(LoadedWave w, const WavePath& path) const;
  HeldPoint drive_of(const LoadedWave& w, Sought sought) const;
  bool is_on_own_side(double omega) const;
  HeldPoint held_point_of(const LoadedWave& w) const;

  DrivenWaves waves_;
  const StatorModes<double>* modes_;  // of waves_; null without modal data
  LoadedWaves loaded_;
  double speed_;
  DriveControl control_;
  std::optional<LoadedWave> last_;  // the first wave that carries the torque before
  WavePath last_path_{0};           // among those of which it is that
};

/// The same for a design, whose number of slices may follow from the wave.
class HeldLine {
 public:
  /// @throws InputError as held_point()
  HeldLine(const MotorDesign& design, double speed, DriveControl control);

  HeldPoint held(double torque, Holding::Sought sought = Holding::Sought::drive);

 private:
  TrackRule track_of(double torque) const;

  const MotorDesign& design_;
  double speed_;
  DriveControl control_;
  std::optional<Holding> holding_;  // none where each torque has a track of its own
};

}  // namespace twum::inline v0_1::core
