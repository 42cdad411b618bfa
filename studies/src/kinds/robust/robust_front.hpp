// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/design_report.hpp"
#include "kinds/rows/study_kind.hpp"

#include <twum/optim/options.hpp>
#include <twum/studies/robust_question.hpp>

namespace twum::inline v0_1::studies {

/// Input of a front under tolerances.
struct RobustFrontBeginning {
  RobustQuestion question;
  const DesignProblem& asked;  ///< the same without tolerances
  DesignReporter reports;
  optim::SolveOptions options;  ///< options without the observer
  std::uint64_t points{0};      ///< largest number of points of the front
};

/// Searches the front. The yield of each point comes from new random motors.
KindAnswer robust_front(const RobustFrontBeginning& beginning, RunContext& context);

}  // namespace twum::inline v0_1::studies
