// SPDX-License-Identifier: Apache-2.0
#include "results/search_words.hpp"
#include "results/standings.hpp"
#include "telling/curve_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/limit_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace twum::inline v0_1::studies::telling {
namespace {

using FrontPoint = ParetoResult::Point;

std::string number_of(std::size_t point) { return std::to_string(point + 1); }

// The values of a goal; those of a metric stand in summary.json.
Numbers goal_numbers(const ParetoResult& answer, std::size_t goal) {
  const std::string& name = answer.goals[goal].metric;
  const bool metric = !std::isnan(value_of(answer.front.front().report.metrics, name));
  Numbers numbers{metric && name.find('/') == std::string::npos ? "front/*/metrics/" + name : "",
                  {}};
  for (const FrontPoint& point : answer.front) numbers.values.push_back(point.goals[goal]);
  return numbers;
}

Chart trade_chart(const ParetoResult& answer, std::size_t k, std::size_t l) {
  const Goal &across = answer.goals[k], &up = answer.goals[l];
  Chart chart{answer.goals.size() == 2 ? "front" : "front " + number_of(k) + " " + number_of(l),
              {name_part(across.metric), " against ", name_part(up.metric)},
              goal_axis(across),
              goal_axis(up)};
  chart.series = {{"", Stroke::dots, goal_numbers(answer, k), goal_numbers(answer, l)}};
  for (std::size_t i = 0; i < answer.front.size(); ++i)
    if (const Phrase role = role_phrase(answer, i); !role.empty())
      chart.marks.push_back({answer.front[i].goals[k], answer.front[i].goals[l], role, "c0"});
  return chart;
}

Section trade(const ParetoResult& answer, std::size_t k, std::size_t l) {
  Section section{{"Trade-off"}, {"Each point is a compromise."}};
  section.hook = "choose";
  section.wide = answer.goals.size() == 2;
  section.charts = {trade_chart(answer, k, l)};
  return section;
}

// "yield >= 99 % holds at 20 of 20 points, checked with new random motors of each."
void add_yields(std::vector<Phrase>& list, const ParetoResult& answer, const std::string& of) {
  const std::vector<RobustYield>& first = answer.front.front().yields;
  for (std::size_t s = 0; s < first.size(); ++s) {
    if (first[s].verdict.empty()) continue;
    const auto holds = std::ranges::count_if(
        answer.front, [s](const FrontPoint& point) { return point.yields[s].verdict == "holds"; });
    list.push_back(
        {name_part(first[s].text), " ≥ ", share_part(first[s].target),
         " holds at " + std::to_string(holds) + of + ", checked with new random motors of each."});
  }
}

// The share of the front on which each set is the best.
void add_choices(std::vector<Phrase>& list, const ParetoResult& answer, const std::string& of) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (const FrontPoint& point : answer.front)
    for (const ChosenSet& one : point.report.choice) ++counts[{one.choice, one.set}];
  for (const auto& [chosen, count] : counts)
    list.push_back({name_part(chosen.first),
                    " is " + printable(chosen.second) + " at " + std::to_string(count) + of + "."});
}

// Limits and ends of ranges that bind somewhere.
void add_binding(std::vector<Phrase>& list, const ParetoResult& answer, const std::string& of) {
  const auto add = [&](Part name, const char* words, auto&& binds) {
    if (const auto count = std::ranges::count_if(answer.front, binds); count > 0)
      list.push_back({std::move(name), words + std::to_string(count) + of + "."});
  };
  const DesignReport& first = answer.front.front().report;
  for (std::size_t i = 0; i < first.constraints.size(); ++i)
    add(limit_part(first.constraints[i].text), " binds at ",
        [i](const FrontPoint& point) { return point.report.constraints[i].active; });
  for (const NamedValue& variable : first.design)
    add(name_part(variable.name), " is at an end of its range at ", [&](const FrontPoint& point) {
      return std::ranges::any_of(point.report.bounds, [&](const BoundState& bound) {
        return bound.variable.name == variable.name;
      });
    });
}

