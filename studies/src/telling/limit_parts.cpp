// SPDX-License-Identifier: Apache-2.0
#include "telling/limit_parts.hpp"

#include "results/robust_answer.hpp"
#include "results/search_words.hpp"
#include "telling/goal_parts.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/motor_limit.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

double number(const Json& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

bool is_limit(const std::string& text) {
  try {
    parse_limit(text);
    return true;
  } catch (const ValueError&) {
    return false;  // one that the others imply
  }
}

Phrase standing_name(const Json& standing) {
  const bool end = standing.contains("variable");
  if (!end && is_limit(standing["text"])) return {limit_part(standing["text"])};
  return end_phrase(standing[end ? "variable" : "metric"], standing["side"] == "at least",
                    standing["limit"], standing["unit"]);
}

// The same where there is room.
Phrase standing_phrase(const Json& standing) {
  Phrase phrase = standing_name(standing);
  if (standing.contains("variable"))
    append(phrase, {", the end of its range"});
  else if (!is_limit(standing["text"]))
    append(phrase, {", which the others imply"});
  return phrase;
}

// "peak power by +20 mW (+0.4 %)"
Phrase change_phrase(const Goal& goal, double by, double now) {
  Phrase phrase{name_part(goal.metric), " by ", strong(change(goal_part(goal, by, 3)))};
  if (now != 0 && std::isfinite(now) && !is_share(goal))
    append(phrase, {" (", change(share_part(by / std::fabs(now))), ")"});
  return phrase;
}

// The best value of a goal among the stored motors that keep the limits and have this value of a parameter; NaN: none.
double best_with(const std::string& name, double value, const Goal& goal, const Json& standings,
                 const Sources& sources) {
  double best = std::nan("");
  if (sources.rows == nullptr) return best;
  const std::vector<double> goals = column_values(*sources.rows, goal.metric);
  const std::vector<double> values = column_values(*sources.rows, name);
  if (goals.size() != values.size()) return best;
  const std::vector<bool> keeps = rows_that_keep(*sources.rows, standings);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] == value && keeps[i])
      best = goal.maximize ? std::fmax(best, goals[i]) : std::fmin(best, goals[i]);
  return best;
}

// A whole number has no slope, but the search has seen the number before.
Phrase whole_phrase(const BoundState& end, const std::vector<Goal>& goals, const Json& standings,
                    const Sources& sources) {
  const std::string& name = end.variable.name;
  Phrase phrase = end_phrase(name, !end.upper, end.limit, end.variable.unit);
  append(phrase, {", the end of its range"});
  phrase = strong(std::move(phrase));
  append(phrase, {": whole numbers have no slope."});
  const double inner = end.limit + (end.upper ? -1 : 1);
  const double best =
      goals.size() == 1 ? best_with(name, inner, goals[0], standings, sources) : std::nan("");
  if (std::isfinite(best))
    append(phrase, {" The best that the search saw with ", value_part(inner, "1"), " has ",
                    a_name_part(goals[0].metric), " of ", goal_part_of(goals[0], best),
                    "; a wider range shows whether this continues."});
  else
    append(phrase, {" Try a wider range."});
  return phrase;
}

// "2.4 W per 1 MPa"
Phrase worth_phrase(const Json& standing, const Goal& goal) {
  const double multiplier = number(standing["multiplier"]);
  if (!(multiplier > 0)) return {"-"};
  const std::string unit = standing["unit"];
  const bool plain = unit.empty() || unit == "1";
  const double per = plain ? 0.01 : display_unit(standing["limit"], unit).divisor;
  return {goal_part(goal, multiplier * per, 3), " per ", value_part(per, unit)};
}

std::string metric_of(const Json& standing) {
  return standing[standing.contains("variable") ? "variable" : "metric"];
}

