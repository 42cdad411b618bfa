// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>
#include <twum/studies/problem/robust_question.hpp>
#include <twum/studies/results/robust_result.hpp>

#include <vector>

namespace twum::studies {

/// What a robust optimum is compared with: the optimum without tolerances, or the motor as it was.
struct NominalMotors {
  double objective{0};             ///< of it, SI; NaN: the goal has none
  std::vector<NamedValue> design;  ///< its variables
  optim::Verification seen;        ///< motors built to it
};

/// A robust optimum in words and SI numbers.
RobustReport robust_report(const RobustQuestion& question, const optim::RobustProblem& posed,
                           const optim::RobustResult& found, const NominalMotors& nominal);

/// The goal by fresh motors where it is a statistic, otherwise nothing.
std::vector<NamedValue> wanted_statistic(const RobustQuestion& question,
                                         const optim::RobustProblem& posed,
                                         const optim::Verification& seen);

/// The certificate of the last round as one of the design: its margins stand for the limits, its indices are left out.
/// Multipliers are those of the goal.
optim::Certificate design_certificate(const optim::RobustResult& found, bool maximize,
                                      const optim::RobustProblem& posed);

}  // namespace twum::studies
