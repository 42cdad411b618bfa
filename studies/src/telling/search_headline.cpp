// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"
#include "results/search_words.hpp"
#include "results/standings.hpp"
#include "telling/goal_parts.hpp"
#include "telling/limit_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

using Look = Headline::Look;

double before_of(const OptimizeResult& answer) {
  for (const auto* values :
       {&answer.before_metrics, &answer.before_design, &answer.before_statistics})
    if (const double value = value_of(*values, answer.goal.metric); !std::isnan(value))
      return value;
  return std::nan("");
}

// What binds most, or a whole number at an end of its range.
Phrase stop_sentence(const OptimizeResult& answer) {
  Phrase phrase{"Most restrictive limit: "};
  const Goal goal = priced_goal(answer);
  for (const Json& standing : standings_json(answer.best, {goal})) {
    if (standing["state"] != "binds") continue;
    append(phrase, holder_phrase(standing, {goal}, answer.best));
    return phrase;
  }
  if (answer.whole_ends.empty())
    return {answer.best.certificate.passed
                ? "No limit is active: it is an optimum inside the ranges."
                : "No limit is active, so a longer search or another start may find a better one."};
  const BoundState& end = answer.whole_ends.front();
  append(phrase, end_phrase(end.variable.name, !end.upper, end.limit, end.variable.unit));
  append(phrase, {", the end of its range: whole numbers have no slope. Try a wider range."});
  return phrase;
}

Phrase best_sentence(const OptimizeResult& answer) {
  const Goal& goal = answer.goal;
  const double now = goal_of(answer.best, goal), before = before_of(answer);
  Phrase phrase{"The best design found has ", a_name_part(goal.metric), " of ",
                strong(goal_part_of(goal, now))};
  if (!std::isnan(before)) append(phrase, {", against ", goal_part_of(goal, before), " before"});
  if (!std::isnan(before) && before != 0 && now != before && !is_share(goal))
    append(phrase, {" (", change(share_part((now - before) / std::fabs(before), 3)), ")"});
  append(phrase, {"."});
  return phrase;
}

std::string choices(const std::vector<ChosenSet>& choice) {
  return choice.empty() ? "" : ", with " + choice_words(choice);
}

// A limit that cannot be kept even alone, its best value, and the ends of ranges where that is.
Phrase impossible_phrase(const ImpossibleState& limit, const std::vector<RangeState>& ranges) {
  Phrase phrase{" ",
                limit_part(limit.text),
                " cannot be reached: the ",
                limit.at_least ? "most" : "least",
                limit.of_two_sides ? " of its left side minus its right side that was" : "",
                " found within the ranges is ",
                named_part(limited_by(limit.text), limit.best, limit.unit)};
  for (std::size_t k = 0; k < limit.ends.size(); ++k) {
    const RangeState& end = ranges[limit.ends[k]];
    append(phrase, {k == 0 ? ", at " : " and "});
    append(phrase, end_phrase(end.variable.name, !end.upper, end.limit, end.variable.unit));
  }
  append(phrase, {choices(limit.choice) + "."});
  return phrase;
}

// What is at fault: limits impossible by themselves first, then those that exclude each other.
Phrase cause_sentence(const Explanation& told) {
  Phrase phrase{strong("No design keeps every limit.")};
  std::vector<Part> group;
  for (const std::string& text : told.conflict)
    if (std::ranges::find(told.impossible, text, &ImpossibleState::text) == told.impossible.end())
      group.push_back(limit_part(text));
  for (const ImpossibleState& limit : told.impossible)
    append(phrase, impossible_phrase(limit, told.ranges));
  if (group.size() == 1) append(phrase, {" ", group.front(), " cannot be reached."});
  if (group.size() > 1) {
    append(phrase, {told.impossible.empty() ? " These cannot hold together: "
                                            : " The others exclude each other as well: "});
    append(phrase, listed(group, "; "));
    append(phrase, {"."});
  }
  if (!told.choice.empty())
    append(phrase, {" No combination of the choices keeps all limits; " +
                    choice_words(told.choice) + " comes nearest."});
  return phrase;
}

// If no limit and no end of a range helps alone.
Phrase joint_cure_sentence(const Explanation& told) {
  const auto loosened =
      std::ranges::count_if(told.limits, [](const RelaxationState& one) { return one.amount > 0; });
  if (loosened == 0)
    return {
        "No loosening of a single limit and no move of one end of a range was found to be enough."};
  return {
      "Loosening a single limit is not enough; the table shows how far several have to be "
      "loosened together."};
}

// The least that would make it possible.
Phrase cure_sentence(const Explanation& told) {
  std::vector<Phrase> least;
  for (const RelaxationState& one : told.limits)
    if (one.amount_alone > 0) {
      const double loosened = one.limit + (one.at_least ? -1 : 1) * one.amount_alone;
      least.push_back({limit_part(one.text), " by ", value_part(one.amount_alone, one.unit, 3)});
      if (!one.of_two_sides)
        append(least.back(), {", to ", named_part(one.metric, loosened, one.unit, 3)});
    }
  for (const RangeState& end : told.ranges)
    if (!std::isnan(end.limit_alone)) {
      least.push_back({"the range of "});
      append(least.back(), end_phrase(end.variable.name, !end.upper, end.limit, end.variable.unit));
      append(least.back(), {", to ", value_part(end.limit_alone, end.variable.unit, 3)});
    }
  if (least.empty()) return joint_cure_sentence(told);
  Phrase phrase{least.size() == 1 ? "It would be possible with this limit loosened: "
                                  : "It would be possible with one of these limits loosened: "};
  for (std::size_t i = 0; i < least.size(); ++i) {
    if (i > 0) append(phrase, {"; or "});
    append(phrase, least[i]);
  }
  append(phrase, {"."});
  return phrase;
}