// One per cent of nothing is nothing: a limit at 0 is moved by as much as its scale says. Nobody reads a per cent of an absolute
// temperature.
Phrase moved_phrase(const Json& standing) {
  const double limit = standing["limit"], moved = standing["moved"];
  const std::string metric = metric_of(standing), unit = standing["unit"];
  const Part there = named_part(metric, moved, unit);
  if (unit == "K" && is_temperature(metric))
    return {": ", value_part(std::fabs(moved - limit), unit, 3), " looser, at ", there,
            ", changes "};
  return {limit == 0 ? ": moved to " : ": 1 % looser, at ", there, ", changes "};
}

Part tolerance_part(const Json& standing) {
  return value_part(number(standing["tolerance"]), standing["unit"], 2);
}

std::vector<Phrase> limit_row(const Json& standing, const std::vector<Goal>& goals) {
  const std::string unit = standing["unit"];
  const bool binds = standing["state"] == "binds";
  std::vector<Phrase> row{standing_name(standing),
                          state_phrase(standing),
                          {named_part(metric_of(standing), number(standing["value"]), unit)},
                          {value_part(number(standing["slack"]), unit, 3)}};
  row.push_back({tolerance_part(standing)});
  for (std::size_t k = 0; k < goals.size(); ++k)
    row.push_back(
        {binds ? change(goal_part(goals[k], number(standing["changes"][k]), 3)) : Part("-")});
  if (goals.size() == 1) row.push_back(binds ? worth_phrase(standing, goals[0]) : Phrase{"-"});
  return row;
}

// Of two sides nothing is a number to go to: it is told by how much.
Phrase loosened_phrase(const RelaxationState& state, double amount) {
  if (!std::isfinite(amount)) return {"does not help alone"};
  if (amount == 0) return {"as it is"};
  if (state.of_two_sides) return {"by ", value_part(amount, state.unit)};
  return {named_part(state.metric, state.limit + (state.at_least ? -amount : amount), state.unit)};
}

Table loosened_table(const std::vector<RelaxationState>& limits) {
  Table table{"relaxation",
              {{"limit to loosen"}, {"value if all are loosened"}, {"value if only this one is"}},
              {}};
  for (const RelaxationState& state : limits)
    table.rows.push_back({{limit_part(state.text)},
                          loosened_phrase(state, state.amount),
                          loosened_phrase(state, state.amount_alone)});
  return table;
}

Table ends_table(const std::vector<RangeState>& ranges) {
  Table table{"range-ends", {{"end of a range to move"}, {"value if only this one is"}}, {}};
  for (const RangeState& end : ranges)
    table.rows.push_back(
        {end_phrase(end.variable.name, !end.upper, end.limit, end.variable.unit),
         {std::isfinite(end.limit_alone) ? value_part(end.limit_alone, end.variable.unit)
                                         : Part("none found")}});
  return table;
}

// The expression from which a parameter follows; a dash for one that does not.
std::string rule_of(const StudyFile& study, const std::string& name) {
  std::string rule = "-";
  std::visit(
      [&]<typename S>(const S& asked) {
        if constexpr (requires { asked.derived; })
          for (const DerivedParameter& one : asked.derived)
            if (info(one.parameter).name == name) rule = one.value.text;
      },
      study.asked);
  return rule;
}

}  // namespace

std::string limited_by(const std::string& text) {
  return is_limit(text) ? parse_limit(text).metric.text : text;
}

double goal_of(const DesignReport& report, const Goal& goal) {
  const double value = goal_value(report, goal);
  return std::isnan(value) ? value_of(report.design, goal.metric) : value;
}

Goal priced_goal(const OptimizeResult& answer) {
  const bool largest = answer.robust && std::isfinite(answer.robust->largest_yield);
  return largest ? Goal{"yield", "1", true} : answer.goal;
}

Phrase end_phrase(const std::string& name, bool at_least, double limit, const std::string& unit) {
  return {name_part(name), at_least ? " ≥ " : " ≤ ", named_part(name, limit, unit)};
}

