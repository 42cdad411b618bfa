// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/design_report.hpp"
#include "kinds/rows/study_kind.hpp"

#include <twum/optim/options.hpp>
#include <twum/studies/robust_question.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// A fixed combination of integer variables and sets.
struct RobustCandidate {
  RobustQuestion question;
  /// start design; its other variables are those of the optimum without tolerances
  std::vector<double> design;
};

/// Input of a robust search.
struct RobustBeginning {
  /// at least one; the combination of the optimum without tolerances first
  std::vector<RobustCandidate> candidates;
  const DesignProblem& asked;  ///< the question with nothing fixed, without tolerances
  const MotorDesign& before;   ///< the motor before the search
  DesignReporter reports;
  optim::SolveOptions options;              ///< of the plain search
  const optim::Result& nominal;             ///< the optimum without tolerances
  std::vector<std::vector<double>> starts;  ///< other local optima
};

/// The question of a candidate about the motor before the search.
RobustQuestion question_before(RobustQuestion question, const MotorDesign& before);

/// Searches the best design under tolerances. Its rows follow those of the plain search. Each candidate is solved by first-order
/// estimates; the best three of them are corrected and verified, and the best of these is the answer.
/// @param plain  the answer of the plain search, whose best design is replaced
KindAnswer robust_optimum(const RobustBeginning& beginning, OptimizeResult plain,
                          RunContext& context);

}  // namespace twum::inline v0_1::studies
