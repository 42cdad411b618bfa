// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/force_line.hpp"

#include <twum/core/metric_value.hpp>

#include <optional>

namespace twum::inline v0_1::core {

/// A voltage or a frequency at which the number of waves at rest changes, and the wave that appears or vanishes
/// there.
struct Threshold {
  double value;           ///< [V] rms, or [Hz]
  double amplitude;       ///< amplitude at the fold [m]; 0 if there is no fold at any voltage
  double frequency;       ///< [Hz]
  double beyond_kink{0};  ///< as of ForceExtremum
};

/// Where a motor at rest starts by itself and where it stops running (D3.2 to D3.4): folds of the waves at rest, continued in voltage and in
/// frequency. Each is found once.
class Thresholds {
 public:
  /// @param design   with modal data
  /// @param track    of its motor
  /// @param extrema  of H at rest, if they are known
  /// @param at_rest  the largest wave at rest under the design's voltage, null if there is none
  Thresholds(const MotorDesign& design, const TrackRule& track,
             std::optional<Vector<ForceExtremum>> extrema, const CurveNode* at_rest);

  /// @param metric  start_voltage, hold_voltage, start_frequency or pull_out_frequency
  /// @throws SearchFailure `undefined` for a frequency if no voltage is given or no frequency starts or ends the
  ///         running wave at this voltage
  const Threshold& at(Metric metric);

  /// The motor's waves at another frequency of the drive; the layer's viscosity follows it where it is that of a loss factor.
  DrivenWaves waves_at(double frequency) const;

 private:
  Threshold voltage(bool start);
  Threshold frequency(bool start);
  std::optional<CurveNode> continued(const ForceExtremum& from) const;
  void follow_frequency();
  void take_folds(const Vector<CurveNode>& nodes);
  std::optional<Threshold> jumping_frequency(bool start);
  const Vector<ForceExtremum>& extrema();

  DrivenWaves waves_;  // at the design's own frequency
  bool given_voltage_;
  double frequency_;                              // of the design
  std::optional<Vector<ForceExtremum>> extrema_;  // at this frequency
  const CurveNode* at_rest_;
  std::optional<CurveNode> start_, pull_out_;  // folds over the frequency
  bool followed_{false};
  std::optional<Threshold> found_[4];
};

}  // namespace twum::inline v0_1::core
