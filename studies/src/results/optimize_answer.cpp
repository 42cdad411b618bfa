// SPDX-License-Identifier: Apache-2.0
#include "results/moves_json.hpp"
#include "results/robust_answer.hpp"
#include "results/search_words.hpp"

namespace twum::inline v0_1::studies {
namespace {

Json stages_json(const OptimizeResult& result) {
  Json json = Json::array();
  for (const optim::StageReport& stage : result.stages)
    json.push_back({{"stage", stage.stage},
                    {"solver", stage.solver},
                    {"word", stage.word},
                    {"code", stage.code},
                    {"feasible", stage.feasible},
                    {"objective", number_json(stage.objective)},
                    {"evaluations", stage.evaluations}});
  for (std::size_t i = 0; i < result.slices_of_stages.size(); ++i)
    json[i]["slices"] = result.slices_of_stages[i];
  return json;
}

Json scan_json(const optim::Scan& scan) {
  return {{"designs", scan.designs},
          {"feasible", scan.feasible},
          {"better", scan.better},
          {"replaced", scan.replaced},
          {"before", number_json(scan.before)}};
}

}  // namespace

Json answer_json(const OptimizeResult& result) {
  Json json{{"objective", goal_json(result.goal)}};
  json["best"] = result.found ? report_json(result.best) : Json(nullptr);
  if (!result.explanation.empty()) json["relaxation"] = relaxation_json(result.explanation);
  json["before"] = {{"design", values_json(result.before_design)},
                    {"metrics", values_json(result.before_metrics)}};
  if (!result.before_statistics.empty())
    json["before"]["statistics"] = values_json(result.before_statistics);
  if (result.robust) json["robust"] = robust_json(*result.robust);
  json["variables_without_influence"] = result.without_influence;
  json["moves"] = moves_json(result.moving, result.moves);
  if (!result.unmoved.empty()) json["moves_missing"] = result.unmoved;
  for (const auto& [radius, other] : result.touching) json["moves_touching"][radius] = other;
  json["scan"] = scan_json(result.scan);
  json["solver"] = result.solver;
  json["stages"] = stages_json(result);
  json["units"] = Json::object();
  add_units(json["units"], result.before_design);
  add_units(json["units"], result.before_metrics);
  add_units(json["units"], result.best.statistics);
  return json;
}

}  // namespace twum::inline v0_1::studies
