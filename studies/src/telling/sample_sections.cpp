// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <cmath>

namespace twum::studies::telling {
namespace {

Part count_part(std::uint64_t count) { return value_part(static_cast<double>(count), "1", 17); }

Table sweep_table(const SweepResult& answer) {
  Table table{"spread", {{"metric"}, {"lowest"}, {"median"}, {"highest"}, {"designs"}}, {}};
  for (const SweepResult::Metric& metric : answer.metrics) {
    table.rows.push_back({{name_part(metric.column.name)}});
    for (const double value : {metric.min, metric.median, metric.max})
      table.rows.back().push_back({value_part(value, metric.column.unit)});
    table.rows.back().push_back({count_part(metric.count)});
  }
  return table;
}

// The designs with the least and the most of each metric.
Table ends_table(const SweepResult& answer) {
  Table table{"ends", {{"metric"}, {"lowest at"}, {"highest at"}}, {}};
  for (const SweepResult::Metric& metric : answer.metrics) {
    table.rows.push_back({{name_part(metric.column.name)}});
    std::vector<Phrase>& row = table.rows.back();
    if (metric.count == 0)
      row.insert(row.end(), 2, {"no design has a value"});
    else if (metric.min == metric.max)
      row.insert(row.end(), 2, {"the same in all designs"});
    else
      row.insert(row.end(),
                 {design_phrase(answer, metric.lowest), design_phrase(answer, metric.highest)});
  }
  return table;
}

// "preload 234 N, amplitude 1.9 µm"
Phrase values_phrase(const std::vector<NamedValue>& values) {
  Phrase phrase;
  for (const NamedValue& one : values)
    append(phrase, {phrase.empty() ? "" : ", ", name_part(one.name),
                    " " + parameter_text(one.name, one.value, one.unit)});
  return phrase;
}

Phrase missing_phrase(const UncertaintyResult::Metric& metric, std::uint64_t missing) {
  if (metric.count == 0) return {name_part(metric.column.name), ": no motor has a value."};
  return {name_part(metric.column.name), ": " + counted(missing, "motor"),
          missing == 1 ? " has no value; the numbers are those of the others."
                       : " have no value; the numbers are those of the others."};
}

std::vector<Phrase> spread_sentences(const UncertaintyResult& answer) {
  std::vector<Phrase> list{{counted(answer.samples, "motor") + " drawn; intervals of ",
                            share_part(answer.confidence, 3), "."}};
  if (!answer.start.empty()) {
    list.push_back({"Varied: the design of " + quoted(answer.start) + ", "});
    append(list.back(), values_phrase(answer.nominal));
    append(list.back(), {"."});
  }
  for (const UncertaintyResult::Metric& metric : answer.metrics)
    if (const std::uint64_t missing = answer.samples - metric.count; missing > 0)
      list.push_back(missing_phrase(metric, missing));
  for (const UncertaintyResult::CutOff& cut : answer.cut_off)
    list.push_back({share_part(cut.share), " of the distribution of ", name_part(cut.variable),
                    " is not admissible and was cut off."});
  return list;
}

struct Statistic {
  std::string name;
  Estimate value;
};

std::vector<Statistic> statistics_of(const UncertaintyResult::Metric& metric) {
  std::vector<Statistic> list{{"mean", metric.mean}, {"standard deviation", metric.sd}};
  for (const UncertaintyResult::Quantile& one : metric.quantiles)
    list.push_back({written(share_part(one.probability), Writing::read) + " quantile", one.value});
  return list;
}

// What is rounding of the values is no spread.
double spread_of(const UncertaintyResult::Metric& metric) {
  constexpr double kRounding = 1e-9;
  return metric.sd.value <= kRounding * std::fabs(metric.mean.value) ? 0 : metric.sd.value;
}

// The values of the distributions, and their intervals.
std::vector<Table> spread_tables(const UncertaintyResult& answer) {
  Table values{"spread", {{"metric"}}, {}};
  Table intervals{"intervals", {{"metric"}, {"statistic"}, {"at least"}, {"at most"}}, {}};
  for (const Statistic& one : statistics_of(answer.metrics.front()))
    values.heads.push_back({one.name});
  values.heads.push_back({"motors without a value"});
  for (const UncertaintyResult::Metric& metric : answer.metrics) {
    const Part name = name_part(metric.column.name);
    const std::string& unit = metric.column.unit;
    std::vector<Phrase> row{{name}};
    for (const Statistic& one : statistics_of(metric)) {
      row.push_back({value_part(one.value.value, unit)});
      intervals.rows.push_back({{name},
                                {one.name},
                                {value_part(one.value.low, unit)},
                                {value_part(one.value.high, unit)}});
    }
    row[2] = {value_part(spread_of(metric), unit)};
    row.push_back({count_part(answer.samples - metric.count)});
    values.rows.push_back(std::move(row));
  }
  return {values, intervals};
}

Section yield_section(const UncertaintyResult& answer) {
  Section section{{"Yield"},
                  {"What each limit costs, and the ends of the ", share_part(answer.confidence, 3),
                   " intervals."}};
  section.hook = "looser";
  if (answer.no_value > 0)
    section.sentences = {{counted(answer.no_value, "motor"),
                          answer.no_value == 1
                              ? " has no value for a limit and counts as not keeping it."
                              : " have no value for a limit and count as not keeping it."}};
  Table table{"yield", {{"limit"}, {"kept by"}, {"at least"}, {"at most"}}, {}};
  const auto add = [&](Part name, const Estimate& e) {
    table.rows.push_back(
        {{std::move(name)}, {share_part(e.value)}, {share_part(e.low)}, {share_part(e.high)}});
  };
  for (const UncertaintyResult::Limit& limit : answer.limits)
    add(limit_part(limit.text), limit.kept);
  add("all of them", *answer.yield);
  section.tables = {table};
  return section;
}

}  // namespace

std::vector<Section> sections_of(const SweepResult& answer) {
  if (answer.stored == 0) return {};
  Section spread{{"Spread of the metrics"}, {"Sampling: " + answer.sampling + "."}};
  if (answer.stored < answer.designs)
    spread.sentences = {{std::to_string(answer.stored) + " of " +
                         counted(answer.designs, "design") + " are computed."}};
  spread.tables = {sweep_table(answer)};
  spread.wide = false;
  Section ends{{"The most and the least"}, {"The designs with them."}};
  ends.tables = {ends_table(answer)};
  return {spread, ends};
}

std::vector<Section> sections_of(const UncertaintyResult& answer) {
  if (answer.samples == 0) return {};
  std::vector<Section> list;
  if (answer.yield) list.push_back(yield_section(answer));
  Section spread{{"Spread"}};
  spread.sentences = spread_sentences(answer);
  if (!answer.metrics.empty()) spread.tables = spread_tables(answer);
  list.push_back(std::move(spread));
  return list;
}

}  // namespace twum::studies::telling
