// SPDX-License-Identifier: Apache-2.0
#include "results/move_words.hpp"

#include "results/search_words.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

constexpr double kMore = 0.01;  // relative change of what is held
const char* const kNoChange = "0 %";

double change(const Move& move, std::size_t j) { return move.slopes[j] * kMore * move.held.value; }

// Relative change of a number of the answer; 0 where there is none.
double part(const NamedValue& answer, const Move& move, std::size_t j) {
  const double size = std::fabs(change(move, j) / answer.value);
  return std::isfinite(size) ? size : 0;
}

double most(const std::vector<NamedValue>& answer, const Move& move) {
  double largest = 0;
  for (std::size_t j = 0; j < answer.size(); ++j)
    largest = std::max(largest, part(answer[j], move, j));
  return largest;
}

// Those that count, the one that counts most first.
std::vector<const Move*> by_weight(const std::vector<NamedValue>& answer,
                                   const std::vector<Move>& moves) {
  constexpr double kNotable = 1e-4;  // the last digit of change_text()
  std::vector<const Move*> order;
  for (const Move& move : moves)
    if (most(answer, move) >= kNotable) order.push_back(&move);
  std::stable_sort(order.begin(), order.end(), [&](const Move* a, const Move* b) {
    return most(answer, *a) > most(answer, *b);
  });
  return order;
}

// "-1 %", to hundredths of a percent; the change itself where the answer is 0.
std::string change_text(const NamedValue& answer, const Move& move, std::size_t j) {
  const double by = change(move, j);
  if (!std::isfinite(by)) return "-";
  if (answer.value == 0 && by != 0) return (by > 0 ? "+" : "") + engineering(by, answer.unit, 3);
  const double percent = answer.value == 0 ? 0 : std::round(1e4 * by / answer.value) / 100;
  if (percent == 0) return kNoChange;
  return (percent > 0 ? "+" : "") + rounded_text(percent, 6) + " %";
}

// The row with the largest change once more, in words.
std::string example(const std::vector<NamedValue>& answer, const Move& move, std::size_t chosen,
                    const std::string& word) {
  std::size_t at = 0;
  for (std::size_t j = 1; j < chosen; ++j)
    if (part(answer[j], move, j) > part(answer[at], move, at)) at = j;
  const auto shown = [](double value, const std::string& unit) {
    return engineering(value, unit, 4);
  };
  return "If " + move.held.name + " were " + shown((1 + kMore) * move.held.value, move.held.unit) +
         " instead of " + shown(move.held.value, move.held.unit) + ", the " + word + " " +
         answer[at].name + " would be " +
         shown(answer[at].value + change(move, at), answer[at].unit) + " instead of " +
         shown(answer[at].value, answer[at].unit) + ".\n";
}

std::string unchanged_words(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return enumeration(names) + (names.size() == 1 ? " does" : " do") + " not change.\n";
}

}  // namespace

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

std::string moves_table(const std::vector<NamedValue>& answer, const std::vector<Move>& moves,
                        std::size_t chosen, const std::string& word) {
  constexpr std::size_t kMost = 6;  // summary.json and the page have all
  std::vector<const Move*> order = by_weight(answer, moves);
  if (order.empty()) return {};
  order.resize(std::min(order.size(), kMost));
  TextTable table{{{"fixed parameter"}, {"(answer now)"}}};
  for (const Move* move : order)
    table.rows.push_back(
        {move->held.name + " " + engineering(move->held.value, move->held.unit, 4)});
  std::vector<std::string> unchanged;
  for (std::size_t j = 0; j < answer.size(); ++j) {
    std::vector<std::string> column{answer[j].name, engineering(answer[j].value, answer[j].unit)};
    for (const Move* move : order) column.push_back(change_text(answer[j], *move, j));
    if (std::all_of(column.begin() + 2, column.end(), [](const auto& c) { return c == kNoChange; }))
      unchanged.push_back(answer[j].name);
    else
      for (std::size_t i = 0; i < column.size(); ++i) table.rows[i].push_back(column[i]);
  }
  return "\nHow the answer changes if a fixed parameter is 1 % larger\n\n" +
         aligned(table, kSummaryWidth) + unchanged_words(unchanged) +
         example(answer, *order.front(), chosen, word);
}

}  // namespace twum::studies
