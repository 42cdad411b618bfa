// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/metric_values.hpp"

#include <twum/studies/motor_problem.hpp>

#include <optional>
#include <vector>

namespace twum::studies {

/// A limit that follows from the metrics and variables of a question.
struct ImpliedLimit {
  MotorLimit limit;
  /// What has no value beyond it: metrics with this argument. Nothing: it orders the coefficients of friction, mu_0 >= mu.
  std::optional<MetricRequest> argument{};

  bool orders_friction() const { return !argument; }
  /// True if it asks for the voltage with which a drive of fixed frequency runs the motor.
  bool is_of_fixed_drive() const;
  /// True if an expression has no value beyond it.
  bool is_about(const MetricExpression& metric) const;
};

/// The largest torque of each load; the limits that end a life, for the new motor; the voltage with which a drive of fixed frequency
/// carries each load, or runs at each speed (Y5.4); the reserves of each torque held at a speed (Y5.1, Y5.2); the order of the
/// coefficients of friction last.
std::vector<ImpliedLimit> implied_limits(const DesignProblem& problem);

/// Responses of a motor and their Jacobian for one combination of sets.
class CombinationResponses {
 public:
  /// @param implied  implied limits of the whole question, the same for each combination
  CombinationResponses(DesignProblem problem, std::vector<ImpliedLimit> implied);

  /// @param design  values of the variables
  optim::Evaluation evaluate(std::span<const double> design, bool gradient) const;

 private:
  using Numbers = std::vector<MetricDerivative>;  // one for each response

  Numbers numbers(const MotorDesign& motor, bool gradient) const;
  Numbers values_of(const MotorDesign& motor, const ExpressionEvaluator& expressions,
                    bool gradient) const;
  std::optional<MetricDerivative> missing_voltage(const MotorDesign& motor,
                                                  const Numbers& reserves) const;
  void end_endless(Numbers& numbers) const;
  void add_friction_order(std::span<const double> design, Numbers& numbers) const;
  optim::Evaluation evaluate_motor(std::span<const double> design, bool gradient) const;
  void add_kinks(std::span<const double> design, const Numbers& numbers,
                 optim::Evaluation& evaluation) const;
  void add_kink(std::size_t response, std::size_t variable, std::span<const double> design,
                optim::Evaluation& evaluation) const;

  DesignProblem problem_;
  VariedParameters varied_;
  std::vector<ImpliedLimit> implied_;
  // all except the order of the friction coefficients, which comes last
  std::vector<MetricExpression> responses_;
  std::size_t metrics_;            // of these, before the reserves of a fixed drive
  ExpressionEvaluator evaluator_;  // of the metrics
  ExpressionEvaluator reserves_;   // of the others
};

/// motor_problem() without the check for an objective.
optim::Problem posed_problem(const DesignProblem& problem);

/// The evaluator of motor_problem(): selects the combination of a design and computes its responses.
class MotorResponses {
 public:
  explicit MotorResponses(DesignProblem problem);

  optim::Evaluation evaluate(std::span<const double> design, bool gradient) const;

  const std::vector<ImpliedLimit>& implied() const noexcept { return implied_; }

 private:
  DesignProblem problem_;
  std::vector<ImpliedLimit> implied_;
  std::vector<CombinationResponses> combinations_;
};

}  // namespace twum::studies
