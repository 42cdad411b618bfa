// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "held/loaded_wave.hpp"

#include <twum/core/held_point.hpp>

#include <optional>

namespace twum::inline v0_1::core {

/// The waves among which the first that carries a load is sought, as the amplitude rises: those of one frequency, or those that a
/// force of the drive holds on its upper flank (Y2.3).
struct WavePath {
  double omega;  ///< of all of them, or where the search for that of the first begins [rad/s]
  std::optional<double> drive{};  ///< Theta u_0 on the flank; zero: R = 0 [N]

  bool operator==(const WavePath&) const = default;
  /// -R on the flank; zero where the voltage is too low for any frequency.
  double flank(const LoadedWave& w) const;
  /// What R of a wave is above that of the flank [N].
  double above_flank(const LoadedWave& w) const { return w.force.real + flank(w); }
  /// Its derivative along a direction of R and I.
  double slope_above_flank(const LoadedWave& w, const WaveBalance<double>& along) const;
  /// domega / dA
  double follows(const LoadedWave& w) const;
  /// dT / dA of a wave that is differentiated
  double slope(const LoadedWave& w) const {
    return drive ? w.torque_in_amplitude + w.torque_in_omega * follows(w) : w.torque_in_amplitude;
  }
};

/// The search for the first wave that carries a load.
class FirstWave {
 public:
  FirstWave(const LoadedWaves& waves, const WavePath& path) : waves_(waves), path_(path) {}

  const WavePath& path() const { return path_; }
  /// True if no smaller amplitude carries the load, too.
  /// @param lower  the first wave that carries another load, on the same flank or at any frequency; null if none is known
  bool is(const LoadedWave& wave, const LoadedWave* lower) const;

  /// Where the torque reaches the load.
  struct Reached {
    LoadedWave near;                      ///< from here Newton's method leads to the load
    std::optional<LoadedWave> low, high;  ///< waves that carry less and more, where they are known

    bool encloses(const LoadedWave& w) const {
      return !(low && w.amplitude < low->amplitude) && !(high && w.amplitude > high->amplitude);
    }
  };
  /// Nothing if no amplitude carries the load, or amplitudes without an answer were passed by: `missed` says which.
  struct Search {
    std::optional<Reached> found;
    HeldStatus missed{HeldStatus::torque_out_of_reach};
  };
  Search reached() const;
  /// The wave there that carries the load (Y2.1), with the slopes of one next to it; nothing where the torque jumps past it, or has no
  /// periodic state.
  std::optional<LoadedWave> solve(Reached ends) const;

 private:
  LoadedWave at(double amplitude, const LoadedWave* near = nullptr, double accuracy = 0) const;
  /// Accuracy of a wave that only leads to others: on a flank that spares solving for its frequency.
  double leading() const { return path_.drive ? kHeldRules.crude : 0; }
  LoadedWave on_flank(double amplitude, const LoadedWave* near, double accuracy) const;
  double likely_omega(const LoadedWave& near, double amplitude) const;
  double rise(const LoadedWave& w) const { return path_.slope(w) * w.amplitude; }
  bool has_peak(const LoadedWave& low, const LoadedWave& high) const;
  LoadedWave below_load(const LoadedWave* near = nullptr) const;
  bool is_even(const LoadedWave& low, const LoadedWave& high) const;
  bool stays_below(const LoadedWave& low, const LoadedWave& high) const;
  double next_step(const LoadedWave& from) const;
  std::optional<LoadedWave> peak_between(const LoadedWave& low, const LoadedWave& high) const;
  Reached between(LoadedWave low, LoadedWave high) const;
  double on_cubic(const LoadedWave& p, const LoadedWave& q) const;
  double towards_load(const LoadedWave& near, const LoadedWave* before, const Reached& ends) const;

  const LoadedWaves& waves_;
  const WavePath path_;
};

}  // namespace twum::inline v0_1::core
