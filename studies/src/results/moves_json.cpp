// SPDX-License-Identifier: Apache-2.0
#include "results/moves_json.hpp"

namespace twum::inline v0_1::studies {

Json moves_json(const std::vector<NamedValue>& answer, const std::vector<Move>& moves) {
  Json json = Json::object();
  for (const Move& move : moves) {
    Json slopes = Json::object();
    for (std::size_t j = 0; j < answer.size(); ++j)
      slopes[answer[j].name] = number_json(move.slopes[j]);
    json[move.held.name] = {
        {"value", move.held.value}, {"unit", move.held.unit}, {"slopes", std::move(slopes)}};
  }
  return json;
}

}  // namespace twum::inline v0_1::studies
