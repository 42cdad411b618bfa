// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/drive/branch_node.hpp"
#include "performance/drive/wave_solutions.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace twum::performance {

/// A wave of the branch, and the state of the contact layer from which it was solved.
struct BranchWave {
  double amplitude, speed;
  WarmStart start;
};

/// End of a branch of solutions on one side.
struct BranchEnd {
  double speed;      ///< rotor speed; infinite where the search met none
  double amplitude;  ///< of the fold there
  bool pulls_out() const { return std::isfinite(speed); }
};

/// The running branch over the rotor speed: the wave that a running motor keeps as its load changes.
///
/// It is followed once over a fixed grid of speeds from rest to beyond no-load. Every search starts from this grid,
/// so that an answer does not depend on earlier calls. Where no running solution exists at rest it begins at the
/// lowest speed at which one does.
class RunningBranch {
 public:
  /// @param extrema  of H at rest
  RunningBranch(const DrivenWaves& waves, const std::vector<ForceExtremum>& extrema);

  bool exists() const { return !nodes_.empty(); }
  /// Where it was followed, by rising speed.
  const std::vector<BranchNode>& nodes() const { return nodes_; }
  const BranchEnd& lower() const { return lower_; }
  const BranchEnd& upper() const { return upper_; }
  /// Amplitude where the branch begins: at rest, or where it pulls out.
  double first_amplitude() const;

  /// The motor under the wave at a speed; without a value off the branch.
  std::optional<MotorPoint> at(double speed) const;
  /// True if a disturbance of the wave there dies away.
  bool steady(const MotorPoint& point, double speed) const;

 private:
  using Node = BranchNode;

  struct NodeSearch {
    std::optional<Node> node;
    long zones;  // followed
  };

  std::optional<DrivenWave> running_at_rest(const std::vector<ForceExtremum>& extrema) const;
  std::optional<Node> first_node(const std::vector<ForceExtremum>& extrema) const;
  NodeSearch node(double speed, double guess, const WarmStart* start,
                  const SolvedPoint* near = nullptr) const;

  MotorPoint solved(const BranchWave& wave) const;
  bool balances(const MotorPoint& point) const;
  std::optional<MotorPoint> proven(double speed, const BranchGuess& guess,
                                   const SolvedPoint& near) const;
  std::array<const Node*, 2> beside(const Node& a, const Node& b) const;
  std::optional<MotorPoint> between(const Node& a, const Node& b, double speed) const;
  std::optional<BranchWave> followed(double speed, const BranchGuess& guess,
                                     const SolvedPoint& near) const;
  std::optional<MotorPoint> polished(double speed, double guess, SolvedPoint at_guess,
                                     double force_slope) const;
  std::optional<MotorPoint> polished(const Node& node) const;
  NodeSearch stepped(const Node& from, double speed, const Node* before = nullptr) const;
  BranchEnd follow(double step, int steps);
  double fold_amplitude(double speed, double near) const;
  BranchEnd fold_beyond(const Node& last, double speed) const;
  std::optional<BranchWave> bracketed(double speed, double low, double high) const;
  std::optional<MotorPoint> beyond(const Node& last, const BranchEnd& end, double speed) const;

  const DrivenWaves& waves_;
  double step_{0};           // of the grid
  std::vector<Node> nodes_;  // by rising speed
  BranchEnd lower_{-std::numeric_limits<double>::infinity(), 0},
      upper_{std::numeric_limits<double>::infinity(), 0};
};

}  // namespace twum::performance
