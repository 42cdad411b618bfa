// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/unit_box.hpp"

#include "entries/spacing.hpp"

#include <twum/optim/distributions.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::studies {
namespace {

double value_at(const DesignVariable& range, double u) {
  if (!info(range.parameter).integer) return between(range.min, range.max, u, range.scale);
  return std::clamp(std::floor(between(range.min, range.max + 1, u, range.scale)), range.min,
                    range.max);
}

double coordinate_of(const DesignVariable& range, double value) {
  if (range.scale == optim::Scale::log)
    return std::log(value / range.min) / std::log(range.max / range.min);
  return (value - range.min) / (range.max - range.min);
}

}  // namespace

UnitBox::UnitBox(const std::vector<Tolerance>& tolerances, const MotorDesign& motor) {
  for (const Tolerance& one : tolerances) {
    const double own = get(motor, one.parameter);
    ranges_.push_back({.parameter = one.parameter, .start = one.centre(own)});
    laws_.push_back(one.distribution(own));
  }
}

std::vector<Parameter> UnitBox::parameters() const {
  std::vector<Parameter> result;
  for (const DesignVariable& range : ranges_) result.push_back(range.parameter);
  return result;
}

std::vector<double> UnitBox::values(std::span<const double> unit) const {
  std::vector<double> result;
  for (std::size_t j = 0; j < size(); ++j) {
    result.push_back(of_tolerances() ? laws_[j].of_normal(optim::normal_quantile(unit[j])).value
                                     : value_at(ranges_[j], unit[j]));
    if (of_tolerances() && info(ranges_[j].parameter).integer)
      result.back() = std::round(result.back());
  }
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
  if (of_tolerances())
    return std::numbers::pi *
           laws_[variable].of_normal(optim::normal_quantile(laws_[variable].cdf(value))).slope;
  return range.scale == optim::Scale::log ? value * std::log(range.max / range.min)
                                          : range.max - range.min;
}

double UnitBox::sd(std::size_t variable) const {
  return of_tolerances() ? laws_[variable].sd() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace twum::inline v0_1::studies
