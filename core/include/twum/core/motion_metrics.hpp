// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>

#include <memory>

namespace twum::inline v0_1 {

/// Answers metrics of motions (MetricInfo::needs_motion) of one design, and lives of a track that wears freely. The library of
/// motions, twum::motion, has them; this one knows their names only, so that a program which moves nothing does without an
/// integrator.
class MotionMetrics {
 public:
  virtual ~MotionMetrics() = default;
  /// Never throws an error of twum: a status tells why there is no value.
  virtual MetricValue evaluate(const MetricRequest& request) = 0;
  /// The same with its derivatives; of a metric without exact ones `smoothness` is undefined.
  virtual MetricDerivative differentiate(const MetricRequest& request,
                                         bool fixed_static_friction) = 0;
};

/// Makes the answers of a design, which outlives them.
using MakeMotionMetrics = std::unique_ptr<MotionMetrics> (*)(const MotorDesign& design);

/// Gives evaluate() and differentiate() the metrics of motions, for the whole program. To be called before them, once; the header
/// <twum/motion.hpp> does it.
/// @return true
bool provide_motion_metrics(MakeMotionMetrics make) noexcept;

/// True if metrics of motions have values: without them their status is `undefined`.
bool has_motion_metrics() noexcept;

}  // namespace twum::inline v0_1