bool changes(const Numbers& numbers) {
  constexpr double kRounding = 1e-6;
  const auto [low, high] = std::ranges::minmax(numbers.values);
  return high - low > kRounding * std::fabs(high);
}

// The variables of the points, which all points have in this order.
std::vector<Parallel::Quantity> variables_of(const ParetoResult& answer) {
  std::vector<Parallel::Quantity> list;
  const auto is_goal = [&](const NamedValue& one) {
    return std::ranges::find(answer.goals, one.name, &Goal::metric) != answer.goals.end();
  };
  for (const NamedValue& one : answer.front.front().report.design) {
    if (is_goal(one)) continue;
    list.push_back({{name_part(one.name)}, one.unit, {"front/*/design/" + one.name, {}}});
    for (const FrontPoint& point : answer.front)
      list.back().values.values.push_back(value_of(point.report.design, one.name));
  }
  return list;
}

Section along(const ParetoResult& answer) {
  Section section{
      {"Along the front"},
      {"The variables over the first goal; then a line for each point, through its goals and "
       "variables."}};
  section.hook = "along";
  section.picture = "along-the-front";
  section.parallel.name = "parallel";
  for (std::size_t k = 0; k < answer.goals.size(); ++k)
    section.parallel.axes.push_back(
        {{name_part(answer.goals[k].metric)}, answer.goals[k].unit, goal_numbers(answer, k)});
  for (Parallel::Quantity& variable : variables_of(answer)) {
    Chart chart{"along " + written(variable.name, Writing::read),
                variable.name,
                goal_axis(answer.goals.front()),
                {variable.name, variable.unit}};
    chart.series = {{"", Stroke::dots, goal_numbers(answer, 0), variable.values}};
    if (!changes(variable.values)) continue;
    section.charts.push_back(std::move(chart));
    section.parallel.axes.push_back(std::move(variable));
  }
  const std::string of = " of " + counted(answer.front.size(), "point");
  add_yields(section.remarks, answer, of);
  for (Phrase& phrase : parts_sentence(answer.parts, answer.part_count))
    section.remarks.push_back(std::move(phrase));
  add_choices(section.remarks, answer, of);
  add_binding(section.remarks, answer, of);
  return section;
}

// The knee first.
std::vector<std::size_t> known_points(const ParetoResult& answer) {
  std::vector<std::size_t> points;
  if (answer.has_knee()) points.push_back(answer.knee);
  for (const std::size_t end : std::set(answer.ends.begin(), answer.ends.end()))
    points.push_back(end);
  return points;
}

Phrase cell_of(const Goal& goal, double value) { return {goal_part(goal, value)}; }

// Ends and knee side by side: goals first, then the design.
Section ends(const ParetoResult& answer) {
  Section section{{"Knee and ends"}};
  Table table{"ends", {{""}}, {}};
  const std::vector<std::size_t> points = known_points(answer);
  const auto add = [&](Phrase name, auto&& cell) {
    table.rows.push_back({std::move(name)});
    for (const std::size_t i : points) table.rows.back().push_back(cell(answer.front[i]));
  };
  for (const std::size_t i : points) table.heads.push_back(role_phrase(answer, i));
  for (std::size_t k = 0; k < answer.goals.size(); ++k)
    add({name_part(answer.goals[k].metric)},
        [&](const FrontPoint& point) { return cell_of(answer.goals[k], point.goals[k]); });
  const FrontPoint& first = answer.front.front();
  for (std::size_t s = 0; s < first.yields.size(); ++s)
    if (!first.yields[s].verdict.empty())
      add({name_part(first.yields[s].text), ", new random motors"},
          [&](const FrontPoint& point) { return Phrase{share_part(point.yields[s].share.value)}; });
  for (std::size_t c = 0; c < first.report.choice.size(); ++c)
    add({name_part(first.report.choice[c].choice)},
        [&](const FrontPoint& point) { return Phrase{printable(point.report.choice[c].set)}; });
  for (const NamedValue& variable : first.report.design)
    add({name_part(variable.name)}, [&](const FrontPoint& point) {
      return Phrase{
          named_part(variable.name, value_of(point.report.design, variable.name), variable.unit)};
    });
  section.tables = {table};
  return section;
}

