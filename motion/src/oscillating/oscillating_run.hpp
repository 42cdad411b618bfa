// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine.hpp"
#include "oscillating/period.hpp"
#include "oscillating/period_watch.hpp"
#include "oscillating/two_waves.hpp"

namespace twum::inline v0_1::motion {

/// One motion of which every vibration is resolved: step after step, with a summary of each period of the drive.
class OscillatingRun final : public Engine {
 public:
  OscillatingRun(const MotorDesign& design, const MotionTask& task);

  void begin(const Stretch& first) override;
  bool follow(const Stretch& stretch) override;
  double angle() const override;
  double speed() const override { return waves_.state().speed; }
  Motion finish() override;

 private:
  /// Layer and rotor under a wave of a given size, over some turns before the beginning.
  void lead_in(const Stretch& first, Complex zeta, double speed);
  ActingNow acting_at(double time) const;
  void enter(const Stretch& stretch);
  void open_period();
  void step();
  void close_period();
  void take_samples();
  /// Phasors of both waves and of the phases at one time.
  void add_phasors(MotionSample& sample, const BothWays& displacement,
                   const BothWays& voltage) const;
  MotionSample first_sample(double speed, Complex zeta) const;

  const MotorDesign& design_;
  const MotionTask& task_;
  MotionModel model_;
  TwoWaves waves_;
  PeriodWatch watch_;
  Imbalance imbalance_;
  int steps_;  // of a period
  Stretch stretch_{};
  double time_{0}, phase_{0}, step_{0};  // phase_: of the drive, psi
  int done_{0};                          // steps of the present period
  Period period_{};
  double energy_{0};                  // electrical, up to the present period
  MotionSample earlier_{}, later_{};  // of the last two periods
  std::size_t next_sample_{0};
  Motion motion_{};
};

}  // namespace twum::inline v0_1::motion
