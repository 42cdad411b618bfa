// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"

#include <twum/motors/statistic.hpp>

namespace twum::inline v0_1::studies {
namespace {

Json robust_limit_json(const RobustLimit& limit) {
  Json importance = Json::object();
  for (const NamedValue& one : limit.importance) importance[one.name] = number_json(one.value);
  return {{"text", limit.text},
          {"sense", limit.at_least ? "at least" : "at most"},
          {"target", limit.target},
          {"beta", number_json(limit.beta)},
          {"probability", number_json(limit.probability)},
          {"share", number_json(limit.share)},
          {"importance", importance},
          {"converged", limit.converged}};
}

Json statistic_json(const RobustStatistic& statistic) {
  return {{"text", statistic.text},
          {"unit", statistic.unit},
          {"lower", number_json(statistic.lower)},
          {"upper", number_json(statistic.upper)},
          {"value", number_json(statistic.value.value)},
          {"low", number_json(statistic.value.low)},
          {"high", number_json(statistic.value.high)}};
}

Json density_json(const RobustDensity& density) {
  return {{"metric", density.metric},
          {"unit", density.unit},
          {"lower", number_json(density.lower)},
          {"upper", number_json(density.upper)},
          {"first", number_json(density.first)},
          {"width", number_json(density.width)},
          {"motors", density.motors},
          {"nominal", density.nominal}};
}

}  // namespace

Json robust_yield_json(const RobustYield& yield) {
  return {{"text", yield.text},
          {"target", number_json(yield.target)},
          {"value", number_json(yield.share.value)},
          {"low", number_json(yield.share.low)},
          {"high", number_json(yield.share.high)},
          {"samples", yield.samples},
          {"weighted", yield.weighted},
          {"verdict", yield.verdict.empty() ? Json(nullptr) : Json(yield.verdict)}};
}

bool is_share(const Goal& goal) {
  return is_statistic(goal.metric) && parse_statistic(goal.metric).unit() == "1";
}

Json robust_json(const RobustReport& report) {
  Json json{{"target", nullptr}, {"yield", nullptr}};
  if (!report.parts.empty()) json["parts"] = {{"file", report.parts}, {"count", report.part_count}};
  if (!report.yields.empty()) {
    json["target"] = number_json(report.yields.front().target);
    json["yield"] = robust_yield_json(report.yields.front());
  }
  json["yields"] = Json::array();
  for (const RobustYield& yield : report.yields) json["yields"].push_back(robust_yield_json(yield));
  json["statistics"] = Json::array();
  for (const RobustStatistic& one : report.statistics)
    json["statistics"].push_back(statistic_json(one));
  json["nominal"] = {{"design", values_json(report.nominal_design)},
                     {"objective", number_json(report.nominal_objective)},
                     {"yield", number_json(report.nominal_yield.value)}};
  json["price"] = number_json(std::fabs(report.nominal_objective - report.objective));
  json["price_of_yield"] = number_json(report.price_of_yield);
  json["price_over_yield"] = Json::array();
  for (const optim::YieldPrice& one : report.prices_of_yields)
    json["price_over_yield"].push_back(
        {{"yield", number_json(one.yield)}, {"objective", number_json(one.objective)}});
  json["largest_yield"] = number_json(report.largest_yield);
  json["limits"] = Json::array();
  for (const RobustLimit& limit : report.limits) json["limits"].push_back(robust_limit_json(limit));
  json["tolerances"] = Json::array();
  for (const RobustTolerance& one : report.tolerances)
    json["tolerances"].push_back(
        {{"name", one.name},
         {"sd", number_json(one.unit == "%" ? one.spread / 100 : one.spread)},
         {"unit", one.unit == "%" ? "1" : one.unit},
         {"gain_per_percent_tighter", number_json(one.gain)},
         {"yield_per_percent", number_json(one.yield_gain)},
         {"yield_per_percent_sampled",
          {{"value", number_json(one.sampled_gain.value)},
           {"low", number_json(one.sampled_gain.low)},
           {"high", number_json(one.sampled_gain.high)}}}});
  json["rounds"] = Json::array();
  for (const optim::RobustRoundReport& round : report.rounds)
    json["rounds"].push_back({{"samples", round.products},
                              {"risk", number_json(round.risk)},
                              {"error", number_json(round.error)},
                              {"objective", number_json(round.objective)}});
  Json delta = Json::object();
  for (const RobustLimit& limit : report.limits) delta[limit.text] = number_json(limit.delta);
  json["correction"] = {
      {"kappa", number_json(report.rounds.empty() ? 0 : report.rounds.back().kappa)},
      {"delta", delta}};
  json["aimed"] = report.aimed;
  json["lost"] = report.lost;
  json["densities"] = Json::array();
  for (const RobustDensity& density : report.densities)
    json["densities"].push_back(density_json(density));
  return json;
}

}  // namespace twum::inline v0_1::studies
