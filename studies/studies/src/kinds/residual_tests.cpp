// SPDX-License-Identifier: Apache-2.0
#include "kinds/residual_tests.hpp"

#include "kinds/fit_curves.hpp"
#include "results/calibration_notes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace twum::studies {
namespace {

using Points = std::vector<const CalibrateResult::Point*>;

// Points that count, by kind, in the order of the data.
std::vector<Points> kinds_of(const CalibrateResult& result) {
  std::vector<Points> kinds;
  for (const CalibrateResult::Point& point : result.data) {
    if (!point.counts) continue;
    const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const Points& kind) {
      return kind.front()->quantity == point.quantity;
    });
    if (known == kinds.end())
      kinds.push_back({&point});
    else
      known->push_back(&point);
  }
  return kinds;
}

// Bonferroni's inequality: how often chance puts one of so many p as low.
double of_many(double p, std::size_t count) {
  return std::min(1.0, static_cast<double>(count) * p);
}

// Signs of a kind in the order of what the bench varied; none if it varied nothing.
std::optional<RunsTest> runs_of(Points kind, const std::optional<NamedValue>& over) {
  if (!over) return {};
  std::erase_if(kind, [&](const auto* p) { return std::isnan(place_on(*p, *over)); });
  std::stable_sort(kind.begin(), kind.end(), [&](const auto* a, const auto* b) {
    return place_on(*a, *over) < place_on(*b, *over);
  });
  std::vector<double> residuals;
  for (const auto* point : kind) residuals.push_back(point->residual);
  if (residuals.size() < 2) return {};
  return runs_test(residuals);
}

void test_runs(CalibrateResult& result, const std::vector<Points>& kinds) {
  std::size_t count = 0;
  for (const Points& kind : kinds) {
    const std::optional<NamedValue> over = axis_of(result.data, *kind.front());
    const std::optional<RunsTest> runs = runs_of(kind, over);
    if (!runs) continue;
    ++count;
    if (result.runs && result.runs->p <= runs->p) continue;
    result.runs = runs;
    result.runs_of = {kind.front()->quantity, over->name};
  }
  if (result.runs) result.runs->p = of_many(result.runs->p, count);
}

double sum_of(const Points& points) {
  double sum = 0;
  for (const auto* point : points) sum += std::pow(point->residual / point->deviation, 2);
  return sum;
}

// A kind that misses its deviations can hide behind others whose deviations are stated too large. Its degrees of freedom are at
// most its numbers.
void test_kinds(CalibrateResult& result, const std::vector<Points>& kinds) {
  if (kinds.size() < 2) return;
  CalibrateResult::KindScatter worst;
  for (const Points& kind : kinds) {
    const double sum = sum_of(kind);
    const double p = of_many(chi_square_tail(sum, kind.size()), kinds.size());
    if (p < worst.p) worst = {kind.front()->quantity, sum, kind.size(), p};
  }
  if (worst.p < kUnlikely) result.worst_kind = worst;
}

}  // namespace

void test_residuals(CalibrateResult& result, bool deviations) {
  if (result.exact || result.degrees_of_freedom == 0) return;
  const std::vector<Points> kinds = kinds_of(result);
  test_runs(result, kinds);
  const std::size_t freedom = result.counting_freedom();
  if (!deviations || !result.columns.empty() || freedom == 0) return;
  double sum = 0;
  for (const Points& kind : kinds) sum += sum_of(kind);
  result.chi_square = sum;
  result.chi_square_p = chi_square_tail(sum, freedom);
  test_kinds(result, kinds);
}

}  // namespace twum::studies
