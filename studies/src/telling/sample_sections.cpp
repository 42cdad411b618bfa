// SPDX-License-Identifier: Apache-2.0
#include "telling/curve_charts.hpp"
#include "telling/failure_sections.hpp"
#include "telling/goal_parts.hpp"
#include "telling/histogram.hpp"
#include "telling/scatter_matrix.hpp"
#include "telling/tellings.hpp"

#include <twum/core/metrics.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/expression.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace twum::inline v0_1::studies::telling {
namespace {

// "preload 234 N, amplitude 1.9 µm"
Phrase values_phrase(const std::vector<NamedValue>& values) {
  Phrase phrase;
  for (const NamedValue& one : values)
    append(phrase, {phrase.empty() ? "" : ", ", name_part(one.name), " ",
                    named_part(one.name, one.value, one.unit)});
  return phrase;
}

Phrase missing_phrase(const UncertaintyResult::Metric& metric, std::uint64_t missing) {
  if (metric.count == 0) return {name_part(metric.column.name), ": no motor has a value."};
  return {name_part(metric.column.name), ": " + counted(missing, "motor"),
          missing == 1 ? " has no value; the statistics are those of the others."
                       : " have no value; the statistics are those of the others."};
}

bool is_life(const std::string& metric) {
  const MetricExpression expression = parse_metric(metric);
  const MetricRequest* request = expression.request();
  return request != nullptr && !request->worn_at && info(request->metric).needs_wear &&
         request->metric != Metric::wear_rate_at;
}

// A life that most motors reach, by its usual name: B10 is that of 90 % of the motors.
std::vector<Phrase> lives_reached(const UncertaintyResult& answer) {
  std::vector<Phrase> list;
  for (const UncertaintyResult::Metric& metric : answer.metrics)
    for (const UncertaintyResult::Quantile& one : metric.quantiles) {
      if (!(one.probability < 0.5) || metric.count == 0 || !is_life(metric.column.name)) continue;
      list.push_back({share_part(1 - one.probability), " of the motors reach a ",
                      name_part(metric.column.name), " of ",
                      strong(value_part(one.value.value, metric.column.unit)), " (the life B",
                      number_text(100 * one.probability), ")."});
    }
  return list;
}

std::vector<Phrase> spread_sentences(const UncertaintyResult& answer) {
  const std::string drawn = answer.weighted
                                ? " drawn near " + counted(answer.ways, "point") +
                                      " where motors are most likely to fail, and weighted; " +
                                      std::to_string(answer.sought) +
                                      " others, or up to four times as many, were drawn first to "
                                      "find these points; intervals of "
                                : " drawn; intervals of ";
  std::vector<Phrase> list{
      {counted(answer.samples, "motor") + drawn, share_part(answer.confidence, 3), "."}};
  if (!answer.start.empty()) {
    list.push_back({"Varied: the design of " + quoted(answer.start) + ", "});
    append(list.back(), values_phrase(answer.nominal));
    append(list.back(), {"."});
  }
  for (Phrase& one : lives_reached(answer)) list.push_back(std::move(one));
  for (const UncertaintyResult::Metric& metric : answer.metrics)
    if (const std::uint64_t missing = answer.samples - metric.count; missing > 0)
      list.push_back(missing_phrase(metric, missing));
  for (Phrase& phrase : parts_sentence(answer.parts, answer.part_count))
    list.push_back(std::move(phrase));
  for (const UncertaintyResult::Inadmissible& one : answer.inadmissible)
    list.push_back({share_part(one.share), " of the distribution of ", name_part(one.variable),
                    " lies outside the permitted range of the parameter; such motors have no value "
                    "and violate every limit."});
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
constexpr double kNoSpread = 1e-9;

double deviation_of(const UncertaintyResult::Metric& metric) {
  return metric.sd.value <= kNoSpread * std::fabs(metric.mean.value) ? 0 : metric.sd.value;
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
    row[2] = {value_part(deviation_of(metric), unit)};
    row.push_back({count_part(answer.samples - metric.count)});
    values.rows.push_back(std::move(row));
  }
  return {values, intervals};
}

using SpreadLimit = UncertaintyResult::Limit;

// The least or the most that a limit asks for; one between two ends has none, nor has one of two sides, whose difference is limited
// by 0.
double end_of(const SpreadLimit& limit) {
  const bool least = std::isfinite(limit.lower), most = std::isfinite(limit.upper);
  const double end = least ? limit.lower : limit.upper;
  return least == most || end == 0 ? std::nan("") : end;
}

SpreadLimit looser(SpreadLimit limit) {
  const double by = 0.01 * std::fabs(end_of(limit));
  limit.lower -= by;
  limit.upper += by;
  return limit;
}

// The share of the stored motors that keep these limits.
class Keepers {
 public:
  Keepers(const ResultStore* rows, const std::vector<SpreadLimit>& limits) : limits_(limits) {
    if (rows == nullptr) return;
    for (const SpreadLimit& limit : limits) {
      columns_.push_back(column_values(*rows, limit.metric));
      for (const StoredColumn& column : rows->columns())
        if (column.name == limit.metric) units_.push_back(column.unit);
    }
  }

