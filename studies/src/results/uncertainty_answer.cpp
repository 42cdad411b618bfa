// SPDX-License-Identifier: Apache-2.0
#include "results/estimate_json.hpp"
#include "results/search_words.hpp"

#include <twum/io/number.hpp>

#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

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

// {preload: {value, low, high}}, of what is known.
Json by_variable(const UncertaintyResult& result, const std::vector<Estimate>& estimates) {
  Json json = Json::object();
  for (std::size_t k = 0; k < estimates.size(); ++k)
    json[result.variables[k].name] = estimate_json(estimates[k]);
  return json;
}

double only_end(const UncertaintyResult::Limit& limit) {
  if (two_ended(limit)) return std::numeric_limits<double>::quiet_NaN();
  return std::isfinite(limit.lower) ? limit.lower : limit.upper;
}

Json spread_limit_json(const UncertaintyResult& result, const UncertaintyResult::Limit& limit) {
  Json json{{"text", limit.text},
            {"metric", limit.metric},
            {"sense", sense_of(limit)},
            {"limit", number_json(only_end(limit))},
            {"lower", number_json(limit.lower)},
            {"upper", number_json(limit.upper)},
            {"kept", estimate_json(limit.kept)},
            {"broken", estimate_json(limit.broken)},
            {"causes", by_variable(result, limit.causes)}};
  if (!result.weighted) return json;
  json["index"] = number_json(limit.index);
  json["likeliest"] = Json::object();
  for (std::size_t k = 0; k < limit.likeliest.size(); ++k)
    json["likeliest"][result.variables[k].name] = number_json(limit.likeliest[k]);
  return json;
}

Estimate scaled_estimate(double factor, const Estimate& estimate) {
  return {factor * estimate.value, factor * estimate.low, factor * estimate.high};
}

Json spread_failures_json(const UncertaintyResult& result) {
  Json json{{"share", estimate_json(result.broken)},
            {"per_million", estimate_json(scaled_estimate(1e6, result.broken))},
            {"causes", by_variable(result, result.causes)},
            {"yield_per_percent", by_variable(result, result.tighter)}};
  if (result.weighted) json["ways"] = result.ways;
  return json;
}

}  // namespace

Json answer_json(const UncertaintyResult& result) {
  Json json{{"samples", result.samples}, {"confidence", result.confidence}};
  if (result.weighted) json["method"] = "importance";
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
      json["limits"].push_back(spread_limit_json(result, limit));
    if (!result.weighted) json["without_value"] = result.no_value;
    json["failing"] = spread_failures_json(result);
  }
  for (const UncertaintyResult::Inadmissible& one : result.inadmissible)
    json["inadmissible"][one.variable] = one.share;
  if (!result.parts.empty()) json["parts"] = {{"file", result.parts}, {"count", result.part_count}};
  return json;
}

}  // namespace twum::inline v0_1::studies