// The limits at a point and the goals that they hold back: at an end of the front its own goal alone, elsewhere each goal,
// with the others held where they are.
struct Held {
  std::vector<Goal> goals;
  Json standings;
};

std::vector<Held> held_at(const ParetoResult& answer, std::size_t i) {
  std::vector<Held> list;
  for (std::size_t k = 0; k < answer.single_goal_ends.size(); ++k)
    if (answer.ends[k] == i)
      list.push_back(
          {{answer.goals[k]}, standings_json(answer.single_goal_ends[k], {answer.goals[k]})});
  if (list.empty())
    list.push_back({answer.goals, standings_json(answer.front[i].report, answer.goals)});
  return list;
}

const char* others_words(const ParetoResult& answer) {
  return answer.goals.size() == 2 ? "with the other goal unchanged"
                                  : "with the other goals unchanged";
}

Phrase stopped_name(const Held& held) {
  if (held.goals.size() > 1) return {"this point"};
  Phrase phrase{"the "};
  append(phrase, goal_name(held.goals[0]));
  return phrase;
}

Section stops(const ParetoResult& answer, std::size_t i, const Sources& sources) {
  Section section{{"Limits at the "}};
  append(section.heading, role_phrase(answer, i));
  section.note = point_phrase(answer, i);
  section.wide = false;
  const DesignReport& report = answer.front[i].report;
  if (report.certificate.weights.empty()) {
    section.sentences = {
        {"This front was computed without derivatives, so the effect of its limits is unknown."}};
    return section;
  }
  for (const Held& held : held_at(answer, i)) {
    std::vector<Phrase> phrases =
        holder_phrases(held.standings, held.goals, report, whole_ends_of(report, sources), sources);
    if (phrases.empty()) {
      section.sentences.push_back({"No limit restricts "});
      append(section.sentences.back(), stopped_name(held));
      append(section.sentences.back(), {"."});
    }
    std::ranges::move(phrases, std::back_inserter(section.remarks));
  }
  return section;
}

Section as_table(const ParetoResult& answer) {
  Section section{{"The front as a table"}};
  const DesignReport& first = answer.front.front().report;
  Table table{"front", {{"point"}}, {}};
  for (const Goal& goal : answer.goals) table.heads.push_back({name_part(goal.metric)});
  for (const ChosenSet& one : first.choice) table.heads.push_back({name_part(one.choice)});
  for (const NamedValue& variable : first.design) table.heads.push_back({name_part(variable.name)});
  for (std::size_t i = 0; i < answer.front.size(); ++i) {
    const FrontPoint& point = answer.front[i];
    Phrase name{number_of(i)};
    if (const Phrase role = role_phrase(answer, i); !role.empty()) {
      append(name, {" ("});
      append(name, role);
      append(name, {")"});
    }
    std::vector<Phrase> row{name};
    for (std::size_t k = 0; k < answer.goals.size(); ++k)
      row.push_back(cell_of(answer.goals[k], point.goals[k]));
    for (const ChosenSet& one : point.report.choice) row.push_back({printable(one.set)});
    for (const NamedValue& variable : first.design)
      row.push_back(
          {named_part(variable.name, value_of(point.report.design, variable.name), variable.unit)});
    table.rows.push_back(std::move(row));
  }
  section.tables = {table};
  return section;
}

Section limits_at(const ParetoResult& answer, const Held& held, bool alone) {
  Section section{{alone ? "Limits" : "Limits at "}};
  if (!alone) append(section.heading, stopped_name(held));
  section.note = held.goals.size() > 1
                     ? Phrase{std::string("Change of one goal or the other if an active limit is "
                                          "loosened by 1 %, to first order, ") +
                              others_words(answer) + "."}
                     : Phrase{
                           "Changes that would improve this end of the front further, without "
                           "regard to the other goals, to first order."};
  section.tables = {limits_table(held.standings, held.goals)};
  return section;
}

}  // namespace

