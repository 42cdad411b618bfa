// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/design_report.hpp"
#include "kinds/study_kind.hpp"

#include <twum/optim/options.hpp>
#include <twum/studies/problem/robust_question.hpp>

#include <span>
#include <vector>

namespace twum::studies {

/// A combination of whole numbers and sets, held.
struct RobustCandidate {
  RobustQuestion question;
  std::vector<double>
      design;  ///< with the rest as in the optimum without tolerances: where the search starts
};

/// What a robust search begins with.
struct RobustBeginning {
  std::vector<RobustCandidate>
      candidates;              ///< at least one; that of the optimum without tolerances first
  const DesignProblem& asked;  ///< nothing held, without tolerances
  const MotorDesign& before;   ///< the motor as it was
  DesignReporter reports;
  optim::SolveOptions options;              ///< of the plain search
  const optim::Result& nominal;             ///< the optimum without tolerances
  std::vector<std::vector<double>> starts;  ///< best designs of other valleys
};

/// Names the question of a candidate to BuiltMotorRows: its design, and whether the motor is that of the file instead.
std::vector<double> question_name(std::span<const double> design, bool before);
/// The question of a candidate about the motor as it was.
RobustQuestion question_before(RobustQuestion question, const MotorDesign& before);

/// Searches the best design under tolerances. Its rows follow those of the plain search. Each candidate is solved by first-order
/// estimates; the best three of them are corrected and verified, and the best of these is the answer.
/// @param plain  the answer of the plain search, whose best design is replaced
KindAnswer robust_optimum(const RobustBeginning& beginning, OptimizeResult plain,
                          RunContext& context);

}  // namespace twum::studies
