// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/problem/motor_problem.hpp>
#include <twum/studies/store/column.hpp>

#include "tables/measured_points.hpp"

#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/optim/least_squares.hpp>

#include <span>
#include <vector>

namespace twum::studies {

/// The residuals of a calibration: torque of the motor less torque measured, at the speed measured,
/// times the root of the point's weight (L1.1) [N m]. The speed is what a test stand sets, the torque what it
/// reads; so the error is one of torque. Constant, safe from any number of threads.
class TorqueFit {
 public:
  /// Residuals below this part of the torques are rounding.
  static constexpr double kRounding = 1e-9;

  TorqueFit(const MotorDesign& motor, std::vector<DesignVariable> parameters,
            std::vector<MeasuredPoint> points, std::vector<DerivedParameter> derived = {});

  const std::vector<DesignVariable>& parameters() const noexcept { return parameters_; }
  const std::vector<MeasuredPoint>& points() const noexcept { return points_; }

  /// With the exact Jacobian. A motor without a torque at one of the speeds has a failure.
  optim::Residuals residuals(std::span<const double> values) const;
  /// Root of the weighted mean square [N m].
  double rms(std::span<const double> residuals) const;
  /// A root mean square that is rounding beside the torques.
  bool exact(double rms) const { return rms <= kRounding * torque_size(); }
  /// Standard deviations were measured.
  bool deviations_given() const { return points_.front().deviation > 0; }
  /// Root mean square of the torques measured [N m].
  double torque_size() const;

  /// Parameters that follow from those of the fit, at values of these.
  std::vector<NamedValue> derived(std::span<const double> values) const;

  /// Static to kinetic friction where the latter is estimated and takes the former along; otherwise 1.
  double static_ratio() const;

  /// Parameters for least_squares(), to begin at some values; empty: where the study says, or at the
  /// motor as it is, or in the middle.
  std::vector<optim::Variable> variables(std::span<const double> start) const;

 private:
  optim::Residuals torque_residuals(std::span<const double> values) const;

  MotorDesign motor_;
  std::vector<DesignVariable> parameters_;
  std::vector<MeasuredPoint> points_;
  VariedParameters varied_;
  std::vector<MetricRequest> requests_;
};

}  // namespace twum::studies
