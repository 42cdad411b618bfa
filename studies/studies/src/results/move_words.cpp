// SPDX-License-Identifier: Apache-2.0
#include "results/move_words.hpp"

#include <twum/studies/text/number.hpp>
#include <twum/studies/text/text_table.hpp>
#include <twum/studies/units/engineering.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

constexpr double kMore = 0.01;  // change of what is held, in parts of it

double moved(const NamedValue& answer, const Move& move, std::size_t j) {
  return answer.value + move.slopes[j] * kMore * move.held.value;
}

// Relative change of a number of the answer; 0 where there is none.
double part(const NamedValue& answer, const Move& move, std::size_t j) {
  const double size = std::fabs(moved(answer, move, j) / answer.value - 1);
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
  constexpr double kNotable = 1e-4;
  std::vector<const Move*> order;
  for (const Move& move : moves)
    if (most(answer, move) >= kNotable) order.push_back(&move);
  std::stable_sort(order.begin(), order.end(), [&](const Move* a, const Move* b) {
    return most(answer, *a) > most(answer, *b);
  });
  return order;
}

// The first row once more, in words.
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
         answer[at].name + " would be " + shown(moved(answer[at], move, at), answer[at].unit) +
         " instead of " + shown(answer[at].value, answer[at].unit) + ".\n";
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
  TextTable table{{{"held fixed", "if it were"}}};
  for (const NamedValue& one : answer) table.rows[0].push_back(one.name);
  for (const Move* move : order) {
    table.rows.push_back({move->held.name + " " + engineering(move->held.value, move->held.unit, 4),
                          engineering((1 + kMore) * move->held.value, move->held.unit, 4)});
    for (std::size_t j = 0; j < answer.size(); ++j) {
      const double value = moved(answer[j], *move, j);
      table.rows.back().push_back(std::isfinite(value) ? engineering(value, answer[j].unit) : "-");
    }
  }
  return "\nWhat the answer would be with another value of what is held fixed\n\n" +
         aligned(table) + example(answer, *order.front(), chosen, word);
}

}  // namespace twum::studies
