// SPDX-License-Identifier: Apache-2.0
#include "results/robust_answer.hpp"
#include "results/search_words.hpp"

#include <algorithm>

namespace twum::inline v0_1::studies {
namespace {

Json yields_json(const std::vector<RobustYield>& yields) {
  Json json = Json::array();
  for (const RobustYield& yield : yields) json.push_back(robust_yield_json(yield));
  return json;
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
  if (!result.parts.empty()) json["parts"] = {{"file", result.parts}, {"count", result.part_count}};
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

}  // namespace twum::inline v0_1::studies
