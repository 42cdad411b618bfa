// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/units/engineering.hpp>

#include <twum/studies/text/number.hpp>

#include <cmath>
#include <numbers>

namespace twum::studies {
namespace {

struct EngineeringPrefix {
  const char* text;
  double value;
};

constexpr EngineeringPrefix kEngineeringPrefixes[] = {{"T", 1e12}, {"G", 1e9},  {"M", 1e6},
                                                      {"k", 1e3},  {"", 1},     {"m", 1e-3},
                                                      {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};

// A prefix before kg or 1 would be wrong, and before a unit that contains kg unusual. Before a power it belongs to
// the base: mm^2 is a millionth of m^2.
bool takes_prefix(std::string_view si_unit) {
  const std::size_t end = si_unit.find_first_of("./^(");
  const bool power = end != std::string_view::npos && (si_unit[end] == '^' || si_unit[end] == '(');
  return !power && !si_unit.starts_with("kg") && !si_unit.starts_with("1");
}

}  // namespace

DisplayUnit display_unit(double size, std::string_view si_unit) {
  if (si_unit == "1") return {"", 1};
  if (si_unit == "rad/s") return {"rpm", 2 * std::numbers::pi / 60};
  const double magnitude = std::abs(size);
  if (!takes_prefix(si_unit) || !(magnitude >= 1e-12) || !std::isfinite(magnitude)) {
    return {std::string(si_unit), 1};
  }
  for (const EngineeringPrefix& prefix : kEngineeringPrefixes) {
    // 0.99999999 k is shown as 1 k, not as 1000.
    if (magnitude >= prefix.value * (1 - 1e-9))
      return {prefix.text + std::string(si_unit), prefix.value};
  }
  return {std::string(si_unit), 1};
}

std::string engineering(double value, std::string_view si_unit, int digits) {
  const DisplayUnit unit = display_unit(value, si_unit);
  const std::string number = rounded_text(value / unit.divisor, digits);
  return unit.text.empty() ? number : number + " " + unit.text;
}

}  // namespace twum::studies
