// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/optimize_result.hpp>

#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Makes the reports on designs of one question.
class DesignReporter {
 public:
  /// @param besides  parameters that were changed before the search, reported with each design
  DesignReporter(const DesignProblem& problem, std::vector<Parameter> extra_parameters);

  DesignReport report(std::span<const double> design, const optim::Certificate& certificate) const;
  std::vector<Goal> goals() const;

  /// Values of the parameters that designs are made of.
  std::vector<NamedValue> design_of(const MotorDesign& motor) const;
  /// Every metric without argument, then those of the question.
  std::vector<NamedValue> metrics_of(const MotorDesign& motor) const;

  /// Variables of whole numbers that are at an end of their range; without a multiplier.
  std::vector<BoundState> whole_ends(std::span<const double> design) const;
  Explanation explanation(const optim::Infeasibility& infeasibility) const;
  /// Variables without influence on the goals or a limit that is active, by the Jacobian.
  std::vector<std::string> without_influence(const optim::Evaluation& evaluation,
                                             const DesignReport& report) const;

 private:
  std::vector<LimitState> limits(const MotorDesign& motor,
                                 const optim::Certificate& certificate) const;
  std::vector<BoundState> bounds(const optim::Certificate& certificate) const;
  bool is_of_the_drive(const MotorLimit& limit) const;
  const MotorLimit* limit_named(const std::string& text) const;
  std::vector<ChosenSet> choice_of(std::span<const double> design) const;

  const DesignProblem& problem_;
  std::vector<Parameter> extra_parameters_;
  std::vector<Parameter> chosen_;  // parameters given by the sets, each once
  std::vector<MetricExpression> metrics_;
  std::vector<MotorLimit> limits_;  // limits of the question, then those that follow
};

}  // namespace twum::inline v0_1::studies
