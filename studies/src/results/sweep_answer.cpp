// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

namespace twum::inline v0_1::studies {
namespace {

Json design_json(const SweepResult& result, const SweepResult::Design& design) {
  if (design.variables.empty()) return nullptr;
  Json json{{"row", design.index}, {"design", Json::object()}, {"metrics", Json::object()}};
  for (std::size_t i = 0; i < result.variables.size(); ++i)
    json["design"][result.variables[i].name] = number_json(design.variables[i]);
  for (const std::size_t i : result.derived)
    json["design"][result.metrics[i].column.name] = number_json(design.metrics[i]);
  for (std::size_t i = 0; i < result.metrics.size(); ++i)
    json["metrics"][result.metrics[i].column.name] = number_json(design.metrics[i]);
  return json;
}

}  // namespace

Json answer_json(const SweepResult& result) {
  Json json{{"sampling", result.sampling}, {"designs", result.designs},
            {"stored", result.stored},     {"failed", result.failed},
            {"units", Json::object()},     {"metrics", Json::object()}};
  for (const StoredColumn& column : result.variables) json["units"][column.name] = column.unit;
  for (const SweepResult::Metric& metric : result.metrics) {
    json["units"][metric.column.name] = metric.column.unit;
    json["metrics"][metric.column.name] = {{"count", metric.count},
                                           {"min", number_json(metric.min)},
                                           {"median", number_json(metric.median)},
                                           {"max", number_json(metric.max)},
                                           {"lowest", design_json(result, metric.lowest)},
                                           {"highest", design_json(result, metric.highest)}};
  }
  return json;
}

}  // namespace twum::inline v0_1::studies
