// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"
#include "results/standings.hpp"
#include "telling/curve_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/limit_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/words.hpp>
#include <twum/optim/solvers.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace twum::inline v0_1::studies::telling {
namespace {

// Where no design keeps all limits there is no optimum, so a limit has no price.
Section limits_least_violated(const Json& standings) {
  Section section{{"Limits at the design that violates them least"}};
  section.tables = {limits_table(standings, {})};
  return section;
}

Section limits(const OptimizeResult& answer, const Json& standings, const Sources& sources) {
  const Goal goal = priced_goal(answer);
  Section section{{"Limits"},
                  {"An active limit restricts the design. The table gives the change of the ",
                   name_part(goal.metric),
                   " if it is loosened by 1 %, to first order, with all variables optimized again. "
                   "The other limits have a margin."}};
  if (answer.robust)
    append(section.note, {" A limit that binds under the tolerances has room at the design itself, "
                          "which some of the motors need."});
  section.remarks = holder_phrases(standings, {goal}, answer.best, answer.whole_ends, sources);
  section.tables = {limits_table(standings, {goal})};
  return section;
}

std::string design_title(const OptimizeResult& answer) {
  return answer.explanation.empty() ? "best" : "this design";
}

Section design(const OptimizeResult& answer, const Sources& sources) {
  Section section{{"Design"},
                  {answer.explanation.empty() ? "The variables of the search."
                                              : "The design that violates the limits least."}};
  section.wide = false;
  section.hook = "motor file";
  section.tables = {
      design_table("design", design_title(answer), answer.best, answer.before_design, sources)};
  return section;
}

Section metrics(const OptimizeResult& answer) {
  Section section{{"Metrics"}, efficiency_note(answer.best.metrics)};
  section.wide = false;
  section.tables = {
      metrics_table("metrics", design_title(answer), answer.best, answer.before_metrics)};
  return section;
}

using Stage = optim::StageReport;

// The runs with as many slices as the last one, which found the answer; values of others differ by their slices' error.
struct Runs {
  std::vector<const Stage*> comparable;
  std::size_t before{0};
  int slices_before{0};
};

Runs runs_of(const OptimizeResult& answer) {
  Runs runs;
  const auto slices = [&](std::size_t i) {
    return answer.slices_of_stages.empty() ? 0 : answer.slices_of_stages[i];
  };
  std::size_t last = 0;
  for (std::size_t i = 0; i < answer.stages.size(); ++i)
    if (!answer.stages[i].solver.empty()) last = i;
  for (std::size_t i = 0; i < answer.stages.size(); ++i) {
    if (answer.stages[i].solver.empty()) continue;
    if (slices(i) == slices(last))
      runs.comparable.push_back(&answer.stages[i]);
    else
      ++runs.before, runs.slices_before = slices(i);
  }
  return runs;
}

bool is_global(const Stage* run) {
  const auto solvers = optim::solvers();
  const auto known = std::ranges::find(solvers, run->solver, &optim::SolverInfo::name);
  return known != solvers.end() && known->global;
}

// How many runs came to the best value.
std::string runs_words(const OptimizeResult& answer, const Runs& runs, bool holding) {
  const std::string alike = answer.stages.size() > 1 ? " with the slices of the answer" : "";
  if (runs.comparable.size() == 1) return "the single solver run" + alike + " ended there";
  constexpr double kSame = 1e-6;
  const double best = goal_of(answer.best, answer.goal);
  const auto same = std::ranges::count_if(runs.comparable, [&](const Stage* run) {
    return run->feasible && std::fabs(run->objective - best) <= kSame * std::fabs(best);
  });
  const auto wide = std::ranges::count_if(runs.comparable, is_global);
  const std::string choosing = !holding                     ? ""
                               : answer.best.choice.empty() ? " and whole numbers"
                                                            : " and choices";
  return std::to_string(same) + " of " + std::to_string(runs.comparable.size()) +
         " solver runs from different starts" + choosing +
         " ended at this value, and none found a better one within the limits" +
         (wide == 0   ? ""
          : wide == 1 ? ", one of them a global search"
                      : ", " + std::to_string(wide) + " of them a global search");
}

// How far "local" can be trusted.
std::vector<Phrase> starts_phrase(const OptimizeResult& answer) {
  const Runs runs = runs_of(answer);
  if (runs.comparable.empty() || std::isnan(goal_of(answer.best, answer.goal))) return {};
  const std::vector<Part> held = held_parts(answer.best);
  Phrase phrase{"It is a local optimum: " + runs_words(answer, runs, !held.empty())};
  if (runs.before > 0)
    append(phrase, {"; " + counted(runs.before, "run") + " with ", name_part("radial_slices"), " ",
                    named_part("radial_slices", runs.slices_before, "1"),
                    " came first, to find a start: their values have another discretization "
                    "error, so do not compare them with this one"});
  append(phrase, {". A better design far from all of them is still possible."});
  if (held.empty()) return {phrase};
  append(phrase, {" Each run keeps "});
  append(phrase, listed(held));
  append(phrase,
         {held.size() > 1 ? " unchanged; the effect of the limits above is for the values found."
                          : " unchanged; the effect of the limits above is for the value found."});
  return {phrase};
}

// The result of the search for a better local optimum, which is not a proof.
std::vector<Phrase> scan_phrase(const OptimizeResult& answer) {
  const optim::Scan& scan = answer.scan;
  if (scan.designs == 0) return {};
  const std::string sample = counted(scan.designs, "design") + " sampled over the whole range" +
                             (answer.best.constraints.empty()
                                  ? ""
                                  : " (" + std::to_string(scan.feasible) + " keep the limits)");
  if (scan.better == 0) return {{"None of " + sample + " is better."}};
  const std::string some = std::to_string(scan.better) + " of " + sample;
  if (scan.replaced)
    return {{some + " were better than the ", goal_part_of(answer.goal, scan.before),
             " of the searches; a search from the best of them found this design."}};
  return {{some + " are better, but the search from the best of them found no answer; raise "
                  "max_evaluations, or start from that row of results.csv."}};
}

// @param ways  independent directions of the same variables
Phrase finding_phrase(const optim::Finding& finding, std::ptrdiff_t ways) {
  const std::vector<Part> names = name_parts(finding.names);
  Phrase phrase{finding.kind == optim::Degeneracy::flat_direction ? "Flat direction: "
                                                                  : finding.text};
  phrase = capitalized(std::move(phrase));
  if (finding.kind == optim::Degeneracy::flat_direction) {
    append(phrase, listed(names));
    append(phrase, {std::string(names.size() > 1 ? " can change together" : " can change") +
                    (ways > 1 ? " in " + std::to_string(ways) + " independent ways" : "") +
                    " without changing the answer; this design is one of many."});
    return phrase;
  }
  if (!names.empty()) {
    append(phrase, {": "});
    append(phrase, listed(names));
  }
  append(phrase, {"."});
  return phrase;
}

// How sure it is that there is nothing better.
Section trust(const OptimizeResult& answer) {
  Section section{{"Verification"}};
  std::vector<Phrase>& list = section.sentences;
  const auto add = [&](std::vector<Phrase> more) {
    std::ranges::move(more, std::back_inserter(list));
  };
  const Goal goal = priced_goal(answer);
  list.push_back(certificate_phrase(answer.best, is_share(goal) ? "" : goal.unit));
  if (goal.metric != answer.goal.metric)
    list.push_back({"The search made the yield as large as possible, in place of the goal."});
  if (answer.best.certificate.passed && !answer.robust) add(starts_phrase(answer));
  add(scan_phrase(answer));
  if (!answer.without_influence.empty()) {
    list.push_back({"To first order, neither the goal nor an active limit depends here on "});
    append(list.back(), listed(name_parts(answer.without_influence), " or "));
    append(list.back(), {"."});
  }
  const std::vector<optim::Finding>& findings = answer.best.certificate.findings;
  for (auto finding = findings.begin(); finding != findings.end(); ++finding) {
    const auto is_alike = [&](const optim::Finding& other) {
      return other.kind == finding->kind && other.names == finding->names;
    };
    if (std::none_of(findings.begin(), finding, is_alike))
      list.push_back(finding_phrase(*finding, std::ranges::count_if(findings, is_alike)));
  }
  return section;
}

// The range in which the search went on: that of the motors that keep the limits, the worst tenth of them aside, or
// of the middle half of all if fewer than ten keep them; with the best so far.
std::pair<double, double> search_range(const std::vector<double>& values,
                                       const std::vector<bool>& keeps,
                                       const std::vector<double>& records, bool maximize) {
  constexpr std::size_t kFew = 10;
  std::vector<double> kept, all, ends = records;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    all.push_back(values[i]);
    if (keeps[i]) kept.push_back(values[i]);
  }
  std::ranges::sort(all);
  std::ranges::sort(kept);
  if (kept.size() < kFew) {
    ends.insert(ends.end(), kept.begin(), kept.end());
    ends.insert(ends.end(), {all[all.size() / 4], all[3 * all.size() / 4]});
  } else {
    const std::size_t tenth = kept.size() / 10;
    ends.push_back(kept[maximize ? tenth : kept.size() - 1 - tenth]);
  }
  const auto [low, high] = std::ranges::minmax_element(ends);
  const double pad = 0.09 * (*high > *low ? *high - *low : std::fabs(*high));
  return {*low - pad, *high + pad};
}

