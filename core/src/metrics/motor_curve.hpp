// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/curve.hpp"
#include "drive/drive.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// What a metric says that needs a point without an answer.
MetricStatus metric_status(PointStatus status);

/// The curve of a motor under one wave, from rest on.
class PrescribedCurve final : public Curve {
 public:
  /// @param modes  of its stator, null if they are not known; both have to outlive the curve
  PrescribedCurve(const DrivenMotor<double>& motor, const StatorModes<double>* modes)
      : Curve(motor, Waves::one), modes_(modes) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;
  std::size_t own_slices() const override { return motor().slices().size(); }
  SliceAnswer slice(double speed, std::size_t index) const override {
    return slice_answer(motor(), speed, index);
  }

 private:
  const StatorModes<double>* modes_;
};

/// The curve of a motor under a voltage: the wave follows the speed.
class DrivenCurve final : public Curve {
 public:
  /// @param motor  of Drive::first_motor(); both have to outlive the curve
  DrivenCurve(const Drive& drive, const DrivenMotor<double>& motor)
      : Curve(motor, Waves::each_its_own, drive.begin()), drive_(drive) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  Vector<CurvePoint> known_points() const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;

 private:
  const Drive& drive_;
};

/// Of a motor under a voltage that stands still: no point of its curve is searched, both throw.
class RestCurve final : public Curve {
 public:
  /// @param waves  have to outlive the curve
  explicit RestCurve(const WavesAtRest& waves)
      : Curve(motor_, Waves::each_its_own), motor_(any_of(waves)) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;

 private:
  static DrivenMotor<double> any_of(const WavesAtRest& waves);

  DrivenMotor<double> motor_;
};

}  // namespace twum::inline v0_1::core
