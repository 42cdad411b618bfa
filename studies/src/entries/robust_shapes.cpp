// SPDX-License-Identifier: Apache-2.0
#include "entries/robust_shapes.hpp"

#include <twum/io/words.hpp>
#include <twum/studies/robust_question.hpp>

#include <algorithm>
#include <utility>

namespace twum::inline v0_1::studies::shapes {
namespace {

StudyLimit parse_study_limit(std::string_view text) {
  if (is_statistic(text)) return {{}, parse_statistic_limit(text)};
  return {parse_limit(text), {}};
}

std::string study_limit_text(const StudyLimit& limit) {
  return limit.plain ? limit.plain->text : limit.statistic->text;
}

// Goals of a search, with their places.
std::vector<std::pair<std::string, const YamlNode*>> goals_of(const Given& given) {
  std::vector<std::pair<std::string, const YamlNode*>> list;
  for (const char* name : {"maximize", "minimize", "prefer"})
    if (const YamlNode* goal = given.find(name)) list.emplace_back(given.path(name), goal);
  if (const YamlNode* objectives = given.find("objectives"))
    for (std::size_t i = 0; i < objectives->items.size(); ++i)
      for (const char* name : {"maximize", "minimize"})
        if (const YamlNode* goal = objectives->items[i].find(name))
          list.emplace_back(given.path("objectives") + "[" + std::to_string(i) + "]." + name, goal);
  return list;
}

// Place of the first goal or limit on a statistic in the file.
const YamlNode* first_statistic(const Given& given, std::string& path) {
  for (const auto& [place, goal] : goals_of(given)) {
    if (!is_statistic(goal->scalar)) continue;
    path = place;
    return goal;
  }
  for (const char* name : {"constraints", "limits"}) {
    const YamlNode* list = given.find(name);
    if (list == nullptr) continue;
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      if (!is_statistic(list->items[i].scalar)) continue;
      path = given.path(name) + "[" + std::to_string(i) + "]";
      return &list->items[i];
    }
  }
  return nullptr;
}

}  // namespace

Shape<std::vector<StudyLimit>> study_limits() {
  const auto plain = text_of<StudyLimit>("a limit", "stall_torque >= 0.8 N.m", parse_study_limit,
                                         study_limit_text);
  const auto tolerant = shape_as<StudyLimit, MotorLimit>(
      tolerant_limit(),
      [](MotorLimit limit) {
        return StudyLimit{std::move(limit), {}};
      },
      [](const StudyLimit& limit) { return *limit.plain; });
  auto shape = list("limits that must hold",
                    one_of<StudyLimit>("a limit", {plain, tolerant}, [](const StudyLimit& limit) {
                      const bool own = limit.plain && !limit.plain->tolerance_text.empty();
                      return own ? std::size_t{1} : std::size_t{0};
                    }));
  shape.schema.sample = "- no_load_speed >= 100 rpm\n- max_pressure <= 10 MPa";
  return shape;
}

void check_statistics(const std::vector<Tolerance>& tolerances,
                      const std::vector<StatisticLimit>& statistics, const Given& given,
                      Diagnostics& diagnostics) {
  const YamlNode* spread = given.find("tolerances");
  const YamlNode* parts = given.find("parts");
  std::string path;
  const YamlNode* limit = first_statistic(given, path);
  if (limit != nullptr && spread == nullptr && parts == nullptr)
    diagnostics.add(limit->mark, path, quoted(limit->scalar) + " needs tolerances",
                    "add them to the study, such as 'tolerances: {preload: 3 %}'");
  if (spread == nullptr && parts == nullptr) return;
  if (limit == nullptr && statistics.empty())
    diagnostics.add(
        (spread ? spread : parts)->mark, given.path(spread ? "tolerances" : "parts"),
        spread ? "tolerances without a statistic" : "measured parts without a statistic",
        "add one to the limits, such as 'yield >= 99 %', or make one the goal");
  for (const auto& [place, goal] : goals_of(given))
    for (const StatisticLimit& one : statistics)
      if (one.statistic.unit() == "1" && trimmed(goal->scalar) == one.statistic.text)
        diagnostics.add(goal->mark, place,
                        quoted(goal->scalar) + " is limited too by " + quoted(one.text),
                        "leave out the limit: the answer is the largest possible one");
  for (const Tolerance& tolerance : tolerances) {
    const auto wrong = search_complaint(tolerance);
    if (!wrong) continue;
    const auto entry = std::find_if(
        spread->entries.begin(), spread->entries.end(),
        [&](const YamlEntry& one) { return find_parameter(one.key) == tolerance.parameter; });
    diagnostics.add(entry->value.mark, given.path("tolerances") + "." + entry->key, wrong->found(),
                    wrong->expected());
  }
}

}  // namespace twum::inline v0_1::studies::shapes
