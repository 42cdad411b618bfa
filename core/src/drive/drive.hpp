// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/running_branch.hpp"

#include <twum/core/operating_point.hpp>

#include <memory>
#include <optional>

namespace twum::inline v0_1::core {

/// The waves of a motor that stands still, under every voltage. Immutable.
class WavesAtRest {
 public:
  explicit WavesAtRest(DrivenWaves waves);
  WavesAtRest(const WavesAtRest&) = delete;
  WavesAtRest& operator=(const WavesAtRest&) = delete;

  const DrivenWaves& waves() const { return waves_; }
  /// H over the amplitude.
  const ForceLine& line() const { return line_; }
  /// Extrema of H.
  const Vector<ForceExtremum>& extrema() const { return extrema_; }
  /// The largest wave under the design's voltage, null if there is none.
  const CurveNode* largest() const { return largest_ ? &*largest_ : nullptr; }

 private:
  DrivenWaves waves_;
  ForceLine line_;
  Vector<ForceExtremum> extrema_;
  std::optional<CurveNode> largest_;
};

/// A motor whose wave follows from voltage and load. Immutable.
class Drive {
 public:
  /// @param design  an admissible design with a voltage
  explicit Drive(const MotorDesign& design)
      : Drive(design, std::make_shared<const WavesAtRest>(waves_of(design))) {}
  /// @param at_rest  of the design
  Drive(const MotorDesign& design, std::shared_ptr<const WavesAtRest> at_rest);
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// The waves of a design, with the number of slices that `auto` finds.
  static DrivenWaves waves_of(const MotorDesign& design);

  /// The point on the branch that the design asks for; its status says why there is none.
  MotorPoint at(double speed) const;
  /// Every wave that the voltage holds at a speed, stable or not, the smallest first.
  Vector<WaveSolution> solutions(double speed) const;

  /// The curve is the running branch.
  bool runs() const { return asked_ == Branch::running; }
  /// Smallest speed of the curve [rad/s]; 0 is rest.
  double begin() const;
  /// The motor under the wave at the beginning of the curve, or under the largest wave at rest if there is no curve.
  DrivenMotor<double> first_motor() const;

  const DrivenWaves& waves() const { return at_rest_->waves(); }
  const RunningBranch& branch() const { return branch_; }

 private:
  Branch asked_;
  std::shared_ptr<const WavesAtRest> at_rest_;
  RunningBranch branch_;
};

}  // namespace twum::inline v0_1::core
