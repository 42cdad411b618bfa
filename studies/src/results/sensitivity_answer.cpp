// SPDX-License-Identifier: Apache-2.0
#include "results/estimate_json.hpp"
#include "results/search_words.hpp"

#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

Json effect_json(const SobolShares& shares) {
  Json json{{"first", estimate_json(shares.first)},
            {"total", estimate_json(shares.total)},
            {"interactions", estimate_json(shares.interactions)}};
  if (std::isfinite(shares.derivative_bound.value))
    json["derivative_bound"] = estimate_json(shares.derivative_bound);
  return json;
}

Json effect_json(const ElementaryEffect& effect) {
  return {{"mu_star", number_json(effect.mu_star.value)},
          {"sigma", number_json(effect.sigma.value)},
          {"mu", number_json(effect.mu)},
          {"mu_star_interval", interval_json(effect.mu_star)},
          {"sigma_interval", interval_json(effect.sigma)}};
}

Json effect_json(const LocalEffect& effect) {
  Json json{{"gradient", number_json(effect.gradient)},
            {"elasticity", number_json(effect.elasticity)}};
  if (std::isfinite(effect.spread)) json["spread"] = effect.spread;
  return json;
}

Json effects_json(const SensitivityResult& result, const MetricSensitivity& metric) {
  return std::visit(
      [&](const auto& effects) {
        if (effects.empty()) return Json(nullptr);
        Json json = Json::object();
        for (std::size_t j = 0; j < effects.size(); ++j)
          json[result.variables[j].name] = effect_json(effects[j]);
        return json;
      },
      metric.effects);
}

Json metric_json(const SensitivityResult& result, const MetricSensitivity& metric) {
  Json json = Json::object();
  if (result.method == SensitivityMethod::local) {
    json["value"] = number_json(metric.value);
    json["smoothness"] = to_string(metric.smoothness);
    if (result.tolerances) json["sd"] = number_json(metric.sd);
  } else {
    json["mean"] = number_json(metric.value);
    json["sd"] = number_json(metric.sd);
    json["samples"] = metric.samples;
    json["dropped"] = metric.dropped;
  }
  if (!metric.note.empty()) json["note"] = metric.note;
  return json;
}

}  // namespace

Json answer_json(const SensitivityResult& result) {
  Json json{{"method", to_string(result.method)}};
  if (result.tolerances) json["tolerances"] = true;
  if (result.method != SensitivityMethod::local) {
    json["confidence"] = result.confidence;
    json["samples"] = result.samples;
  }
  if (result.width > 0) {
    json["width"] = result.width;
    json["narrow"] = result.narrow;
  }
  json["indices"] = Json::object();
  json["metrics"] = Json::object();
  json["units"] = Json::object();
  for (std::size_t j = 0; j < result.variables.size(); ++j) {
    json["units"][result.variables[j].name] = result.variables[j].unit;
    if (!result.motor.empty()) json["at"][result.variables[j].name] = result.motor[j];
  }
  for (const MetricSensitivity& metric : result.metrics) {
    json["units"][metric.metric.name] = metric.metric.unit;
    json["indices"][metric.metric.name] = effects_json(result, metric);
    json["metrics"][metric.metric.name] = metric_json(result, metric);
  }
  return json;
}

}  // namespace twum::inline v0_1::studies
