// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/problem/motor_problem.hpp>
#include <twum/studies/store/column.hpp>

#include "tables/measured_points.hpp"

#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/optim/least_squares.hpp>

#include <span>
#include <string>
#include <vector>

namespace twum::studies {

/// The residuals of a calibration: what the motor gives less what was measured, times the root of the point's weight (L1.1);
/// in the unit of the points if they are of one kind, else in standard deviations. What the bench sets, such as a speed, is
/// exact; what it reads has the error. Constant, safe from any number of threads.
class MeasuredFit {
 public:
  /// Residuals below this part of what was measured are rounding.
  static constexpr double kRounding = 1e-9;

  /// @param points  at least one
  /// @throws ValueError as VariedParameters; InputError for a motor that is not admissible with what a point sets
  MeasuredFit(const MotorDesign& motor, std::vector<DesignVariable> parameters,
              std::vector<MeasuredPoint> points, std::vector<DerivedParameter> derived = {});

  /// The motor as it is, before anything is fitted.
  const MotorDesign& motor() const noexcept { return motor_; }
  /// The motor with the parameters at these values.
  MotorDesign motor_at(std::span<const double> values) const { return varied_.motor(values); }
  /// The fit estimates or derives the parameter or its twin, or a point sets it.
  bool sets(Parameter parameter) const;
  /// The same with further parameters varied, behind its own.
  MeasuredFit varying(const std::vector<Parameter>& more) const;
  /// The same with the residuals of each column in parts of a deviation.
  /// @param columns     number of the column of each point
  /// @param deviations  of the columns, in units of the residuals
  MeasuredFit in_parts(const std::vector<std::size_t>& columns,
                       const std::vector<double>& deviations) const;
  /// The same with other points.
  MeasuredFit asking(std::vector<MeasuredPoint> points) const;

  const std::vector<DesignVariable>& parameters() const noexcept { return parameters_; }
  const std::vector<MeasuredPoint>& points() const noexcept { return points_; }

  /// With the exact Jacobian. A motor without one of the numbers has a failure.
  optim::Residuals residuals(std::span<const double> values) const;
  /// Root of the weighted mean square.
  double rms(std::span<const double> residuals) const;
  /// SI unit of residuals and their root mean square; "1" for points of several kinds.
  std::string unit() const;
  /// The points are numbers of several kinds, such as torques and currents.
  bool mixed() const { return mixed_; }
  /// A root mean square that is rounding beside what was measured.
  bool exact(double rms) const { return rms <= kRounding * size(); }
  /// Standard deviations were measured.
  bool deviations_given() const { return points_.front().deviation > 0; }
  /// Standard deviation of every residual, where those of the points were measured.
  double stated_deviation() const;
  /// Root of the mean square of what was measured, in the unit of the residuals.
  double size() const;

  /// Parameters that follow from those of the fit, at values of these.
  std::vector<NamedValue> derived(std::span<const double> values) const;

  /// Static to kinetic friction where the latter is estimated and takes the former along; otherwise 1.
  double static_ratio() const;

  /// Parameters for least_squares(), to begin at some values; empty: where the study says, or at the
  /// motor as it is, or in the middle.
  std::vector<optim::Variable> variables(std::span<const double> start) const;

 private:
  // Points that the same parameters were set for.
  struct Condition {
    std::vector<ParameterValue> set;
    VariedParameters varied;
    std::vector<std::size_t> points;      // their numbers
    std::vector<MetricRequest> requests;  // of those that are metrics, in their order
  };

  Condition& condition_of(const MeasuredPoint& point, const std::vector<DerivedParameter>& derived);
  void add(const Condition& condition, std::span<const double> values,
           optim::Residuals& result) const;
  optim::Residuals all_residuals(std::span<const double> values) const;

  MotorDesign motor_;
  std::vector<DesignVariable> parameters_;
  std::vector<MeasuredPoint> points_;
  VariedParameters varied_;  // of the motor as it is
  std::vector<Condition> conditions_;
  bool mixed_{false};
};

}  // namespace twum::studies
