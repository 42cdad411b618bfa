// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/expression.hpp>
#include <twum/studies/telling.hpp>

#include <string_view>
#include <vector>

/// Limits of a design on the charts of its curve; internal.
namespace twum::inline v0_1::studies::telling {

/// A limit or a duty of a design on a metric.
struct CurveLimit {
  MetricRequest request;
  Bound bound;  ///< without its place
  double limit;
};

/// Those limits of a design that a chart of its curve may have a place for.
std::vector<CurveLimit> curve_limits(const DesignReport& report, const std::vector<Goal>& goals);

/// Those that lie on the chart of a column of this curve, at their places.
std::vector<Bound> bounds_on(std::string_view column, const MotorCurve& curve,
                             const std::vector<CurveLimit>& limits);

}  // namespace twum::inline v0_1::studies::telling
