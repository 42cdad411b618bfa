// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/metric_values.hpp"

#include <twum/studies/problem/motor_problem.hpp>

#include <optional>
#include <vector>

namespace twum::studies {

/// A limit that follows from what a question asks.
struct ImpliedLimit {
  std::string name;
  std::optional<double> load;  ///< max_torque >= load [N m]; otherwise static >= kinetic friction
};

/// The loads [N m] that an expression asks a metric at.
std::vector<double> loads_of(const MetricExpression& metric);

std::vector<ImpliedLimit> implied_limits(const DesignProblem& problem);

/// Responses of one motor and their Jacobian, where nothing is left to choose.
class CombinationResponses {
 public:
  /// @param implied  those of the whole question: the same for each combination
  CombinationResponses(DesignProblem problem, std::vector<ImpliedLimit> implied);

  /// @param design  values of the variables
  optim::Evaluation evaluate(std::span<const double> design, bool gradient) const;

 private:
  using Numbers = std::vector<MetricDerivative>;  // one for each response

  Numbers numbers(const MotorDesign& motor, bool gradient) const;
  void add_friction_order(std::span<const double> design, Numbers& numbers) const;
  optim::Evaluation evaluate_motor(std::span<const double> design, bool gradient) const;
  void add_kinks(std::span<const double> design, const Numbers& numbers,
                 optim::Evaluation& evaluation) const;
  void add_kink(std::size_t response, std::size_t variable, std::span<const double> design,
                optim::Evaluation& evaluation) const;

  DesignProblem problem_;
  VariedParameters varied_;
  std::vector<ImpliedLimit> implied_;
  std::vector<MetricExpression> responses_;  // all but the friction order, which comes last
  ExpressionEvaluator evaluator_;            // of these
};

/// motor_problem() without the check that it can be solved: it may lack an objective.
optim::Problem posed_problem(const DesignProblem& problem);

/// The evaluator of motor_problem(): responses of the combination that a design names.
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
