// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"
#include "results/search_words.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace twum::studies {
namespace {

struct Shown {
  std::string title;
  const ParetoResult::Point* point;
};

// The ends and the knee, each with its title.
std::vector<Shown> shown(const ParetoResult& result) {
  std::vector<Shown> list;
  for (std::size_t k = 0; k < result.ends.size(); ++k)
    list.push_back({goal_words(result.goals[k]), &result.front[result.ends[k]]});
  if (result.has_knee()) list.push_back({"knee", &result.front[result.knee]});
  return list;
}

std::string goal_text(const Goal& goal, double value) {
  return is_share(goal) ? percent_words(value) : engineering(value, goal.unit);
}

// Ends and knee side by side: goals first, then design variables.
std::string front_table(const ParetoResult& result) {
  const std::vector<Shown> columns = shown(result);
  TextTable table;
  table.rows.push_back({""});
  for (const Shown& column : columns) table.rows.back().push_back(column.title);
  for (std::size_t k = 0; k < result.goals.size(); ++k) {
    table.rows.push_back({result.goals[k].metric});
    for (const Shown& column : columns)
      table.rows.back().push_back(goal_text(result.goals[k], column.point->goals[k]));
  }
  for (std::size_t s = 0; s < columns.front().point->yields.size(); ++s) {
    if (columns.front().point->yields[s].verdict.empty()) continue;
    table.rows.push_back({columns.front().point->yields[s].text + ", new random motors"});
    for (const Shown& column : columns)
      table.rows.back().push_back(percent_words(column.point->yields[s].share.value));
  }
  const DesignReport& first = columns.front().point->report;
  for (std::size_t i = 0; i < first.choice.size(); ++i) {
    table.rows.push_back({first.choice[i].choice});
    for (const Shown& column : columns)
      table.rows.back().push_back(printable(column.point->report.choice[i].set));
  }
  for (const NamedValue& variable : first.design) {
    table.rows.push_back({variable.name});
    for (const Shown& column : columns) {
      const double value = value_of(column.point->report.design, variable.name);
      table.rows.back().push_back(
          std::isnan(value) ? "-" : parameter_text(variable.name, value, variable.unit));
    }
  }
  return aligned(table, kSummaryWidth);
}

// Fronts with at most this many points are listed; longer ones are in summary.json.
constexpr std::size_t kFewPoints = 12;

std::string point_text(const ParetoResult& result, std::size_t i) {
  std::string text = std::to_string(i + 1);
  if (result.has_knee() && i == result.knee) text += " (knee)";
  return text;
}

// Every point of a short front: goals first, then design variables.
std::string points_table(const ParetoResult& result) {
  if (result.front.size() > kFewPoints || result.front.size() <= shown(result).size()) return {};
  TextTable table{{{"point"}}};
  for (const Goal& goal : result.goals) table.rows.front().push_back(goal.metric);
  const DesignReport& first = result.front.front().report;
  for (const ChosenSet& one : first.choice) table.rows.front().push_back(one.choice);
  for (const NamedValue& variable : first.design) table.rows.front().push_back(variable.name);
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    const ParetoResult::Point& point = result.front[i];
    std::vector<std::string> row{point_text(result, i)};
    for (std::size_t k = 0; k < result.goals.size(); ++k)
      row.push_back(goal_text(result.goals[k], point.goals[k]));
    for (const ChosenSet& one : point.report.choice) row.push_back(printable(one.set));
    for (const NamedValue& variable : first.design)
      row.push_back(parameter_text(variable.name, value_of(point.report.design, variable.name),
                                   variable.unit));
    table.rows.push_back(std::move(row));
  }
  return "\n" + aligned(table, kSummaryWidth);
}

// A limit that is active at a point, and 1 % of it [SI].
struct Holder {
  std::string name;
  double multiplier;
  double step;
};

// The most valuable first.
std::vector<Holder> holders(const DesignReport& report) {
  std::vector<Holder> list;
  const auto add = [&](const std::string& name, const auto& state) {
    if (state.multiplier > 0)
      list.push_back(
          {name, state.multiplier, std::fabs(state.gain_per_percent / state.multiplier)});
  };
  for (const LimitState& limit : report.constraints) {
    if (limit.active) add(limit.text, limit);
  }
  for (const BoundState& bound : report.bounds)
    add(bound.variable.name + " " + end_words(bound), bound);
  std::stable_sort(list.begin(), list.end(), [](const Holder& a, const Holder& b) {
    return a.multiplier * a.step > b.multiplier * b.step;
  });
  return list;
}

// The value of 1 % of each limit at a point, one column for each goal.
std::string worth_table(const std::string& title, const DesignReport& report,
                        const std::vector<Goal>& goals) {
  TextTable table{{{title}}};
  for (const Goal& goal : goals) table.rows.front().push_back(goal.metric);
  for (const Holder& holder : holders(report)) {
    table.rows.push_back({holder.name});
    const std::vector<double> improvement = gains(holder.multiplier, report.certificate);
    for (std::size_t k = 0; k < goals.size(); ++k)
      table.rows.back().push_back(
          change_words((goals[k].maximize ? 1 : -1) * improvement[k] * holder.step, goals[k].unit));
  }
  return table.rows.size() > 1 ? "\n" + aligned(table) : std::string();
}

