// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"

#include "results/robust_answer.hpp"

#include <cctype>

namespace twum::studies::telling {

Part goal_part(const Goal& goal, double value, int digits) {
  return is_share(goal) ? share_part(value, digits) : value_part(value, goal.unit, digits);
}

Axis goal_axis(const Goal& goal) {
  return {{name_part(goal.metric)}, is_share(goal) ? "%" : goal.unit};
}

Phrase listed(const std::vector<Part>& parts, const std::string& last) {
  Phrase phrase;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) phrase.push_back(i + 1 < parts.size() ? std::string(", ") : last);
    phrase.push_back(parts[i]);
  }
  return phrase;
}

Phrase capitalized(Phrase phrase) {
  if (phrase.empty()) return phrase;
  Part& first = phrase.front();
  if (first.kind == Part::Kind::name || first.kind == Part::Kind::limit) {
    first.text = written(first, Writing::page);
    first.kind = Part::Kind::words;
  }
  if (first.kind == Part::Kind::words && !first.text.empty())
    first.text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(first.text[0])));
  return phrase;
}

void append(Phrase& phrase, const Phrase& more) {
  phrase.insert(phrase.end(), more.begin(), more.end());
}

}  // namespace twum::studies::telling
