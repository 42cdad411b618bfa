// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <string>

namespace twum::inline v0_1::studies::telling {
namespace {

const char* outcome_words(StudyOutcome outcome) {
  switch (outcome) {
    case StudyOutcome::optimal: return "optimal";
    case StudyOutcome::feasible: return "feasible, optimality not verified";
    case StudyOutcome::infeasible: return "no feasible design";
    case StudyOutcome::budget: return "stopped at its evaluation limit";
    case StudyOutcome::failed: return "nothing could be computed";
    case StudyOutcome::done: return "complete";
    case StudyOutcome::fitted: return "the motor fits the points";
    case StudyOutcome::poor: return "the motor does not fit the points";
    case StudyOutcome::several: return "several motors fit equally well";
    case StudyOutcome::undetermined: return "the points do not determine every parameter";
    case StudyOutcome::at_bounds: return "every parameter at an end of its range";
    case StudyOutcome::interrupted: return "interrupted";
  }
  return "";
}

// Whether an evaluation is one point of a motor.
bool of_points(StudyKind kind) {
  return kind == StudyKind::curve || kind == StudyKind::frequency || kind == StudyKind::map ||
         kind == StudyKind::heat || kind == StudyKind::life || kind == StudyKind::motion;
}

struct Badge {
  const StudyResult& result;

  std::string operator()(const OptimizeResult& answer) const {
    if (result.outcome != StudyOutcome::optimal) return outcome_words(result.outcome);
    const optim::Certificate& certificate = answer.best.certificate;
    return certificate.second_order || !certificate.passed ? "certified local optimum"
                                                           : "optimum to first order only";
  }

  std::string operator()(const ParetoResult& /*answer*/) const {
    return result.outcome == StudyOutcome::optimal ? "every point certified"
                                                   : outcome_words(result.outcome);
  }

  std::string operator()(const UncertaintyResult& answer) const {
    if (result.outcome != StudyOutcome::done || !answer.yield) return outcome_words(result.outcome);
    if (answer.weighted && answer.broken.value == 0) return "no failure found";
    return written(share_part(answer.yield->value), Writing::read) + " keep the limits";
  }

  template <typename Other>
  std::string operator()(const Other& /*answer*/) const {
    return outcome_words(result.outcome);
  }
};

}  // namespace

Headline headline(const StudyResult& result) {
  Headline told;
  if (result.outcome == StudyOutcome::interrupted)
    told = {Headline::Look::bad,
            "",
            {{strong("This study was interrupted"), "; these results are incomplete."}},
            {}};
  else
    told =
        std::visit([&](const auto& answer) { return headline_of(answer, result); }, result.answer);
  told.badge = std::visit(Badge{result}, result.answer);
  told.title = title_of(result.kind);
  if (!result.motor.empty()) told.title += " of " + printable(result.motor);
  if (of_points(result.kind)) told.rows = "points";
  return told;
}

std::vector<Section> sections(const StudyResult& result, const Sources& sources) {
  return std::visit([&](const auto& answer) { return sections_of(answer, sources); },
                    result.answer);
}

}  // namespace twum::inline v0_1::studies::telling