// How many of the points are shown to be compromises.
Phrase front_sentence(const ParetoResult& answer) {
  const auto certified = static_cast<std::size_t>(std::ranges::count_if(
      answer.front, [](const auto& point) { return point.report.certificate.passed; }));
  const std::size_t count = answer.front.size();
  const std::string best = " can be improved in one goal without loss in another.";
  if (certified == count)
    return {strong(std::to_string(count)),
            (count == 1 ? " best compromise, which" : " best compromises: none of them") +
                (count == 1 ? " cannot be improved in one goal without loss in another." : best)};
  Phrase phrase{strong(std::to_string(count)), count == 1 ? " compromise" : " compromises"};
  if (certified == 0)
    append(phrase, {", not certified: it is not shown that a goal cannot be improved without loss "
                    "in another."});
  else
    append(phrase, {", " + std::to_string(certified) + " of them certified: none of these" + best});
  return phrase;
}

// What the next points on both sides of the knee give and take.
Phrase trade_phrase(const ParetoResult& answer, std::size_t i) {
  if (answer.goals.size() != 2)
    return {" Away from it, a small gain in one goal costs much of the other."};
  const auto differs = [&](std::size_t k, std::size_t goal) -> Phrase {
    const double by = answer.front[k].goals[goal] - answer.front[i].goals[goal];
    return {goal_part(answer.goals[goal], std::fabs(by), 3), by > 0 ? " more " : " less ",
            name_part(answer.goals[goal].metric)};
  };
  Phrase phrase{" The next point"};
  for (const std::size_t k : {i - 1, i + 1}) {
    if (k >= answer.front.size()) continue;  // before the first one, too
    if (k == i + 1 && i > 0) append(phrase, {", the next on the other side"});
    append(phrase, {" has "});
    append(phrase, differs(k, 0));
    append(phrase, {" and "});
    append(phrase, differs(k, 1));
  }
  append(phrase, {"."});
  return phrase;
}

Phrase knee_sentence(const ParetoResult& answer) {
  if (answer.has_knee()) {
    Phrase phrase{"The knee has "};
    append(phrase, point_phrase(answer, answer.knee));
    append(phrase, {"."});
    append(phrase, trade_phrase(answer, answer.knee));
    return phrase;
  }
  if (answer.front.size() == 1) {
    Phrase phrase{"It has "};
    append(phrase, point_phrase(answer, 0));
    append(phrase, {"; no design was found that is better in one goal alone."});
    return phrase;
  }
  Phrase phrase{"The front has no knee, because it bends the other way. It runs from "};
  append(phrase, point_phrase(answer, answer.ends.front()));
  append(phrase, {" to "});
  append(phrase, point_phrase(answer, answer.ends.back()));
  append(phrase, {"."});
  return phrase;
}

Headline no_front(const ParetoResult& answer) {
  if (!answer.largest_yield)
    return {Look::bad, "", {{strong("No point of the front was found.")}}, {}};
  Phrase second{"At the design of the largest one "};
  append(second, yield_phrase(*answer.largest_yield));
  append(second, {" Tighten a tolerance or loosen a limit."});
  return {Look::bad, "", {{strong("The required yield cannot be reached.")}, second}, {}};
}

}  // namespace

Phrase point_phrase(const ParetoResult& answer, std::size_t i) {
  Phrase phrase;
  for (std::size_t k = 0; k < answer.goals.size(); ++k) {
    if (k > 0) append(phrase, {" with "});
    append(phrase, {strong(name_part(answer.goals[k].metric)), strong(" "),
                    strong(goal_part(answer.goals[k], answer.front[i].goals[k], 3))});
  }
  return phrase;
}

Headline relaxation_headline(const Explanation& explanation) {
  return {Look::bad, "", {cause_sentence(explanation), cure_sentence(explanation)}, {}};
}

Headline headline_of(const OptimizeResult& answer, const StudyResult& result) {
  if (!answer.found) {
    const char* none = result.outcome == StudyOutcome::budget
                           ? "The search ended before it found a design with a value."
                           : "No design could be evaluated.";
    return {Look::bad, "", {{strong(none)}}, {}};
  }
  if (!answer.explanation.empty()) return relaxation_headline(answer.explanation);
  const Phrase second = answer.robust ? robust_sentence(*answer.robust) : stop_sentence(answer);
  return {result.outcome == StudyOutcome::optimal ? Look::good : Look::bad,
          "",
          {best_sentence(answer), second},
          {}};
}

Headline headline_of(const ParetoResult& answer, const StudyResult& result) {
  if (!answer.explanation.empty()) return relaxation_headline(answer.explanation);
  if (answer.front.empty()) return no_front(answer);
  return {result.outcome == StudyOutcome::optimal ? Look::good : Look::bad,
          "",
          {front_sentence(answer), knee_sentence(answer)},
          {}};
}

}  // namespace twum::inline v0_1::studies::telling
