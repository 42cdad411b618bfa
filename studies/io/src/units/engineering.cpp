// SPDX-License-Identifier: Apache-2.0
#include <twum/io/engineering.hpp>

#include <twum/io/number.hpp>

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::io {
namespace {

struct EngineeringPrefix {
  const char* text;
  double value;
};

constexpr EngineeringPrefix kEngineeringPrefixes[] = {{"T", 1e12}, {"G", 1e9},  {"M", 1e6},
                                                      {"k", 1e3},  {"", 1},     {"m", 1e-3},
                                                      {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};

// A prefix before kg, %, 1, degC, minutes or hours would be wrong, and before a unit that contains kg unusual. Before a power it
// belongs to the base: mm^2 is a millionth of m^2.
bool takes_prefix(std::string_view si_unit) {
  if (si_unit == "degC" || si_unit == "min" || si_unit == "h") return false;
  const std::size_t end = si_unit.find_first_of("./^(");
  const bool power = end != std::string_view::npos && (si_unit[end] == '^' || si_unit[end] == '(');
  return !power && !si_unit.starts_with("kg") && !si_unit.starts_with("1") &&
         !si_unit.starts_with("%");
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string with_unit(double value, const DisplayUnit& unit, const std::string& text, int digits) {
  const std::string number = rounded_text(value / unit.divisor, digits);
  return text.empty() ? number : number + " " + text;
}

}  // namespace

std::vector<DisplayUnit> display_units(std::string_view si_unit) {
  if (si_unit == "1") return {{"", 1}};
  if (si_unit == "rad/s") return {{"rpm", 2 * std::numbers::pi / 60}};
  // Nobody counts in kiloseconds.
  if (si_unit == "s") return {{"h", 3600}, {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  if (!takes_prefix(si_unit)) return {{std::string(si_unit), 1}};
  std::vector<DisplayUnit> units;
  for (const EngineeringPrefix& prefix : kEngineeringPrefixes)
    units.push_back({prefix.text + std::string(si_unit), prefix.value});
  return units;
}

DisplayUnit display_unit(double size, std::string_view si_unit) {
  const std::vector<DisplayUnit> units = display_units(si_unit);
  if (units.size() == 1) return units.front();
  const double magnitude = std::abs(size);
  // 0.99999999 k is shown as 1 k, not as 1000.
  for (const DisplayUnit& unit : units)
    if (std::isfinite(magnitude) && magnitude >= unit.divisor * (1 - 1e-9)) return unit;
  return {std::string(si_unit), 1};  // no prefix is small enough
}

std::string printed_unit(std::string_view unit) {
  std::string text(unit);
  if (text.starts_with("u")) text.replace(0, 1, "µ");
  replace_all(text, "degC", "°C");
  replace_all(text, ".", "·");
  replace_all(text, "^2", "²");
  replace_all(text, "^3", "³");
  return text;
}

std::string engineering(double value, std::string_view si_unit, int digits) {
  const DisplayUnit unit = display_unit(value, si_unit);
  return with_unit(value, unit, unit.text, digits);
}

std::string printed_engineering(double value, std::string_view si_unit, int digits) {
  const DisplayUnit unit = display_unit(value, si_unit);
  return with_unit(value, unit, printed_unit(unit.text), digits);
}

}  // namespace twum::inline v0_1::io
