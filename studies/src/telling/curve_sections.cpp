// SPDX-License-Identifier: Apache-2.0
#include "telling/curve_charts.hpp"
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace twum::inline v0_1::studies::telling {
namespace {

using CurveMember = CurveResult::Member;

// Metrics that curves are compared by; they stand first.
constexpr std::string_view kFirst[] = {"stall_torque",
                                       "max_torque",
                                       "no_load_speed",
                                       "peak_power",
                                       "contact_efficiency_at_peak_power",
                                       "contact_ratio",
                                       "max_pressure"};

Phrase member_phrase(const CurveResult& answer, const CurveMember& member) {
  if (!answer.family) return {"motor"};
  return {name_part(answer.family->name), " ", value_part(member.value, answer.family->unit)};
}

std::vector<std::size_t> order_of(const std::vector<NamedValue>& metrics) {
  std::vector<std::size_t> order(metrics.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::ranges::find(kFirst, metrics[i].name) - std::begin(kFirst);
  });
  return order;
}

Table metric_table(const CurveResult& answer) {
  Table table{"metrics", {{"metric"}}, {}};
  for (const CurveMember& member : answer.members)
    table.heads.push_back(member_phrase(answer, member));
  for (const std::size_t i : order_of(answer.members.front().metrics)) {
    table.rows.push_back({{name_part(answer.members.front().metrics[i].name)}});
    for (const CurveMember& member : answer.members) {
      const NamedValue& value = member.metrics[i];
      Phrase cell{named_part(value.name, value.value, value.unit)};
      if (member.statuses[i] != "ok") append(cell, {" (" + member.statuses[i] + ")"});
      table.rows.back().push_back(std::move(cell));
    }
  }
  return table;
}

}  // namespace

Phrase efficiency_note(const std::vector<NamedValue>& metrics) {
  const auto any = [&](std::initializer_list<std::string_view> beginnings) {
    return std::ranges::any_of(metrics, [&](const NamedValue& metric) {
      return std::ranges::any_of(
          beginnings, [&](std::string_view begin) { return metric.name.starts_with(begin); });
    });
  };
  if (!any({"contact_efficiency"}) || !any({"max_efficiency", "efficiency_at"})) return {};
  return {
      "Contact efficiency is the rotor's output power over the power from the stator to the "
      "contact. Efficiency also includes the loss in the vibrating stator, so it is smaller."};
}

std::vector<Section> sections_of(const CurveResult& answer, const Sources& sources) {
  if (answer.members.empty()) return {};
  Section metrics{{"Metrics"}, efficiency_note(answer.members.front().metrics)};
  for (const CurveMember& member : answer.members) {
    if (member.failed == 0) continue;
    metrics.sentences.push_back(member_phrase(answer, member));
    append(metrics.sentences.back(),
           {": " + std::to_string(member.failed) + " of " + std::to_string(member.points) +
            " points could not be computed."});
  }
  metrics.tables = {metric_table(answer)};
  std::vector<Section> list = torque_sections({"Torque"}, sources);
  list.push_back(std::move(metrics));
  std::ranges::move(curve_sections(sources), std::back_inserter(list));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
