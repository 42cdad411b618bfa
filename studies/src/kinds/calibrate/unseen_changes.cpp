// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/unseen_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

using optim::LeastSquaresResult;

// The change of b, in percent, that undoes 1 % more of a: their columns are parallel.
double undone_by(const LeastSquaresResult& fit, const optim::Residuals& residuals,
                 const std::vector<std::string>& names) {
  const std::size_t n = fit.estimates.size();
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(fit.estimates.begin(), fit.estimates.end(),
                     [&](const optim::Estimate& e) { return e.name == name; }) -
        fit.estimates.begin());
  };
  const std::size_t a = place(names[0]);
  const std::size_t b = place(names[1]);
  double both = 0;
  double second = 0;
  for (std::size_t i = 0; i < residuals.values.size(); ++i) {
    const double slope = residuals.jacobian[i * n + b];
    both += residuals.jacobian[i * n + a] * slope;
    second += slope * slope;
  }
  return -both / second * fit.estimates[a].value / fit.estimates[b].value;
}

// A change of 10 % of what moves most, the first of the parameters upwards. Left out is what moves by less than a
// twentieth of that and does less than a tenth of what another part does.
CalibrateResult::Combination combination(const LeastSquaresResult& fit,
                                         const optim::Direction& direction, std::size_t points) {
  constexpr double kStep = 0.1;
  constexpr double kNotable = 0.05;
  constexpr double kCounts = 0.1;
  constexpr double kLeast = 1e-6;  // less is rounding, where the direction is not seen at all
  const double most = *std::max_element(direction.part_norms.begin(), direction.part_norms.end());
  CalibrateResult::Combination result;
  double percent = 0;
  for (std::size_t j = 0; j < direction.change.size(); ++j) {
    const bool counts =
        direction.part_norms[j] > kCounts * most && std::fabs(direction.change[j]) >= kLeast;
    if (!(std::fabs(direction.change[j]) >= kNotable) && !counts) continue;
    if (percent == 0) percent = std::copysign(100 * kStep, direction.change[j]);
    result.parts.push_back({fit.estimates[j].name, percent * direction.change[j]});
  }
  result.effect = kStep * direction.effect / std::sqrt(static_cast<double>(points)) / fit.scatter;
  return result;
}

}  // namespace

std::vector<CalibrateResult::Undetermined> unseen_sets(
    const LeastSquaresResult& fit, const optim::Residuals& residuals,
    const std::vector<std::vector<std::string>>& list) {
  std::vector<CalibrateResult::Undetermined> sets;
  for (const auto& names : list) {
    CalibrateResult::Undetermined set;
    set.names = names;
    if (names.size() == 2) set.undone_by = undone_by(fit, residuals, names);
    sets.push_back(std::move(set));
  }
  return sets;
}

std::vector<CalibrateResult::Combination> hardly_seen(const LeastSquaresResult& fit,
                                                      std::size_t points, bool exact) {
  constexpr double kHalf = 0.5;
  constexpr double kUnseen = 1e-10;  // as for the rank: of the best visible one
  const double most = fit.directions.empty() ? 0 : fit.directions.back().effect;
  std::vector<CalibrateResult::Combination> list;
  for (const optim::Direction& direction : fit.directions) {
    const bool unseen = direction.effect <= kUnseen * most;
    const bool wide = !exact && fit.student_t * fit.scatter / direction.effect > kHalf;
    if (!unseen && !wide && !list.empty()) break;
    list.push_back(combination(fit, direction, points));
    list.back().unseen = unseen;
    if (exact) list.back().effect = std::numeric_limits<double>::quiet_NaN();
    if (!unseen && !wide) break;  // the worst is told even where it is not bad
  }
  return list;
}

}  // namespace twum::inline v0_1::studies
