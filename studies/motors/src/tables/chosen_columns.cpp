// SPDX-License-Identifier: Apache-2.0
#include "tables/chosen_columns.hpp"

#include "tables/heading.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>

namespace twum::inline v0_1::motors {
namespace {

std::string unit_of_heading(std::string_view text) {
  for (const Heading& form : heading_forms(text))
    if (form.has_unit && names_unit(form.unit)) return std::string(form.unit);
  return {};
}

std::string listed(const std::vector<ColumnHeading>& headings) {
  std::string text;
  for (const ColumnHeading& heading : headings)
    text += (text.empty() ? "" : ", ") + quoted(heading.text);
  return text;
}

std::vector<ColumnHeading>::iterator column_of(const ColumnChoice& choice,
                                               std::vector<ColumnHeading>& headings) {
  if (choice.number > 0)
    return headings.begin() +
           static_cast<std::ptrdiff_t>(std::min(choice.number - 1, headings.size()));
  return std::ranges::find_if(headings, [&](const ColumnHeading& heading) {
    return !heading.chosen && names(choice, heading.text);
  });
}

}  // namespace

bool names(const ColumnChoice& choice, std::string_view heading) {
  const std::string_view wanted = trimmed(choice.heading);
  if (wanted.empty()) return false;
  if (trimmed(heading) == wanted) return true;
  return std::ranges::any_of(heading_forms(heading),
                             [&](const Heading& form) { return form.name == wanted; });
}

void name_chosen_columns(const std::vector<ColumnChoice>& choices,
                         std::vector<ColumnHeading>& headings, SourceMark begin,
                         Diagnostics& diagnostics) {
  const std::string all = listed(headings);
  for (const ColumnChoice& choice : choices) {
    const auto column = column_of(choice, headings);
    const std::string wanted =
        choice.number > 0 ? std::to_string(choice.number) : quoted(choice.heading);
    if (column == headings.end()) {
      diagnostics.add(begin, choice.quantity,
                      "no column " + wanted + ", which 'columns' of the study names",
                      "expected one of " + all);
      continue;
    }
    if (column->chosen) {
      diagnostics.add(column->mark, choice.quantity,
                      "column " + wanted + " has another meaning already",
                      "name each column once under 'columns' of the study");
      continue;
    }
    if (parse_number(column->text)) {
      diagnostics.add(column->mark, choice.quantity,
                      "a number where the headings should be: " + quoted(column->text),
                      "add a line with a heading for each column above the numbers");
      return;
    }
    const std::string unit = choice.unit.empty() ? unit_of_heading(column->text) : choice.unit;
    column->text = choice.quantity + (unit.empty() ? "" : " [" + unit + "]");
    column->chosen = true;
    column->reversed = choice.reversed;
  }
}

}  // namespace twum::inline v0_1::motors
