// SPDX-License-Identifier: Apache-2.0
#include "tables/parameter_heading.hpp"

#include <twum/io/words.hpp>

namespace twum::inline v0_1::motors {

namespace {

std::optional<Parameter> spelled(std::string_view name) {
  if (const auto parameter = find_parameter(name)) return parameter;
  constexpr std::string_view kMotor = "motor.";
  if (name.starts_with(kMotor)) name.remove_prefix(kMotor.size());
  for (const ParameterInfo& row : parameter_table())
    if (row.file_entry == name) return row.parameter;
  return {};
}

}  // namespace

std::optional<Parameter> parameter_named(std::string_view name) {
  if (const auto parameter = spelled(name)) return parameter;
  return name.size() > kLongestSymbol ? spelled(in_small_letters(name)) : std::nullopt;
}

bool is_bare_letter(const Heading& heading) {
  return heading.name.size() == 1 && !heading.has_unit;
}

std::string bare_letter_words(std::string_view letter, const ParameterInfo& row) {
  return "the letter " + quoted(letter) + " alone does not say whether " + std::string(row.name) +
         " is meant";
}

std::string bare_letter_advice(const ParameterInfo& row) {
  return "write '" + heading_of(row) + "', or another heading if it is no parameter";
}

std::string heading_of(const ParameterInfo& row) {
  return std::string(row.name) + (row.unit == "1" ? "" : " [" + std::string(row.unit) + "]");
}

}  // namespace twum::inline v0_1::motors
