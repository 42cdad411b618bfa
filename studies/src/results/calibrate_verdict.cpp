// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {

namespace {

// Part of the largest value that is noticed.
constexpr double kNoticeable = 0.02;

double largest(const std::vector<CalibrateResult::Point>& data, const std::string& quantity) {
  double size = 0;
  for (const auto& point : data)
    if (point.quantity == quantity) size = std::max(size, std::fabs(point.value));
  return size;
}

// Of numbers of several kinds the standard deviations are the measure; there is no largest one.
double part_of_largest(double rms, const std::vector<CalibrateResult::Point>& data) {
  const bool mixed = std::any_of(data.begin(), data.end(), [&](const auto& point) {
    return point.quantity != data.front().quantity;
  });
  const double size = data.empty() || mixed ? 0 : largest(data, data.front().quantity);
  return size > 0 && rms > 0 ? rms / size : 0;
}

}  // namespace

double CalibrateResult::misfit() const {
  double part = 0;
  for (const ColumnScatter& column : columns)
    if (const double size = largest(data, column.quantity); size > 0)
      part = std::max(part, column.deviation / size);
  return columns.empty() ? part_of_largest(residual_rms, data) : part;
}

double CalibrateResult::misfit_of(const Optimum& optimum) const {
  return part_of_largest(optimum.residual_rms, data);
}

std::vector<std::string> CalibrateResult::files() const {
  std::vector<std::string> list;
  for (const Estimate& e : estimates)
    if (!e.file.empty() && std::find(list.begin(), list.end(), e.file) == list.end())
      list.push_back(e.file);
  return list.empty() ? std::vector<std::string>{""} : list;
}

std::vector<NamedValue> CalibrateResult::motor_values(const std::vector<double>& values,
                                                      const std::string& file) const {
  std::vector<NamedValue> list;
  for (std::size_t j = 0; j < values.size(); ++j) {
    const Estimate& e = estimates[j];
    if (!e.file.empty() && e.file != file) continue;
    const std::string name = e.parameter.name.substr(0, e.parameter.name.find(" ("));
    list.push_back({name, e.parameter.unit, values[j]});
  }
  return list;
}

std::vector<NamedValue> CalibrateResult::motor_values(const std::string& file) const {
  std::vector<double> values;
  for (const Estimate& e : estimates) values.push_back(e.parameter.value);
  std::vector<NamedValue> list = motor_values(values, file);
  list.insert(list.end(), derived.begin(), derived.end());
  return list;
}

bool CalibrateResult::at_bounds() const {
  return !estimates.empty() && std::all_of(estimates.begin(), estimates.end(),
                                           [](const auto& e) { return e.bound != Bound::none; });
}

double CalibrateResult::chance() const {
  return std::min({neighbours ? neighbours->p : 1.0, chi_square ? chi_square_p : 1.0,
                   worst_kind ? worst_kind->p : 1.0});
}

bool CalibrateResult::shifted() const { return offset && offset->p < kRare; }

bool CalibrateResult::poor() const {
  if (shifted() || chance() < kRare || (chance() < kUnlikely && misfit() > kNoticeable))
    return true;
  return !chi_square && (misfit() > kLarge || missed() != nullptr);
}

bool CalibrateResult::alike() const {
  constexpr double kPart = 0.25;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Point& point : data) {
    if (!neighbours || !point.counts || point.quantity != neighbours_of.quantity) continue;
    low = std::min(low, point.residual);
    high = std::max(high, point.residual);
  }
  return low * high > 0 && high - low <= kPart * std::min(std::fabs(low), std::fabs(high));
}

const CalibrateResult::Point* CalibrateResult::missed() const {
  if (chi_square || counting_freedom() >= kKnownScatter) return nullptr;
  const Point* worst = nullptr;
  double most = 1;
  for (const Point& point : data) {
    const double allowed =
        std::max(kLarge * std::fabs(point.value), kNoticeable * largest(data, point.quantity));
    const double part = std::sqrt(point.weight) * std::fabs(point.residual) / allowed;
    if (!point.counts || !(part > most)) continue;
    most = part;
    worst = &point;
  }
  return worst;
}

std::size_t CalibrateResult::counting_freedom() const {
  const auto left_out = static_cast<std::size_t>(
      std::count_if(data.begin(), data.end(), [](const Point& point) { return !point.counts; }));
  return degrees_of_freedom > left_out ? degrees_of_freedom - left_out : 0;
}

std::size_t CalibrateResult::equals() const {
  return static_cast<std::size_t>(
      std::count_if(optima.begin(), optima.end(), [](const auto& o) { return o.fits_as_well; }));
}

bool CalibrateResult::of_use(const Estimate& e) {
  constexpr double kFactor = 3;
  constexpr double kPart = 0.1;
  if (e.bound != Bound::none) return false;
  if (!std::isfinite(e.low) || !std::isfinite(e.high) || (e.low_cut && e.high_cut)) return false;
  const bool one_sign = e.low > 0 || e.high < 0;
  const double ratio = std::max(e.high / e.low, e.low / e.high);
  if (one_sign && ratio <= kFactor) return true;
  return e.scale == optim::Scale::log ? std::log(e.high / e.low) <= kPart * std::log(e.max / e.min)
                                      : e.high - e.low <= kPart * (e.max - e.min);
}

bool CalibrateResult::determined() const {
  return undetermined.empty() && std::all_of(estimates.begin(), estimates.end(), of_use);
}

OutcomeWord CalibrateResult::verdict() const {
  if (at_bounds()) return StudyOutcome::at_bounds;
  if (poor()) return StudyOutcome::poor;
  if (equals() > 1) return StudyOutcome::several;
  return determined() ? StudyOutcome::fitted : StudyOutcome::undetermined;
}

}  // namespace twum::inline v0_1::studies
