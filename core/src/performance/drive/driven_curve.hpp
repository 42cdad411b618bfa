// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/curve/curve.hpp"
#include "performance/drive/drive.hpp"

namespace twum::performance {

/// The input power in the efficiency of a curve.
enum class Input : unsigned char {
  mechanical,  ///< stator power and stator loss (T7.7)
  electrical   ///< the power at the terminals (D4.3)
};

/// The curve of a motor under a voltage: the wave follows the speed.
class DrivenCurve final : public Curve {
 public:
  /// @param motor  of Drive::first_motor(); both have to outlive the curve
  DrivenCurve(const Drive& drive, const DrivenMotor<double>& motor, Input input)
      : Curve(motor, drive.begin()), drive_(drive), input_(input) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;

 private:
  const Drive& drive_;
  Input input_;
};

/// The curve under one wave whose efficiency is a share of the power at the terminals.
class TerminalCurve final : public Curve {
 public:
  /// @param motor  has to outlive the curve
  TerminalCurve(const DrivenMotor<double>& motor, const StatorModes<double>& modes)
      : Curve(motor), modes_(modes) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;

 private:
  StatorModes<double> modes_;
};

}  // namespace twum::performance
