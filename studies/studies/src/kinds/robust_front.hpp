// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/design_report.hpp"
#include "kinds/study_kind.hpp"

#include <twum/optim/options.hpp>
#include <twum/studies/problem/robust_question.hpp>

namespace twum::studies {

/// What a front under tolerances begins with.
struct RobustFrontBeginning {
  RobustQuestion question;
  const DesignProblem& asked;  ///< the same without tolerances
  DesignReporter reports;
  optim::SolveOptions options;  ///< observer apart
  std::uint64_t points{0};      ///< of the front, at most
};

/// Searches the front; each of its points says its yield by new random motors.
KindAnswer robust_front(const RobustFrontBeginning& beginning, RunContext& context);

}  // namespace twum::studies