Phrase role_phrase(const ParetoResult& answer, std::size_t point) {
  Phrase phrase;
  for (std::size_t k = 0; k < answer.ends.size(); ++k) {
    if (answer.ends[k] != point) continue;
    if (!phrase.empty()) append(phrase, {", "});
    append(phrase, goal_name(answer.goals[k]));
  }
  if (answer.has_knee() && answer.knee == point)
    append(phrase, {phrase.empty() ? "knee" : ", knee"});
  return phrase;
}

namespace {

// The torque of a point, with its limits.
std::vector<Chart> point_charts(const ParetoResult& answer, std::size_t i, const Sources& sources) {
  if (sources.curves == nullptr) return {};
  const auto found = std::ranges::find(*sources.curves, i, &MotorCurve::place);
  if (found == sources.curves->end()) return {};
  Chart chart = torque_chart({&*found, 1}, curve_limits(answer.front[i].report, answer.goals));
  chart.title = {"torque of point " + number_of(i)};
  return {chart};
}

// The motors at the ends of the front and at its knee.
std::vector<Section> known_curves(const ParetoResult& answer, const Sources& sources) {
  if (sources.curves == nullptr) return {};
  std::vector<MotorCurve> known = *sources.curves;
  std::erase_if(known,
                [&](const MotorCurve& curve) { return role_phrase(answer, curve.place).empty(); });
  const Sources of{sources.study, sources.rows, &known};
  std::vector<Section> list = torque_sections({"Motors of the front"}, of);
  std::ranges::move(curve_sections(of), std::back_inserter(list));
  return list;
}

}  // namespace

std::vector<Section> point_sections(const ParetoResult& answer, std::size_t i,
                                    const Sources& sources) {
  const FrontPoint& point = answer.front[i];
  Section head{{"Point " + number_of(i)}};
  if (const Phrase role = role_phrase(answer, i); !role.empty()) {
    append(head.heading, {": "});
    append(head.heading, role);
  }
  Phrase said;
  for (const ChosenSet& one : point.report.choice)
    append(said, {name_part(one.choice), " " + printable(one.set) + ", "});
  append(said, point_phrase(answer, i));
  append(said, {". "});
  for (const RobustYield& yield : point.yields) {
    append(said, yield_phrase(yield));
    append(said, {" "});
  }
  append(said, certificate_phrase(point.report, ""));
  head.sentences = {said};
  head.charts = point_charts(answer, i, sources);
  head.tables = {design_table("point-" + number_of(i), "this point", point.report,
                              answer.before_design, sources)};
  Section metrics{{"Metrics"}, efficiency_note(point.report.metrics)};
  metrics.tables = {metrics_table("point-metrics-" + number_of(i), "this point", point.report,
                                  answer.before_metrics)};
  std::vector<Section> list{head, metrics};
  for (const Held& held : held_at(answer, i))
    if (!held.standings.empty()) list.push_back(limits_at(answer, held, held.goals.size() > 1));
  return list;
}

std::vector<Section> sections_of(const ParetoResult& answer, const Sources& sources) {
  if (answer.front.empty()) return relaxation_sections(answer.explanation);
  std::vector<Section> list = relaxation_sections(answer.explanation);
  for (std::size_t k = 0; k < answer.goals.size(); ++k)
    for (std::size_t l = k + 1; l < answer.goals.size(); ++l) list.push_back(trade(answer, k, l));
  list.push_back(hooked("chosen"));
  list.push_back(along(answer));
  std::ranges::move(known_curves(answer, sources), std::back_inserter(list));
  for (const std::size_t i : known_points(answer)) list.push_back(stops(answer, i, sources));
  list.push_back(ends(answer));
  list.push_back(as_table(answer));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
