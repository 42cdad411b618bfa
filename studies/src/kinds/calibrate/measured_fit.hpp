// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/studies/motor_problem.hpp>

#include "tables/measured_points.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/optim/least_squares.hpp>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {

/// A parameter of a fit: of all tables of measurements, or of one.
struct FitParameter : DesignVariable {
  /// Of all.
  explicit FitParameter(const DesignVariable& range) : DesignVariable(range) {}
  /// Of the table of this number and name.
  FitParameter(const DesignVariable& range, std::size_t number, std::string name)
      : DesignVariable(range), table(number), file(std::move(name)) {}

  std::optional<std::size_t> table{};
  std::string file{};

  /// "amplitude", or "amplitude (b.csv)".
  std::string name() const;
  /// The way from a to b in parts of the range, on its scale.
  double part(double a, double b) const;
  /// The value at a share of this way.
  double between(double a, double b, double share) const;
};

/// A set of values as numbers that tell it from others. Keys of containers are made of these: a template of the standard library with
/// a type of ours is visible in each program that links the library.
std::vector<double> plain_numbers(const std::vector<ParameterValue>& set);

/// The residuals of a calibration: computed minus measured values, times the root of the point's weight (L1.1). They
/// are in the unit of the points if all are of one kind, else in standard deviations. Quantities that the bench sets,
/// such as a speed, are taken as exact; readings have errors. Immutable and thread-safe.
class MeasuredFit {
 public:
  /// Residuals below this share of the measured values are rounding errors.
  static constexpr double kRounding = 1e-9;

  /// @param points  at least one
  /// @throws ValueError as VariedParameters; InputError for a motor that is not admissible with the parameters that a
  ///          point sets
  MeasuredFit(const MotorDesign& motor, std::vector<FitParameter> parameters,
              std::vector<MeasuredPoint> points, std::vector<DerivedParameter> derived = {});

  /// The motor before the fit.
  const MotorDesign& motor() const noexcept { return motor_; }
  /// The motor with the parameters at these values; with those of this table where tables have their own.
  MotorDesign motor_at(std::span<const double> values, std::size_t table = 0) const;
  /// Whether tables have values of their own.
  bool per_file() const;
  /// Whether the fit estimates or derives the parameter or its alternative, or a point sets it.
  bool sets(Parameter parameter) const;
  /// The same fit with further parameters varied, after its own.
  MeasuredFit varying(const std::vector<Parameter>& more) const;
  /// The same fit with the residuals of each column divided by a deviation.
  /// @param columns     index of the column of each point
  /// @param deviations  of the columns, in units of the residuals
  MeasuredFit in_parts(const std::vector<std::size_t>& columns,
                       const std::vector<double>& deviations) const;
  /// The same fit with other points.
  MeasuredFit asking(std::vector<MeasuredPoint> points) const;

  const std::vector<FitParameter>& parameters() const noexcept { return parameters_; }
  const std::vector<MeasuredPoint>& points() const noexcept { return points_; }

  /// Residuals with the exact Jacobian. Fails if the motor has no value for one of the points.
  optim::Residuals residuals(std::span<const double> values) const;
  /// Root of the weighted mean square.
  double rms(std::span<const double> residuals) const;
  /// SI unit of residuals and their root mean square; "1" for points of several kinds.
  std::string unit() const;
  /// Whether the points are of several kinds, such as torques and currents.
  bool mixed() const { return mixed_; }
  /// Whether a root mean square is within rounding errors of the measured values.
  bool exact(double rms) const { return rms <= kRounding * size(); }
  /// Whether the points have standard deviations.
  bool deviations_given() const { return points_.front().deviation > 0; }
  /// Standard deviation of every residual, if those of the points are given.
  double stated_deviation() const;
  /// Root mean square of the measured values, in the unit of the residuals.
  double size() const;

  /// Parameters that follow from those of the fit, at values of these.
  std::vector<NamedValue> derived(std::span<const double> values) const;

  /// Ratio of static to kinetic friction if the latter is estimated and the former follows it; otherwise 1.
  double static_ratio() const;

  /// Parameters for least_squares(), with these start values. If empty, they start as the study says, else at the
  /// motor's value, else in the middle.
  std::vector<optim::Variable> variables(std::span<const double> start) const;

 private:
  // Readings of one quantity at one place: what the motor has there is computed once.
  struct Readings {
    Reading reading;
    std::vector<std::size_t> points;  // their numbers
  };
  // Readings that the same parameters were set for, in one table where tables have values of their own.
  struct Condition {
    std::vector<std::size_t> places;  // of its parameters among all
    VariedParameters varied;
    std::vector<Readings> readings;       // each different
    std::vector<MetricRequest> requests;  // of those that are metrics, in their order
  };

  std::vector<std::size_t> places_in(std::size_t table) const;
  std::vector<Parameter> parameters_at(const std::vector<std::size_t>& places) const;
  class Sorter;
  void add(const Condition& condition, std::span<const double> values,
           optim::Residuals& result) const;
  void add(const Condition& condition, const Readings& readings, const MetricDerivative& found,
           const VariedParameters::Slopes& slopes, optim::Residuals& result) const;
  optim::Residuals all_residuals(std::span<const double> values) const;

  MotorDesign motor_;
  std::vector<FitParameter> parameters_;
  std::vector<MeasuredPoint> points_;
  VariedParameters varied_;  // of the motor as it is, in the first table
  std::vector<Condition> conditions_;
  std::vector<Parameter> set_;  // by the bench, at any point
  bool mixed_{false};
};

}  // namespace twum::inline v0_1::studies
