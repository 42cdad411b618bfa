// SPDX-License-Identifier: Apache-2.0
#include "results/estimate_json.hpp"
#include "results/search_words.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::studies {
namespace {

std::string yield_text(double share) { return rounded_text(100 * share, 4) + " %"; }

std::string yield_text(const Estimate& e) {
  return yield_text(e.value) + "  (" + yield_text(e.low) + " to " + yield_text(e.high) + ")";
}

Json metric_json(const UncertaintyResult::Metric& metric, std::uint64_t samples) {
  Json json{{"mean", number_json(metric.mean.value)},
            {"sd", number_json(metric.sd.value)},
            {"quantiles", Json::object()},
            {"mean_interval", interval_json(metric.mean)},
            {"sd_interval", interval_json(metric.sd)},
            {"quantile_intervals", Json::object()},
            {"count", metric.count},
            {"missing", samples - metric.count}};
  for (const UncertaintyResult::Quantile& quantile : metric.quantiles) {
    const std::string name = number_text(quantile.probability);
    json["quantiles"][name] = number_json(quantile.value.value);
    json["quantile_intervals"][name] = interval_json(quantile.value);
  }
  return json;
}

bool two_ended(const UncertaintyResult::Limit& limit) {
  return std::isfinite(limit.lower) && std::isfinite(limit.upper);
}

const char* sense_of(const UncertaintyResult::Limit& limit) {
  if (two_ended(limit)) return "between";
  return std::isfinite(limit.lower) ? "at least" : "at most";
}

double only_end(const UncertaintyResult::Limit& limit) {
  if (two_ended(limit)) return std::numeric_limits<double>::quiet_NaN();
  return std::isfinite(limit.lower) ? limit.lower : limit.upper;
}

std::string finite_text(double value, const std::string& unit) {
  return std::isfinite(value) ? engineering(value, unit) : "-";
}

// One row each for value and interval, so that columns stay narrow.
void add_rows(const UncertaintyResult::Metric& metric, TextTable& table) {
  std::vector<std::string> values{metric.column.name};
  std::vector<std::string> intervals{""};
  const auto add = [&](const Estimate& e) {
    const std::string& unit = metric.column.unit;
    values.push_back(finite_text(e.value, unit));
    intervals.push_back("(" + finite_text(e.low, unit) + " to " + finite_text(e.high, unit) + ")");
  };
  add(metric.mean);
  add(metric.sd);
  for (const UncertaintyResult::Quantile& quantile : metric.quantiles) add(quantile.value);
  table.rows.push_back(std::move(values));
  table.rows.push_back(std::move(intervals));
}

std::string spread_table(const UncertaintyResult& result) {
  TextTable table{{{"metric", "mean", "standard deviation"}}};
  if (result.metrics.empty()) return {};
  for (const UncertaintyResult::Quantile& quantile : result.metrics.front().quantiles)
    table.rows.front().push_back(yield_text(quantile.probability) + " quantile");
  for (const UncertaintyResult::Metric& metric : result.metrics) add_rows(metric, table);
  return aligned(table, kSummaryWidth);
}

std::string without(std::uint64_t count) {
  return counted(count, "motor") + (count == 1 ? " has" : " have") + " no value";
}

std::string missing_text(const UncertaintyResult& result) {
  std::string text;
  for (const UncertaintyResult::Metric& metric : result.metrics) {
    const std::uint64_t missing = result.samples - metric.count;
    if (missing == 0) continue;
    text += metric.column.name + ": ";
    text += metric.count == 0 ? "no motor has a value.\n"
                              : without(missing) + "; the numbers are those of the others.\n";
  }
  for (const UncertaintyResult::CutOff& cut : result.cut_off) {
    text += yield_text(cut.share) + " of the distribution of " + cut.variable +
            " is not admissible and was cut off.\n";
  }
  return text;
}

std::string yield_text(const UncertaintyResult& result) {
  if (!result.yield) return {};
  std::string text = "\nYield: " + yield_text(*result.yield) + " of the motors keep all limits.\n";
  TextTable table{{{"limit", "kept by"}}};
  for (const UncertaintyResult::Limit& limit : result.limits)
    table.rows.push_back({limit.text, yield_text(limit.kept)});
  text += aligned(table);
  const auto worst =
      std::min_element(result.limits.begin(), result.limits.end(),
                       [](const auto& a, const auto& b) { return a.kept.value < b.kept.value; });
  if (result.limits.size() > 1 && worst->kept.value < 1)
    text += "'" + worst->text + "' costs most.\n";
  if (result.no_value > 0) {
    text += without(result.no_value) + " for a limit and " +
            (result.no_value == 1 ? "counts" : "count") + " as not keeping it.\n";
  }
  return text;
}

// "preload 234 N, amplitude 1.9 um"
std::string listed(const std::vector<NamedValue>& values) {
  std::string text;
  for (const NamedValue& value : values)
    text += (text.empty() ? "" : ", ") + value.name + " " +
            parameter_text(value.name, value.value, value.unit);
  return text;
}

}  // namespace

Json answer_json(const UncertaintyResult& result) {
  Json json{{"samples", result.samples}, {"confidence", result.confidence}};
  if (!result.start.empty()) json["start"] = result.start;
  json["nominal"] = {{"design", values_json(result.nominal)}};
  json["metrics"] = Json::object();
  json["units"] = Json::object();
  for (const StoredColumn& variable : result.variables)
    json["units"][variable.name] = variable.unit;
  for (const UncertaintyResult::Metric& metric : result.metrics) {
    json["units"][metric.column.name] = metric.column.unit;
    json["metrics"][metric.column.name] = metric_json(metric, result.samples);
  }
  if (result.yield) {
    json["yield"] = estimate_json(*result.yield);
    json["limits"] = Json::array();
    for (const UncertaintyResult::Limit& limit : result.limits)
      json["limits"].push_back({{"text", limit.text},
                                {"metric", limit.metric},
                                {"sense", sense_of(limit)},
                                {"limit", number_json(only_end(limit))},
                                {"lower", number_json(limit.lower)},
                                {"upper", number_json(limit.upper)},
                                {"kept", estimate_json(limit.kept)}});
    json["without_value"] = result.no_value;
  }
  if (!result.cut_off.empty()) {
    for (const UncertaintyResult::CutOff& cut : result.cut_off)
      json["cut_off"][cut.variable] = cut.share;
  }
  return json;
}

std::string answer_text(const UncertaintyResult& result) {
  if (result.samples == 0) return {};
  std::string text = counted(result.samples, "motor") + " drawn, " +
                     rounded_text(100 * result.confidence, 3) + " % intervals in parentheses";
  if (result.failed > 0) text += "; " + std::to_string(result.failed) + " failed or incomplete";
  if (!result.start.empty())
    text += "\nvaried: the design of " + quoted(result.start) + ", " + listed(result.nominal);
  return text + "\n\n" + spread_table(result) + missing_text(result) + yield_text(result);
}

}  // namespace twum::studies
