// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/implied_limits.hpp"
#include "problem/metric_values.hpp"

#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// The reserves of voltage that a motor under a fixed drive has where it runs: computed, so that a search sees how near its end is,
/// or taken as large, for motors that are only counted.
enum class RunningReserves : unsigned char { computed, large };

/// Responses of a motor and their Jacobian for one combination of sets.
class CombinationResponses {
 public:
  /// @param implied  implied limits of the whole question, the same for each combination
  CombinationResponses(DesignProblem problem, std::vector<ImpliedLimit> implied,
                       RunningReserves running);

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
  RunningReserves running_;
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
  explicit MotorResponses(DesignProblem problem,
                          RunningReserves running = RunningReserves::computed);

  optim::Evaluation evaluate(std::span<const double> design, bool gradient) const;

  const std::vector<ImpliedLimit>& implied() const noexcept { return implied_; }

 private:
  DesignProblem problem_;
  std::vector<ImpliedLimit> implied_;
  std::vector<CombinationResponses> combinations_;
};

}  // namespace twum::inline v0_1::studies
