// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/held_waves.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// A piece of a path on which the frequency is monotonic and all waves are stable, or none.
struct PathPiece {
  Vector<ResponseWave> waves;  ///< along the path, at least two
  bool stable;
  BranchEndKind first_end, last_end;

  double lowest() const { return std::fmin(waves.front().omega, waves.back().omega); }
  double highest() const { return std::fmax(waves.front().omega, waves.back().omega); }
  bool covers(double omega) const { return omega >= lowest() && omega <= highest(); }
};

/// All waves of a motor under one voltage over the drive frequency, for a given load of the rotor. The path is
/// parametrized by the amplitude: each amplitude has one frequency on either flank of the resonance (D5.1), so the
/// path has no folds in it.
class FrequencyPath {
 public:
  /// @param waves    at any frequency; has to outlive the path
  /// @param lowest   smallest frequency of interest [rad/s]
  /// @param highest  largest [rad/s]
  FrequencyPath(const DrivenWaves& waves, const RotorLoad& load, double lowest, double highest);

  const Vector<PathPiece>& pieces() const { return pieces_; }
  /// Largest amplitudes, where the flanks meet [rad/s].
  const Vector<double>& resonances() const { return resonances_; }
  /// The wave of a piece at a frequency that the piece covers; none where the contact has no answer there.
  std::optional<ResponseWave> at(const PathPiece& piece, double omega) const;

 private:
  struct Stretch {
    double low, high;  // amplitudes
    bool closed;       // the flanks meet at both
    double amplitude(double place) const;
  };
  struct Node {
    ResponseWave wave;
    BranchEndKind kind;  // kind of event there
  };

  std::optional<ResponseWave> wave_at(const Stretch& stretch, double place,
                                      const HeldWaves::Guess& guess) const;
  std::optional<ResponseWave> between(const Stretch& stretch, const ResponseWave& a,
                                      const ResponseWave& b, double place) const;
  std::optional<ResponseWave> at(const Stretch& stretch, const ResponseWave& a,
                                 const ResponseWave& b, double omega) const;
  ResponseWave surely_between(const Stretch& stretch, const ResponseWave& a, const ResponseWave& b,
                              double place) const;
  std::optional<ResponseWave> turn(const Stretch& stretch, const ResponseWave& a,
                                   const ResponseWave& b, const ResponseWave& c) const;
  ResponseWave last_stable(const Stretch& stretch, const ResponseWave& a,
                           const ResponseWave& b) const;

  double excess(const ResponseWave& on_backbone) const;
  Vector<Stretch> stretches() const;
  void with_islands(Vector<ResponseWave>& scan) const;
  Vector<Stretch> between_borders(const Vector<ResponseWave>& scan) const;
  void follow(std::size_t stretch);
  Vector<Node> with_turns(const Stretch& stretch, const Vector<ResponseWave>& run) const;
  void cut(const Vector<Node>& nodes, std::size_t stretch);

  HeldWaves held_;
  double lowest_, highest_;
  Vector<Stretch> stretches_;
  Vector<std::size_t> stretch_of_;  // of each piece
  Vector<PathPiece> pieces_;
  Vector<double> resonances_;
};

}  // namespace twum::inline v0_1::core