// The motors in the order in which they were computed: those that keep the limits, those that do not, and the best so far.
struct History {
  Numbers inside_x, inside_y, outside_x, outside_y, best_x, best_y;
  std::size_t beyond{0};  // of the axis, at whose edge they stand
};

History history_of(const std::vector<double>& values, const std::vector<bool>& keeps,
                   const Goal& goal, Axis& axis) {
  History history;
  double best = std::nan("");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool worse = goal.maximize ? values[i] <= best : values[i] >= best;
    if (!keeps[i] || !std::isfinite(values[i]) || worse) continue;
    best = values[i];
    history.best_x.values.push_back(static_cast<double>(i + 1));
    history.best_y.values.push_back(best);
  }
  if (std::isfinite(best)) {
    history.best_x.values.push_back(static_cast<double>(values.size()));
    history.best_y.values.push_back(best);
  }
  std::tie(axis.low, axis.high) = search_range(values, keeps, history.best_y.values, goal.maximize);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    history.beyond += values[i] < axis.low || values[i] > axis.high ? 1 : 0;
    (keeps[i] ? history.inside_x : history.outside_x).values.push_back(static_cast<double>(i + 1));
    (keeps[i] ? history.inside_y : history.outside_y)
        .values.push_back(std::clamp(values[i], axis.low, axis.high));
  }
  return history;
}

