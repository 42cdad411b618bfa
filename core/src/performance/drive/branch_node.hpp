// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/drive/driven_wave.hpp"

#include <array>

namespace twum::performance {

/// A wave of a branch over the rotor speed, from which its neighbours are found.
struct BranchNode {
  double speed, amplitude;
  double slope;         ///< dA / dOmega along the branch
  double force_slope;   ///< H_A
  bool grows;           ///< a disturbance of the wave does not die away
  SolvedPoint solved;   ///< under nearly this amplitude; its numbers are to first order in the rest
  WarmStart start;      ///< the layer's state at entry under this amplitude
  MovingStates states;  ///< how that moves
};

/// A node from a wave that almost balances its drive.
/// @param step  what Newton's method adds to the amplitude of `wave`
BranchNode branch_node(DrivenWaves::LevelSlopes wave, double step, bool grows);

/// They have as many slices, all with states that move.
bool same_slices(const BranchNode& a, const BranchNode& b);

/// Where the search for a wave of the branch begins.
struct BranchGuess {
  double amplitude, force_slope;
  WarmStart start;
  MovingStates states;  ///< empty where the nodes do not agree on the slices
  double left{1};       ///< share of the guess's error that a step of Newton's method may leave
};

/// Between two nodes, or as far beyond the second: Hermite's cubics for amplitude and state, whose slopes are known, and for all
/// else the polynomial through the two and the nodes beside them.
/// @param beside  the next nodes on both sides, if they have the same zones and slices; else null
BranchGuess guess_between(const BranchNode& a, const BranchNode& b, double speed,
                          const std::array<const BranchNode*, 2>& beside = {});

/// The start under an amplitude that is larger by `step`.
WarmStart moved(const WarmStart& start, const MovingStates& states, double step);

}  // namespace twum::performance
