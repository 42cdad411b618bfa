// SPDX-License-Identifier: Apache-2.0
#include <twum/io/dimension.hpp>

#include "units/unit_definitions.hpp"
#include "units/unit_system.hpp"

#include <twum/io/number.hpp>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kRadian = 3;
static_assert(std::string_view(kBaseUnits[kRadian].symbol) == "rad");

// Powers such as 3 * (1/3) differ from integers by a few roundings; different powers differ by far more.
bool same_power(double a, double b) { return std::fabs(a - b) < 1e-9; }

using NamedUnit = std::pair<std::string, Dimension>;

const std::vector<NamedUnit>& named_units() {
  static const std::vector<NamedUnit> units = [] {
    std::vector<NamedUnit> list;
    for (const NamedDimension& named : kDimensions)
      list.emplace_back(named.unit, Dimension(named.unit));
    return list;
  }();
  return units;
}

std::string factor_text(const char* symbol, double power) {
  return same_power(power, 1) ? symbol : std::string(symbol) + "^" + rounded_text(power, 4);
}

bool is_single(const std::string& unit) { return unit.find_first_of("./^") == std::string::npos; }

}  // namespace

Dimension::Dimension(std::string_view unit) {
  if (unit == "1") return;
  const auto powers = base_powers(unit);
  for (std::size_t i = 0; i < powers_.size(); ++i) powers_[i] = powers[i];
}

Dimension Dimension::times(const Dimension& other) const {
  Dimension result = *this;
  for (std::size_t i = 0; i < powers_.size(); ++i) result.powers_[i] += other.powers_[i];
  return result;
}

Dimension Dimension::over(const Dimension& other) const { return times(other.power(-1)); }

Dimension Dimension::power(double exponent) const {
  Dimension result = *this;
  for (double& power : result.powers_) power *= exponent;
  return result;
}

bool Dimension::differs_by_angle_only(const Dimension& other) const {
  Dimension turned = *this;
  turned.powers_[kRadian] = other.powers_[kRadian];
  return turned == other && !(*this == other);
}

bool Dimension::operator==(const Dimension& other) const {
  for (std::size_t i = 0; i < powers_.size(); ++i) {
    if (!same_power(powers_[i], other.powers_[i])) return false;
  }
  return true;
}

std::string Dimension::unit() const {
  if (none()) return "1";
  for (const auto& [unit, dimension] : named_units()) {
    if (dimension == *this) return unit;
  }
  for (const auto& [unit, dimension] : named_units()) {
    if (dimension.power(2) == *this) return is_single(unit) ? unit + "^2" : "(" + unit + ")^2";
  }
  std::string above;
  std::string below;
  std::size_t divisors = 0;
  for (std::size_t i = 0; i < powers_.size(); ++i) {
    if (same_power(powers_[i], 0)) continue;
    std::string& side = powers_[i] > 0 ? above : below;
    if (powers_[i] < 0) ++divisors;
    side += (side.empty() ? "" : ".") + factor_text(kBaseUnits[i].symbol, std::fabs(powers_[i]));
  }
  if (below.empty()) return above;
  if (divisors > 1) below = "(" + below + ")";
  return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace twum::inline v0_1::io