Phrase holder_phrase(const Json& standing, const std::vector<Goal>& goals,
                     const DesignReport& report) {
  Phrase phrase = strong(standing_phrase(standing));
  if (standing["multiplier"].is_null()) {
    append(phrase, {": it is met. What it costs is known at an optimum only."});
    return phrase;
  }
  std::vector<Phrase> changes;
  for (std::size_t k = 0; k < goals.size(); ++k)
    if (const double by = number(standing["changes"][k]); by != 0 && std::isfinite(by))
      changes.push_back(change_phrase(goals[k], by, goal_of(report, goals[k])));
  if (changes.empty()) {
    append(phrase, {": it is met, but loosening it by 1 % changes nothing to first order."});
    return phrase;
  }
  append(phrase, moved_phrase(standing));
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (k > 0) append(phrase, {" or "});
    append(phrase, changes[k]);
  }
  append(phrase, {"."});
  return phrase;
}

std::vector<Phrase> holder_phrases(const Json& standings, const std::vector<Goal>& goals,
                                   const DesignReport& report,
                                   const std::vector<BoundState>& whole_ends,
                                   const Sources& sources) {
  std::vector<Phrase> phrases;
  for (const Json& standing : standings)
    if (standing["state"] == "binds") phrases.push_back(holder_phrase(standing, goals, report));
  for (const BoundState& end : whole_ends)
    phrases.push_back(whole_phrase(end, goals, standings, sources));
  return phrases;
}

Phrase state_phrase(const Json& standing) {
  const std::string state = standing["state"];
  if (state == "holds") return {good("holds")};
  if (state == "unknown") return {"unknown"};
  if (state == "broken")
    return {bad("broken by "), bad(value_part(number(standing["violation"]), standing["unit"], 3))};
  if (state == "unreachable") return {bad("cannot be reached")};
  constexpr double kRoom = 1e3;  // of what a limit is kept within: far more than a search leaves
  const bool room = number(standing["slack"]) > kRoom * number(standing["tolerance"]);
  return {bad(room ? "binds under the tolerances" : "binds")};
}

Table limits_table(const Json& standings, const std::vector<Goal>& goals) {
  Table table{"limits", {{"limit"}, {"state"}, {"value"}, {"to spare"}, {"kept within"}}, {}};
  table.typed = table.heads.size();
  for (const Goal& goal : goals) table.heads.push_back({"changes ", name_part(goal.metric), " by"});
  if (goals.size() == 1) table.heads.push_back({"worth"});
  for (const Json& standing : standings) table.rows.push_back(limit_row(standing, goals));
  return table;
}

std::optional<std::pair<double, double>> range_of(const Sources& sources, const std::string& name) {
  std::optional<std::pair<double, double>> ends;
  if (sources.study == nullptr) return ends;
  std::visit(
      [&]<typename S>(const S& asked) {
        if constexpr (requires { asked.solver; })
          for (const DesignVariable& range : asked.variables)
            if (info(range.parameter).name == name) ends.emplace(range.min, range.max);
      },
      sources.study->asked);
  return ends;
}

std::vector<BoundState> whole_ends_of(const DesignReport& report, const Sources& sources) {
  std::vector<BoundState> ends;
  for (const NamedValue& value : report.design) {
    const auto parameter = find_parameter(value.name);
    const auto range = range_of(sources, value.name);
    if (!parameter || !info(*parameter).integer || !range || range->first == range->second)
      continue;
    for (const bool upper : {false, true})
      if (const double end = upper ? range->second : range->first; value.value == end)
        ends.push_back({{value.name, value.unit}, upper, end});
  }
  return ends;
}

