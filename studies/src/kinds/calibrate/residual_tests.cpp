// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/residual_tests.hpp"

#include "results/calibration_notes.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/offset_test.hpp>
#include <twum/studies/fit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
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

// Neighbours have one table, and one setting of the bench but for what is varied.
bool in_one_series(const CalibrateResult::Point& a, const CalibrateResult::Point& b,
                   const std::string& varied) {
  return table_of(a) == table_of(b) &&
         std::equal(a.set.begin(), a.set.end(), b.set.begin(), b.set.end(),
                    [&](const NamedValue& x, const NamedValue& y) {
                      return x.name == y.name && (x.name == varied || x.value == y.value);
                    });
}

// Residuals and their rows of the points that count.
optim::Residuals counting(const optim::Residuals& all, const CalibrateResult& result) {
  optim::Residuals some;
  const std::size_t n = all.jacobian.size() / all.values.size();
  for (std::size_t i = 0; i < result.data.size(); ++i) {
    if (!result.data[i].counts) continue;
    some.values.push_back(all.values[i]);
    for (std::size_t j = 0; j < n; ++j) some.jacobian.push_back(all.jacobian[i * n + j]);
  }
  return some;
}

// Number of a point among those that count.
std::size_t number_of(const CalibrateResult::Point& point, const CalibrateResult& result) {
  return static_cast<std::size_t>(std::count_if(
      result.data.data(), &point, [](const CalibrateResult::Point& one) { return one.counts; }));
}

// The points of a kind in the order of what the bench varied, by their numbers.
std::vector<std::vector<std::size_t>> series_of(const Points& kind, const NamedValue& over,
                                                const CalibrateResult& result) {
  std::vector<Points> series;
  for (const auto* point : kind) {
    if (std::isnan(place_on(*point, over))) continue;
    const auto known = std::find_if(series.begin(), series.end(), [&](const Points& one) {
      return in_one_series(*one.front(), *point, over.name);
    });
    if (known == series.end())
      series.push_back({point});
    else
      known->push_back(point);
  }
  std::vector<std::vector<std::size_t>> numbers;
  for (Points& one : series) {
    std::stable_sort(one.begin(), one.end(), [&](const auto* a, const auto* b) {
      return place_on(*a, over) < place_on(*b, over);
    });
    numbers.emplace_back();
    for (const auto* point : one) numbers.back().push_back(number_of(*point, result));
  }
  return numbers;
}

void test_neighbours(CalibrateResult& result, const std::vector<Points>& kinds,
                     const optim::Residuals& residuals, const optim::LeastSquaresResult& fit) {
  std::size_t count = 0;
  for (const Points& kind : kinds) {
    const std::optional<NamedValue> over = axis_of(result.data, *kind.front());
    if (!over) continue;
    const auto test = optim::neighbour_test(residuals, fit, series_of(kind, *over, result));
    if (test.count == 0) continue;
    ++count;
    if (result.neighbours && result.neighbours->p <= test.p) continue;
    result.neighbours = test;
    result.neighbours_of = {kind.front()->quantity, over->name};
  }
  if (result.neighbours) result.neighbours->p = of_many(result.neighbours->p, count);
}

// Those of one table that counts. Where columns have a scatter of their own, these are the columns.
std::vector<Points> by_table(const Points& kind) {
  std::vector<Points> columns;
  for (const auto* point : kind) {
    const auto known = std::find_if(columns.begin(), columns.end(), [&](const Points& column) {
      return table_of(*column.front()) == table_of(*point);
    });
    if (known == columns.end())
      columns.push_back({point});
    else
      known->push_back(point);
  }
  return columns;
}

// An instrument that was not set to zero shifts all that it reads. Where every reading was taken at the same place, they have
// no neighbours, and a scatter that is estimated from them holds the shift.
void test_offsets(CalibrateResult& result, const std::vector<Points>& kinds,
                  const optim::Residuals& residuals, const optim::LeastSquaresResult& fit,
                  double known) {
  CalibrateResult::ColumnOffset rarest;
  std::size_t count = 0;
  for (const Points& kind : kinds) {
    for (const Points& column : by_table(kind)) {
      std::vector<std::size_t> rows;
      std::vector<double> slopes;
      for (const auto* point : column) {
        rows.push_back(number_of(*point, result));
        slopes.push_back(std::sqrt(point->weight));
      }
      const auto test =
          optim::offset_test(residuals, fit, {rows, slopes, !result.columns.empty()}, known);
      if (!(test.deviation > 0)) continue;
      ++count;
      const CalibrateResult::Point& one = *column.front();
      if (test.p < rarest.p)
        rarest = {one.quantity, one.unit, table_of(one), column.size(), -test.offset, test.p};
    }
  }
  if (count == 0) return;
  rarest.p = of_many(rarest.p, count);
  if (rarest.p < kUnlikely) result.offset = rarest;
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
    const double p =
        of_many(optim::chi_square_tail(static_cast<double>(kind.size()), sum), kinds.size());
    if (p < worst.p) worst = {kind.front()->quantity, sum, kind.size(), p};
  }
  if (worst.p < kUnlikely) result.worst_kind = worst;
}

}  // namespace

void test_residuals(CalibrateResult& result, const optim::Residuals& residuals,
                    const optim::LeastSquaresResult& fit, bool deviations, double known) {
  if (result.exact || result.degrees_of_freedom == 0) return;
  const std::vector<Points> kinds = kinds_of(result);
  const optim::Residuals some = counting(residuals, result);
  test_neighbours(result, kinds, some, fit);
  test_offsets(result, kinds, some, fit, known);
  const std::size_t freedom = result.counting_freedom();
  if (!deviations || !result.columns.empty() || freedom == 0) return;
  double sum = 0;
  for (const Points& kind : kinds) sum += sum_of(kind);
  result.chi_square = sum;
  result.chi_square_p = optim::chi_square_tail(static_cast<double>(freedom), sum);
  test_kinds(result, kinds);
}

}  // namespace twum::studies
