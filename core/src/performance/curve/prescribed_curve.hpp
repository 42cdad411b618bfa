// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/curve/curve.hpp"

namespace twum::performance {

/// What a metric says that needs a point without an answer.
MetricStatus metric_status(PointStatus status);

/// The curve of a motor under one wave, from rest on.
class PrescribedCurve final : public Curve {
 public:
  explicit PrescribedCurve(const DrivenMotor<double>& motor) : Curve(motor) {}

  CurvePoint point(double speed, const WarmStart* guess, double accuracy) const override;
  CurveSlope slope(double speed, const WarmStart* guess) const override;
};

}  // namespace twum::performance
