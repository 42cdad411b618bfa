// SPDX-License-Identifier: Apache-2.0
#include "quantity_text.hpp"

#include <cmath>
#include <cstdio>

namespace twum::inline v0_1::stator {
namespace {

struct Prefix {
  double factor;
  const char* letter;
};

// The largest that leaves one or more before the point.
Prefix prefix_of(double value, std::string_view unit) {
  constexpr Prefix kPrefixes[] = {{1e9, "G"}, {1e6, "M"},  {1e3, "k"},
                                  {1, ""},    {1e-3, "m"}, {1e-6, "u"}};
  if (unit != "m" && unit != "Pa") return {1, ""};
  for (const Prefix& prefix : kPrefixes)
    if (std::fabs(value) >= prefix.factor && std::isfinite(value)) return prefix;
  return {1, ""};
}

}  // namespace

std::string quantity_text(double value, std::string_view unit) {
  const Prefix prefix = prefix_of(value, unit);
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value / prefix.factor);
  return unit == "1" ? text : std::string(text) + " " + prefix.letter + std::string(unit);
}

}  // namespace twum::inline v0_1::stator
