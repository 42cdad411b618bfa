// SPDX-License-Identifier: Apache-2.0
#include "results/estimate_json.hpp"
#include "results/search_words.hpp"

#include <twum/io/number.hpp>

#include <cmath>
#include <limits>

namespace twum::studies {
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

double only_end(const UncertaintyResult::Limit& limit) {
  if (two_ended(limit)) return std::numeric_limits<double>::quiet_NaN();
  return std::isfinite(limit.lower) ? limit.lower : limit.upper;
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
  for (const UncertaintyResult::Inadmissible& one : result.inadmissible)
    json["inadmissible"][one.variable] = one.share;
  if (!result.parts.empty()) json["parts"] = {{"file", result.parts}, {"count", result.part_count}};
  return json;
}

}  // namespace twum::studies
