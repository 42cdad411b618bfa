// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/branch_piece.hpp"
#include "drive/force_line.hpp"

#include <array>
#include <optional>
#include <utility>

namespace twum::inline v0_1::core {

/// The waves of a motor over the rotor speed, as curves that are followed once. Every answer starts from their nodes, so that it does
/// not depend on earlier ones.
///
/// The running branch is the largest running wave at each speed: that of a motor whose load changes slowly. It may have more than
/// one piece: where one ends at a fold, the motor falls to the next one below or pulls out.
class RunningBranch {
 public:
  /// @param at_rest    H at rest
  /// @param largest    wave there, null if there is none
  /// @param with_dead  the dead branch is followed too
  RunningBranch(const DrivenWaves& waves, const ForceLine& at_rest, const CurveNode* largest,
                bool with_dead);

  bool exists() const { return !nodes_.empty(); }
  /// Waves of the running branch, by rising speed.
  const Vector<const CurveNode*>& nodes() const { return nodes_; }
  /// Where it begins: at rest, or where it pulls out.
  const CurveNode& first() const { return *nodes_.front(); }
  /// Where the curve ends and the motor pulls out; null if it goes on to rest.
  const CurveNode* pull_out() const;

  /// The motor under the wave of the running or the dead branch at a speed; its status says why there is none.
  MotorPoint at(double speed, bool running) const;
  /// True if a wave is one of the running branch or of another running one, false if not; nothing where no curve was followed.
  std::optional<bool> runs(double speed, double amplitude) const;

 private:
  MotorPoint without_wave(PointStatus status) const;
  WaveCurve curve(double lowest, double highest, double longest = kRules.speed.longest) const;
  bool ends_in_gap() const;
  const BranchPiece* fastest_piece(bool running) const;
  void search();
  ForceLine line(double speed) const;
  ForceLine near(double amplitude, double speed) const;
  void search_island(double near, double step, ForceExtremum hold);
  void trace_waves_of(const ForceLine& line, double speed);
  void trace(const CurveNode& wave, double speed);
  void continue_past_jump(const CurveNode& from, bool upward, bool running);
  void add_pieces(Vector<CurveNode> nodes, std::optional<bool> running);
  bool known(double speed, double amplitude) const;
  bool passes(const BranchPiece& piece, double speed, double amplitude) const;
  bool runs(const Vector<CurveNode>& nodes) const;
  void list_nodes();

  /// Two neighbouring nodes of a piece; null where there is none.
  struct Neighbours {
    const BranchPiece* piece{nullptr};
    const CurveNode *a{nullptr}, *b{nullptr};
    bool grows() const { return !piece || a->grows || b->grows; }
  };
  Neighbours about(double speed, bool running) const;
  std::optional<MotorPoint> between(const Neighbours& nodes, double speed) const;
  std::optional<MotorPoint> outside(double speed, bool running) const;
  std::optional<MotorPoint> solve_in_known_zones(double speed, const CurveGuess& guess,
                                                 const SolvedPoint& near) const;
  std::optional<MotorPoint> continue_past_end(const CurveNode& last, double speed) const;
  std::optional<MotorPoint> in_gap(double speed, bool running) const;
  MotorPoint beside_gap(double speed, double amplitude) const;
  std::optional<MotorPoint> solved(const CurveNode& wave, double speed,
                                   const SolvedPoint& near) const;
  bool steady(const MotorPoint& point, double speed) const;

  const DrivenWaves& waves_;
  double unit_{0}, fastest_{0};  // speed of y = 1, and up to which the curves are followed
  Vector<ForceExtremum> at_rest_;
  Vector<BranchPiece> pieces_;
  int curves_{0};
  Vector<const CurveNode*> nodes_;
};

}  // namespace twum::inline v0_1::core
