// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"
#include "results/provenance.hpp"

#include <twum/base/version.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// A number, or the name of the set with this number.
Json end_json(const StoredColumn& variable, double value) {
  const std::string* word = variable.word(value);
  return word == nullptr ? number_json(value) : Json(*word);
}

Json regions_json(const std::vector<FailureRegion>& regions) {
  Json list = Json::array();
  for (const FailureRegion& region : regions) {
    Json where = Json::object();
    for (const FailureRegion::Range& range : region.where) {
      where[range.variable.name] = {{"low", end_json(range.variable, range.low)},
                                    {"high", end_json(range.variable, range.high)}};
    }
    list.push_back({{"reason", region.reason}, {"count", region.count}, {"where", where}});
  }
  return list;
}

}  // namespace

Json summary_value(const StudyResult& result) {
  Json json{{"study", result.study},
            {"kind", to_string(result.kind)},
            {"motor", result.motor},
            {"outcome", result.outcome.c_str()},
            {"evaluations", result.evaluations},
            {"failures", result.failures},
            {"failure_regions", regions_json(result.failure_regions)},
            {"seed", result.seed},
            {"version", version()},
            {"started", result.started},
            {"seconds", number_json(result.seconds)},
            {"hash", result.hash},
            {"build", build_json()},
            {"model_notes", result.model_notes}};
  const Json answer = std::visit([](const auto& one) { return answer_json(one); }, result.answer);
  json.update(answer);
  return json;
}

std::string summary_json(const StudyResult& result) {
  return summary_value(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twum::inline v0_1::studies
