// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::studies::telling {
namespace {

const char* begin_words(StudyOutcome outcome) {
  switch (outcome) {
    case StudyOutcome::fitted: return "Estimates: ";
    case StudyOutcome::poor: return "The motor does not fit these points. The best fit has ";
    case StudyOutcome::several: return "Several motors fit equally well. One of them has ";
    case StudyOutcome::undetermined:
      return "The points do not determine all of these parameters. The best fit has ";
    case StudyOutcome::at_bounds:
      return "Nothing was fitted: every parameter is at an end of its range, ";
    default: return "The search ended before it reached the best fit, at ";
  }
}

// "preload 158 N (150 N to 166 N)"
Phrase estimate_phrase(const CalibrateResult& answer, const CalibrateResult::Estimate& e) {
  const int digits = interval_digits(e.low, e.high);
  const auto value = [&](double v) { return value_part(v, e.parameter.unit, digits); };
  const std::string remark = estimate_remark(answer, e);
  Phrase phrase{name_part(e.parameter.name), " ", value(e.parameter.value)};
  if (!remark.empty())
    append(phrase, {" (" + remark + ")"});
  else if (!std::isnan(e.low))
    append(phrase, {" (", value(e.low), " to ", value(e.high), ")"});
  for (Part& part : phrase) part.strong = true;
  return phrase;
}

Phrase residual_sentence(const CalibrateResult& answer) {
  Phrase phrase{"The residuals between motor and points are ",
                value_part(answer.residual_rms, answer.unit, 3)};
  if (answer.unit == "1") append(phrase, {" standard deviations"});
  append(phrase, {" (root mean square)."});
  return phrase;
}

Headline no_fit(const CalibrateResult& answer) {
  return {Headline::Look::bad,
          "",
          {{strong("No fit was found."), " The motor has no ",
            answer.data.front().torque() ? "torque at one of the speeds measured."
                                         : "value for one of the measured numbers."}},
          {}};
}

}  // namespace

Headline headline_of(const CalibrateResult& answer, const StudyResult& result) {
  using Look = Headline::Look;
  if (answer.unmeasured)
    return {Look::plain,
            "",
            {{"Nothing is measured yet. The table lists the first measurements to make."}},
            {}};
  if (answer.estimates.empty()) return no_fit(answer);
  Phrase first{begin_words(result.outcome)};
  bool doubtful = result.outcome != StudyOutcome::fitted;
  for (const CalibrateResult::Estimate& e : answer.estimates) {
    if (&e != &answer.estimates.front()) append(first, {strong(", ")});
    append(first, estimate_phrase(answer, e));
    doubtful = doubtful || !estimate_remark(answer, e).empty();
  }
  append(first, {strong(".")});
  Headline told{doubtful ? Look::bad : Look::good, "", {first}, {}};
  if (!answer.exact) told.sentences.push_back(residual_sentence(answer));
  for (const std::string& note : calibration_notes(answer)) told.remarks.push_back({note});
  return told;
}

}  // namespace twum::inline v0_1::studies::telling