Table design_table(const std::string& name, const std::string& title, const DesignReport& report,
                   const std::vector<NamedValue>& before, const Sources& sources) {
  Table table{name, {{"parameter"}, {"before"}, {title}}, {}};
  if (sources.study != nullptr) table.heads.push_back({"range or rule"});
  for (const ChosenSet& one : report.choice) {
    table.rows.push_back({{name_part(one.choice)}, {"-"}, {printable(one.set)}});
    if (sources.study != nullptr) table.rows.back().push_back({"chosen"});
  }
  for (const NamedValue& value : report.design) {
    table.rows.push_back({{name_part(value.name)},
                          {named_part(value.name, value_of(before, value.name), value.unit)},
                          {named_part(value.name, value.value, value.unit)}});
    if (const auto range = range_of(sources, value.name))
      table.rows.back().push_back(
          {value_part(range->first, value.unit), " to ", value_part(range->second, value.unit)});
    else if (sources.study != nullptr)
      table.rows.back().push_back({rule_of(*sources.study, value.name)});
  }
  return table;
}

Table metrics_table(const std::string& name, const std::string& title, const DesignReport& report,
                    const std::vector<NamedValue>& before) {
  Table table{name, {{"metric"}, {"before"}, {title}}, {}};
  for (const NamedValue& value : report.metrics)
    table.rows.push_back({{name_part(value.name)},
                          {named_part(value.name, value_of(before, value.name), value.unit)},
                          {named_part(value.name, value.value, value.unit)}});
  return table;
}

std::vector<Part> held_parts(const DesignReport& report) {
  std::vector<Part> parts;
  for (const ChosenSet& one : report.choice) parts.push_back(name_part(one.choice));
  for (const NamedValue& value : report.design)
    if (const auto p = find_parameter(value.name); p && info(*p).integer)
      parts.push_back(name_part(value.name));
  return parts;
}

Phrase certificate_phrase(const DesignReport& report, const std::string& goal_unit) {
  const optim::Certificate& certificate = report.certificate;
  if (!certificate.passed)
    return {"Not certified as an optimum" +
            (certificate.reason.empty() ? "" : ": " + certificate.reason) + "."};
  constexpr double kRounding = 1e-10;  // of the slope itself
  Phrase phrase{"Certified by exact derivatives, independent of the solver"};
  const std::vector<Part> held = held_parts(report);
  if (!held.empty()) {
    append(phrase, {", with "});
    append(phrase, listed(held));
    append(phrase, {" held"});
  }
  append(phrase, {std::string(": no small change within the limits improves it") +
                  (certificate.second_order ? "" : " to first order") + " ("});
  if (certificate.stationarity < kRounding)
    append(phrase, {"the slope is zero up to rounding"});
  else
    append(phrase, {"the slope is zero up to this share of its terms: ",
                    value_part(certificate.stationarity, "1", 2)});
  if (!goal_unit.empty() && !std::isnan(certificate.gain))
    append(phrase,
           {"; a step could gain at most ", value_part(std::fabs(certificate.gain), goal_unit, 2)});
  append(phrase, {")."});
  return phrase;
}

std::vector<Section> relaxation_sections(const Explanation& explanation) {
  Section section{
      {"What would make it possible"},
      {"The least change of each limit, and of each end of a range, that was found to be enough."}};
  if (!explanation.limits.empty()) section.tables.push_back(loosened_table(explanation.limits));
  if (!explanation.ranges.empty()) section.tables.push_back(ends_table(explanation.ranges));
  return section.tables.empty() ? std::vector<Section>{} : std::vector{section};
}

std::vector<bool> rows_that_keep(const ResultStore& rows, const Json& standings) {
  std::vector<bool> keeps(rows.rows(), true);
  for (const Json& standing : standings) {
    if (!standing.contains("metric")) continue;
    const std::vector<double> values = column_values(rows, standing["metric"]);
    // Rounding may put the answer itself beyond a limit. That much does not count as a violation.
    const double room = standing["allowance"];
    const double lower = standing["lower"].is_null() ? -HUGE_VAL : number(standing["lower"]) - room;
    const double upper = standing["upper"].is_null() ? HUGE_VAL : number(standing["upper"]) + room;
    for (std::size_t i = 0; i < values.size(); ++i)
      keeps[i] = keeps[i] && values[i] >= lower && values[i] <= upper;
  }
  return keeps;
}

}  // namespace twum::inline v0_1::studies::telling
