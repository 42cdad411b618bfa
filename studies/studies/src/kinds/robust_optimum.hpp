// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/design_report.hpp"
#include "kinds/study_kind.hpp"

#include <twum/optim/options.hpp>
#include <twum/studies/problem/robust_question.hpp>

namespace twum::studies {

/// What a robust search begins with.
struct RobustBeginning {
  const RobustQuestion& question;  ///< whole numbers and sets held
  const DesignProblem& asked;      ///< nothing held, without tolerances
  const MotorDesign& before;       ///< the motor as it was
  DesignReporter reports;
  optim::SolveOptions options;   ///< of the plain search
  const optim::Result& nominal;  ///< the optimum without tolerances
};

/// Searches the best design under tolerances. Its rows follow those of the plain search.
/// @param plain  the answer of the plain search, whose best design is replaced
KindAnswer robust_optimum(const RobustBeginning& beginning, OptimizeResult plain,
                          RunContext& context);

}  // namespace twum::studies