  bool known() const {
    return !columns_.empty() &&
           std::ranges::none_of(columns_, [](const auto& column) { return column.empty(); });
  }

  // Of what the i-th limits, SI.
  const std::string& unit(std::size_t i) const { return units_[i]; }

  // With one of the limits looser by 1 %.
  double share(std::size_t moved) const {
    std::vector<SpreadLimit> limits = limits_;
    limits[moved] = looser(limits[moved]);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < columns_.front().size(); ++i) kept += keeps(limits, i) ? 1 : 0;
    return static_cast<double>(kept) / static_cast<double>(columns_.front().size());
  }

 private:
  bool keeps(const std::vector<SpreadLimit>& limits, std::size_t row) const {
    for (std::size_t k = 0; k < limits.size(); ++k)
      if (!(columns_[k][row] >= limits[k].lower && columns_[k][row] <= limits[k].upper))
        return false;
    return true;
  }

  const std::vector<SpreadLimit>& limits_;
  std::vector<std::vector<double>> columns_;
  std::vector<std::string> units_;
};

// What a limit costs, and what 1 % of it would bring.
Phrase kept_phrase(const UncertaintyResult& answer, std::size_t i, const Keepers& keepers) {
  const SpreadLimit& limit = answer.limits[i];
  Phrase phrase{strong(limit_part(limit.text)), ": kept by ", share_part(limit.kept.value),
                " of the motors"};
  if (std::isfinite(end_of(limit))) {
    const double then = keepers.share(i);
    if (then == answer.yield->value)
      append(phrase, {"; loosening it by 1 % changes nothing"});
    else
      append(phrase, {"; loosened by 1 %, to ", value_part(end_of(looser(limit)), keepers.unit(i)),
                      ", the yield is ", strong(share_part(then))});
  }
  append(phrase, {"."});
  return phrase;
}

Section yield_section(const UncertaintyResult& answer, const Sources& sources) {
  Section section{{"Yield"},
                  {"Share of the motors that keep each limit, and the ends of the ",
                   share_part(answer.confidence, 3), " intervals."}};
  const Keepers keepers(sources.rows, answer.limits);
  std::multimap<double, Phrase> by_cost;  // without the motors the table says as much
  for (std::size_t i = 0; keepers.known() && i < answer.limits.size(); ++i)
    by_cost.emplace(answer.limits[i].kept.value, kept_phrase(answer, i, keepers));
  for (auto& [kept, phrase] : by_cost) section.remarks.push_back(std::move(phrase));
  if (answer.no_value > 0)
    section.sentences = {{counted(answer.no_value, "motor"),
                          answer.no_value == 1
                              ? " has no value for a limit and counts as failing."
                              : " have no value for a limit and count as failing."}};
  Table table{"yield", {{"limit"}, {"kept by"}, {"at least"}, {"at most"}}, {}};
  const auto add = [&](Part name, const Estimate& e) {
    table.rows.push_back(
        {{std::move(name)}, {share_part(e.value)}, {share_part(e.low)}, {share_part(e.high)}});
  };
  for (const SpreadLimit& limit : answer.limits) add(limit_part(limit.text), limit.kept);
  add("all limits", *answer.yield);
  section.tables = {table};
  return section;
}

