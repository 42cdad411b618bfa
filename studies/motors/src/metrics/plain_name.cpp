// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/plain_name.hpp>

#include <twum/core/parameters.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

namespace twum::inline v0_1::motors {
namespace {

// Names that are not their words with underscores.
const std::map<std::string, std::string, std::less<>> kPlainWords = {
    {"amplitude", "wave amplitude"},          {"frequency", "drive frequency"},
    {"wavelengths", "number of wavelengths"}, {"no_load_speed", "no-load speed"},
    {"pull_out_torque", "pull-out torque"},   {"pull_out_frequency", "pull-out frequency"}};

std::string plain_word(const std::string& name) {
  const auto known = kPlainWords.find(name);
  if (known != kPlainWords.end()) return known->second;
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  for (const auto& [typed, read] :
       {std::pair{"youngs", "Young's"}, std::pair{"poisson", "Poisson"}})
    if (const std::size_t at = text.find(typed); at != std::string::npos)
      text.replace(at, std::string_view(typed).size(), read);
  return text;
}

// The text in the parentheses of "NAME(...)"; empty if the text has another form.
std::string inside_of(const std::string& text, std::string_view name) {
  const bool call = text.starts_with(name) && text.ends_with(')') &&
                    text.size() > name.size() + 1 && text[name.size()] == '(';
  return call ? text.substr(name.size() + 1, text.size() - name.size() - 2) : "";
}

std::string statistic_name(const std::string& text) {
  if (const std::string of = inside_of(text, "mean"); !of.empty()) return "mean " + plain_name(of);
  if (const std::string of = inside_of(text, "sd"); !of.empty())
    return "standard deviation of the " + plain_name(of);
  if (const std::string of = inside_of(text, "probability"); !of.empty())
    return "probability of " + plain_limit(of);
  const std::string of = inside_of(text, "quantile");
  const std::size_t comma = of.rfind(',');
  if (comma == std::string::npos) return "";
  return std::string(trimmed(of.substr(comma + 1))) + " quantile of the " +
         plain_name(of.substr(0, comma));
}

}  // namespace

std::string plain_name(const std::string& name) {
  if (const std::string statistic = statistic_name(name); !statistic.empty()) return statistic;
  const std::size_t call = name.find("_at(");
  const bool word = std::all_of(
      name.begin(), name.begin() + static_cast<std::ptrdiff_t>(std::min(call, name.size())),
      [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  if (!word || (call != std::string::npos && !name.ends_with(')'))) return name;
  if (call != std::string::npos)
    return plain_word(name.substr(0, call)) + " at " +
           name.substr(call + 4, name.size() - call - 5);
  const auto parameter = find_parameter(name);
  const bool layer = parameter && info(*parameter).file_entry.starts_with("contact_layer");
  return (layer ? "contact layer " : "") + plain_word(name);
}

std::string plain_limit(const std::string& text) {
  static const std::map<std::string_view, std::string> kLimitSigns = {
      {">=", "≥"}, {"<=", "≤"}, {"==", "="}, {"+-", "±"}};
  std::string plain, part;
  const auto flush = [&] {
    const std::string word(trimmed(part));
    if (!word.empty()) plain += (plain.empty() ? "" : " ") + plain_name(word);
    part.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto sign = kLimitSigns.find(std::string_view(text).substr(i, 2));
    if (sign == kLimitSigns.end()) {
      part += text[i];
      continue;
    }
    flush();
    plain += (plain.empty() ? "" : " ") + sign->second;
    ++i;
  }
  flush();
  return plain;
}

}  // namespace twum::inline v0_1::motors