std::vector<Section> search(const OptimizeResult& answer, const Json& standings,
                            const ResultStore& rows) {
  const std::vector<double> values = column_values(rows, answer.goal.metric);
  if (values.size() < 2 || std::ranges::none_of(values, [](double v) { return std::isfinite(v); }))
    return {};
  Chart chart{"search",
              {"course of the search"},
              {{"evaluation"}, "1", false, 1, static_cast<double>(values.size())},
              goal_axis(answer.goal)};
  const History history = history_of(values, rows_that_keep(rows, standings), answer.goal, chart.y);
  // Limits hold without tolerances here, so the best of these motors is not the best under tolerances.
  const std::string kept =
      answer.robust ? "keeps every limit without tolerances" : "keeps every limit";
  chart.series = {{"violates a limit", Stroke::dots, history.outside_x, history.outside_y, "faint"},
                  {kept, Stroke::dots, history.inside_x, history.inside_y, "c2"}};
  if (!answer.robust)
    chart.series.push_back({"best so far", Stroke::steps, history.best_x, history.best_y});
  Section section{{"Course of the search"}, {"All computed motors, in order."}};
  if (const std::string count = std::to_string(history.beyond); history.beyond > 0) {
    append(section.note, {" " + count + " of them lie beyond the axis and are drawn at its edge."});
    append(chart.title, {"; " + count + " beyond the axis are drawn at its edge"});
  }
  section.charts = {chart};
  return {section};
}

std::vector<Section> runs(const OptimizeResult& answer) {
  if (answer.stages.empty()) return {};
  Section section{{"Solver runs"},
                  {"Each solver run, with its stage in results.csv and its return code."}};
  const bool sliced = !answer.slices_of_stages.empty();
  const Goal goal = priced_goal(answer);
  Table table{"starts",
              {{"stage"},
               {"solver"},
               {"return code"},
               {name_part(goal.metric)},
               {"keeps limits"},
               {"evaluations"}},
              {}};
  if (sliced) table.heads.push_back({name_part("radial_slices")});
  table.typed = table.heads.size();
  for (std::size_t i = 0; i < answer.stages.size(); ++i) {
    const Stage& run = answer.stages[i];
    table.rows.push_back({{std::to_string(run.stage)},
                          {run.solver.empty() ? "-" : run.solver},
                          {run.word.empty() ? "-" : run.word},
                          {goal_part_of(goal, run.objective)},
                          {run.feasible ? good("yes") : bad("no")},
                          {count_part(run.evaluations)}});
    if (sliced)
      table.rows.back().push_back({named_part("radial_slices", answer.slices_of_stages[i], "1")});
  }
  if (!answer.solver.empty())
    section.sentences = {{"The answer was found by " + answer.solver + "."}};
  section.tables = {table};
  return {section};
}

}  // namespace

std::vector<Section> sections_of(const OptimizeResult& answer, const Sources& sources) {
  std::vector<Section> list;
  const auto add = [&](std::vector<Section> more) {
    std::ranges::move(more, std::back_inserter(list));
  };
  if (!answer.found) {
    add(torque_sections({"Torque of the original motor"}, sources));
    add(curve_sections(sources));
    return list;
  }
  const Json standings = standings_json(answer.best, {priced_goal(answer)});
  const std::vector<CurveLimit> on_curves = curve_limits(answer.best, {answer.goal});
  add(torque_sections({"Torque: before and after"}, sources, on_curves));
  add(relaxation_sections(answer.explanation));
  if (!standings.empty())
    list.push_back(answer.explanation.empty() ? limits(answer, standings, sources)
                                              : limits_least_violated(standings));
  if (answer.robust) add(robust_sections(*answer.robust, answer.goal));
  add({design(answer, sources), metrics(answer)});
  if (answer.explanation.empty()) {
    list.push_back(trust(answer));
    add(moves_sections(answer.moving, answer.moves, answer.goal.metric, answer.unmoved, sources,
                       answer.touching));
  }
  add(curve_sections(sources, on_curves));
  if (sources.rows != nullptr) add(search(answer, standings, *sources.rows));
  add(runs(answer));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
