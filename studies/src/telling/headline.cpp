// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <map>
#include <string_view>

namespace twum::studies::telling {
namespace {

// Words of outcomes that mean the same for every kind.
std::string outcome_words(const std::string& outcome) {
  static const std::map<std::string_view, const char*> kWords = {
      {"feasible", "keeps the limits, not shown to be best"},
      {"infeasible", "no design keeps the limits"},
      {"budget", "stopped by its budget"},
      {"failed", "nothing could be computed"},
      {"done", "complete"},
      {"fitted", "the motor follows the points"},
      {"poor", "the motor does not follow the points"},
      {"several", "several motors fit equally well"},
      {"undetermined", "the points do not determine every parameter"},
      {"at-bounds", "every parameter at an end of its range"},
      {"interrupted", "interrupted"}};
  const auto known = kWords.find(outcome);
  return known == kWords.end() ? outcome : known->second;
}

const char* kind_words(StudyKind kind) {
  switch (kind) {
    case StudyKind::curve: return "torque-speed curves";
    case StudyKind::sweep: return "sweep of designs";
    case StudyKind::sensitivity: return "sensitivity";
    case StudyKind::optimize: return "optimization";
    case StudyKind::size: return "sizing for a duty";
    case StudyKind::pareto: return "trade-off front";
    case StudyKind::uncertainty: return "spread under tolerances";
    case StudyKind::calibrate: return "calibration";
    case StudyKind::frequency: return "sweep of the frequency";
    case StudyKind::map: return "map over speed and torque";
    case StudyKind::heat: return "temperatures";
    case StudyKind::life: return "life";
  }
  return "";
}

// Whether an evaluation is one point of a motor.
bool of_points(StudyKind kind) {
  return kind == StudyKind::curve || kind == StudyKind::frequency || kind == StudyKind::map ||
         kind == StudyKind::heat || kind == StudyKind::life;
}

struct Badge {
  const StudyResult& result;

  std::string operator()(const OptimizeResult& answer) const {
    if (result.outcome != "optimal") return outcome_words(result.outcome);
    const optim::Certificate& certificate = answer.best.certificate;
    return certificate.second_order || !certificate.passed ? "certified local optimum"
                                                           : "optimum to first order only";
  }

  std::string operator()(const ParetoResult& /*answer*/) const {
    return result.outcome == "optimal" ? "every point certified" : outcome_words(result.outcome);
  }

  std::string operator()(const UncertaintyResult& answer) const {
    if (result.outcome != "done" || !answer.yield) return outcome_words(result.outcome);
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
  if (result.outcome == "interrupted")
    told = {Headline::Look::bad,
            "",
            {{strong("This study was interrupted"), "; what is here is not all of it."}},
            {}};
  else
    told =
        std::visit([&](const auto& answer) { return headline_of(answer, result); }, result.answer);
  told.badge = std::visit(Badge{result}, result.answer);
  told.title = kind_words(result.kind);
  if (!result.motor.empty()) told.title += " of " + printable(result.motor);
  if (of_points(result.kind)) told.rows = "points";
  return told;
}

std::vector<Section> sections(const StudyResult& result, const Sources& sources) {
  return std::visit([&](const auto& answer) { return sections_of(answer, sources); },
                    result.answer);
}

}  // namespace twum::studies::telling
