// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/unit_box.hpp"

#include "entries/spacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::studies {
namespace {

double value_at(const DesignVariable& range, double u) {
  if (!info(range.parameter).integer) return between(range.min, range.max, u, range.log);
  return std::clamp(std::floor(between(range.min, range.max + 1, u, range.log)), range.min,
                    range.max);
}

double coordinate_of(const DesignVariable& range, double value) {
  if (range.log) return std::log(value / range.min) / std::log(range.max / range.min);
  return (value - range.min) / (range.max - range.min);
}

}  // namespace

std::vector<Parameter> UnitBox::parameters() const {
  std::vector<Parameter> result;
  for (const DesignVariable& range : ranges_) result.push_back(range.parameter);
  return result;
}

std::vector<double> UnitBox::values(std::span<const double> unit) const {
  std::vector<double> result;
  for (std::size_t j = 0; j < size(); ++j) result.push_back(value_at(ranges_[j], unit[j]));
  return result;
}

std::vector<double> UnitBox::coordinates(std::span<const double> unit) const {
  std::vector<double> result(unit.begin(), unit.end());
  for (std::size_t j = 0; j < size(); ++j) {
    if (info(ranges_[j].parameter).integer)
      result[j] = coordinate_of(ranges_[j], value_at(ranges_[j], unit[j]));
  }
  return result;
}

double UnitBox::slope(std::size_t variable, double value) const {
  const DesignVariable& range = ranges_[variable];
  if (info(range.parameter).integer) return std::numeric_limits<double>::quiet_NaN();
  return range.log ? value * std::log(range.max / range.min) : range.max - range.min;
}

}  // namespace twum::studies
