// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust.hpp>
#include <twum/studies/robust_question.hpp>
#include <twum/studies/robust_result.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// Reference for a robust optimum: the optimum without tolerances, or the motor before the search.
struct NominalMotors {
  double objective{0};             ///< its goal, SI; NaN if it has no value
  std::vector<NamedValue> design;  ///< its variables
  optim::Verification seen;        ///< a sample of motors built to it
};

/// A robust optimum in words and SI numbers.
RobustReport robust_report(const RobustQuestion& question, const optim::RobustProblem& posed,
                           const optim::RobustResult& found, const NominalMotors& nominal);

/// The yields and probabilities of the study.
std::vector<RobustYield> yields_of(const optim::RobustProblem& posed,
                                   const optim::Verification& seen);

/// The goals that are statistics, by new random motors.
std::vector<NamedValue> wanted_statistics(const RobustQuestion& question,
                                          const optim::RobustProblem& posed,
                                          const optim::Verification& seen);

/// The certificate of a round as one of the design: margins become limits, and the indices are left out.
optim::Certificate design_certificate(optim::Certificate certificate,
                                      const optim::RobustProblem& posed);

/// The same of an optimum, with multipliers of the goal itself.
optim::Certificate goal_certificate(const optim::RobustResult& found, bool maximize,
                                    const optim::RobustProblem& posed);

}  // namespace twum::inline v0_1::studies
