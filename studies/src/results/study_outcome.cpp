// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/study_outcome.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <iterator>

namespace twum::inline v0_1::studies {
namespace {

// In the order of StudyOutcome.
constexpr const char* kOutcomeWords[] = {"interrupted", "optimal", "feasible",     "infeasible",
                                         "budget",      "failed",  "fitted",       "poor",
                                         "at-bounds",   "several", "undetermined", "done"};
static_assert(std::size(kOutcomeWords) == static_cast<std::size_t>(StudyOutcome::done) + 1);

}  // namespace

const char* to_string(StudyOutcome outcome) noexcept {
  return kOutcomeWords[static_cast<std::size_t>(outcome)];
}

StudyOutcome outcome_of(optim::Outcome search) noexcept {
  switch (search) {
    case optim::Outcome::optimal: return StudyOutcome::optimal;
    case optim::Outcome::feasible: return StudyOutcome::feasible;
    case optim::Outcome::infeasible: return StudyOutcome::infeasible;
    case optim::Outcome::budget: return StudyOutcome::budget;
    case optim::Outcome::failed: break;
  }
  return StudyOutcome::failed;
}

OutcomeWord::OutcomeWord(std::string_view word) {
  const auto* const found = std::find(std::begin(kOutcomeWords), std::end(kOutcomeWords), word);
  if (found == std::end(kOutcomeWords))
    throw InputError("'" + std::string(word) + "' is no outcome of a study");
  outcome_ = static_cast<StudyOutcome>(found - std::begin(kOutcomeWords));
}

}  // namespace twum::inline v0_1::studies