Window window_of(const UncertaintyResult& answer, const std::string& metric) {
  Window window{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const SpreadLimit& limit : answer.limits) {
    if (limit.metric != metric) continue;
    window.lower = std::max(window.lower, limit.lower);
    window.upper = std::min(window.upper, limit.upper);
  }
  return window;
}

Numbers counts_of(const std::vector<std::size_t>& counts) {
  return {"", {counts.begin(), counts.end()}};
}

// A limit is drawn unless it is far from all motors, and the axis reaches a little beyond it.
void add_limits(Chart& chart, const Window& window) {
  const double first = chart.x.low, last = chart.x.high, span = last - first;
  for (const double limit : {window.lower, window.upper}) {
    if (!(limit > first - span && limit < last + span)) continue;
    chart.guides.push_back(
        {limit, {limit == window.lower ? "≥ " : "≤ ", value_part(limit, chart.x.unit)}});
    chart.x.low = std::min(chart.x.low, limit - 0.04 * span);
    chart.x.high = std::max(chart.x.high, limit + 0.04 * span);
  }
}

Chart histogram(const UncertaintyResult& answer, const UncertaintyResult::Metric& metric,
                const std::vector<double>& values) {
  const std::string& name = metric.column.name;
  const Window window = window_of(answer, name);
  const Bins bins = counted_bins(values, window);
  const bool limited = std::isfinite(window.lower) || std::isfinite(window.upper);
  Numbers edges;
  for (std::size_t i = 0; i <= bins.kept.size(); ++i) edges.values.push_back(bins.edge(i));
  Chart chart{
      "histogram " + name,
      {"spread of ", name_part(name)},
      {{name_part(name)}, metric.column.unit, false, edges.values.front(), edges.values.back()},
      {{"motors"}, "1", true},
      {{limited ? "keeps the limit" : "motors", Stroke::bars, edges, counts_of(bins.kept)},
       {limited ? "violates the limit" : "", Stroke::bars, edges, counts_of(bins.failed), "c1"}}};
  add_limits(chart, window);
  for (const UncertaintyResult::Quantile& one : metric.quantiles)
    chart.guides.push_back({one.value.value, {share_part(one.probability)}, Guide::Kind::quantile});
  chart.least = window.lower;
  chart.most = window.upper;
  constexpr double kRoom = 1.3;  // for the names of the guides above the highest bar
  for (const Series& series : chart.series)
    chart.y.high = std::fmax(chart.y.high, kRoom * *std::ranges::max_element(series.y.values));
  chart.y.low = 0;
  return chart;
}

// The motors of one metric in bins.
Section spread_of(const UncertaintyResult& answer, const UncertaintyResult::Metric& metric,
                  std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Section section{{name_part(metric.column.name)}};
  section.wide = false;
  const auto [low, high] = std::ranges::minmax_element(values);
  if (low == values.end())
    section.note = {"No motor has a value."};
  else if (*high - *low <= kNoSpread * std::fabs(*high))
    section.note = {"The same in every motor: ", value_part(*low, metric.column.unit), "."};
  else
    section.charts = {histogram(answer, metric, values)};
  return section;
}

}  // namespace

std::vector<Section> sections_of(const UncertaintyResult& answer, const Sources& sources) {
  if (answer.samples == 0) return {};
  std::vector<Section> list;
  if (sources.rows != nullptr)
    for (const UncertaintyResult::Metric& metric : answer.metrics)
      list.push_back(spread_of(answer, metric, column_values(*sources.rows, metric.column.name)));
  if (answer.yield)
    list.push_back(answer.weighted ? failure_table_section(answer)
                                   : yield_section(answer, sources));
  for (Section& section : cause_sections(answer)) list.push_back(std::move(section));
  if (sources.rows != nullptr && !answer.weighted)
    for (Section& section : scatter_sections(answer, *sources.rows))
      list.push_back(std::move(section));
  Section spread{{"Spread"}};
  spread.sentences = spread_sentences(answer);
  if (!answer.metrics.empty()) spread.tables = spread_tables(answer);
  list.push_back(std::move(spread));
  std::ranges::move(motor_sections(sources), std::back_inserter(list));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