// At the knee, gains of one goal while the others stay; at an end, gains of its own goal only.
std::string worth_text(const ParetoResult& result) {
  if (result.single_goal_ends.empty()) return {};
  std::string text;
  if (result.has_knee())
    text += worth_table("per 1 % looser at the knee, one of", result.front[result.knee].report,
                        result.goals);
  for (std::size_t k = 0; k < result.single_goal_ends.size(); ++k)
    text += worth_table(
        std::string("per 1 % looser at the ") + (result.goals[k].maximize ? "largest" : "smallest"),
        result.single_goal_ends[k], {result.goals[k]});
  return text;
}

// The share of the front on which each set is the best.
std::string choice_counts(const ParetoResult& result) {
  std::map<std::string, std::size_t> counts;
  for (const ParetoResult::Point& point : result.front)
    for (const ChosenSet& one : point.report.choice)
      ++counts[one.choice + " is " + printable(one.set)];
  std::string text;
  for (const auto& [words, count] : counts)
    text += words + " at " + std::to_string(count) + " of " +
            counted(result.front.size(), "point") + ".\n";
  return text;
}

// Limits that bind somewhere, with the share of the front on which they do.
std::string binding_words(const ParetoResult& result) {
  std::string text;
  const std::string of = " of " + counted(result.front.size(), "point") + ".\n";
  const auto& limits = result.front.front().report.constraints;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto count = std::count_if(result.front.begin(), result.front.end(),
                                     [i](const auto& p) { return p.report.constraints[i].active; });
    if (count > 0) text += limits[i].text + " binds at " + std::to_string(count) + of;
  }
  for (const NamedValue& variable : result.front.front().report.design) {
    const auto count = std::count_if(result.front.begin(), result.front.end(), [&](const auto& p) {
      return std::any_of(p.report.bounds.begin(), p.report.bounds.end(),
                         [&](const BoundState& b) { return b.variable.name == variable.name; });
    });
    if (count > 0) text += variable.name + " is at a bound at " + std::to_string(count) + of;
  }
  return text;
}

Json yields_json(const std::vector<RobustYield>& yields) {
  Json json = Json::array();
  for (const RobustYield& yield : yields) json.push_back(robust_yield_json(yield));
  return json;
}

// "yield >= 99 % holds at 20 of 20 points."
std::string yields_words(const ParetoResult& result) {
  std::string text;
  const std::vector<RobustYield>& first = result.front.front().yields;
  for (std::size_t s = 0; s < first.size(); ++s) {
    if (first[s].verdict.empty()) continue;
    const auto holds =
        std::count_if(result.front.begin(), result.front.end(),
                      [s](const auto& point) { return point.yields[s].verdict == "holds"; });
    text += first[s].text + " >= " + percent_words(first[s].target) + " holds at " +
            std::to_string(holds) + " of " + counted(result.front.size(), "point") +
            ", by new random motors of each.\n";
  }
  return text;
}

}  // namespace

bool ParetoResult::has_knee() const {
  return !front.empty() && std::find(ends.begin(), ends.end(), knee) == ends.end();
}

Json answer_json(const ParetoResult& result) {
  Json json{{"objectives", Json::array()}, {"front", Json::array()}};
  for (const Goal& goal : result.goals) json["objectives"].push_back(goal_json(goal));
  for (const ParetoResult::Point& point : result.front) {
    json["front"].push_back(report_json(point.report));
    if (!point.yields.empty()) json["front"].back()["yields"] = yields_json(point.yields);
  }
  if (result.largest_yield) json["largest_yield"] = robust_yield_json(*result.largest_yield);
  json["knee"] = result.has_knee() ? Json(result.knee) : Json(nullptr);
  json["ends"] = result.ends;
  json["single_goal_ends"] = Json::array();
  for (const DesignReport& report : result.single_goal_ends)
    json["single_goal_ends"].push_back(limits_json(report));
  json["hypervolume"] = number_json(result.hypervolume);
  json["reference_point"] = result.reference_point;
  if (!result.explanation.empty()) json["relaxation"] = relaxation_json(result.explanation);
  json["before"] = {{"design", values_json(result.before_design)},
                    {"metrics", values_json(result.before_metrics)}};
  json["units"] = Json::object();
  add_units(json["units"], result.before_design);
  add_units(json["units"], result.before_metrics);
  if (!result.front.empty()) add_units(json["units"], result.front.front().report.statistics);
  return json;
}

std::string answer_text(const ParetoResult& result) {
  if (!result.explanation.empty()) return relaxation_tables(result.explanation);
  if (result.front.empty()) return {};
  return front_table(result) + points_table(result) + "\n" + yields_words(result) +
         choice_counts(result) + binding_words(result) + worth_text(result);
}

}  // namespace twum::studies
