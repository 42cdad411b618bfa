// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/drive/wave_solutions.hpp"

#include <twum/core/performance/metrics.hpp>

#include <optional>
#include <vector>

namespace twum::performance {

/// A voltage or a frequency at which the number of waves at rest changes, and the wave that appears or vanishes
/// there.
struct Threshold {
  double value;           ///< [V] rms, or [Hz]
  double amplitude;       ///< amplitude at the fold [m]; 0 if there is no fold at any voltage
  double frequency;       ///< [Hz]
  double beyond_kink{0};  ///< as of ForceExtremum
};

/// Where a motor at rest starts by itself and where it stops running (D3.2 to D3.4). Each threshold is computed once.
class Thresholds {
 public:
  /// @param design   with modal data
  /// @param track    of its motor
  /// @param extrema  of H at rest, if they are known
  Thresholds(const MotorDesign& design, const TrackRule& track,
             std::optional<std::vector<ForceExtremum>> extrema);

  /// @param metric  start_voltage, hold_voltage, start_frequency or pull_out_frequency
  /// @throws SearchFailure `undefined` for a frequency if no voltage is given or no frequency starts or ends the
  ///         running wave at this voltage
  const Threshold& at(Metric metric);

  /// The motor's waves at another frequency of the drive; the layer's viscosity follows it where it is that of a loss factor.
  DrivenWaves waves_at(double frequency) const;

 private:
  Threshold voltage(bool start);
  Threshold frequency(bool start);
  std::optional<ForceExtremum> own_extremum(bool start);

  struct Followed {
    double amplitude, frequency;
    bool settled;  ///< H has its extremum there, and it is the drive's force
  };
  Followed followed(const ForceExtremum& from, double frequency) const;
  bool is_extremum(const Followed& at, bool maximum, const DrivenWaves::LevelSlopes& near) const;

  DrivenWaves waves_;  // at the design's own frequency
  bool given_voltage_;
  double frequency_;                                   // of the design
  std::optional<std::vector<ForceExtremum>> extrema_;  // at this frequency
  std::optional<Threshold> found_[4];
};

}  // namespace twum::performance
