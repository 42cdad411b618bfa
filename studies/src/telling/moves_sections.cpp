// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/limit_parts.hpp"
#include "telling/tellings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace twum::inline v0_1::studies::telling {
namespace {

constexpr double kMore = 0.01;  // relative change of what is held

double change_of(const Move& move, std::size_t j) {
  return move.slopes[j] * kMore * move.held.value;
}

constexpr double kNotable = 1e-4;  // the last digit of change_part()

// Beyond the range of a variable the answer is another one, which no slope tells.
bool leaves_range(const NamedValue& answer, const Move& move, std::size_t j,
                  const Sources& sources) {
  const auto range = range_of(sources, answer.name);
  const double then = answer.value + change_of(move, j), room = kNotable * std::fabs(answer.value);
  return range && (then < range->first - room || then > range->second + room);
}

// Relative change of a number of the answer; 0 where there is none.
double part_of(const NamedValue& answer, const Move& move, std::size_t j) {
  const double size = std::fabs(change_of(move, j) / answer.value);
  return std::isfinite(size) ? size : 0;
}

double most(const std::vector<NamedValue>& answer, const Move& move) {
  double largest = 0;
  for (std::size_t j = 0; j < answer.size(); ++j)
    largest = std::max(largest, part_of(answer[j], move, j));
  return largest;
}

// Those that count, the one that counts most first.
std::vector<const Move*> by_weight(const std::vector<NamedValue>& answer,
                                   const std::vector<Move>& moves) {
  std::vector<const Move*> order;
  for (const Move& move : moves)
    if (most(answer, move) >= kNotable) order.push_back(&move);
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](const Move* move) { return most(answer, *move); });
  return order;
}

// "-1 %", to hundredths of a per cent; the change itself where the answer is 0.
Part change_part(const NamedValue& answer, const Move& move, std::size_t j) {
  const double by = change_of(move, j);
  if (answer.value == 0 && by != 0) return change(value_part(by, answer.unit, 3));
  const double share = answer.value == 0 ? 0 : std::round(1e4 * by / answer.value) / 1e4;
  return std::isfinite(by) && share != 0 ? change(share_part(share, 6))
                                         : share_part(share + 0.0, 6);  // no -0 %
}

bool moves_any(const NamedValue& answer, const std::vector<const Move*>& order, std::size_t j) {
  return std::ranges::any_of(order, [&](const Move* move) {
    return change_part(answer, *move, j).value != 0;  // nor unknown
  });
}

// Numbers that do not change have no column.
Table table_of(const std::vector<NamedValue>& answer, const std::vector<const Move*>& order,
               const Sources& sources) {
  Table table{"moves", {{"fixed parameter"}, {"value"}}, {{{"(present answer)"}, {"-"}}}};
  for (const Move* move : order)
    table.rows.push_back({{name_part(move->held.name)},
                          {named_part(move->held.name, move->held.value, move->held.unit)}});
  for (std::size_t j = 0; j < answer.size(); ++j) {
    if (!moves_any(answer[j], order, j)) continue;
    table.heads.push_back({name_part(answer[j].name)});
    table.rows[0].push_back({value_part(answer[j].value, answer[j].unit)});
    for (std::size_t i = 0; i < order.size(); ++i)
      table.rows[i + 1].push_back({leaves_range(answer[j], *order[i], j, sources)
                                       ? "out of its range"
                                       : change_part(answer[j], *order[i], j)});
  }
  return table;
}

std::vector<Phrase> unchanged(const std::vector<NamedValue>& answer,
                              const std::vector<const Move*>& order) {
  std::vector<Part> names;
  for (std::size_t j = 0; j < answer.size(); ++j)
    if (!moves_any(answer[j], order, j)) names.push_back(name_part(answer[j].name));
  if (names.empty()) return {};
  Phrase phrase = listed(names);
  append(phrase, {names.size() == 1 ? " does not change." : " do not change."});
  return {phrase};
}

// The parameter of the answer that a row changes most once more, in words; nothing if its digits do not show the change, or any of
// the answer leaves its range.
std::optional<Phrase> example(const std::vector<NamedValue>& answer, const Move& move,
                              const std::string& goal, const Sources& sources) {
  for (std::size_t j = 0; j < answer.size(); ++j)
    if (leaves_range(answer[j], move, j, sources)) return {};
  std::size_t at = 0;
  for (std::size_t j = 1; j < answer.size(); ++j)
    if (answer[j].name != goal && part_of(answer[j], move, j) > part_of(answer[at], move, at))
      at = j;
  const Part now = value_part(answer[at].value, answer[at].unit);
  const Part then = value_part(answer[at].value + change_of(move, at), answer[at].unit);
  if (written(now, Writing::typed) == written(then, Writing::typed)) return {};
  return Phrase{"If ",
                name_part(move.held.name),
                " were ",
                named_part(move.held.name, (1 + kMore) * move.held.value, move.held.unit),
                " instead of ",
                named_part(move.held.name, move.held.value, move.held.unit),
                ", ",
                name_part(answer[at].name),
                " would be ",
                then,
                " instead of ",
                now,
                "."};
}

}  // namespace

std::vector<Section> moves_sections(
    const std::vector<NamedValue>& answer, const std::vector<Move>& moves, const std::string& goal,
    const std::string& missing, const Sources& sources,
    const std::vector<std::pair<std::string, std::string>>& touching) {
  Section section{{"Change of the answer if a fixed parameter is 1 % larger"}};
  if (!missing.empty()) {
    section.heading = {"Fixed parameters"};
    section.sentences = {
        {"The change of the answer with a fixed parameter is unknown: " + missing + "."}};
    return {section};
  }
  const std::vector<const Move*> order = by_weight(answer, moves);
  if (order.empty()) return {};
  section.note = {
      "In each row one parameter is 1 % larger, the others are unchanged, and the answer is found "
      "again, to first order. Where a value would leave its range, solve again."};
  section.sentences = unchanged(answer, order);
  for (const Move* move : order)
    if (auto told = example(answer, *move, goal, sources)) {
      section.sentences.push_back(*std::move(told));
      break;
    }
  for (const auto& [radius, other] : touching)
    section.sentences.push_back({name_part(radius), " has no row, because it equals ",
                                 name_part(other),
                                 ". Changed alone, it would create a step in the geometry."});
  section.tables = {table_of(answer, order, sources)};
  return {section};
}

}  // namespace twum::inline v0_1::studies::telling
