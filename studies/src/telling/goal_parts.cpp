// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"

#include "results/robust_answer.hpp"
#include "telling/load_parts.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace twum::inline v0_1::studies::telling {

Part goal_part(const Goal& goal, double value, int digits) {
  return is_share(goal) ? share_part(value, digits) : value_part(value, goal.unit, digits);
}

Part goal_part_of(const Goal& goal, double value) {
  return is_share(goal) ? share_part(value) : named_part(goal.metric, value, goal.unit);
}

Axis goal_axis(const Goal& goal) {
  return {{name_part(goal.metric)}, is_share(goal) ? "%" : goal.unit};
}

Phrase goal_name(const Goal& goal) {
  return {goal.maximize ? "largest " : "smallest ", name_part(goal.metric)};
}

bool is_temperature(const std::string& name) {
  if (const auto metric = find_metric(name)) return info(*metric).absolute;
  if (find_parameter(name)) return name.find("_temperature") != std::string::npos;
  try {
    return is_absolute(parse_side(name));
  } catch (const ValueError&) {
    return false;  // no expression, such as the name of a program's own metric
  }
}

Part named_part(const std::string& name, double value, const std::string& unit, int digits) {
  if (name == "radial_slices" && std::isfinite(value)) return parameter_text(name, value, unit);
  if (unit == "K" && is_temperature(name)) return celsius_part(value, digits);
  return value_part(value, unit, digits);
}

Part count_part(std::uint64_t count) { return value_part(static_cast<double>(count), "1", 17); }

int interval_digits(double low, double high) {
  const double size = std::max(std::fabs(low), std::fabs(high));
  const double digits = std::ceil(std::log10(2 * size / (high - low))) + 1;
  return std::isfinite(digits) ? static_cast<int>(std::clamp(digits, 4.0, 9.0)) : 4;
}

Phrase listed(const std::vector<Part>& parts, const std::string& last) {
  Phrase phrase;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) phrase.push_back(i + 1 < parts.size() ? std::string(", ") : last);
    phrase.push_back(parts[i]);
  }
  return phrase;
}

std::vector<Part> name_parts(const std::vector<std::string>& names) {
  std::vector<Part> parts;
  for (const std::string& name : names) parts.push_back(name_part(name));
  return parts;
}

Phrase capitalized(Phrase phrase) {
  if (phrase.empty()) return phrase;
  Part& first = phrase.front();
  if (first.kind == Part::Kind::name || first.kind == Part::Kind::limit) {
    first.text = written(first, Writing::page);
    first.kind = Part::Kind::words;
  }
  // A formula begins as one types it.
  const bool typed = first.text.substr(0, first.text.find(' ')).find('_') != std::string::npos;
  if (first.kind == Part::Kind::words && !first.text.empty() && !typed)
    first.text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(first.text[0])));
  return phrase;
}

void append(Phrase& phrase, const Phrase& more) {
  phrase.insert(phrase.end(), more.begin(), more.end());
}

Phrase strong(Phrase phrase) {
  for (Part& part : phrase) part.strong = true;
  return phrase;
}

Section hooked(const std::string& hook) {
  Section section;
  section.hook = hook;
  return section;
}

std::string colour_of(std::size_t i) { return "c" + std::to_string(i % 7); }

std::vector<double> column_values(const ResultStore& rows, const std::string& name) {
  const std::vector<StoredColumn>& columns = rows.columns();
  const auto place = std::ranges::find(columns, name, &StoredColumn::name);
  if (place == columns.end()) return {};
  const auto column = static_cast<std::size_t>(place - columns.begin());
  std::vector<double> values;
  rows.read([&](const StoredRow& row) { values.push_back(row.values[column]); });
  return values;
}

}  // namespace twum::inline v0_1::studies::telling
