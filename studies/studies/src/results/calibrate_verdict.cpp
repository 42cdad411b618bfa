// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"

#include <algorithm>
#include <cmath>

namespace twum::studies {

namespace {

// Of numbers of several kinds the standard deviations are the measure; there is no largest one.
double part_of_largest(double rms, const std::vector<CalibrateResult::Point>& data) {
  double largest = 0;
  for (const auto& point : data) {
    if (point.quantity != data.front().quantity) return 0;
    largest = std::max(largest, std::fabs(point.value));
  }
  return largest > 0 && rms > 0 ? rms / largest : 0;
}

}  // namespace

double CalibrateResult::misfit() const {
  double part = 0;
  for (const ColumnScatter& column : columns) {
    double largest = 0;
    for (const Point& point : data)
      if (point.quantity == column.quantity) largest = std::max(largest, std::fabs(point.value));
    if (largest > 0) part = std::max(part, column.deviation / largest);
  }
  return columns.empty() ? part_of_largest(residual_rms, data) : part;
}

double CalibrateResult::misfit_of(const Optimum& optimum) const {
  return part_of_largest(optimum.residual_rms, data);
}

bool CalibrateResult::at_bounds() const {
  return !estimates.empty() && std::all_of(estimates.begin(), estimates.end(),
                                           [](const auto& e) { return e.bound != Bound::none; });
}

bool CalibrateResult::poor() const {
  constexpr double kRare = 0.01;
  constexpr double kNoticeable = 0.02;
  const double chance = std::min(runs ? runs->p : 1.0, chi_square ? chi_square_p : 1.0);
  return chance < kRare || (chance < kUnlikely && misfit() > kNoticeable) ||
         (!chi_square && misfit() > kLarge);
}

std::size_t CalibrateResult::chi_square_freedom() const {
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
  return e.log ? std::log(e.high / e.low) <= kPart * std::log(e.max / e.min)
               : e.high - e.low <= kPart * (e.max - e.min);
}

bool CalibrateResult::determined() const {
  return undetermined.empty() && std::all_of(estimates.begin(), estimates.end(), of_use);
}

const char* CalibrateResult::verdict() const {
  if (at_bounds()) return "at-bounds";
  if (poor()) return "poor";
  if (equals() > 1) return "several";
  return determined() ? "fitted" : "undetermined";
}

}  // namespace twum::studies
